//! A model made into what the solver is given. Nothing is solved here.

use super::beam_problem::{Beam, BeamProblem};
use super::stress_free_placement::StressFreePlacement;
use crate::adhesion::friction::dahl::FrictionLaw;
use crate::adhesion::section::coverage::TiltCount;
use crate::adhesion::section::law::Law;
use crate::adhesion::section::line_load::{LineLaw, LineLoad};
use crate::adhesion::substrate::Substrate;
use crate::adhesion::substrate_response::GroundLaw;
use crate::beam::element::energy_density::{EnergyDensity, FACE};
use crate::beam::element::integrand::PlanarIntegrand;
use crate::beam::mesh::{Focus, MeshKind, MeshPolicy, Reach};
use crate::beam::planar::chain::{Chain, MOST_FIELDS};
use crate::beam::planar::density::on_ground::BeamOnGround;
use crate::beam::planar::density::reduced::ReducedBeam;
use crate::beam::planar::density::reissner::ReissnerBeam;
use crate::beam::planar::density::sheared::ShearedBeam;
use crate::beam::planar::density::yielding_film::YieldingFilm;
use crate::beam::planar::model_limits::{ModelLimits, UprightCorner, UprightPole};
use crate::beam::planar::planar_beam::{BeamMemory, PlanarBeam};
use crate::beam::planar::uniform_chain::elements::UniformChain;
use crate::beam::reference_configuration::ReferenceConfiguration;
use crate::beam::varying::{Profile, Varying};
use crate::model::ground::FLOOR_OF_STICKING;
use crate::model::peel::{Form, Hold, PeelModel};
use crate::solve::problem::{EndConditions, InitialState, MeasuredBeside, PathMeasure};
use crate::solve::state::History;
use crate::solve::system::INTERFACE;
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// How a beam is discretised.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Discretisation {
    /// Which unknowns a node has
    pub form: Form,
    /// Order p of the elements, 1 to [`Discretisation::MOST_ORDER`]
    pub order: usize,
    /// How the elements are placed
    pub mesh: MeshKind,
    /// At which ends they are small whatever the front
    pub fine: FineEnds,
}

impl Discretisation {
    /// With a mesh that follows the front.
    pub const fn moving(form: Form, order: usize) -> Self {
        Self { form, order, mesh: MeshKind::Moving, fine: FineEnds::Free }
    }

    /// The same with a mesh of another kind.
    pub const fn on(self, mesh: MeshKind) -> Self {
        Self { mesh, ..self }
    }
}

/// At which ends of a strip elements are small whatever the front.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum FineEnds {
    /// At the free end, which may come to stand on its edge.
    #[default]
    Free,
    /// At the grip as well, which may come down to the ground and adhere.
    Both,
}

/// Elements of an order that there is not.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error, Serialize, Deserialize)]
#[error("elements of order {order} do not exist; the order is 1 to {}", Discretisation::MOST_ORDER)]
pub struct NoSuchOrder {
    /// What was asked for
    pub order: usize,
}

/// Weights of the focus at an end that may adhere by itself, and at one that is bent and no more.
const AT_END: f64 = 0.8;
const WHERE_BENT: f64 = 0.2;
/// Length of the focus at the front, over that of the process zone, for a law with corners, and its weight.
///
/// Thirty sampled scenes at a quarter of 1e-6 took least time with these, 27 s on a shared machine; with weights of 3 to 12 and lengths of 1.5 to 3 they took 32 to 56 s.
const CORNERED_ZONE: f64 = 1.2;
const CORNERED_WEIGHT: f64 = 8.0;

/// Length of elements at the front of a strip that its adhesive holds, over the shear lag length: a section that turns slips by h/2 of that, which is
/// resisted over that length over √3.
const TURNING: f64 = 0.5;

/// From one remembered slip to the next, and from one remembered opening to the next, over the least length over which what happens at the front
/// changes.
const SLIP_SPACING: f64 = 1.0 / 24.0;
const OPENING_SPACING: f64 = 1.0 / 96.0;
/// Most remembered openings: each point of a path has its own.
const MOST_OPENINGS: f64 = 20_000.0;

impl PeelModel {
    /// What the solver is given, with elements of order 1 to 8 and a mesh that follows the front, of a model that [`PeelModel::check`]
    /// has nothing against. The displacement is that of the
    /// grip, whatever spring moves it. On ground that is not flat the form is [`Form::ThreeField`] and the mesh fixed; the beam is then
    /// stress-free above its ground, and `study::prepared` lets it settle there and takes the steps before the pull.
    ///
    /// # Errors
    /// Another order.
    pub fn problem(&self, form: Form, order: usize) -> Result<BeamProblem, NoSuchOrder> {
        self.discretised(Discretisation::moving(form, order), |_| {})
    }

