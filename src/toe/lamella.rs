//! A lamella: a band on rows of setae, pulled at one of them.
//!
//! ```text
//!      P                x = pitch · (row - at)
//!      ↑  overhang
//!      o----------o-------o-------o-------o---  band, EI and EA
//!                 |       |       |       |     rows of setae, from 0 on
//!             ========================================
//! ```
//!
//! Rows stand a pitch apart. All setae of a row move as one: the band bends along its length alone. Its turns are small, so that what happens
//! behind the first tenths of a radian is left to the closed form of a peeling tape.

use super::chain::{BandSection, Chain};
use super::cluster::Cluster;
use super::events::{ArrayEvent, ArrayFailure, Followed, LoadedArray};
use super::law::{RootLaw, RootLawError};
use super::scatter::{RootOffset, Scatter};
use nalgebra::Vector3;

/// What grows, at the place that is pulled.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ArrayDrive {
    /// A force at an angle to the ground, rad: 90 degrees lift.
    Force {
        /// From the band's direction towards its rows on
        angle: f64,
    },
    /// A moment that turns the end off the ground.
    Moment,
    /// A moment that presses the end and lifts what is behind it.
    Press,
}

impl ArrayDrive {
    /// Its force along the ground and off it, and its moment, for a load of one.
    pub(crate) fn unit(&self) -> Vector3<f64> {
        match self {
            // a right angle is exact: nothing then pulls along the ground
            Self::Force { angle } if *angle == std::f64::consts::FRAC_PI_2 => Vector3::new(0.0, 1.0, 0.0),
            Self::Force { angle } => Vector3::new(angle.cos(), angle.sin(), 0.0),
            Self::Moment => Vector3::new(0.0, 0.0, -1.0),
            Self::Press => Vector3::new(0.0, 0.0, 1.0),
        }
    }
}

/// A band on rows of setae.
#[derive(Clone, Debug, PartialEq)]
pub struct Lamella {
    /// How many rows
    pub rows: usize,
    /// Setae in a row
    pub columns: usize,
    /// From row to row, nm
    pub pitch: f64,
    /// Of the band
    pub section: BandSection,
    /// Of a seta
    pub law: RootLaw,
    /// How setae differ
    pub scatter: Scatter,
    /// Band in front of row 0 without setae, nm
    pub overhang: f64,
    /// Row at which it is pulled; none: at the end of the overhang
    pub pulled_at: Option<usize>,
}

/// An array that cannot be followed.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[allow(missing_docs)] // the message of each names its numbers
pub enum ArrayError {
    #[error(transparent)]
    Law(#[from] RootLawError),
    #[error("the {name} of the array is {value}: give a finite number above zero")]
    NotPositive { name: &'static str, value: f64 },
    #[error("the array has {rows} rows of {columns} setae: give at least {least} rows, and setae in each")]
    TooFew { rows: usize, columns: usize, least: usize },
    #[error("the array has {setae} setae, which need {megabytes} MB: give fewer, {most} at most")]
    TooMany { setae: usize, megabytes: usize, most: usize },
    #[error("the band is pulled at row {}, of {rows}: give one that it has", .row + 1)]
    NoSuchRow { row: usize, rows: usize },
    #[error("the scatter of strengths is {scatter}: give at least 0 and less than 1, or setae hold nothing")]
    StrengthScatter { scatter: f64 },
    #[error(
        "{unattached} of {setae} setae do not adhere at the start, with heights of ±{height} nm and a reach of {reach:.6} nm: give a smaller scatter of heights, or press by at least {press:.6} nm"
    )]
    Unattached { unattached: usize, setae: usize, height: f64, reach: f64, press: f64 },
    #[error(
        "the force of the law of a seta is not linear in the place of its root: a band takes a potential of degree 2; fit one"
    )]
    NotLinear,
    #[error(
        "the law of a seta carries no force along the ground, and the array is pulled along it: give setae a stiffness there, or lift at 90 degrees"
    )]
    NoShear,
    #[error(transparent)]
    Failed(#[from] ArrayFailure),
}

/// Most setae, with what one needs in bytes.
const MOST_SETAE: usize = 10_000_000;
const BYTES_A_SETA: usize = 200;

