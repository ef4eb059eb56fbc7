//! The pull-off of a seta by a table that grows: where a tip comes to rest outside of the table, the spatula is solved there, and the pull-off is repeated
//! with the wider table, until no tip leaves it.

use super::error::CoarseningError;
use super::options::{CoarseningOptions, TipRange};
use super::run::coarsen;
use super::seta_tip::TableLaw;
use super::table::TipTable;
use super::visited::Visited;
use crate::model::{PeelModel, SetaError, SetaModel, Sideways, TipLaw};
use crate::study::{SetaEnd, SetaLoading, SetaOptions, SetaPullOff, StopCriteria, pull_off};
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// Pull-offs, at most.
const MOST_ROUNDS: usize = 6;

/// The table of a spatula, which grows as the tips of a seta leave it. The table of a range is the same however the range came about.
#[derive(Clone, Debug)]
pub struct GrowingTable {
    spatula: PeelModel,
    table: Arc<TipTable>,
    /// What the tables before this one gave
    rounds: Vec<TableRound>,
}

/// A pull-off by one of the tables.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct TableRound {
    /// What the table holds
    pub range: TipRange,
    /// Nodes of the table
    pub rows: usize,
    /// Where outside of it the tips have been
    pub visited: Visited,
    /// Largest force along the last step, nN
    pub peak_force: Option<f64>,
}

/// What follows a pull-off by a table.
#[derive(Clone, Debug, PartialEq)]
pub enum AfterRound {
    /// Nothing: no tip left the table, or it was stopped.
    Done,
    /// Another one: the table has grown.
    Again,
    /// Nothing: tips are outside of the table, and it does not grow any more, for want of rounds or for this reason.
    Outside(Option<CoarseningError>),
}

impl GrowingTable {
    /// Of a spatula, as wide and as accurate as the options say.
    ///
    /// # Errors
    /// Those of the table.
    pub fn new(spatula: &PeelModel, options: &CoarseningOptions) -> Result<Self, CoarseningError> {
        Ok(Self::of(spatula, Arc::new(coarsen(spatula, options)?)))
    }

    /// Of a table of this spatula that is there already.
    pub fn of(spatula: &PeelModel, table: Arc<TipTable>) -> Self {
        Self { spatula: spatula.clone(), table, rounds: Vec::new() }
    }

    /// The same behind these pull-offs of an earlier run.
    ///
    /// # Errors
    /// Those of the table.
    pub fn behind(self, rounds: Vec<TableRound>) -> Result<Self, CoarseningError> {
        let table = match rounds.last() {
            None => self.table,
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
        TableLaw::new(self.table.clone(), sideways)
    }

    fn wider(&self, last: &TableRound) -> Result<Arc<TipTable>, CoarseningError> {
        let range = last.visited.widened(&last.range);
        Ok(Arc::new(coarsen(&self.spatula, &CoarseningOptions { range, ..self.table.options })?))
    }

    /// Takes note of a pull-off by the table as it is, with where outside of it the tips have been, and grows where they have.
    pub fn after(&mut self, pull_off: &SetaPullOff, visited: Visited) -> AfterRound {
        let peak_force = pull_off.peak.as_ref().map(|peak| peak.point.force_along);
        let is_inside = visited.outside.is_empty();
        let round = TableRound { range: self.table.options.range, rows: self.table.rows(), visited, peak_force };
        self.rounds.push(round);
        if is_inside || matches!(pull_off.end, SetaEnd::Bound(_)) {
            return AfterRound::Done;
        }
        if self.rounds.len() >= MOST_ROUNDS {
            return AfterRound::Outside(None);
        }
        match self.rounds.last().map(|last| self.wider(last)) {
            Some(Ok(table)) => self.table = table,
            Some(Err(why)) => return AfterRound::Outside(Some(why)),
            None => {}
        }
        AfterRound::Again
    }

    /// By how much the places outside of the first table have changed the peak force, nN.
    pub fn changed(&self) -> Option<f64> {
        Some(self.rounds.last()?.peak_force? - self.rounds.first()?.peak_force?)
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
