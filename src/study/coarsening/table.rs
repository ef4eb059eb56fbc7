//! The table of a tip: both branches of a spatula, with their errors and where they come from.

use super::columns::TipSheet;
use super::options::{CoarseningOptions, TipPlace, TipResponse};
use super::refine::{SheetErrors, TipScales};
use super::sheet::Sheet;

/// The table of a tip.
#[derive(Clone, Debug)]
pub struct TipTable {
    /// How it was made
    pub options: CoarseningOptions,
    /// The branch on which the pad adheres
    pub attached: Sheet,
    /// The branch on which it does not
    pub detached: Sheet,
    /// How wrong the attached branch is
    pub attached_errors: SheetErrors,
    /// How wrong the detached branch is
    pub detached_errors: SheetErrors,
    /// What errors are measured by
    pub scales: TipScales,
    /// The normal force at which the detached branch begins, nN: farther away it is taken to be zero
    pub neglected_force: f64,
    /// E where the attached branch has no normal force at v = 0 and θ = 0, aJ
    pub rest_energy: f64,
    /// Columns that were followed, those that check among them
    pub columns: usize,
    /// Equilibria of nodes and between them
    pub equilibria: usize,
}

impl TipTable {
    /// Whether both branches are as accurate as was asked.
    pub fn is_met(&self) -> bool {
        [self.attached_errors, self.detached_errors].iter().all(|errors| errors.relative <= self.options.tolerance)
    }

    /// The larger of the relative errors of the branches.
    pub fn relative_error(&self) -> f64 {
        self.attached_errors.relative.max(self.detached_errors.relative)
    }

    /// Nodes of both branches: the rows of the table.
    pub fn rows(&self) -> usize {
        self.attached.table().nodes.len() + self.detached.table().nodes.len()
    }

    /// A branch.
    pub fn sheet(&self, on: TipSheet) -> &Sheet {
        match on {
            TipSheet::Attached => &self.attached,
            TipSheet::Detached => &self.detached,
        }
    }

    /// How wrong a branch is.
    pub fn errors(&self, on: TipSheet) -> &SheetErrors {
        match on {
            TipSheet::Attached => &self.attached_errors,
            TipSheet::Detached => &self.detached_errors,
        }
    }

    /// Whether a detached tip is so far away that its force is neglected: from there it falls off to zero.
    pub(crate) fn is_far(&self, place: TipPlace) -> bool {
        place.normal > self.detached.ends(place)[0]
    }

    /// Whether the table holds a place, on a branch.
    pub fn contains(&self, on: TipSheet, place: TipPlace) -> bool {
        self.sheet(on).contains(place) || (on == TipSheet::Detached && self.is_far(place))
    }

    /// Energy, forces and stiffness on a branch, which goes on a little beyond its limit point. Outside of the table, see
    /// [`TipTable::contains`], it is an extrapolation.
    pub fn response(&self, on: TipSheet, place: TipPlace) -> TipResponse {
        self.sheet(on).response(place)
    }

    /// The branch on which a tip is that has been on `before`: at its limit point it snaps over to the other.
    pub fn branch(&self, before: TipSheet, place: TipPlace) -> TipSheet {
        match before {
            TipSheet::Attached if self.attached.is_beyond(place) => TipSheet::Detached,
            TipSheet::Detached if self.detached.is_beyond(place) => TipSheet::Attached,
            same => same,
        }
    }

    /// Energy that is released where an attached tip snaps off, at the limit point of v and θ, aJ.
    pub fn released(&self, place: TipPlace) -> f64 {
        let limit = self.attached.limit(place);
        let at = TipPlace { normal: limit.normal, ..place };
        limit.energy - self.response(TipSheet::Detached, at).energy
    }
}
