//! The pull-off of a seta by a table that grows: where a tip comes to rest outside of the table, the spatula is solved there, and the pull-off is repeated
//! with the wider table, until no tip leaves it.

use super::near_end::{NearEnd, Visited};
use super::options::{CoarseningError, CoarseningOptions, HeldError, TipRange};
use super::run::Coarsening;
use super::table::TipTable;
use super::tip_in_space::TableLaw;
use crate::model::peel::PeelModel;
use crate::model::seta::check::SetaError;
use crate::model::seta::normal_pull::Sideways;
use crate::model::seta::parameters::SetaModel;
use crate::model::seta::tip_law::TipLaw;
use crate::study::asked::stop_criteria::{Bound, StopCriteria};
use crate::study::seta::loading::{SetaLoading, SetaOptions};
use crate::study::seta::result::{SetaEnd, SetaPullOff};
use crate::study::seta::run::pull_off;
use crate::study::states::seta_state::SetaPoint;
use serde::{Deserialize, Serialize};
use std::fmt;
use std::sync::Arc;

/// Nodes along a branch of a table that grows, at most, or twice as many as the first one has.
const MOST_NODES: usize = 120;
/// Pull-offs, at most.
const MOST_ROUNDS: usize = 6;

/// The table of a spatula, which grows as the tips of a seta leave it. The table of a range is the same however the range came about.
#[derive(Clone, Debug)]
pub struct GrowingTable {
    spatula: PeelModel,
    table: Arc<TipTable>,
    /// What the tables before this one gave
    rounds: Vec<TableRound>,
    /// Nodes along a branch, at most
    most_nodes: usize,
    /// When it stops growing
    stop: StopCriteria,
    /// The spatula near the end of its branch, once no tip leaves the table
    near_end: Option<Arc<NearEnd>>,
}

/// What follows a pull-off by a table.
#[derive(Clone, Debug, PartialEq)]
pub enum AfterRound {
    /// Nothing: no tip left the table, or it was stopped.
    Done,
    /// Another one: the table has grown.
    Again,
    /// Nothing: tips are outside of the table, and it does not grow any more.
    Outside(OutsideTable),
    /// Nothing: tips are outside of the table, and this criterion was met before it had grown.
    Stopped(Bound),
}

impl GrowingTable {
    /// Of a spatula, as wide and as accurate as the options say.
    ///
    /// # Errors
    /// Those of the table.
    pub fn new(spatula: &PeelModel, options: &CoarseningOptions) -> Result<Self, CoarseningError> {
        Self::until(spatula, options, &StopCriteria::default())
    }

    /// The same, as long as what the caller knows does not say that it is to stop; nor does it grow then.
    ///
    /// # Errors
    /// Those of the table; a criterion that was met.
    pub(crate) fn until(
        spatula: &PeelModel,
        options: &CoarseningOptions,
        stop: &StopCriteria,
    ) -> Result<Self, CoarseningError> {
        let table = Coarsening::until(spatula, options, stop)?.table()?;
        Ok(Self { stop: stop.clone(), ..Self::of(spatula, Arc::new(table)) })
    }

    /// Of a table of this spatula that is there already.
    pub fn of(spatula: &PeelModel, table: Arc<TipTable>) -> Self {
        let most_nodes = MOST_NODES.max(2 * table.attached.table().path.len());
        Self {
            spatula: spatula.clone(),
            table,
            rounds: Vec::new(),
            most_nodes,
            stop: StopCriteria::default(),
            near_end: None,
        }
    }

    /// The same, which no longer grows once what the caller knows says so.
    pub fn growing_until(self, stop: &StopCriteria) -> Self {
        Self { stop: stop.clone(), ..self }
    }

    /// The same whose seta is pulled off once more when no tip leaves the table, with the spatula itself at the tips that are nearer than this to
    /// the end of their attached branch, nm.
    ///
    /// # Errors
    /// Those of the spatula.
    pub fn resolved(self, within: f64) -> Result<Self, CoarseningError> {
        let near_end = NearEnd::new(&self.spatula, &self.table, within)?;
        Ok(Self { near_end: Some(Arc::new(near_end)), ..self })
    }

    /// The same behind these pull-offs of an earlier run.
    ///
    /// # Errors
    /// Those of the table.
    pub fn behind(self, rounds: Vec<TableRound>) -> Result<Self, CoarseningError> {
        let table = match rounds.last() {
            None => self.table,
            Some(last) if last.visited.outside.is_empty() => self.of_range(last.range)?,
            Some(last) => self.wider(last)?,
        };
        Ok(Self { table, rounds, ..self })
    }

    /// The table as it is now.
    pub fn table(&self) -> &Arc<TipTable> {
        &self.table
    }

    /// What pull-offs gave so far.
    pub fn rounds(&self) -> &[TableRound] {
        &self.rounds
    }

    /// The law of the tips by the table as it is now.
    pub fn law(&self, sideways: Sideways) -> TableLaw {
        let law = TableLaw::new(self.table.clone(), sideways);
        match self.resolving() {
            Some(near_end) => law.resolved(near_end.clone()),
            None => law,
        }
    }

