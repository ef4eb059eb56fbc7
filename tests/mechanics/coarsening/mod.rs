//! The law of a tip, coarse-grained from its spatula.

mod held;
mod in_space;
mod near_end;
mod resolved;
mod seta_law;
mod sliding;
mod strip;

use peelkit::model::{Body, Grip, PeelModel, Spatula};
use peelkit::prelude::Adhesion;
use peelkit::study::coarsening::{Sheet, TipPlace};

/// The spatula of scenes/spatula.toml.
fn spatula() -> PeelModel {
    PeelModel::of(Body::Spatula(Spatula::default()), Adhesion::default(), Grip::FREE)
}

fn at(normal: f64, lateral: f64, rotation: f64) -> TipPlace {
    TipPlace { normal, lateral, rotation }
}

/// Forces against differences of the energy, stiffness against differences of the forces: the largest of each, over one plus its number.
fn differences(sheet: &Sheet, place: TipPlace) -> [f64; 2] {
    let here = sheet.response(place);
    let mut worst = [0.0f64; 2];
    for (i, step) in [1e-4, 1e-4, 1e-6].into_iter().enumerate() {
        let [behind, ahead] = [-step, step].map(|step| {
            let mut moved = place;
            *[&mut moved.normal, &mut moved.lateral, &mut moved.rotation][i] += step;
            sheet.response(moved)
        });
        let slope = |ahead: f64, behind: f64| (ahead - behind) / (2.0 * step);
        let off = |found: f64, known: f64| (found - known).abs() / (1.0 + known.abs());
        worst[0] = worst[0].max(off(slope(ahead.energy, behind.energy), here.force[i]));
        for j in 0..3 {
            worst[1] = worst[1].max(off(slope(ahead.force[j], behind.force[j]), here.stiffness[i][j]));
            assert!((here.stiffness[i][j] - here.stiffness[j][i]).abs() <= 1e-9 * (1.0 + here.stiffness[i][j].abs()));
        }
    }
    worst
}
