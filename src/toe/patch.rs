//! A patch: rows and columns of setae on a rigid backing that moves without turning.
//!
//! Roots move as one along straight steps, so what holds them is one polynomial between two events: the force, its largest value and the work
//! are exact. A backing that is a dome of radius R presses the setae in the middle first: a seta at r from there stands r²/2R lower than its
//! place, which is a height like any other.

use super::cluster::Cluster;
use super::events::{ASKED, ArrayEnd, ArrayEvent};
use super::lamella::{ArrayError, checked_scatter, checked_size, checked_start};
use super::law::RootLaw;
use super::scatter::{RootOffset, Scatter};
use crate::study::coarsening::seta_law::law::dot;

/// The face that carries the roots.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Backing {
    /// A plane along the ground.
    #[default]
    Flat,
    /// A sphere, for places r much smaller than its radius.
    Dome {
        /// R, nm
        radius: f64,
    },
}

/// A straight way of the roots.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PatchStep {
    /// From the direction along the ground, rad: 90 degrees lift
    pub angle: f64,
    /// How far, nm; none: until all are detached
    pub distance: Option<f64>,
}

/// Setae on a rigid backing.
#[derive(Clone, Debug, PartialEq)]
pub struct Patch {
    /// How many rows
    pub rows: usize,
    /// Setae in a row
    pub columns: usize,
    /// From seta to seta, nm
    pub pitch: f64,
    /// What carries them
    pub backing: Backing,
    /// Of a seta
    pub law: RootLaw,
    /// How setae differ
    pub scatter: Scatter,
    /// How far the backing is pressed at the start, nm: all setae have to adhere there
    pub press: f64,
    /// What it does then
    pub steps: Vec<PatchStep>,
}

/// The events of a patch. The row of an event is that of its first seta; its setae are numbered over the whole patch.
#[derive(Clone, Debug, PartialEq)]
pub struct PatchFollowed {
    /// In their order; their lift is the way so far, their load the force along the step
    pub events: Vec<ArrayEvent>,
    /// Force along and off the ground before each
    pub forces: Vec<[f64; 2]>,
    /// Place of the backing at each, nm
    pub places: Vec<[f64; 2]>,
    /// The event at which the normal force is largest
    pub peak: usize,
    /// Where it ends
    pub end: ArrayEnd,
    /// Largest force along the step, between events as well, nN
    pub largest_load: f64,
    /// Stored at the end less at the start, plus what was released, aJ: the work of the backing
    pub work: f64,
    /// Released in events, aJ
    pub released: f64,
}

impl Patch {
    /// Follows the steps, every event.
    ///
    /// # Errors
    /// A law, a size or a scatter that is none, and setae that do not adhere at the start.
    pub fn follow(&self) -> Result<PatchFollowed, ArrayError> {
        self.follow_until(&|| false)
    }

    /// The same, until it is stopped.
    ///
    /// # Errors
    /// As of [`Patch::follow`].
    pub(crate) fn follow_until(&self, stopped: &dyn Fn() -> bool) -> Result<PatchFollowed, ArrayError> {
        self.check()?;
        let mut cluster = Cluster::new(&self.law, self.offsets());
        let mut place = [0.0, -self.press];
        let start = cluster.response(place).energy;
        let mut out = PatchFollowed {
            events: Vec::new(),
            forces: Vec::new(),
            places: Vec::new(),
            peak: 0,
            end: ArrayEnd::Detached,
            largest_load: f64::NEG_INFINITY,
            work: 0.0,
            released: 0.0,
        };
        let (mut way, mut reached) = (0.0, f64::NEG_INFINITY);
        for step in &self.steps {
            let direction = unit(step.angle);
            let mut left = step.distance.unwrap_or(f64::INFINITY);
            while cluster.adhering() > 0 {
                if out.events.len().is_multiple_of(ASKED) && stopped() {
                    out.end = ArrayEnd::Stopped;
                    break;
                }
                let next = cluster.next(place, direction);
                // what one event brings beyond its exit goes at once, at the same place
                let ahead = next.map_or(f64::INFINITY, |next| next.ahead.max(0.0)).min(left);
                if ahead.is_infinite() {
                    out.end = ArrayEnd::NoFurtherExit;
                    break;
                }
                out.largest_load = out.largest_load.max(largest_along(&cluster, place, direction, ahead));
                place = [place[0] + ahead * direction[0], place[1] + ahead * direction[1]];
                (way, left) = (way + ahead, left - ahead);
                let Some(next) = next.filter(|next| next.ahead.max(0.0) <= ahead) else { break };
                let before = cluster.response(place);
                let setae = cluster.change(&next);
                let released = cluster.released(&setae, &next, place);
                let after = cluster.response(place);
                out.released += released;
                let row = setae.first().map_or(0, |&seta| seta as usize / self.columns);
                let load = dot(before.force, direction);
                out.events.push(ArrayEvent {
                    row,
                    setae,
                    sheets: [next.from, next.to],
                    lift: way,
                    load,
                    load_after: dot(after.force, direction),
                    released,
                    work: before.energy - start + out.released - released,
                    adhering: cluster.adhering(),
                    starts_jump: way > reached,
                });
                reached = reached.max(way);
                out.forces.push(before.force);
                out.places.push(place);
            }
        }
        if out.end == ArrayEnd::Detached && cluster.adhering() > 0 {
            out.end = ArrayEnd::Events;
        }
        out.work = cluster.response(place).energy - start + out.released;
        let largest = |a: &usize, b: &usize| out.forces[*a][1].total_cmp(&out.forces[*b][1]).then(b.cmp(a));
        out.peak = (0..out.events.len()).max_by(largest).unwrap_or(0);
        Ok(out)
    }

