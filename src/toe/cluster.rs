//! Setae whose roots move as one: those of a row of a band, or of a whole rigid patch.
//!
//! What holds them is one polynomial, the sum over all. On each sheet the seta that leaves it next is known without looking at the others: a seta
//! at height h and of strength s leaves it where u·d = s c + h d_n, which is a number of its own, and the direction is that of all.

use super::law::RootLaw;
use super::potential::Potential;
use super::scatter::RootOffset;
use crate::study::coarsening::seta_law::law::{RootResponse, dot};
use std::cmp::Ordering;
use std::collections::BinaryHeap;

/// What a seta does next as the root moves on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct NextExit {
    /// Sheet that is left
    pub from: usize,
    /// Sheet that is reached; the number of sheets is the detached one
    pub to: usize,
    /// How far along the direction, in lengths of it
    pub ahead: f64,
}

/// A seta by the place at which it leaves a sheet; the lowest place is the largest, and of equal ones the lowest number.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Waiting {
    place: f64,
    seta: u32,
}

impl Eq for Waiting {}
impl Ord for Waiting {
    fn cmp(&self, other: &Self) -> Ordering {
        other.place.total_cmp(&self.place).then(other.seta.cmp(&self.seta))
    }
}
impl PartialOrd for Waiting {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

/// Setae at one place.
#[derive(Clone, Debug)]
pub(crate) struct Cluster {
    law: RootLaw,
    /// Of the exit of each sheet
    normals: Vec<[f64; 2]>,
    setae: Vec<RootOffset>,
    /// Sheet of each
    on: Vec<u8>,
    /// How many are on each sheet, the detached one last
    counts: Vec<usize>,
    /// The sum over all
    total: Potential,
    /// By sheet: those that leave it forwards
    leaving: Vec<BinaryHeap<Waiting>>,
    /// By sheet: those that leave it backwards, by their places with the other sign
    returning: Vec<BinaryHeap<Waiting>>,
}

impl Cluster {
    /// All of them adhering.
    pub(crate) fn new(law: &RootLaw, setae: Vec<RootOffset>) -> Self {
        let sheets = law.sheets();
        let mut out = Self {
            law: law.clone(),
            normals: (0..sheets).filter_map(|sheet| Some(law.sheet(sheet, 1.0)?.exit.direction)).collect(),
            on: vec![0; setae.len()],
            counts: vec![0; sheets + 1],
            total: Potential::ZERO,
            leaving: vec![BinaryHeap::new(); sheets],
            returning: vec![BinaryHeap::new(); sheets],
            setae,
        };
        (0..out.setae.len()).for_each(|seta| out.enter(seta, 0));
        out
    }

    /// How many setae it has.
    pub(crate) fn setae(&self) -> usize {
        self.setae.len()
    }

    /// How many adhere, on whatever sheet.
    pub(crate) fn adhering(&self) -> usize {
        self.setae.len() - self.counts[self.counts.len() - 1]
    }

    /// Energy, force and stiffness of all together, with the root at a place, nm.
    pub(crate) fn response(&self, root: [f64; 2]) -> RootResponse {
        if self.adhering() == 0 { RootResponse::default() } else { self.total.response(root) }
    }

    /// The first change as the root moves from a place along a direction. Negative where it should have happened before.
    pub(crate) fn next(&mut self, root: [f64; 2], direction: [f64; 2]) -> Option<NextExit> {
        let mut first: Option<NextExit> = None;
        let mut take = |from, to, ahead: f64| {
            if first.is_none_or(|known| ahead < known.ahead) {
                first = Some(NextExit { from, to, ahead });
            }
        };
        for sheet in 0..self.normals.len() {
            if self.counts[sheet] == 0 {
                continue;
            }
            let forwards = self.normals[sheet];
            let (speed, at) = (dot(forwards, direction), dot(forwards, root));
            if speed > 0.0
                && let Some(place) = self.first_of(sheet, true)
            {
                take(sheet, sheet + 1, (place - at) / speed);
            }
            if sheet > 0 {
                let back = self.normals[sheet - 1];
                let (speed, at) = (dot(back, direction), dot(back, root));
                if speed < 0.0
                    && let Some(place) = self.first_of(sheet, false)
                {
                    take(sheet, sheet - 1, (-place - at) / speed);
                }
            }
        }
        first
    }

    /// Lets the setae that are next, and all that are where they are, change their sheet. What they are.
    pub(crate) fn change(&mut self, exit: &NextExit) -> Vec<u32> {
        let forwards = exit.to > exit.from;
        let mut changed = Vec::new();
        let Some(place) = self.first_of(exit.from, forwards) else { return changed };
        while self.first_of(exit.from, forwards) == Some(place) {
            let heap = if forwards { &mut self.leaving } else { &mut self.returning };
            let Some(top) = heap[exit.from].pop() else { break };
            let seta = top.seta as usize;
            let before = self.potential(seta, exit.from);
            self.total.add(&before, -1.0);
            self.counts[exit.from] -= 1;
            self.enter(seta, exit.to);
            changed.push(top.seta);
        }
        changed
    }

    /// Energy that setae release as they change their sheet with the root at a place, aJ.
    pub(crate) fn released(&self, setae: &[u32], exit: &NextExit, root: [f64; 2]) -> f64 {
        let energy = |seta: u32, sheet: usize| self.potential(seta as usize, sheet).response(root).energy;
        setae.iter().map(|&seta| energy(seta, exit.from) - energy(seta, exit.to)).sum()
    }

    fn enter(&mut self, seta: usize, sheet: usize) {
        self.on[seta] = sheet as u8;
        self.counts[sheet] += 1;
        let RootOffset { height, strength } = self.setae[seta];
        if let Some(own) = self.law.sheet(sheet, strength) {
            let potential = own.potential.raised(height);
            if self.total == Potential::ZERO {
                self.total = potential;
            } else {
                self.total.add(&potential, 1.0);
            }
            let place = own.exit.distance + height * own.exit.direction[1];
            self.leaving[sheet].push(Waiting { place, seta: seta as u32 });
            if own.goes_back
                && let Some(before) = self.law.sheet(sheet - 1, strength)
            {
                let place = -(before.exit.distance + height * before.exit.direction[1]);
                self.returning[sheet].push(Waiting { place, seta: seta as u32 });
            }
        }
    }

    fn potential(&self, seta: usize, sheet: usize) -> Potential {
        let RootOffset { height, strength } = self.setae[seta];
        self.law.sheet(sheet, strength).map_or(Potential::ZERO, |own| own.potential.raised(height))
    }

    /// Where the next one leaves a sheet. What has left it by another way is thrown out.
    fn first_of(&mut self, sheet: usize, forwards: bool) -> Option<f64> {
        let heap = if forwards { &mut self.leaving[sheet] } else { &mut self.returning[sheet] };
        while let Some(top) = heap.peek() {
            if usize::from(self.on[top.seta as usize]) == sheet {
                return Some(top.place);
            }
            heap.pop();
        }
        None
    }
}
