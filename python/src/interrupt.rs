//! Ctrl-C: Python hears signals in its main thread alone, and only where it is asked.

use peelkit::study::{StopCriteria, StopReason};
use peelkit_analyses::Watcher;
use pyo3::prelude::*;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread::{self, ThreadId};
use std::time::{Duration, Instant};

/// From one look at the signals to the next.
const INTERVAL: Duration = Duration::from_millis(20);

/// What looks at the signals while a run computes without the interpreter, in the thread that has called it.
#[derive(Clone)]
pub struct Watch(Arc<Seen>);

struct Seen {
    caller: ThreadId,
    interrupted: AtomicBool,
    looked: Mutex<Instant>,
    /// What a signal handler has raised
    raised: Mutex<Option<PyErr>>,
}

impl Watch {
    /// Of the thread that calls this.
    pub fn begin() -> Self {
        let (looked, raised) = (Mutex::new(Instant::now()), Mutex::new(None));
        Self(Arc::new(Seen { caller: thread::current().id(), interrupted: AtomicBool::new(false), looked, raised }))
    }

    /// These criteria, and besides: at every stage a run ends where a signal handler has raised something.
    pub fn on(&self, stop: StopCriteria) -> StopCriteria {
        let watch = self.clone();
        stop.or_when(move |_| watch.interrupted().then_some(StopReason::Interrupted))
    }

    /// Whether a signal handler has raised something; looks at the signals once in a while.
    pub fn interrupted(&self) -> bool {
        let seen = &*self.0;
        if thread::current().id() == seen.caller && seen.is_time() {
            self.look();
        }
        seen.interrupted.load(Ordering::Relaxed)
    }

    /// Waits for a message of another thread, which this one is to be told of; looks at the signals meanwhile. Nothing where a
    /// signal handler has raised something, and where the other thread has ended.
    pub fn wait<T>(&self, receiver: &Receiver<T>) -> Option<T> {
        loop {
            match receiver.recv_timeout(INTERVAL) {
                Ok(found) => return Some(found),
                Err(RecvTimeoutError::Disconnected) => return None,
                Err(RecvTimeoutError::Timeout) => self.look(),
            }
            if self.0.interrupted.load(Ordering::Relaxed) {
                return None;
            }
        }
    }

    /// What `work` finds, which computes in threads of its own and asks this watch whether to go on.
    pub fn over<T: Send>(&self, work: impl FnOnce() -> T + Send) -> thread::Result<T> {
        thread::scope(|scope| {
            let (ended, end) = channel::<()>();
            let worker = scope.spawn(move || {
                let _ended = ended;
                work()
            });
            // what it sends is its end alone; once interrupted it ends by itself
            let _ = self.wait(&end);
            worker.join()
        })
    }

    /// Looks at the signals.
    fn look(&self) {
        // an interpreter that ends has nobody who would hear
        let raised = Python::try_attach(|py| py.check_signals()).and_then(Result::err);
        if let Some(error) = raised {
            *self.0.raised.lock().unwrap_or_else(PoisonError::into_inner) = Some(error);
            self.0.interrupted.store(true, Ordering::Relaxed);
        }
    }

    /// Raises what a signal handler has raised.
    pub fn end(&self) -> PyResult<()> {
        self.0.raised.lock().unwrap_or_else(PoisonError::into_inner).take().map_or(Ok(()), Err)
    }
}

impl Watcher for Watch {
    fn ends(&self, stop: StopCriteria) -> StopCriteria {
        self.on(stop)
    }

    fn asked(&self) -> bool {
        self.interrupted()
    }
}

impl Seen {
    fn is_time(&self) -> bool {
        let mut looked = self.looked.lock().unwrap_or_else(PoisonError::into_inner);
        let over = looked.elapsed() >= INTERVAL;
        if over {
            *looked = Instant::now();
        }
        over
    }
}
