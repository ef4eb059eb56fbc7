//! An array under a load in proportion, followed from event to event.
//!
//! Between two events the places of all nodes lie on a line, q = h + P g: g of the load that grows, h of what stays. So the next event is the
//! least of as many divisions as there are rows, and nothing is searched or iterated. The lift is what does work with the load: along a line it
//! grows, and the load with it, or falls where setae soften. After a seta is lost the next event may lie below the lift that was reached.
//! Then it comes at once under a held lift: the events from one such lift to the next are a jump.

use super::chain::Chain;
use super::cluster::{Cluster, NextExit};
use crate::study::coarsening::seta_law::law::RootResponse;
use nalgebra::{Matrix3, Vector3};
use serde::{Deserialize, Serialize};

/// More changes than this times the setae and their sheets are a circle.
const MOST_CHANGES: usize = 4;
/// Events from one balance of energies to the next.
const BALANCED: usize = 256;
/// Events after which it is asked whether to stop.
pub(crate) const ASKED: usize = 64;

/// Setae change their sheet.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ArrayEvent {
    /// Row whose setae they are
    pub row: usize,
    /// Their numbers in it, more than one where they are equal
    pub setae: Vec<u32>,
    /// Sheet that they leave, and the one that they reach; the number of sheets is the detached one
    pub sheets: [usize; 2],
    /// Work-conjugate of the load, nm or rad
    pub lift: f64,
    /// Load before it, nN or nN nm
    pub load: f64,
    /// Load after it at the same lift
    pub load_after: f64,
    /// Energy that it releases at a held lift, aJ
    pub released: f64,
    /// Work of the load up to it, aJ
    pub work: f64,
    /// How many setae adhere after it
    pub adhering: usize,
    /// Whether it comes at a lift above all before: a jump starts
    pub starts_jump: bool,
}

/// Where the events end.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum ArrayEnd {
    /// No seta adheres
    Detached,
    /// What adheres cannot hold the band: it swings about one row
    Mechanism,
    /// No seta comes nearer to its exit as the lift grows
    NoFurtherExit,
    /// As many events as were asked for
    Events,
    /// It was asked to stop
    Stopped,
}

/// Why no events can be followed.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[allow(missing_docs)] // the message of each names its numbers
pub enum ArrayFailure {
    #[error("what stays on the array detaches setae of row {} by itself, at {load:.6} of the load that grows: give less of it", .row + 1)]
    DetachesByItself { row: usize, load: f64 },
    #[error(
        "the stiffness of the array has no inverse after {events} events: the load moves it without a force; hold it in one more place"
    )]
    Singular { events: usize },
    #[error("places of the array are not finite after {events} events: check the stiffnesses of band and setae")]
    NotFinite { events: usize },
    #[error(
        "{events} events, and still setae change to and fro at a lift of {lift:.6}: this softening cannot be followed row by row; try shorter rows or a gentler one"
    )]
    Circle { events: usize, lift: f64 },
}

/// What was followed.
#[derive(Clone, Debug, PartialEq)]
pub struct Followed {
    /// In their order
    pub events: Vec<ArrayEvent>,
    /// The event with the largest load
    pub peak: usize,
    /// Places of all nodes just before it
    pub at_peak: Vec<Vector3<f64>>,
    /// Where it ends
    pub end: ArrayEnd,
    /// Largest difference of work and stored plus released energy, of the work
    pub imbalance: f64,
}

/// Nodes with setae, and the loads on them.
#[derive(Clone, Debug)]
pub(crate) struct LoadedArray {
    /// The bands
    pub chain: Chain,
    /// Of each node, none where no setae stand
    pub clusters: Vec<Option<Cluster>>,
    /// The row of each node
    pub rows: Vec<usize>,
    /// Forces and moments that grow, in the order of the unknowns
    grows: Vec<(usize, Vector3<f64>)>,
    /// Those that stay
    stays: Vec<(usize, Vector3<f64>)>,
    /// A node that is held along the ground: by a spring of this stiffness, nN/nm, which carries nothing where nothing pulls along the ground
    pub held_along: Option<(usize, f64)>,
    /// Of each node's setae with their roots at rest
    at_rest: Vec<RootResponse>,
}

/// A line of places, and what does work along it.
struct Line {
    /// At a lift of zero, and by the lift
    start: Vec<Vector3<f64>>,
    along: Vec<Vector3<f64>>,
    /// Load at a lift of zero, and by the lift
    load: [f64; 2],
    /// Whether no force acts at a lift of zero
    proportional: bool,
}

