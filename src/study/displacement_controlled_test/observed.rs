//! The entry: which models have such a test.

use super::result::Observed;
use super::run::{Course, run};
use crate::model::check::error::ModelError;
use crate::model::peel::PeelModel;
use crate::study::asked::accuracy::Accuracy;
use crate::study::asked::stop_criteria::StopCriteria;
use crate::study::terms::term_selection::checked;

/// Why a scene has no test.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum NoTest {
    /// The model, or the accuracy asked for, cannot be computed.
    #[error(transparent)]
    Model(#[from] ModelError),
    /// There is friction.
    #[error(
        "there is friction: where a strip that slides during a jump comes to rest depends on the speed of the jump, and equilibrium does not determine it"
    )]
    Friction,
    /// The load has no potential.
    #[error(
        "the load has no potential (adhesion.line_load = \"force-only\", law = \"surface-traction\" or adhesion.shear_work): the state after a loss of stability, and the energy released, are not defined"
    )]
    NoPotential,
    /// The grip takes steps before the pull.
    #[error("drive.steps has steps before the pull; the test has to begin at rest, where it also ends")]
    Steps,
    /// The adhesion does not heal.
    #[error("adhesion.healing is false: the test comes back to where it began, as a strip does that adheres again")]
    Healing,
    /// The film yields.
    #[error("strip.yield_strength is given: a film that has yielded does not come back to where the test began")]
    Yielding,
    /// The grip turns as it goes.
    #[error("drive.turn rotates the grip during the pull; the work of the machine is that of a force alone")]
    Turn,
}

impl NoTest {
    /// What to try.
    pub fn remedy(&self) -> String {
        let remedy = match self {
            Self::Model(error) => return error.remedy(),
            Self::Friction => "Omit --observed, or remove the table [friction]",
            Self::NoPotential => "Omit --observed, or use another line_load or law, or no shear_work",
            Self::Healing => "Omit --observed, or remove adhesion.healing",
            Self::Yielding => "Omit --observed, or remove strip.yield_strength",
            Self::Steps => "Omit --observed, or remove drive.steps",
            Self::Turn => "Omit --observed, or remove drive.turn",
        };
        remedy.into()
    }
}

/// Pulls the strip off and comes back, with the machine behind a spring where the grip has one.
///
/// The machine's displacement U rises from 0 until no point of the strip is nearer than 10 r0, and falls back to 0. At each
/// limit point of U on the stable path the strip jumps at that U; where it comes to rest is found by [`crate::solve::relax()`].
/// Errors: limit points as in [`crate::study::peel()`]; ∫ P dU against the energies in [`crate::study::Balance::error`], which is at most 1e-6 or
/// the accuracy asked for, or the test fails.
///
/// # Errors
/// Where the model or the accuracy cannot be computed ([`checked`]), or has no such test.
pub fn observed<'m, M>(model: &'m M, accuracy: &Accuracy, stop: &StopCriteria) -> Result<Observed, NoTest>
where
    PeelModel: From<&'m M>,
{
    let model = begun_at_rest(model.into(), accuracy)?;
    Ok(run(&model, Course::ThereAndBack, accuracy, stop))
}

/// Why [`observed()`] refuses this model, if it does. Nothing is computed.
pub fn no_test<'m, M>(model: &'m M, accuracy: &Accuracy) -> Option<NoTest>
where
    PeelModel: From<&'m M>,
{
    begun_at_rest(model.into(), accuracy).err()
}

/// The retreat of [`observed()`] alone: until the beam is off, or stands on the face of its end. What it is for is [`Observed::peeling_force`].
/// It may begin behind steps of the grip, because it does not return to them.
///
/// # Errors
/// As of [`observed()`].
pub fn observed_retreat<'m, M>(model: &'m M, accuracy: &Accuracy, stop: &StopCriteria) -> Result<Observed, NoTest>
where
    PeelModel: From<&'m M>,
{
    let model = tested(model.into(), accuracy)?;
    Ok(run(&model, Course::There, accuracy, stop))
}

/// As [`tested`], if the test begins at rest.
fn begun_at_rest(model: PeelModel, accuracy: &Accuracy) -> Result<PeelModel, NoTest> {
    let model = tested(model, accuracy)?;
    if model.steps.is_empty() { Ok(model) } else { Err(NoTest::Steps) }
}

/// The model that is computed, in the plane where it stays there, if it has a test.
fn tested(model: PeelModel, accuracy: &Accuracy) -> Result<PeelModel, NoTest> {
    let model = model.in_the_plane().unwrap_or(model);
    checked(&model, accuracy)?;
    if model.friction_law().is_some() {
        return Err(NoTest::Friction);
    }
    if !model.adhesion.healing {
        return Err(NoTest::Healing);
    }
    if model.yields() {
        return Err(NoTest::Yielding);
    }
    if !model.has_potential() {
        return Err(NoTest::NoPotential);
    }
    if model.pull.turn != 0.0 {
        return Err(NoTest::Turn);
    }
    Ok(model)
}
