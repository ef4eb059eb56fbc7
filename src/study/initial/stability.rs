//! Whether a model has a stable state to start from: by the criterion of what is bonded, before anything is solved, and by the
//! negative eigenvalues of the equilibrium where the path would start.

use super::error::UnstableRest;
use super::loading_steps::elements;
use super::step_jump::{FINER, UPRIGHT, with_x, without_x};
use crate::beam::bonded_beam::{BondedBeam, BondedMode};
use crate::model::peel::{Adhesion, Hold, PeelModel};
use crate::model::problem::beam_problem::BeamProblem;
use crate::model::problem::build::Discretisation;
use crate::solve::newton::Solution;
use crate::solve::path::equilibrium_path::Path;
use crate::solve::path::options::{PathError, PathOptions};
use crate::solve::path::predictor::MOST_POINTS;
use crate::solve::relax::{Held, RelaxError, RelaxOptions, disturbed_anyhow, relax};
use crate::solve::state::State;
use crate::solve::workspace::{ShouldStop, Workspace};
use serde::{Deserialize, Serialize};
use std::f64::consts::FRAC_PI_2;
use std::sync::Arc;

/// A start that was unstable: the beam was relaxed from there to a stable equilibrium.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct RelaxedStart {
    /// Negative eigenvalues of the equilibrium that it left
    pub negative: usize,
    /// Energy that it released on the way, aJ
    pub released: f64,
}

/// Places at which the sections of a beam of varying outline are looked at.
const PLACES: usize = 64;
/// Waves on a bonded beam that are those of an infinite one.
const WAVES: f64 = 2.0;
/// Error of the equilibrium whose eigenvalues are counted.
const ROUGH: f64 = 1e-9;
/// Most that a step of relaxation moves, relative as in [`crate::solve::System::size`], and most steps. Strips whose free
/// end turns up and comes to rest take some tens; those that have not by then tilt along all of their length, and have not in 1000.
const RELAXING: f64 = 0.1;
const MOST_STEPS: usize = 200;

/// Refuses a model whose bonded sections tilt in bulk: where θ = cos(πS/2ℓ), with y = 0 and from a free end to where sections are held at
/// S = ℓ, has a negative energy. Of a strip in a grip that is free to turn that is GA_s < m, of any length.
pub(super) fn check_bonded(model: &PeelModel) -> Result<(), UnstableRest> {
    if !model.ground.substrate.is_flat() {
        return Ok(());
    }
    let (softening, resistance) = match model.strip() {
        Some(strip) => {
            let beam = model.bonded_beam(0.0);
            let held = (model.grip.rotation == Hold::Fixed).then_some(strip.length);
            (beam.softening, beam.tilt_resistance(model.grip.pretension.unwrap_or(0.0), held))
        }
        None => over_the_pad(model),
    };
    // what friction holds by its lower face bends over twice its height
    let sticks = model.tangential_stiffness().is_some() && model.grip.rotation == Hold::Fixed;
    let ratio = softening / resistance;
    if sticks || softening <= resistance {
        return Ok(());
    }
    Err(UnstableRest::Tilting { softening, resistance, shear: model.section().shear, ratio })
}

/// Softening and resistance of a beam of varying outline, over what lies on the ground in its stress-free configuration: means with the weights
/// of that mode.
fn over_the_pad(model: &PeelModel) -> (f64, f64) {
    let length = model.contact_extent();
    let weighted = |part: usize| {
        let share = (part as f64 + 0.5) / PLACES as f64;
        let (sin, cos) = (FRAC_PI_2 * share).sin_cos();
        let beam = model.bonded_beam(share * length);
        let bending = beam.section.bending * (FRAC_PI_2 / length).powi(2) * sin * sin;
        [beam.softening * cos * cos, beam.section.shear * cos * cos + bending]
    };
    let mean = |index: usize| (0..PLACES).map(|part| weighted(part)[index]).sum::<f64>() * 2.0 / PLACES as f64;
    (mean(0), mean(1))
}