impl LoadedArray {
    /// Nodes with setae, without loads.
    pub(crate) fn new(chain: Chain, clusters: Vec<Option<Cluster>>, rows: Vec<usize>) -> Self {
        let at_rest = vec![RootResponse::default(); chain.nodes()];
        Self { chain, clusters, rows, grows: Vec::new(), stays: Vec::new(), held_along: None, at_rest }
    }

    /// With a load at a node that grows, and one that stays there.
    pub(crate) fn loaded(mut self, node: usize, grows: Vector3<f64>, stays: [f64; 3]) -> Self {
        self.grows = vec![(node, grows)];
        self.stays = vec![(node, Vector3::from(stays))];
        self
    }

    /// Follows the events until the end, as many as `most`, or until it is `stopped`.
    ///
    /// # Errors
    /// A singular stiffness, numbers that are not finite, setae that change to and fro, or what stays being too much.
    pub(crate) fn follow(mut self, most: usize, stopped: &dyn Fn() -> bool) -> Result<Followed, ArrayFailure> {
        let setae: usize = self.clusters.iter().flatten().map(Cluster::setae).sum();
        let mut out =
            Followed { events: Vec::new(), peak: 0, at_peak: Vec::new(), end: ArrayEnd::Detached, imbalance: 0.0 };
        let (mut adhering, mut holding) = (setae, self.clusters.iter().flatten().filter(|c| c.adhering() > 0).count());
        (0..self.chain.nodes()).for_each(|node| self.hold(node));
        let (mut changed, mut reached) = (None, f64::NEG_INFINITY);
        // what the load has done up to the last event, what has been released, and the energy at the start
        let (mut work, mut released, mut at_start) = (0.0, 0.0, 0.0);
        // energy just before the last event
        let mut energy_before = 0.0;
        loop {
            // a band on one row swings about it: nothing is stored then
            let ends = match adhering {
                0 => Some(ArrayEnd::Detached),
                _ if holding < 2 => Some(ArrayEnd::Mechanism),
                _ => None,
            };
            if let Some(end) = ends {
                if let Some(last) = out.events.last_mut() {
                    last.released = energy_before;
                }
                out.end = end;
                return Ok(out);
            }
            let number = out.events.len();
            if !self.chain.eliminate(changed) {
                return Err(ArrayFailure::Singular { events: number });
            }
            let line = self.line().ok_or(ArrayFailure::NotFinite { events: number })?;
            let (lift_before, load_before) = match out.events.last_mut() {
                Some(last) => {
                    last.load_after = line.load[0] + line.load[1] * last.lift;
                    last.released = energy_before - self.energy_on(&line, last.lift);
                    released += last.released;
                    (last.lift, last.load_after)
                }
                None => {
                    let lift = -line.load[0] / line.load[1];
                    at_start = self.energy(&line.at(lift));
                    (lift, 0.0)
                }
            };
            if number >= most || (number.is_multiple_of(ASKED) && stopped()) {
                out.end = if number >= most { ArrayEnd::Events } else { ArrayEnd::Stopped };
                return Ok(out);
            }
            let Some((node, next)) = self.next(&line) else {
                out.end = ArrayEnd::NoFurtherExit;
                return Ok(out);
            };
            let lift = next.ahead;
            let load = line.load[0] + line.load[1] * lift;
            if number == 0 && lift < lift_before {
                return Err(ArrayFailure::DetachesByItself { row: self.rows[node], load });
            }
            if number > MOST_CHANGES * setae * 2 {
                return Err(ArrayFailure::Circle { events: number, lift });
            }
            work += 0.5 * (load + load_before) * (lift - lift_before);
            energy_before = self.energy_on(&line, lift);
            let highest = out.events.get(out.peak).is_none_or(|peak| load > peak.load);
            // every so often the energy is computed from the places, as a check
            if highest || number.is_multiple_of(BALANCED) {
                let stored = self.energy(&line.at(lift)) - at_start;
                out.imbalance = out.imbalance.max(((work - stored - released) / work).abs());
            }
            if highest {
                (out.peak, out.at_peak) = (number, line.at(lift));
            }
            let Some(cluster) = &mut self.clusters[node] else {
                return Err(ArrayFailure::Circle { events: number, lift });
            };
            let had = cluster.adhering();
            let setae = cluster.change(&next);
            let left = cluster.adhering();
            adhering -= had - left;
            holding -= usize::from(had > 0 && left == 0);
            self.hold(node);
            changed = Some(node);
            out.events.push(ArrayEvent {
                row: self.rows[node],
                setae,
                sheets: [next.from, next.to],
                lift,
                load,
                load_after: 0.0,
                released: 0.0,
                work,
                adhering,
                starts_jump: lift > reached,
            });
            reached = reached.max(lift);
        }
    }

