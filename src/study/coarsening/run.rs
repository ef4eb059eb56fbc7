//! A table under way, and the spatula itself, which can be solved at a place of a tip.

use super::columns::{BranchStart, Columns, TipSheet};
use super::held_spatula::HeldSpatula;
use super::options::{CoarseningError, CoarseningOptions, HeldError, PadEnd, TipPlace, TipResponse, refuse};
use super::refine::{Grid, Refined, Wanted, refined};
use super::table::TipTable;
use crate::beam::planar::planar_beam::FRONT;
use crate::model::peel::PeelModel;
use crate::study::asked::stop_criteria::{Bound, Stage, StopCriteria};

/// A spatula whose table is made.
pub struct Coarsening {
    model: PeelModel,
    options: CoarseningOptions,
    attached: Columns,
    attached_grid: Grid,
    /// What the detached branch has; none before the largest force is known.
    detached: Option<Columns>,
    detached_grid: Grid,
    rest_energy: f64,
    rest_adhering: f64,
    stop: StopCriteria,
    most_nodes: usize,
}

/// The force at which the detached branch begins, over the tolerance times the largest force.
const NEGLECTED: f64 = 0.25;
/// The most that it is, over the force with which that branch ends.
const OF_LIMIT: f64 = 0.25;
/// A pad that adheres over more than this share of what it does at rest has not come off.
const STILL_ADHERES: f64 = 0.5;
/// How far away the detached branch is begun, over the length of the spatula, beside what its rotation takes.
const AWAY: f64 = 0.5;

/// Computes the table of a tip.
///
/// # Errors
/// Options or a model that it cannot be computed of; a place at which the spatula was not solved.
pub fn coarsen(model: &PeelModel, options: &CoarseningOptions) -> Result<TipTable, CoarseningError> {
    Coarsening::new(model, options)?.table()
}

impl Coarsening {
    /// Of a model, at rest.
    ///
    /// # Errors
    /// Options or a model that a table cannot be computed of.
    pub fn new(model: &PeelModel, options: &CoarseningOptions) -> Result<Self, CoarseningError> {
        Self::until(model, options, &StopCriteria::default())
    }

    /// The same, which ends when what the caller knows says so: the time, an interruption. Other criteria are those of a path.
    ///
    /// # Errors
    /// Options or a model that a table cannot be computed of; a criterion that was met.
    pub fn until(model: &PeelModel, options: &CoarseningOptions, stop: &StopCriteria) -> Result<Self, CoarseningError> {
        options.check()?;
        refuse(model)?;
        let rested = HeldSpatula::new(model, options.pad_end, options.tolerance, stop.for_solves(Stage::Path))
            .and_then(|spatula| spatula.rest().map(|rest| (spatula, rest)));
        let (spatula, rest) = rested.map_err(|why| stopped(why, stop, [0; 2]))?;
        let lateral = if options.pad_end == PadEnd::Held { options.range.lateral } else { [0.0; 2] };
        let rotation = options.range.rotation;
        Ok(Self {
            model: model.clone(),
            options: *options,
            rest_energy: rest.solution.energy,
            rest_adhering: rest.solution.observables.monitors[FRONT],
            attached: Columns::new(BranchStart::Attached { spatula, rest, press: options.range.press }),
            attached_grid: Grid::new(lateral, rotation),
            detached: None,
            detached_grid: Grid::new([0.0; 2], rotation),
            stop: stop.clone(),
            most_nodes: usize::MAX,
        })
    }

    /// The same, whose table has no more nodes than these along a branch: where it would take more, there is none.
    pub(crate) fn with_most_nodes(self, most_nodes: usize) -> Self {
        Self { most_nodes, ..self }
    }

