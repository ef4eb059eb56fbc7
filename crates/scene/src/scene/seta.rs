//! A seta as data: the table `seta`.

use peelkit::model::{NormalPull, PullCurve, Seta, Sideways, TipLaw};
use peelkit::study::SetaStart;
use std::sync::Arc;

/// The error that a table of tips may have where the scene does not say it.
const TIP_TOLERANCE: f64 = 1e-3;

/// What the tips of a seta follow.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum SetaTipLaw {
    /// The curve of their spatula, pulled along the normal: a function of the height alone
    #[default]
    Curve,
    /// The table of their spatula: a function of height and rotation
    Table,
    /// None: their spatulae are beams that adhere, in one equilibrium with the seta
    Beam,
}

pub(crate) const TIP_LAWS: [(&str, SetaTipLaw); 3] =
    [("curve", SetaTipLaw::Curve), ("table", SetaTipLaw::Table), ("beam", SetaTipLaw::Beam)];

impl SetaTipLaw {
    /// Its name in a scene.
    pub fn name(self) -> &'static str {
        TIP_LAWS.iter().find(|named| named.1 == self).map_or("", |named| named.0)
    }
}

/// A seta as a scene gives it.
#[derive(Clone, Debug, PartialEq)]
pub struct SetaTable {
    /// Geometry and material
    pub seta: Seta,
    /// Of what holds a tip along the ground to the place where it began to adhere, nN/nm; none: tips slide freely
    pub lateral_stiffness: Option<f64>,
    /// Height above its place at rest at which a detached tip adheres again, nm
    pub contact_height: f64,
    /// Force with which the seta is pressed on before all steps, nN; none: every tip adheres at the start
    pub preload: Option<f64>,
    /// What its tips follow
    pub tip_law: SetaTipLaw,
    /// Folder of `peel coarsen` with their table, as the scene names it; none: the table is computed
    pub tip_table: Option<String>,
    /// Error that the table may have, over the largest force and the largest moment
    pub tip_tolerance: f64,
    /// How near to where they snap off tips are solved as spatulae, nm; none: they follow the table there as well
    pub resolve_within: Option<f64>,
}

/// How high a seta that is pressed on starts above the height at which its highest tip would adhere, nm.
const CLEARANCE: f64 = 1.0;
/// The same of tips that follow their table, whose attraction says itself where they adhere.
const OUT_OF_REACH: f64 = 100.0;

impl Default for SetaTable {
    /// The default seta; its angle is that of the text "60 deg", to the last bit.
    fn default() -> Self {
        let seta = Seta { shaft_angle: 60.0 * 1f64.to_radians(), ..Seta::default() };
        Self {
            seta,
            lateral_stiffness: None,
            contact_height: 0.0,
            preload: None,
            tip_law: SetaTipLaw::default(),
            tip_table: None,
            tip_tolerance: TIP_TOLERANCE,
            resolve_within: None,
        }
    }
}

impl SetaTable {
    /// The law of its tips, of which each follows this curve.
    pub fn law(&self, curve: PullCurve) -> Arc<dyn TipLaw> {
        Arc::new(NormalPull { curve, sideways: self.sideways(), contact_height: self.contact_height })
    }

    /// What holds its tips along the ground.
    pub fn sideways(&self) -> Sideways {
        self.lateral_stiffness.map_or(Sideways::Free, Sideways::Held)
    }

    /// From its tips to its root, upright, nm: how far the root is moved at most.
    pub(crate) fn height(&self) -> f64 {
        self.seta.reach()
    }

    /// How it starts: adhering, or above the ground where it is pressed on first.
    pub(crate) fn start(&self) -> SetaStart {
        let clearance = match self.tip_law {
            SetaTipLaw::Curve => CLEARANCE,
            SetaTipLaw::Table | SetaTipLaw::Beam => OUT_OF_REACH,
        };
        match self.preload {
            None => SetaStart::Adhering,
            Some(_) => SetaStart::Above(self.seta.spread() + self.contact_height + clearance),
        }
    }
}