    /// The next change along a line, and its node. Of equal ones the first.
    fn next(&mut self, line: &Line) -> Option<(usize, NextExit)> {
        let mut first: Option<(usize, NextExit)> = None;
        for (node, cluster) in self.clusters.iter_mut().enumerate() {
            if let Some(cluster) = cluster
                && let Some(next) = cluster.next(root(&line.start[node]), root(&line.along[node]))
                && first.is_none_or(|(_, known)| next.ahead < known.ahead)
            {
                first = Some((node, next));
            }
        }
        first
    }

    /// Places under unit loads, by node; the array as it stands at first.
    ///
    /// # Errors
    /// A singular stiffness.
    pub(crate) fn places_under(&mut self, loads: &[(usize, Vector3<f64>)]) -> Result<Vec<Vector3<f64>>, ArrayFailure> {
        (0..self.chain.nodes()).for_each(|node| self.hold(node));
        if !self.chain.eliminate(None) {
            return Err(ArrayFailure::Singular { events: 0 });
        }
        let mut out = vec![Vector3::zeros(); self.chain.nodes()];
        loads.iter().for_each(|(node, load)| out[*node] += load);
        self.chain.solve(&mut out);
        Ok(out)
    }

    fn hold(&mut self, node: usize) {
        let mut held = Matrix3::zeros();
        if let Some(cluster) = &self.clusters[node] {
            let at_rest = cluster.response([0.0; 2]);
            (0..2).for_each(|i| (0..2).for_each(|j| held[(i, j)] = at_rest.stiffness[i][j]));
            self.at_rest[node] = at_rest;
        }
        if let Some((at, stiffness)) = self.held_along
            && at == node
        {
            held[(0, 0)] += stiffness;
        }
        self.chain.set_held(node, held);
    }

    fn line(&self) -> Option<Line> {
        let nodes = self.chain.nodes();
        let mut along = vec![Vector3::zeros(); nodes];
        self.grows.iter().for_each(|(node, load)| along[*node] += load);
        self.chain.solve(&mut along);
        let mut start = vec![Vector3::zeros(); nodes];
        self.stays.iter().for_each(|(node, load)| start[*node] += load);
        for node in 0..nodes {
            let force = self.at_rest[node].force;
            start[node] -= Vector3::new(force[0], force[1], 0.0);
        }
        let proportional = start.iter().all(|own| *own == Vector3::zeros());
        if !proportional {
            self.chain.solve(&mut start);
        }
        // lifts of both: q = start + P along becomes start' + lift along'
        let lift =
            |places: &[Vector3<f64>]| self.grows.iter().map(|(node, load)| load.dot(&places[*node])).sum::<f64>();
        let (at, by) = (lift(&start), lift(&along));
        if !(at.is_finite() && by.is_finite() && by != 0.0) {
            return None;
        }
        along.iter_mut().for_each(|own| *own /= by);
        if !proportional {
            start.iter_mut().zip(&along).for_each(|(own, along)| *own -= along * at);
        }
        Some(Line { start, along, load: [-at / by, by.recip()], proportional })
    }

    /// Stored, less the work of what stays, aJ.
    fn energy(&self, places: &[Vector3<f64>]) -> f64 {
        let of_setae = |(node, cluster): (usize, &Option<Cluster>)| {
            cluster.as_ref().map_or(0.0, |cluster| cluster.response(root(&places[node])).energy)
        };
        let of_stays: f64 = self.stays.iter().map(|(node, load)| load.dot(&places[*node])).sum();
        self.chain.energy(places) + self.clusters.iter().enumerate().map(of_setae).sum::<f64>() - of_stays
    }

    /// The same on a line. Where all is in proportion it is half of load times lift.
    fn energy_on(&self, line: &Line, lift: f64) -> f64 {
        if line.proportional && self.at_rest.iter().all(|own| own.energy == 0.0) {
            0.5 * line.load[1] * lift * lift
        } else {
            self.energy(&line.at(lift))
        }
    }
}

impl Line {
    fn at(&self, lift: f64) -> Vec<Vector3<f64>> {
        self.start.iter().zip(&self.along).map(|(start, along)| start + along * lift).collect()
    }
}

/// Of a node: what its setae are moved by.
fn root(place: &Vector3<f64>) -> [f64; 2] {
    [place.x, place.y]
}