impl Lamella {
    /// What of it cannot be followed.
    ///
    /// # Errors
    /// The first number that is none.
    pub fn check(&self) -> Result<(), ArrayError> {
        self.law.check()?;
        checked_size(self.rows, self.columns, 2)?;
        let numbers = [("pitch", self.pitch), ("EI", self.section.bending), ("EA", self.section.axial)];
        for (name, value) in numbers {
            if !(value.is_finite() && value > 0.0) {
                return Err(ArrayError::NotPositive { name, value });
            }
        }
        if !(self.overhang.is_finite() && self.overhang >= 0.0) {
            return Err(ArrayError::NotPositive { name: "overhang", value: self.overhang });
        }
        if let Some(row) = self.pulled_at
            && row >= self.rows
        {
            return Err(ArrayError::NoSuchRow { row, rows: self.rows });
        }
        if !self.law.is_linear() {
            return Err(ArrayError::NotLinear);
        }
        checked_scatter(&self.scatter)?;
        let offsets = (0..self.rows * self.columns).map(|number| self.scatter.of(number));
        checked_start(&self.law, offsets, self.scatter.height, 0.0)
    }

    /// Its events as the load grows, beside a load (nN, nN, nN nm) that stays at the same place.
    ///
    /// # Errors
    /// What [`Lamella::check`] refuses; what cannot be followed.
    pub fn follow(&self, drive: ArrayDrive, stays: [f64; 3], most: usize) -> Result<Followed, ArrayError> {
        self.follow_until(drive, stays, most, &|| false)
    }

    /// The same, until it is stopped.
    ///
    /// # Errors
    /// As of [`Lamella::follow`].
    pub(crate) fn follow_until(
        &self,
        drive: ArrayDrive,
        stays: [f64; 3],
        most: usize,
        stopped: &dyn Fn() -> bool,
    ) -> Result<Followed, ArrayError> {
        self.check()?;
        checked_shear(&self.law, drive, stays)?;
        let (array, pulled) = self.array();
        Ok(array.loaded(pulled, drive.unit(), stays).follow(most, stopped)?)
    }

    /// Forces along the ground and off it on each row, under a load of one along the ground at the row `sheared`, and off it where it is pulled.
    ///
    /// # Errors
    /// What [`Lamella::check`] refuses, and a singular stiffness.
    pub(crate) fn shares(&self, sheared: usize) -> Result<Vec<[f64; 2]>, ArrayError> {
        self.check()?;
        let (mut array, pulled) = self.array();
        let node = (0..array.chain.nodes()).find(|&node| array.clusters[node].is_some() && array.rows[node] == sheared);
        let node = node.ok_or(ArrayError::NoSuchRow { row: sheared, rows: self.rows })?;
        let along = array.places_under(&[(node, Vector3::x())])?;
        let off = array.places_under(&[(pulled, Vector3::y())])?;
        let mut out = vec![[0.0; 2]; self.rows];
        for node in 0..array.chain.nodes() {
            if let Some(cluster) = &array.clusters[node] {
                let force = |place: &Vector3<f64>| cluster.response([place.x, place.y]).force;
                let rest = cluster.response([0.0; 2]).force;
                out[array.rows[node]] = [force(&along[node])[0] - rest[0], force(&off[node])[1] - rest[1]];
            }
        }
        Ok(out)
    }

    /// The angle of its load to the ground, rad, up to which each row holds F_n <= F_s tan α: tan φ = tan α · min s/n over the rows that are
    /// lifted. It is sheared at a row, and lifted where it is pulled.
    ///
    /// # Errors
    /// As of `Lamella::shares`; a law without stiffness along the ground.
    pub fn critical_angle(&self, of_a_seta: f64, sheared: usize) -> Result<f64, ArrayError> {
        if !self.law.carries_shear() {
            return Err(ArrayError::NoShear);
        }
        let shares = self.shares(sheared)?;
        let least = shares.iter().filter(|[_, normal]| *normal > 0.0).map(|[shear, normal]| shear / normal);
        Ok((of_a_seta.tan() * least.fold(f64::INFINITY, f64::min)).atan())
    }

    /// Force of a row over its place, all of it adhering, nN/nm.
    pub fn row_stiffness(&self) -> [[f64; 2]; 2] {
        self.law.stiffness().map(|row| row.map(|own| own * self.columns as f64))
    }

    /// The node on which a row stands: those behind where it is pulled from the far end, then those before it from the front.
    pub(super) fn node_of(&self, row: usize) -> usize {
        let front = usize::from(self.overhang > 0.0);
        let (place, count) = (row + front, self.rows + front);
        let pulled = self.pulled_at.map_or(0, |row| row + front);
        if place > pulled { count - 1 - place } else { count - 1 - pulled + place }
    }

