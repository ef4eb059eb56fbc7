//! Models made into what moves in time.

use super::beam_problem::BeamProblem;
use super::build::{Discretisation, NoSuchOrder, three_field};
use super::rod::{RodError, RodModel};
use crate::adhesion::section::cohesive::opening_rate::OpeningRate;
use crate::adhesion::section::coverage::TiltCount;
use crate::adhesion::section::line_load::RateLaw;
use crate::beam::mesh::{Focus, MeshKind, Reach};
use crate::beam::planar::chain::Chain;
use crate::beam::planar::density::reissner::{ReissnerBeam, ReissnerRod};
use crate::beam::planar::density::viscous::Viscous;
use crate::beam::planar::planar_beam::{BeamInertia, FaceDistance, PlanarBeam};
use crate::beam::viscosity::Viscosity;
use crate::model::peel::{Form, PeelModel};
use crate::solve::problem::Problem;
use crate::solve::time::dynamic_system::DynamicProblem;
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// What a material has besides its stiffness where it moves in time. Times are in ns: then masses are in nN·ns²/nm = 1e-18 kg, and velocities in
/// nm/ns = m/s.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct MovingMaterial {
    /// ρ, kg/m³; zero where inertia does not count
    pub density: f64,
    /// How it flows
    pub viscosity: Viscosity,
    /// How the traction of a cohesive law grows with the rate at which the face opens; none: it does not
    pub opening: Option<OpeningRate>,
}

/// 1 kg/m³ in 1e-18 kg/nm³.
pub(crate) const KG_PER_CUBIC_METRE: f64 = 1e-9;