    /// The same as `how` says, with a beam that `adjust` may change before it is shared.
    ///
    /// # Errors
    /// An order that there is not.
    pub(crate) fn discretised(
        &self,
        how: Discretisation,
        adjust: impl FnOnce(&mut PlanarBeam),
    ) -> Result<BeamProblem, NoSuchOrder> {
        how.check().map_err(|_| NoSuchOrder { order: how.order })?;
        if let Some((space, section)) = self.space.and_then(|space| Some((space, self.spatial_section(&space).ok()?))) {
            return self.spatial_problem(&space, section, how);
        }
        let form = self.form(how.form);
        let (width, height) = self.free_end();
        let (law, length, along) = (self.line_law(), self.length(), self.has_horizontal_force());
        let gap_scale = law.gap_scale();
        let lead = usize::from(form == Form::ThreeField);
        let process_length = 0.7 * self.process_length();
        let mut scale = [gap_scale; MOST_FIELDS];
        scale[lead + 1] = (gap_scale / process_length).min(1.0);
        let (front_foci, mut fixed_foci) = (self.front_foci(process_length), self.fixed_foci(process_length, how.fine));
        let rest_adhesion = width * law.rest_energy();
        let placement = match self.contour() {
            None => StressFreePlacement::flat(length, law.rest_gap()),
            Some(contour) => {
                let beam = Varying::new(contour, self.material());
                StressFreePlacement::varying(&beam, &self.adhesion, &self.ground, &front_foci, &mut fixed_foci)
            }
        };
        let profile = self.profile();
        let substrate = self.ground.substrate.clone();
        let friction = self.friction_law();
        let sticking = self.sticking_length().map(|short| FLOOR_OF_STICKING * short);
        let floors = [self.ground.floor(process_length, how.mesh), sticking];
        fixed_foci.extend(floors.into_iter().flatten().map(|floor| Focus::everywhere(length, floor)));
        let start = match placement.rest {
            ReferenceConfiguration::Curve(_) => InitialState::StressFree,
            ReferenceConfiguration::Varying(_) => InitialState::Settling,
        };
        let mut beam = PlanarBeam {
            memory: self.face_memory(&placement.rest),
            chain: match self.face_law() {
                Some(sheared) => {
                    // what is held along the ground holds the free end
                    let end = if sheared.is_sliding() { Some(0.0) } else { None };
                    let pinned_left = [end, None, None];
                    let heals = self.adhesion.healing;
                    match self.film_law() {
                        Some(yielding) => {
                            let elastic = ShearedBeam { profile, law, sheared, heals };
                            three_field(YieldingFilm { elastic, law: yielding }, how.order, pinned_left)
                        }
                        None if heals => {
                            three_field(ShearedBeam::<false> { profile, law, sheared, heals }, how.order, pinned_left)
                        }
                        None => {
                            three_field(ShearedBeam::<true> { profile, law, sheared, heals }, how.order, pinned_left)
                        }
                    }
                }
                None => chain(profile, (law, TiltCount::Coarse), (&substrate, friction), form, along, how.order),
            },
            length,
            rest: placement.rest,
            rest_gap: law.rest_gap(),
            rotation: lead + 1,
            pretension: self.grip.pretension.unwrap_or(0.0),
            stretch: self.prestretch(),
            scale,
            round_off: 0.0,
            rest_adhesion,
            fronts: placement.fronts,
            rest_front: placement.rest_front,
            mesh: MeshPolicy {
                kind: how.mesh,
                front_foci,
                edge_foci: Vec::new(),
                fixed_foci,
                pieces: placement.pieces,
            },
            process_length,
            height,
            sees_tilt: law.line_load != LineLoad::AxisGap,
            barrier: law.barrier(),
            slip_reach: self.adhesion.sheared_law().map(|law| law.slip_reach()),
            conservative: self.has_potential() && friction.is_none() && !self.yields(),
            limits: self.limits(),
            inertia: None,
            substrate,
        };
        adjust(&mut beam);
        let measure = PathMeasure {
            monitors: [beam.process_length, beam.scale[beam.rotation]],
            force: rest_adhesion.abs(),
            beside: MeasuredBeside::Nothing,
        };
        let grip = self.end_conditions(&beam);
        Ok(BeamProblem::new(Beam::Planar(Arc::new(beam)), grip, measure, start))
    }

