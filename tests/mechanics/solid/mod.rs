//! Solids that adhere: strips as plane solids, a spatula and a profile in space.

mod elements;
mod first_peak;
mod profile;
mod spatula;
mod ways;
mod whole_path;

use peelkit::model::{PeelModel, SolidSettings, Strip, StripModel};
use peelkit::solid::{Grading, Plane, SolidContact, SolidElement, SolidGrip, SolidMaterial, SolidStrip};
use std::sync::Arc;

/// The strip of the paper, of a length and height, whose contact face alone adheres.
fn model(length: f64, height: f64) -> PeelModel {
    let mut model = PeelModel::from(StripModel::of_the_paper(length, 1.0));
    model.body = peelkit::model::Body::Strip(Strip { height, ..*model.strip().unwrap() });
    model.adhesion.far_face = false;
    model
}

fn element(name: &str) -> SolidElement {
    SolidElement::named(name).unwrap()
}

/// A small strip in two or three columns and two rows, of all that may be chosen.
fn all_small() -> Vec<(String, SolidSettings)> {
    let mut all = Vec::new();
    for name in ["Q1C1", "Q1C3", "Q1CH", "H1(2)", "Q(3,2)"] {
        for grip in [SolidGrip::Rigid, SolidGrip::Parabolic] {
            for contact in SolidContact::NAMED {
                for (plane, material) in [
                    (Plane::Stress, SolidMaterial::NeoHookean),
                    (Plane::Strain, SolidMaterial::NeoHookean),
                    (Plane::Stress, SolidMaterial::StVenantKirchhoff),
                ] {
                    let settings = SolidSettings {
                        element: element(name),
                        modes: true,
                        along: 2.0,
                        through: 2,
                        across: 2,
                        plane,
                        material,
                        contact: contact.1,
                        grip,
                        grading: Grading::None,
                    };
                    all.push((format!("{name} {grip:?} {} {plane:?} {material:?}", contact.0), settings));
                }
            }
        }
    }
    all
}

fn strip(settings: &SolidSettings, model: &PeelModel) -> Arc<SolidStrip> {
    Arc::new(settings.strip(model).unwrap())
}