    /// The table, refined to the tolerance; what was computed before is not computed again.
    ///
    /// # Errors
    /// A place at which the spatula was not solved; a branch that ends while much of the pad still adheres; a criterion that was met.
    pub fn table(&mut self) -> Result<TipTable, CoarseningError> {
        self.whole_table().map_err(|why| {
            let of = |count: fn(&Columns) -> usize| count(&self.attached) + self.detached.as_ref().map_or(0, count);
            stopped(why, &self.stop, [of(Columns::len), of(Columns::nodes)])
        })
    }

    fn whole_table(&mut self) -> Result<TipTable, HeldError> {
        let CoarseningOptions { tolerance, most_columns, .. } = self.options;
        let wanted = Wanted { tolerance, most_columns, most_nodes: self.most_nodes };
        let Refined { sheet: attached, errors: attached_errors, scales } =
            refined(&mut self.attached, &mut self.attached_grid, wanted, None)?;
        for (at, node) in attached.table().limits() {
            if node.adhering > STILL_ADHERES * self.rest_adhering {
                let (adhering, rest) = (node.adhering, self.rest_adhering);
                return Err(HeldError::StillAdheres { at, adhering, rest });
            }
        }
        let mut free = match self.detached.take() {
            Some(known) => known,
            None => self.far_away(NEGLECTED * tolerance * scales.force)?,
        };
        let found = refined(&mut free, &mut self.detached_grid, wanted, Some(scales));
        let neglected_force = free.start().force();
        let (columns, equilibria) = (self.attached.len() + free.len(), self.attached.nodes() + free.nodes());
        self.detached = Some(free);
        let Refined { sheet: detached, errors: detached_errors, .. } = found?;
        Ok(TipTable {
            options: self.options,
            attached,
            detached,
            attached_errors,
            detached_errors,
            scales,
            neglected_force,
            rest_energy: self.rest_energy,
            columns,
            equilibria,
        })
    }

    /// Where the detached branch begins, from far away: with this force, or less where that is more than a part of what it ends with.
    fn far_away(&self, most: f64) -> Result<Columns, HeldError> {
        let should_stop = self.stop.for_solves(Stage::Path);
        let spatula = HeldSpatula::new(&self.model, PadEnd::Sliding, self.options.tolerance, should_stop)?;
        let [from, to] = self.options.range.rotation;
        let far = spatula.lifted((AWAY + from.abs().max(to.abs())) * self.model.length())?;
        let mut force = most;
        for rotation in [from, 0.0, to] {
            force = force.min(OF_LIMIT * BranchStart::force_at_limit(&spatula, &far, rotation)?);
        }
        Ok(Columns::new(BranchStart::Detached { spatula, far, force }))
    }

    /// Solves the spatula itself with its end at a place, on a branch, whether the table holds it or not.
    ///
    /// # Errors
    /// The spatula has no stable equilibrium there on this branch, or it was not found.
    pub fn resolve(&self, on: TipSheet, place: TipPlace) -> Result<TipResponse, HeldError> {
        let columns = match (on, &self.detached) {
            (TipSheet::Detached, Some(detached)) => detached,
            (TipSheet::Detached, None) => return Err(HeldError::NoTable),
            (TipSheet::Attached, _) => &self.attached,
        };
        let start = columns.start();
        let mut ws = start.spatula().workspace();
        let state = start.column(place.lateral, place.rotation)?.state(start.spatula(), place.normal, &mut ws)?;
        start.spatula().response(&state.solution.at, &mut ws).map_err(|cause| HeldError::NotReached {
            from: place,
            to: place,
            reached: place,
            cause,
        })
    }

    /// Where its attached branch begins.
    pub(super) fn into_attached(self) -> BranchStart {
        self.attached.into_start()
    }
}

/// Why there is no table behind so many columns and equilibria.
fn stopped(why: HeldError, stop: &StopCriteria, [columns, equilibria]: [usize; 2]) -> CoarseningError {
    match why {
        HeldError::Stopped => {
            let bound = stop.reached_bound(Stage::Path).unwrap_or(Bound::Interrupted);
            CoarseningError::Stopped { bound, columns, equilibria }
        }
        why => why.into(),
    }
}