    /// Force of each seta off the ground just before an event, nN, and its sheet.
    pub(crate) fn loads(&self, followed: &PatchFollowed, event: usize) -> Vec<(u8, f64)> {
        let mut on = vec![0u8; self.rows * self.columns];
        for event in &followed.events[..event] {
            event.setae.iter().for_each(|&seta| on[seta as usize] = event.sheets[1] as u8);
        }
        let place = followed.places.get(event).copied().unwrap_or([0.0, -self.press]);
        let force = |(offset, &sheet): (RootOffset, &u8)| {
            let own = self.law.sheet(usize::from(sheet), offset.strength);
            let at = [place[0], place[1] - offset.height];
            (sheet, own.map_or(0.0, |own| own.potential.response(at).force[1]))
        };
        self.offsets().into_iter().zip(&on).map(force).collect()
    }

    /// What of it cannot be followed.
    ///
    /// # Errors
    /// The first number that is none, and setae that do not adhere at the start.
    pub fn check(&self) -> Result<(), ArrayError> {
        self.law.check()?;
        checked_size(self.rows, self.columns, 1)?;
        let radius = if let Backing::Dome { radius } = self.backing { radius } else { 1.0 };
        for (name, value) in [("pitch", self.pitch), ("radius of the dome", radius)] {
            if !(value.is_finite() && value > 0.0) {
                return Err(ArrayError::NotPositive { name, value });
            }
        }
        if !(self.press.is_finite() && self.press >= 0.0) {
            return Err(ArrayError::NotPositive { name: "press", value: self.press });
        }
        checked_scatter(&self.scatter)?;
        // heights of the dome take reach like those of the setae
        let offsets = self.offsets();
        let height = match self.backing {
            Backing::Flat => self.scatter.height,
            Backing::Dome { .. } => offsets.iter().map(|own| own.height.abs()).fold(0.0, f64::max),
        };
        checked_start(&self.law, offsets.into_iter(), height, self.press)
    }

    fn offsets(&self) -> Vec<RootOffset> {
        let middle = [0.5 * (self.rows as f64 - 1.0), 0.5 * (self.columns as f64 - 1.0)];
        let of = |number: usize| {
            let mut own = self.scatter.of(number);
            if let Backing::Dome { radius } = self.backing {
                let x = (number / self.columns) as f64 - middle[0];
                let z = (number % self.columns) as f64 - middle[1];
                own.height -= (x * x + z * z) * self.pitch * self.pitch / (2.0 * radius);
            }
            own
        };
        (0..self.rows * self.columns).map(of).collect()
    }
}

/// The largest force along a straight way without events. It is a cubic in the way: its slope vanishes at most twice.
fn largest_along(cluster: &Cluster, from: [f64; 2], direction: [f64; 2], ahead: f64) -> f64 {
    let at = |s: f64| cluster.response([from[0] + s * direction[0], from[1] + s * direction[1]]);
    let slope = |s: f64| {
        let k = at(s).stiffness;
        dot(direction, [dot(k[0], direction), dot(k[1], direction)])
    };
    let load = |s: f64| dot(at(s).force, direction);
    // the slope is a parabola through three of its values
    let (a, m, b) = (slope(0.0), slope(0.5 * ahead), slope(ahead));
    let (c2, c1) = (2.0 * (a + b - 2.0 * m), 4.0 * m - 3.0 * a - b);
    let mut out = load(0.0).max(load(ahead));
    let root = (c1 * c1 - 4.0 * c2 * a).sqrt();
    let q = -0.5 * (c1 + root.copysign(c1));
    for share in [q / c2, a / q] {
        if share > 0.0 && share < 1.0 {
            out = out.max(load(share * ahead));
        }
    }
    out
}

/// A direction; along and off the ground it is exact.
fn unit(angle: f64) -> [f64; 2] {
    if angle == std::f64::consts::FRAC_PI_2 { [0.0, 1.0] } else { [angle.cos(), angle.sin()] }
}