    /// The spatula of the tips near the end of their branch, in the next pull-off: once none of them leaves the table.
    fn resolving(&self) -> Option<&Arc<NearEnd>> {
        let is_due = |last: &TableRound| last.within.is_some() || last.visited.outside.is_empty();
        self.near_end.as_ref().filter(|_| self.rounds.last().is_some_and(is_due))
    }

    /// The table of a range, which was there before.
    fn of_range(&self, range: TipRange) -> Result<Arc<TipTable>, CoarseningError> {
        if self.table.options.range == range {
            return Ok(self.table.clone());
        }
        let options = CoarseningOptions { range, ..self.table.options };
        let table = Coarsening::until(&self.spatula, &options, &self.stop)?.with_most_nodes(self.most_nodes).table()?;
        Ok(Arc::new(table))
    }

    /// A table with room for where tips have been outside of the last one: for all of it, or where the spatula cannot be followed so far, for one of
    /// how far they are pressed and how far they turn.
    fn wider(&self, last: &TableRound) -> Result<Arc<TipTable>, CoarseningError> {
        let known = last.range;
        let whole = last.visited.widened(&known);
        let deeper = TipRange { press: whole.press, ..known };
        let turned = TipRange { press: known.press, ..whole };
        let mut why = None;
        for range in [Some(whole), Some(turned).filter(|_| deeper != known), Some(deeper).filter(|_| turned != known)] {
            let Some(range) = range.filter(|range| *range != known) else { continue };
            let options = CoarseningOptions { range, ..self.table.options };
            let wider = Coarsening::until(&self.spatula, &options, &self.stop);
            match wider.and_then(|wider| wider.with_most_nodes(self.most_nodes).table()) {
                Ok(table) => return Ok(Arc::new(table)),
                Err(stopped @ CoarseningError::Stopped { .. }) => return Err(stopped),
                Err(other) => why = why.or(Some(other)),
            }
        }
        Err(why.unwrap_or(CoarseningError::Held(HeldError::NoTable)))
    }

    /// Takes note of a pull-off by the table as it is, with where outside of it the tips have been, and grows where they have.
    pub fn after(&mut self, pull_off: &SetaPullOff, visited: Visited) -> AfterRound {
        let peak_force = pull_off.peak.as_ref().map(|peak| peak.point.force_along);
        let is_inside = visited.outside.is_empty();
        let within = self.resolving().map(|near_end| near_end.within());
        let round =
            TableRound { range: self.table.options.range, rows: self.table.rows(), within, visited, peak_force };
        self.rounds.push(round);
        if is_inside && within.is_none() && self.near_end.is_some() && matches!(pull_off.end, SetaEnd::Completed) {
            return AfterRound::Again;
        }
        if is_inside || matches!(pull_off.end, SetaEnd::Bound(_)) {
            return AfterRound::Done;
        }
        let outside = |end: TableEnd| AfterRound::Outside(OutsideTable::new(pull_off, &self.rounds, end));
        if self.rounds.len() >= MOST_ROUNDS {
            return outside(TableEnd::Rounds);
        }
        match self.rounds.last().map(|last| self.wider(last)) {
            Some(Ok(table)) => self.table = table,
            Some(Err(CoarseningError::Stopped { bound, .. })) => return AfterRound::Stopped(bound),
            Some(Err(why)) => return outside(TableEnd::Spatula(why)),
            None => {}
        }
        AfterRound::Again
    }

    /// By how much the places outside of the first table have changed the peak force, nN.
    pub fn changed(&self) -> Option<f64> {
        Some(self.last_by_table()?.peak_force? - self.rounds.first()?.peak_force?)
    }

    /// By how much the spatulae at the tips near the end of their branch have changed the peak force, nN; none where there were none.
    pub fn changed_by_resolved(&self) -> Option<f64> {
        let last = self.rounds.last().filter(|last| last.within.is_some())?;
        Some(last.peak_force? - self.last_by_table()?.peak_force?)
    }

    /// The last pull-off in which all tips followed the table.
    fn last_by_table(&self) -> Option<&TableRound> {
        self.rounds.iter().rfind(|round| round.within.is_none())
    }

    /// Whether every tip stayed within the last table.
    pub fn is_inside(&self) -> bool {
        self.rounds.last().is_some_and(|round| round.visited.outside.is_empty())
    }

    /// Rows that places outside of the first table have added to it.
    pub fn added(&self) -> usize {
        self.rounds.first().map_or(0, |first| self.table.rows().saturating_sub(first.rows))
    }
}

/// Pulls off the seta that `of` makes of the law of its tips. The table grows as tips leave it, and keeps what each of the pull-offs gave.
///
/// # Errors
/// A seta that cannot be computed.
pub fn pull_off_by_table(
    growing: &mut GrowingTable,
    (of, sideways): (&dyn Fn(Arc<dyn TipLaw>) -> SetaModel, Sideways),
    (loading, options): (&SetaLoading, &SetaOptions),
    stop: &StopCriteria,
) -> Result<(SetaPullOff, AfterRound), SetaError> {
    loop {
        let law = growing.law(sideways);
        let pull_off = pull_off(&of(Arc::new(law.clone())), loading, options, stop)?;
        match growing.after(&pull_off, law.visited()) {
            AfterRound::Again => {}
            after => return Ok((pull_off, after)),
        }
    }
}

