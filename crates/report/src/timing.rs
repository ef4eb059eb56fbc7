//! How long a computation takes.

use std::time::Instant;

/// What a computation gives, and the seconds of wall clock that it took.
pub fn timed<T>(computation: impl FnOnce() -> T) -> (T, f64) {
    let started = Instant::now();
    let found = computation();
    (found, started.elapsed().as_secs_f64())
}
