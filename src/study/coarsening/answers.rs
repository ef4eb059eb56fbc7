//! What a tip was asked last: a state of the seta is asked for its forces, its energy and its stiffness one after the other.

use super::branch::TipSheet;
use super::near_end::Source;
use super::place::TipResponse;
use crate::beam::spatial::rotation::Quaternion;
use crate::beam::spatial::tree::branching_beam::EndResponse;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, PoisonError};

/// Where a tip is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Asked {
    pub on: TipSheet,
    /// From its place of adhesion, nm
    pub place: [f64; 3],
    pub directors: Quaternion,
}

/// What its law says there.
#[derive(Clone, Copy, Debug)]
pub(super) struct Answer {
    pub source: Source,
    /// In its plane
    pub in_plane: TipResponse,
    /// In space
    pub in_space: EndResponse,
}

/// The last two answers of a tip: those at both ends of a step.
#[derive(Debug, Default)]
pub(super) struct Answers {
    last: Mutex<[Option<(Asked, Answer)>; 2]>,
    solved: AtomicBool,
}

impl Answers {
    /// The answer that is known, or the one that is found.
    pub fn get(&self, asked: Asked, find: impl FnOnce() -> Answer) -> Answer {
        let lock = || self.last.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some((_, known)) = lock().iter().flatten().find(|(own, _)| *own == asked) {
            return *known;
        }
        let found = find();
        if matches!(found.source, Source::Spatula(_)) {
            self.solved.store(true, Ordering::Relaxed);
        }
        let mut last = lock();
        last.swap(0, 1);
        last[0] = Some((asked, found));
        found
    }

    /// Whether an answer has come from the spatula.
    pub fn was_solved(&self) -> bool {
        self.solved.load(Ordering::Relaxed)
    }
}
