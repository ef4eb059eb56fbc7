//! A pull at a rate as data: the table `time`.

use peelkit::adhesion::OpeningRate;
use peelkit::beam::Viscosity;
use peelkit::model::MovingMaterial;
use peelkit::study::TimeAccuracy;

/// The library counts times in ns, a scene in s.
pub(crate) const NS_PER_S: f64 = 1e9;

/// How the material of a beam flows; its times and its ratio are keys of their own.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Flow {
    /// Not at all
    #[default]
    Elastic,
    /// A spring beside a dashpot
    KelvinVoigt,
    /// A spring beside a spring and a dashpot in series
    StandardLinearSolid,
}

/// The words for it.
pub(crate) const FLOWS: [(&str, Flow); 3] = [
    ("elastic", Flow::Elastic),
    ("kelvin-voigt", Flow::KelvinVoigt),
    ("standard-linear-solid", Flow::StandardLinearSolid),
];

impl Flow {
    /// The word for it.
    pub(crate) fn word(self) -> &'static str {
        FLOWS.iter().find(|(_, own)| *own == self).map_or("", |(word, _)| word)
    }
}

/// A pull at a rate as a scene gives it.
#[derive(Clone, Debug, PartialEq)]
pub struct TimeTable {
    /// Velocity of what moves the grip, m/s
    pub rate: f64,
    /// ρ, kg/m³
    pub density: f64,
    /// How the material flows
    pub material: Flow,
    /// τ of Kelvin and Voigt's material, s
    pub retardation_time: Option<f64>,
    /// τ of a standard linear solid, s
    pub relaxation_time: Option<f64>,
    /// E₀/E∞ of a standard linear solid
    pub stiffness_ratio: Option<f64>,
    /// Rate of opening at which the traction of a cohesive law rises, m/s
    pub opening_rate: Option<f64>,
    /// With which power it rises; none: 1
    pub rate_exponent: Option<f64>,
    /// Where the grip comes to rest, nm; none: as far away as the body is long, or the seta
    pub displacement: Option<f64>,
    /// How long it is followed at rest, s; none: it ends where nothing adheres, or where the grip comes to rest
    pub held: Option<f64>,
    /// On how much of its way the grip accelerates, nm; none: a tenth of what moves a section by r0, of a seta 20 nm
    pub acceleration: Option<f64>,
    /// Error of a step in time, over the gap at rest, of a seta over 10 nm and 0.01 rad
    pub tolerance: f64,
}

impl Default for TimeTable {
    /// An elastic material; rate and density are NaN until a text gives them.
    fn default() -> Self {
        Self {
            rate: f64::NAN,
            density: f64::NAN,
            material: Flow::Elastic,
            retardation_time: None,
            relaxation_time: None,
            stiffness_ratio: None,
            opening_rate: None,
            rate_exponent: None,
            displacement: None,
            held: None,
            acceleration: None,
            tolerance: TimeAccuracy::default().tolerance,
        }
    }
}

impl TimeTable {
    /// The keys of a material with what they hold, and whose they are.
    pub(crate) fn of_materials(&self) -> [(&'static str, Option<f64>, Flow); 3] {
        [
            ("retardation_time", self.retardation_time, Flow::KelvinVoigt),
            ("relaxation_time", self.relaxation_time, Flow::StandardLinearSolid),
            ("stiffness_ratio", self.stiffness_ratio, Flow::StandardLinearSolid),
        ]
    }

    /// The material as it moves. What it lacks is NaN, which a scene that was read does not.
    pub fn moving_material(&self) -> MovingMaterial {
        let ns = |time: Option<f64>| NS_PER_S * time.unwrap_or(f64::NAN);
        let viscosity = match self.material {
            Flow::Elastic => Viscosity::Elastic,
            Flow::KelvinVoigt => Viscosity::KelvinVoigt { retardation_time: ns(self.retardation_time) },
            Flow::StandardLinearSolid => Viscosity::StandardLinearSolid {
                relaxation_time: ns(self.relaxation_time),
                stiffness_ratio: self.stiffness_ratio.unwrap_or(f64::NAN),
            },
        };
        let exponent = self.rate_exponent.unwrap_or(1.0);
        let opening = self.opening_rate.map(|reference| OpeningRate { reference, exponent });
        MovingMaterial { density: self.density, viscosity, opening }
    }
}
