//! The pull-off of a seta by a table that grows: where a tip comes to rest outside of the table, the spatula is solved there, and the pull-off is repeated
//! with the wider table, until no tip leaves it.

use super::error::CoarseningError;
use super::options::TipRange;
use super::run::Coarsening;
use super::seta_tip::TableLaw;
use super::table::TipTable;
use super::visited::Visited;
use crate::model::{SetaError, SetaModel, Sideways, TipLaw};
use crate::study::{SetaEnd, SetaLoading, SetaOptions, SetaPullOff, StopCriteria, pull_off};
use std::sync::Arc;

/// Pull-offs, at most.
const MOST_ROUNDS: usize = 6;

/// A pull-off and the table that its tips follow.
#[derive(Clone, Debug)]
pub struct PullOffByTable {
    /// The pull-off by the last table
    pub pull_off: SetaPullOff,
    /// The last table
    pub table: Arc<TipTable>,
    /// What each table gave, the last one included
    pub rounds: Vec<TableRound>,
}

/// A pull-off by one of the tables.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TableRound {
    /// What the table holds
    pub range: TipRange,
    /// Where the tips have been
    pub visited: Visited,
    /// Largest force along the last step, nN
    pub peak_force: Option<f64>,
}

impl PullOffByTable {
    /// Whether every tip stayed within the table.
    pub fn is_inside(&self) -> bool {
        self.rounds.last().is_some_and(|round| round.visited.outside == 0)
    }

    /// By how much the places outside of the first table have changed the peak force, nN.
    pub fn changed(&self) -> Option<f64> {
        Some(self.rounds.last()?.peak_force? - self.rounds.first()?.peak_force?)
    }
}

/// Why there is no pull-off by a table.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ByTableError {
    /// The table
    #[error("{0}")]
    Table(#[from] CoarseningError),
    /// The seta
    #[error("{0}")]
    Seta(#[from] SetaError),
}

/// Pulls off the seta that `of` makes of the law of its tips. The table is made, and grows as tips leave it.
///
/// # Errors
/// A table that cannot be made as wide as the tips ask for; a seta that cannot be computed. Where tips are still outside after six tables, the result
/// says so.
pub fn pull_off_by_table(
    coarsening: &mut Coarsening,
    (of, sideways): (&dyn Fn(Arc<dyn TipLaw>) -> SetaModel, Sideways),
    (loading, options): (&SetaLoading, &SetaOptions),
    stop: &StopCriteria,
) -> Result<PullOffByTable, ByTableError> {
    let mut rounds: Vec<TableRound> = Vec::new();
    loop {
        let table = Arc::new(coarsening.table()?);
        let law = TableLaw::new(table.clone(), sideways);
        let pull_off = pull_off(&of(Arc::new(law.clone())), loading, options, stop)?;
        let visited = law.visited();
        let peak_force = pull_off.peak.as_ref().map(|peak| peak.point.force_along);
        rounds.push(TableRound { range: table.options.range, visited, peak_force });
        let is_stopped = matches!(pull_off.end, SetaEnd::Bound(_));
        if visited.outside == 0 || is_stopped || rounds.len() == MOST_ROUNDS {
            return Ok(PullOffByTable { pull_off, table, rounds });
        }
        coarsening.grow_to(&visited);
    }
}