    /// Nodes from the far end to where it is pulled, which is the root: rows before and behind it are two branches.
    fn array(&self) -> (LoadedArray, usize) {
        let with_overhang = self.overhang > 0.0;
        // places along the band, by place from the front
        let mut places: Vec<(f64, Option<usize>)> =
            (0..self.rows).map(|row| (row as f64 * self.pitch, Some(row))).collect();
        if with_overhang {
            places.insert(0, (-self.overhang, None));
        }
        let pulled = self.pulled_at.map_or(0, |row| row + usize::from(with_overhang));
        let count = places.len();
        let mut order: Vec<usize> = (pulled + 1..count).rev().collect();
        order.extend(0..=pulled);
        let mut node_of = vec![0; count];
        order.iter().enumerate().for_each(|(node, &place)| node_of[place] = node);
        let mut chain = Chain::of_nodes(count);
        for &place in &order[..count - 1] {
            let towards = if place > pulled { place - 1 } else { place + 1 };
            chain.join(node_of[place], node_of[towards], places[towards].0 - places[place].0, &self.section);
        }
        let row_of = |place: usize| places[place].1;
        let cluster = |row: usize| {
            let setae = (0..self.columns).map(|column| self.scatter.of(row * self.columns + column)).collect();
            Cluster::new(&self.law, setae)
        };
        let clusters = order.iter().map(|&place| row_of(place).map(cluster)).collect();
        let rows = order.iter().map(|&place| row_of(place).unwrap_or(0)).collect();
        let mut array = LoadedArray::new(chain, clusters, rows);
        array.held_along = (!self.law.carries_shear()).then(|| (count - 1, self.section.axial / self.pitch));
        (array, count - 1)
    }
}

/// Sheet of each seta, row by row, after events.
pub(crate) fn sheets_after(rows: usize, columns: usize, events: &[ArrayEvent]) -> Vec<u8> {
    let mut on = vec![0; rows * columns];
    for event in events {
        event.setae.iter().for_each(|&seta| on[event.row * columns + seta as usize] = event.sheets[1] as u8);
    }
    on
}

/// Enough setae, and not more than a machine holds.
pub(super) fn checked_size(rows: usize, columns: usize, least: usize) -> Result<(), ArrayError> {
    if rows < least || columns == 0 {
        return Err(ArrayError::TooFew { rows, columns, least });
    }
    let setae = rows.saturating_mul(columns);
    if setae > MOST_SETAE {
        let megabytes = setae.saturating_mul(BYTES_A_SETA) / 1_000_000;
        return Err(ArrayError::TooMany { setae, megabytes, most: MOST_SETAE });
    }
    Ok(())
}

/// No load along the ground on setae that carry none.
pub(super) fn checked_shear(law: &RootLaw, drive: ArrayDrive, stays: [f64; 3]) -> Result<(), ArrayError> {
    let is_sheared = drive.unit().x != 0.0 || stays[0] != 0.0;
    if is_sheared && !law.carries_shear() { Err(ArrayError::NoShear) } else { Ok(()) }
}

/// Strengths above zero.
pub(super) fn checked_scatter(scatter: &Scatter) -> Result<(), ArrayError> {
    if !(0.0..1.0).contains(&scatter.strength) {
        return Err(ArrayError::StrengthScatter { scatter: scatter.strength });
    }
    if !(scatter.height.is_finite() && scatter.height >= 0.0) {
        return Err(ArrayError::NotPositive { name: "scatter of heights", value: scatter.height });
    }
    Ok(())
}

/// All setae, whose heights are within ± `height` (nm), adhering when the roots are pressed by so much (nm).
pub(super) fn checked_start(
    law: &RootLaw,
    offsets: impl ExactSizeIterator<Item = RootOffset>,
    height: f64,
    press: f64,
) -> Result<(), ArrayError> {
    let Some(first) = law.sheet(0, 1.0) else { return Ok(()) };
    let (normal, setae) = (first.exit.direction[1], offsets.len());
    let (mut unattached, mut needed) = (0, 0.0f64);
    for own in offsets {
        // u·d at the start, beyond where it lets go; the exit itself belongs to what is loaded
        let beyond = (-press - own.height) * normal - own.strength * first.exit.distance;
        if beyond > 0.0 {
            unattached += 1;
            needed = needed.max(press + beyond / normal);
        }
    }
    if unattached == 0 {
        return Ok(());
    }
    let reach = first.exit.distance / normal;
    Err(ArrayError::Unattached { unattached, setae, height, reach, press: needed })
}