/// Why a model cannot be followed in time.
#[derive(Clone, Debug, PartialEq, thiserror::Error, Serialize, Deserialize)]
#[allow(missing_docs)] // the message of each names its numbers
pub enum NotInTime {
    #[error("{what} is {value}; it must be {wanted}")]
    OutOfRange { what: &'static str, value: f64, wanted: &'static str },
    #[error("{what} is not followed in time yet; follow it without, or as a path of equilibria")]
    NotCovered { what: &'static str },
    #[error(transparent)]
    Order(#[from] NoSuchOrder),
}

impl MovingMaterial {
    /// # Errors
    /// A number that is out of range.
    pub fn check(&self) -> Result<(), NotInTime> {
        let require = |what, value: f64, good: bool, wanted| {
            if good && value.is_finite() { Ok(()) } else { Err(NotInTime::OutOfRange { what, value, wanted }) }
        };
        require("the density in kg/m³", self.density, self.density >= 0.0, "zero or positive")?;
        if let Some(OpeningRate { reference, exponent }) = self.opening {
            require("the rate of opening in nm/ns", reference, reference > 0.0, "positive")?;
            let [least, most] = OpeningRate::EXPONENTS;
            require(
                "the exponent of the rate of opening",
                exponent,
                (least..=most).contains(&exponent),
                "from 0.01 to 2",
            )?;
        }
        match self.viscosity {
            Viscosity::Elastic => Ok(()),
            Viscosity::KelvinVoigt { retardation_time: time } => {
                require("the retardation time in ns", time, time > 0.0, "positive")
            }
            Viscosity::StandardLinearSolid { relaxation_time: time, stiffness_ratio: ratio } => {
                require("the relaxation time in ns", time, time > 0.0, "positive")?;
                require("the ratio E₀/E∞", ratio, ratio > 1.0, "more than 1")
            }
        }
    }
}

/// A beam in its grip that can move in time.
#[derive(Clone)]
pub struct MovingBeam {
    /// As for equilibria, on the same mesh
    pub statics: BeamProblem,
    /// What is followed in time
    pub dynamics: DynamicProblem,
}

impl MovingBeam {
    fn new(statics: BeamProblem, beam: Arc<PlanarBeam>) -> Self {
        let problem: Problem = (*statics).clone();
        Self { dynamics: DynamicProblem::new(problem, beam), statics }
    }
}

/// A planar beam that is changed before it is shared.
fn planar(statics: BeamProblem) -> MovingBeam {
    let beam = statics.beam.planar().cloned();
    let beam = beam.unwrap_or_else(|| unreachable!("a model without space is in the plane"));
    MovingBeam::new(statics, beam)
}

impl PeelModel {
    /// A strip or a spatula on flat ground, without friction, as it moves in time: with ξ = x - S, y and θ at each node and a fixed mesh, with elements
    /// everywhere that are no longer than the process zone where there are enough of them. Its free end keeps its place along the substrate.
    ///
    /// # Errors
    /// What it cannot be followed with, a number out of range.
    pub fn in_time(&self, material: &MovingMaterial, order: usize) -> Result<MovingBeam, NotInTime> {
        material.check()?;
        let not_covered = [
            (self.space.is_some(), "a body in space"),
            (!self.ground.substrate.is_flat(), "ground that is not flat"),
            (self.friction_law().is_some(), "friction"),
            (self.adhesion.shear_strength.is_some(), "a shear strength of the adhesion"),
            (!self.adhesion.healing, "an adhesion that does not heal"),
            (self.yields(), "a film that yields"),
            (!self.steps.is_empty(), "a step before the pull"),
            (self.pull.turn != 0.0, "a grip that turns as it goes"),
            (self.grip.pretension.is_some(), "a pretension"),
            (!self.material().stretch.is_linear(), "a stretch that is not linear"),
            (self.has_layers(), "layers"),
            (
                material.opening.is_some() && !self.adhesion.attraction.is_cohesive(),
                "a rate of opening of a law that is not cohesive",
            ),
        ];
        if let Some((_, what)) = not_covered.into_iter().find(|(is_there, _)| *is_there) {
            return Err(NotInTime::NotCovered { what });
        }
        let how = Discretisation::moving(Form::ThreeField, order).on(MeshKind::Graded);
        let (model, density) = (self.clone(), KG_PER_CUBIC_METRE * material.density);
        let section = move |place: f64| {
            let (section, ..) = model.section_at(place);
            let own = model.material();
            let per_stiffness = density / own.youngs_modulus;
            [per_stiffness * section.axial, per_stiffness * section.bending / own.bending_stiffness_factor]
        };
        let adhesive = material.opening.map(|rate| RateLaw { law: self.line_law(), rate });
        let profile = self.profile();
        let distance = adhesive.map(|adhesive| -> FaceDistance {
            let profile = profile.clone();
            Box::new(move |place, [gap, rotation]| adhesive.law.face_distance(profile.at(place).height, gap, rotation))
        });
        let inertia = BeamInertia { section: Box::new(section), viscosity: material.viscosity, distance };
        let statics = self.discretised(how, |beam| {
            beam.mesh.fixed_foci.push(self.touching(beam));
            beam.inertia = Some(Arc::new(inertia));
            if material.viscosity.is_viscous() || adhesive.is_some() {
                let density = ReissnerBeam { profile, law: self.line_law(), count: TiltCount::Coarse };
                beam.chain = three_field(Viscous { density, adhesive }, order, [Some(0.0), None, None]);
            }
        })?;
        Ok(planar(statics))
    }
}

impl PeelModel {
    /// Elements as long as the process zone wherever the beam may touch the ground: its front passes all of that.
    fn touching(&self, beam: &PlanarBeam) -> Focus {
        let (extent, process) = (self.contact_extent(), beam.process_length);
        if self.is_uniform() {
            return Focus::everywhere(beam.length, process);
        }
        let half = 0.5 * extent;
        Focus { center: half, length: half, weight: half / process, reach: Reach::Far }
    }
}

impl RodModel {
    /// The rod as it moves in time.
    ///
    /// # Errors
    /// What is wrong with the rod.
    pub fn in_time(&self, order: usize, inertia: BeamInertia) -> Result<MovingBeam, RodError> {
        let viscous: Option<Box<dyn Chain>> = inertia.viscosity.is_viscous().then(|| {
            let rod = ReissnerRod { section: self.section, rest: self.rest };
            three_field(Viscous::material(rod), order, self.pinned_left())
        });
        let statics = self.discretised(order, |beam| {
            beam.inertia = Some(Arc::new(inertia));
            if let Some(chain) = viscous {
                beam.chain = chain;
            }
        })?;
        Ok(planar(statics))
    }
}