    /// The same problem, discretised as `how` says, with tilted sections counted finely, where that is another count: a mesh follows the front by it.
    pub(crate) fn counted_finely(&self, problem: &BeamProblem, how: Discretisation) -> Option<BeamProblem> {
        let (law, substrate) = (self.line_law(), &self.ground.substrate);
        let counts = matches!(law.law, Law::BodyForce) && law.line_load != LineLoad::AxisGap;
        if !counts || self.space.is_some() || !substrate.is_flat() || self.friction_law().is_some() {
            return None;
        }
        let (form, along) = (self.form(how.form), self.has_horizontal_force());
        let counted = (law, TiltCount::Fine);
        let fine = |beam: &mut PlanarBeam| {
            beam.chain = chain(self.profile(), counted, (substrate, None), form, along, how.order);
        };
        let fine = self.discretised(how, fine).ok()?;
        Some(problem.with_beam(fine.beam))
    }

    /// The same problem in the plane, discretised as `how` says, with further places where elements are small.
    pub(crate) fn with_foci(&self, problem: &BeamProblem, how: Discretisation, foci: &[Focus]) -> Option<BeamProblem> {
        let further = |beam: &mut PlanarBeam| beam.mesh.fixed_foci.extend(foci);
        let finer = self.discretised(how, further).ok().filter(|_| self.space.is_none())?;
        Some(problem.with_beam(finer.beam))
    }

    /// Where its model ends on the way.
    fn limits(&self) -> ModelLimits {
        let one_force =
            self.has_horizontal_force() && self.ground.substrate.is_flat() && self.tangential_stiffness().is_none();
        let bonded = (one_force && self.is_uniform()).then(|| self.bonded_beam(0.0));
        let model = self.clone();
        let section = move |place| {
            let (section, width, _) = model.section_at(place);
            [section.bending, width]
        };
        let law = self.line_law();
        let pole = law.has_pole().then(|| UprightPole { law, section: Box::new(section) });
        let model = self.clone();
        let width = move |place| model.section_at(place).1;
        let smooth = pole.is_none() && self.ground.substrate.is_flat();
        let corner = smooth.then(|| UprightCorner { law, width: Box::new(width) });
        ModelLimits { bonded, pole, corner }
    }

    /// Its sections along S.
    pub(super) fn profile(&self) -> Profile {
        let (width, height) = self.free_end();
        match self.contour() {
            None => Profile::stretched(self.section(), self.material().stretch, width, height),
            Some(contour) => Profile::Varying(Varying::new(contour, self.material())),
        }
    }

    /// What the grip of a pull drives and holds.
    fn end_conditions(&self, beam: &PlanarBeam) -> EndConditions {
        let (height, rotation, across) = (beam.slot_of_height(), beam.slot_of_rotation(), beam.slot_of_x());
        let fixed = self.grip.rotation == Hold::Fixed;
        let mut held = [false; INTERFACE];
        held[rotation] = fixed;
        let mut scale = [1.0; INTERFACE];
        scale[..beam.fields()].copy_from_slice(&beam.scale[..beam.fields()]);
        if let Some(across) = across {
            held[across] = self.grip.horizontal == Hold::Fixed;
            scale[across] = beam.scale[height];
        }
        EndConditions {
            driven: height,
            across,
            direction: self.pull.direction(),
            held,
            geared: rotation,
            gear: if fixed { self.pull.turn } else { 0.0 },
            compliance: 0.0,
            origin: beam.interface_at_rest(),
            scale,
        }
    }

    /// What the lower face remembers in the stress-free configuration: that it has not slid, or has nowhere been.
    fn face_memory(&self, rest: &ReferenceConfiguration) -> BeamMemory {
        if let Some(law) = self.friction_law() {
            return BeamMemory::Slip(Arc::new(self.not_slid(rest, &law)));
        }
        if self.yields() {
            return BeamMemory::Film { heals: self.adhesion.healing };
        }
        if self.adhesion.healing {
            return BeamMemory::Nothing;
        }
        let spacing = (OPENING_SPACING * self.opening_length()).max(self.length() / MOST_OPENINGS);
        BeamMemory::Opening(Arc::new(History::even(self.length(), spacing, |_| [0.0; FACE])))
    }

