//! The open connections: so many at most, and room for a new one is made by the oldest that nobody waits for.

use std::collections::VecDeque;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Arc, Mutex, PoisonError};
use tokio::task::AbortHandle;

/// How many requests of a connection are being answered.
pub(crate) type Busy = Arc<AtomicUsize>;

/// One request that is being answered.
pub(crate) struct BeingAnswered(Busy);

impl BeingAnswered {
    pub fn new(busy: &Busy) -> Self {
        busy.fetch_add(1, Ordering::Relaxed);
        Self(Arc::clone(busy))
    }
}

impl Drop for BeingAnswered {
    fn drop(&mut self) {
        self.0.fetch_sub(1, Ordering::Relaxed);
    }
}

struct Open {
    busy: Busy,
    task: AbortHandle,
}

/// The open connections of a server, the oldest first.
#[derive(Clone, Default)]
pub(crate) struct Connections(Arc<Mutex<VecDeque<Open>>>);

impl Connections {
    /// Makes room for one below the limit; whether there is any.
    pub fn make_room(&self, most: usize) -> bool {
        let mut open = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        open.retain(|one| !one.task.is_finished());
        if open.len() < most {
            return true;
        }
        let idle = open.iter().position(|one| one.busy.load(Ordering::Relaxed) == 0);
        match idle.and_then(|oldest| open.remove(oldest)) {
            Some(oldest) => {
                oldest.task.abort();
                true
            }
            None => false,
        }
    }

    pub fn add(&self, busy: Busy, task: AbortHandle) {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).push_back(Open { busy, task });
    }
}