/// Lets a path that would start in an unstable equilibrium start in the stable one to which the beam relaxes from there, if there is one.
pub(super) fn stabilise(
    model: &PeelModel,
    how: Discretisation,
    problem: &mut BeamProblem,
    should_stop: &Option<ShouldStop>,
) -> Result<Option<RelaxedStart>, UnstableRest> {
    if !problem.system.is_conservative() && problem.beam.planar().is_none_or(|beam| beam.limits.pole.is_none()) {
        return Ok(None);
    }
    let first = match first(model, problem, should_stop) {
        Ok(first) => first,
        Err(_) => return near_face_alone(model, how, should_stop).map_or(Ok(None), Err),
    };
    let upright_in = |at: &State| problem.beam.planar().and_then(|beam| beam.upright_section(at, UPRIGHT));
    if let Some(upright) = upright_in(&first.at) {
        return Err(UnstableRest::Upright(upright));
    }
    let negative = first.negative;
    if negative == 0 || !problem.system.is_conservative() {
        return Ok(None);
    }
    let beam = model.bonded_beam(0.0);
    let force = model.grip.pretension.unwrap_or(0.0);
    let flat = model.is_uniform() && model.ground.substrate.is_flat();
    if flat && let Some(wrinkles) = wrinkles(model, &beam, force, negative) {
        return Err(wrinkles);
    }
    let failed = |cause| {
        let ratio = beam.ratio(BondedMode::FreeEnd, force);
        UnstableRest::NotRelaxed { negative, ratio, cause }
    };
    let at = relaxed(model, how, problem, &first, should_stop)
        .map_err(|cause| near_face_alone(model, how, should_stop).unwrap_or_else(|| failed(cause)))?;
    if let Some(upright) = upright_in(&at) {
        return Err(UnstableRest::Upright(upright));
    }
    let energy = |at: &State| {
        let direction = vec![0.0; problem.system.unknowns(at)];
        problem.system.evaluate(at, &direction).0.energy
    };
    let released = energy(&first.at) - energy(&at);
    problem.start_at(Arc::new(at));
    problem.settles();
    Ok(Some(RelaxedStart { negative, released }))
}

/// That the whole of a long strip wrinkles.
fn wrinkles(model: &PeelModel, beam: &BondedBeam, force: f64, negative: usize) -> Option<UnstableRest> {
    let ratio = beam.ratio(BondedMode::Wrinkling, force);
    let wavelength = beam.wavelength(force).filter(|wave| ratio >= 1.0 && model.length() > WAVES * wave)?;
    Some(UnstableRest::Wrinkling { softening: beam.softening, ratio, wavelength, negative })
}

/// The equilibrium in which the path would start, on few elements.
fn first(
    model: &PeelModel,
    problem: &BeamProblem,
    should_stop: &Option<ShouldStop>,
) -> Result<Arc<Solution>, PathError> {
    let options = PathOptions {
        elements: elements(model, problem),
        tolerance: ROUGH,
        prediction: MOST_POINTS,
        first_displacement: model.first_way(),
        ..PathOptions::default()
    };
    Path::new(problem, options).until(should_stop.clone()).advance()
}

/// The stable equilibrium downhill from an unstable one, with the grip where it is. A beam whose horizontal force is a multiplier
/// has no energy that falls: it is relaxed with x at every node.
fn relaxed(
    model: &PeelModel,
    how: Discretisation,
    problem: &BeamProblem,
    first: &Solution,
    should_stop: &Option<ShouldStop>,
) -> Result<State, RelaxError> {
    let with_x = with_x(model, how, problem);
    let (falling, start) = match &with_x {
        None => (problem, first.at.clone()),
        Some(with_x) => (with_x, with_x.initial(first.at.mesh.elements())),
    };
    let displacement = falling.displacement(&start);
    let mut ws = Workspace::until(should_stop.clone());
    let mut at_rest = |from: State| {
        let options = RelaxOptions { most_steps: MOST_STEPS, ..RelaxOptions::by(RELAXING) };
        relax(falling, from, Held::Displacement(displacement), &options, &mut ws).map(|relaxed| relaxed.solution.at)
    };
    let at = at_rest(disturbed_anyhow(falling, &start))?;
    let finer = falling.system.on_elements(&at, FINER * at.mesh.elements());
    let at = at_rest(finer)?;
    Ok(match &with_x {
        Some(with_x) => without_x(problem, at, with_x),
        None => at,
    })
}

/// That the pole of the near face is why a beam does not settle in a stable state: with both faces it does.
fn near_face_alone(model: &PeelModel, how: Discretisation, should_stop: &Option<ShouldStop>) -> Option<UnstableRest> {
    if !model.line_law().has_pole() {
        return None;
    }
    let adhesion = Adhesion { far_face: true, ..model.adhesion };
    let both = PeelModel { adhesion, ..model.clone() };
    let problem = both.discretised(how, |_| {}).ok()?;
    let rest = first(&both, &problem, should_stop).ok().filter(|rest| rest.negative == 0)?;
    let beam = problem.beam.planar()?;
    let rotations = beam.nodes(&rest.at.values).iter().skip(beam.rotation).step_by(beam.fields());
    let steepest = rotations.fold(0.0f64, |most, rotation| most.max(rotation.sin().abs()));
    Some(UnstableRest::NearFaceAlone { steepest: steepest.asin().to_degrees() })
}
