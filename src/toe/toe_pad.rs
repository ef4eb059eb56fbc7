//! A toe: a pad whose branches are lamellae.
//!
//! ```text
//!      P
//!      ↑
//!      o==========o==========o==========o     pad, one node a lamella, a pitch apart
//!   ---+---    ---+---    ---+---    ---+---  lamellae, joined at one of their rows, or rigid
//!    | | |      | | |      | | |      | | |   rows of setae
//!  ==========================================
//! ```
//!
//! Lamellae lie one behind the other; where one is joined to the pad it moves and turns with it. All is one tree.

use super::chain::{BandSection, Chain};
use super::cluster::Cluster;
use super::events::{Followed, LoadedArray};
use super::lamella::{ArrayDrive, ArrayError, Lamella, checked_shear, checked_size};

/// A pad on lamellae.
#[derive(Clone, Debug, PartialEq)]
pub struct Toe {
    /// How many
    pub lamellae: usize,
    /// From one to the next, nm
    pub pitch: f64,
    /// Of the pad
    pub pad: BandSection,
    /// Each of them; where it is pulled stands in `joined_at`
    pub lamella: Lamella,
    /// Row at which a lamella is joined to the pad; none: it is rigid, and its setae stand on the pad's node
    pub joined_at: Option<usize>,
}

impl Toe {
    /// What of it cannot be followed.
    ///
    /// # Errors
    /// The first number that is none.
    pub fn check(&self) -> Result<(), ArrayError> {
        self.lamella.check()?;
        checked_size(self.lamellae, self.lamella.rows * self.lamella.columns, 2)?;
        for (name, value) in [
            ("pitch of the lamellae", self.pitch),
            ("EI of the pad", self.pad.bending),
            ("EA of the pad", self.pad.axial),
        ] {
            if !(value.is_finite() && value > 0.0) {
                return Err(ArrayError::NotPositive { name, value });
            }
        }
        match self.joined_at {
            Some(row) if row >= self.lamella.rows => Err(ArrayError::NoSuchRow { row, rows: self.lamella.rows }),
            _ => Ok(()),
        }
    }

    /// Its events as the load at its first, distal node grows. Rows count on from lamella to lamella; a rigid lamella is one row.
    ///
    /// # Errors
    /// What [`Toe::check`] refuses; what cannot be followed.
    pub fn follow(&self, drive: ArrayDrive, stays: [f64; 3], most: usize) -> Result<Followed, ArrayError> {
        self.follow_until(drive, stays, most, &|| false)
    }

    /// The same, until it is stopped.
    ///
    /// # Errors
    /// As of [`Toe::follow`].
    pub(crate) fn follow_until(
        &self,
        drive: ArrayDrive,
        stays: [f64; 3],
        most: usize,
        stopped: &dyn Fn() -> bool,
    ) -> Result<Followed, ArrayError> {
        self.check()?;
        checked_shear(&self.lamella.law, drive, stays)?;
        let (array, distal) = self.array();
        Ok(array.loaded(distal, drive.unit(), stays).follow(most, stopped)?)
    }

    /// Rows over all lamellae, and setae in each.
    pub(crate) fn size(&self) -> [usize; 2] {
        match self.joined_at {
            Some(_) => [self.lamellae * self.lamella.rows, self.lamella.columns],
            None => [self.lamellae, self.lamella.rows * self.lamella.columns],
        }
    }

    /// The node on which a row stands.
    pub(super) fn node_of(&self, row: usize) -> usize {
        let rows = self.size()[0] / self.lamellae;
        let (joined, branch, lamella, own) = (self.joined_at.unwrap_or(0), rows - 1, row / rows, row % rows);
        match own.cmp(&joined) {
            std::cmp::Ordering::Greater => lamella * branch + rows - 1 - own,
            std::cmp::Ordering::Less => lamella * branch + rows - 1 - joined + own,
            std::cmp::Ordering::Equal => self.lamellae * branch + self.lamellae - 1 - lamella,
        }
    }

    /// Branches first, each from its ends to where it is joined, then the pad from its far end to the distal one.
    fn array(&self) -> (LoadedArray, usize) {
        let [all_rows, columns] = self.size();
        let (rows, band) = (all_rows / self.lamellae, &self.lamella);
        let joined = self.joined_at.unwrap_or(0);
        let pad_of = |lamella: usize| self.node_of(lamella * rows + joined);
        let mut chain = Chain::of_nodes(self.lamellae * rows);
        let mut row_of = vec![0; self.lamellae * rows];
        for lamella in 0..self.lamellae {
            let node = |row: usize| self.node_of(lamella * rows + row);
            for row in (0..rows).filter(|&row| row != joined) {
                let towards = if row > joined { row - 1 } else { row + 1 };
                chain.join(node(row), node(towards), (towards as f64 - row as f64) * band.pitch, &band.section);
                row_of[node(row)] = lamella * rows + row;
            }
            row_of[pad_of(lamella)] = lamella * rows + joined;
            if lamella > 0 {
                chain.join(pad_of(lamella), pad_of(lamella - 1), -self.pitch, &self.pad);
            }
        }
        let cluster = |&row: &usize| {
            let setae = (0..columns).map(|column| band.scatter.of(row * columns + column)).collect();
            Some(Cluster::new(&band.law, setae))
        };
        let clusters = row_of.iter().map(cluster).collect();
        let distal = chain.nodes() - 1;
        let mut array = LoadedArray::new(chain, clusters, row_of);
        array.held_along = (!band.law.carries_shear()).then(|| (distal, self.pad.axial / self.pitch));
        (array, distal)
    }
}