// -- What is known of a pull-off in which tips have been outside of their table, and the table does not grow any more --
//
// A seta whose tips slide remembers nothing but which of them adhere. So an equilibrium in which all tips are within the table is one of the
// seta, with these tips; which tips adhere there is known as far as the tips that were outside before have kept their hold, or lost it, as
// those of the extrapolation did.

/// Why a table does not grow any more.
#[derive(Clone, Debug, PartialEq)]
pub enum TableEnd {
    /// As many pull-offs were computed as are.
    Rounds,
    /// The spatula cannot be followed to where tips have been.
    Spatula(CoarseningError),
}

/// Where a tip was outside of its table.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OutsideAt {
    /// Number of the step of the loading, from 0
    pub step: usize,
    /// How far the root has moved in it, nm
    pub displacement: f64,
}

impl From<&SetaPoint> for OutsideAt {
    fn from(point: &SetaPoint) -> Self {
        Self { step: point.step, displacement: point.displacement }
    }
}

impl fmt::Display for OutsideAt {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(f, "{:.1} nm of step {}", self.displacement, self.step + 1)
    }
}

/// Tips that have been outside of their table in the last pull-off.
#[derive(Clone, Debug, PartialEq)]
pub struct OutsideTable {
    /// How many
    pub tips: usize,
    /// How many pull-offs were computed, each with its table
    pub rounds: usize,
    /// By how much one was pressed farther than where the table begins, at most, nm
    pub pressed: f64,
    /// The smallest and the largest θ, rad, where they are outside of the range of the table
    pub rotation: Option<[f64; 2]>,
    /// The first and the last equilibrium with a tip outside
    pub between: Option<[OutsideAt; 2]>,
    /// Whether all tips are within the table at the peak and at the equilibria before and behind it
    pub peak_is_inside: bool,
    /// Why the table does not grow
    pub end: TableEnd,
}

impl OutsideTable {
    /// Of the last of these pull-offs.
    pub(super) fn new(pull_off: &SetaPullOff, rounds: &[TableRound], end: TableEnd) -> Self {
        let (visited, range) = rounds.last().map(|last| (last.visited.clone(), last.range)).unzip();
        let visited = visited.unwrap_or_default();
        let [from, to] = visited.rotation;
        let is_turned = range.is_some_and(|range| from < range.rotation[0] || to > range.rotation[1]);
        let points = &pull_off.points;
        let is_outside = |point: &&SetaPoint| point.outside > 0;
        let first = points.iter().find(is_outside);
        let between = first.zip(points.iter().rfind(is_outside));
        let peak = pull_off.peak.as_ref().and_then(|peak| points.iter().position(|point| *point == peak.point));
        let about = |peak: usize| &points[peak.saturating_sub(1)..(peak + 2).min(points.len())];
        Self {
            tips: visited.outside.len(),
            rounds: rounds.len(),
            pressed: visited.pressed,
            rotation: is_turned.then_some(visited.rotation),
            between: between.map(|(first, last)| [first.into(), last.into()]),
            peak_is_inside: peak.is_some_and(|peak| about(peak).iter().all(|point| point.outside == 0)),
            end,
        }
    }
}

impl OutsideTable {
    /// What outputs call it.
    pub fn code(&self) -> &'static str {
        if self.peak_is_inside { "outside-table" } else { "peak-outside-table" }
    }
}

impl fmt::Display for OutsideTable {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let Self { tips, rounds, pressed, .. } = self;
        write!(f, "{tips} tips were outside of the last of {rounds} tables")?;
        if let Some([first, last]) = &self.between {
            write!(f, ", from {first} to {last}")?;
        }
        if *pressed > 0.0 {
            write!(f, ", up to {pressed:.1} nm below where it begins")?;
        }
        if let Some([from, to]) = self.rotation {
            write!(f, ", with θ from {from:.4} to {to:.4} rad")?;
        }
        f.write_str(": their forces there are extrapolated")?;
        if let TableEnd::Spatula(why) = &self.end {
            write!(f, ", as no wider table can be made: {why}")?;
        }
        f.write_str(match self.peak_is_inside {
            true => ". At the peak all tips are within the table: it is that of the tips that adhere there. Which tips adhere there, and where, is as if those that were outside had kept their hold; that is not known",
            false => ". At the peak, or next to it, there are such tips: it is not known",
        })
    }
}

/// A pull-off by one of the tables.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct TableRound {
    /// What the table holds
    pub range: TipRange,
    /// Nodes of the table
    pub rows: usize,
    /// From how far before the end of their branch tips were solved as spatulae, nm; none: all by the table
    pub within: Option<f64>,
    /// Where outside of it the tips have been
    pub visited: Visited,
    /// Largest force along the last step, nN
    pub peak_force: Option<f64>,
}
