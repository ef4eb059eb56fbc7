//! What one page, or whoever pretends to be one, may ask of the machine.

use std::time::Duration;

/// What one page may ask of the machine.
#[derive(Clone, Copy, Debug)]
pub struct Limits {
    /// Runs at the same time
    pub runs: usize,
    /// Runs that wait for one of these to end; a further one is refused.
    pub waiting: usize,
    /// Longest time for a path; its limit points and error bounds end after twice as long.
    pub time: Duration,
    /// Largest head of a request, bytes
    pub head_size: usize,
    /// Largest rest of a request, bytes
    pub body: usize,
    /// Open connections; beyond, the oldest one that is not being answered is closed.
    pub connections: usize,
    /// Longest time in which the head of a request arrives, and longest time for which a connection may rest
    pub head: Duration,
    /// Longest time in which the rest of a request arrives
    pub arrival: Duration,
}

impl Limits {
    /// For a machine with so many cores.
    pub fn of_cores(cores: usize) -> Self {
        Self {
            runs: cores.max(1),
            waiting: 32,
            time: Duration::from_secs(20),
            head_size: 1 << 16,
            body: 1 << 20,
            connections: 256,
            head: Duration::from_secs(15),
            arrival: Duration::from_secs(10),
        }
    }
}

impl Default for Limits {
    /// For this machine.
    fn default() -> Self {
        Self::of_cores(std::thread::available_parallelism().map_or(1, usize::from))
    }
}