    /// The lower face in the stress-free configuration, which has not slid.
    fn not_slid(&self, rest: &ReferenceConfiguration, law: &FrictionLaw) -> History {
        let face = |s: f64| {
            let ([x, gap, rotation], half) = (rest.at(s), 0.5 * self.section_at(s).2);
            let [limit, _] = law.limit(gap + half * (1.0 - rotation.cos()));
            [x + half * rotation.sin(), 0.0, limit]
        };
        History::even(self.length(), SLIP_SPACING * self.feature_length(), face)
    }

    /// Where elements are small next to the front, as if that were at S = 0. Corners of a law lie where it acts, a few
    /// process zones long.
    fn front_foci(&self, process_length: f64) -> Vec<Focus> {
        let mut foci = vec![Focus { center: 0.0, length: process_length, weight: 1.0, reach: Reach::Far }];
        if self.cuts_elements() {
            let length = CORNERED_ZONE * process_length;
            foci.push(Focus { center: 0.0, length, weight: CORNERED_WEIGHT, reach: Reach::Near });
        }
        let lag = self.adhesion.sheared_law().and_then(|_| self.shear_lag_length());
        if let Some(length) = lag.map(|lag| TURNING * lag).filter(|&length| length < process_length) {
            foci.push(Focus { center: 0.0, length, weight: 1.0, reach: Reach::Far });
        }
        foci
    }

    /// Whether elements are cut where the pieces of the law join.
    pub(crate) fn cuts_elements(&self) -> bool {
        let joins =
            !self.line_law().knots().is_empty() || self.adhesion.shear_strength.is_some() || !self.adhesion.healing;
        joins && self.ground.substrate.is_flat()
    }

    /// Where elements are small whatever the front: at the free end, which may come to stand on its edge, a wedge whose attraction
    /// is concentrated on a part of the gap scale, and at the end of a strip that may not turn there, or that steps bend before the pull.
    fn fixed_foci(&self, process_length: f64, fine: FineEnds) -> Vec<Focus> {
        let edge = (0.36 * process_length).min(0.25 * self.line_law().gap_scale());
        let mut foci = vec![Focus { center: 0.0, length: edge, weight: AT_END, reach: Reach::Far }];
        let bent = self.grip.rotation == Hold::Fixed || !self.steps.is_empty();
        let weight = match fine {
            FineEnds::Both => Some(AT_END),
            FineEnds::Free => bent.then_some(WHERE_BENT),
        };
        if let Some((strip, weight)) = self.strip().zip(weight) {
            foci.push(Focus { center: strip.length, length: process_length, weight, reach: Reach::Far });
        }
        foci
    }
}

/// The chain of a profile under a line load, with a horizontal section force or without.
fn chain(
    profile: Profile,
    (law, count): (LineLaw, TiltCount),
    (substrate, friction): (&Substrate, Option<FrictionLaw>),
    form: Form,
    pulled_along: bool,
    order: usize,
) -> Box<dyn Chain> {
    if !substrate.is_flat() || friction.is_some() {
        let ground = GroundLaw { law, substrate: substrate.clone() };
        let end = if friction.is_some() { None } else { Some(0.0) };
        return three_field(BeamOnGround { profile, ground, friction }, order, [end, None, None]);
    }
    match (form, pulled_along) {
        (Form::TwoField, false) => two_field(ReducedBeam::<false> { profile, law, count }, order),
        (Form::TwoField, true) => two_field(ReducedBeam::<true> { profile, law, count }, order),
        // held at x(0) = 0, which without a horizontal section force carries none
        (Form::ThreeField, _) => three_field(ReissnerBeam { profile, law, count }, order, [Some(0.0), None, None]),
    }
}

/// Two unknowns a node, both free at the left end.
pub(super) fn two_field(density: impl EnergyDensity<2> + 'static, order: usize) -> Box<dyn Chain> {
    let density: Box<dyn PlanarIntegrand<2>> = Box::new(density);
    if density.has_border() {
        Box::new(UniformChain::new::<true>(density, order, [None; 2]))
    } else {
        Box::new(UniformChain::new::<false>(density, order, [None; 2]))
    }
}

/// Three unknowns a node and no border; `pinned_left` holds fields of the left end where it has a value.
pub(super) fn three_field(
    density: impl EnergyDensity<3> + 'static,
    order: usize,
    pinned_left: [Option<f64>; 3],
) -> Box<dyn Chain> {
    Box::new(UniformChain::new::<false>(Box::new(density), order, pinned_left))
}
