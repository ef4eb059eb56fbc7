//! A solid: the table `solid`, and what does not stand beside it.

use crate::error::{Origin, SceneError, ValueError};
use crate::key::kind::Setting;
use crate::scene::Scene;
use crate::scene::solid::SolidTable;
use crate::value::form::Form;
use crate::value::{Fault, Value, quoted};
use peelkit::model::SolidSettings;
use peelkit::solid::{Grading, MOST_SOLID_ORDER, Plane, SolidContact, SolidElement, SolidGrip, SolidMaterial};
use peelkit::study::{Choice, FollowedUntil, Terms};
use std::ops::Range;

/// The table of a scene.
pub(crate) const TABLE: &str = "solid";
/// Most rows of elements through the thickness.
pub(crate) const MOST_ROWS: usize = 200;

pub(crate) const PLANES: &[(&str, Plane)] = &[("stress", Plane::Stress), ("strain", Plane::Strain)];
pub(crate) const MATERIALS: &[(&str, SolidMaterial)] =
    &[("neo-hookean", SolidMaterial::NeoHookean), ("st-venant-kirchhoff", SolidMaterial::StVenantKirchhoff)];
pub(crate) const GRIPS: &[(&str, SolidGrip)] = &[("rigid", SolidGrip::Rigid), ("parabolic", SolidGrip::Parabolic)];
pub(crate) const GRADINGS: &[(&str, Grading)] = &[("none", Grading::None), ("grip", Grading::OF_GRIP)];
pub(crate) const CONTACTS: &[(&str, SolidContact)] = &SolidContact::NAMED;

/// `element`
pub(crate) static ELEMENT: Setting = Setting {
    takes: "\"Q1C1\" to \"Q1C8\", \"Q1CH\", \"H1(q)\" or \"Q(p,q)\", with orders p along the strip and q through it from 1 to 8",
    brief: "Q1CH, H1(2), ...",
    example: "\"Q1CH\"",
    form: || Form::Word(elements()),
    read: |scene, value, _| {
        let Value::Text(text) = value else { return Err(Fault::whole(format!("is {value}, no word"))) };
        let none = || Fault::whole(format!("is {}, which is none of its values", quoted(text)));
        scene.solid_table().element = SolidElement::named(text).ok_or_else(none)?;
        Ok(())
    },
    write: |scene, _| Some(Value::Text(scene.solid.as_ref()?.element.to_string())),
};

/// The names of all elements.
fn elements() -> Vec<&'static str> {
    static NAMES: std::sync::LazyLock<Vec<String>> = std::sync::LazyLock::new(|| {
        let orders = 1..=MOST_SOLID_ORDER;
        let enriched = orders.clone().map(|order| SolidElement::Enriched { order });
        let hermite = orders.clone().map(|through| SolidElement::Hermite { through });
        let full =
            orders.clone().flat_map(|along| orders.clone().map(move |through| SolidElement::Full { along, through }));
        enriched
            .chain([SolidElement::HermiteEdge])
            .chain(hermite)
            .chain(full)
            .map(|element| element.to_string())
            .collect()
    });
    NAMES.iter().map(String::as_str).collect()
}

/// That the body of a scene is a solid, where a beam is asked for.
pub(crate) fn refused(file: &Origin, header: Range<usize>) -> SceneError {
    let problem = ValueError::new(
        "is a table of a body that is computed as a solid, which `peel run`, `sweep`, `fit`, `optimise` and `uncertainty` alone do; here beams are computed",
        "Give the scene to one of them, or remove [solid] to compute a beam.",
    );
    file.error(header, &format!("[{TABLE}]"), problem)
}

impl Scene {
    /// How the body is computed as the solid of a table.
    pub fn solid_settings(&self, table: &SolidTable) -> SolidSettings {
        let SolidTable { element, modes, along, through, across, plane, material, contact, grip, grading } = *table;
        // elements as long as the body are the longest
        let along = along.unwrap_or_else(|| self.model.process_length().min(self.model.length()));
        SolidSettings { element, modes, along, through, across, plane, material, contact, grip, grading }
    }
}

/// What of a scene does not stand beside the table: by the key of the scene.
pub(crate) fn problem(scene: &Scene) -> Option<(String, ValueError)> {
    let table = scene.solid.as_ref()?;
    let Choice { order, elements, mesh, form, .. } = scene.accuracy.choice;
    let usual = Choice::NOTHING;
    let of_beams = [
        (scene.time.is_some(), "time.rate", "has no rate"),
        (scene.accuracy.terms == Terms::Auto, "terms", "is computed with all its terms"),
        (order.is_some(), "accuracy.order", "has its elements by `solid.element`"),
        (elements.is_some(), "accuracy.elements", "has its elements by `solid.along` and `solid.through`"),
        (mesh != usual.mesh || form != usual.form, "accuracy.order", "has elements of its own"),
        (
            scene.bounds.until == FollowedUntil::Detachment,
            "path.until",
            "is followed to the end or to its first limit points",
        ),
    ];
    let found = of_beams.into_iter().find(|(is_given, ..)| *is_given).map(|(_, key, why)| {
        let problem = ValueError::new(
            format!("is given, and a body computed as a solid {why}"),
            "Remove it, or remove the table [solid].",
        );
        (key.to_owned(), problem)
    });
    found.or_else(|| {
        let error = scene.solid_settings(table).check(&scene.model).err()?;
        let (key, message) = (error.key(), error.to_string());
        let found = message.strip_prefix(&format!("`{key}` ")).unwrap_or(&message);
        Some((key.to_owned(), ValueError::new(found, error.remedy())))
    })
}
