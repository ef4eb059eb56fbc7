//! Ctrl-C: once, nothing more is begun; twice, the command quits.

use peelkit::study::{Stage, StopCriteria, StopReason};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// The exit status that shells give to a command that Ctrl-C ended.
const QUIT: i32 = 130;

/// Whether the user, or the system that shuts down, has asked to stop.
pub struct Interrupt(Arc<AtomicBool>);

impl Interrupt {
    /// Listens from now on; `answer` reports to the user what the first Ctrl-C does.
    pub fn listen(answer: impl Fn() + Send + 'static) -> Self {
        let asked = Arc::new(AtomicBool::new(false));
        let seen = Arc::clone(&asked);
        let heard = move || {
            if seen.swap(true, Ordering::Relaxed) {
                std::process::exit(QUIT);
            }
            answer();
        };
        // Fails where the caller has one of the signals ignored, as nohup does: then they stay as they are.
        let _ = ctrlc::try_set_handler(heard);
        Self(asked)
    }

    pub fn asked(&self) -> bool {
        self.0.load(Ordering::Relaxed)
    }

    /// These criteria, and besides: a path ends where the user has asked to stop; what was reached of it is still worked out.
    pub fn ends(&self, stop: StopCriteria) -> StopCriteria {
        let asked = Arc::clone(&self.0);
        stop.or_when(move |stage| {
            (stage == Stage::Path && asked.load(Ordering::Relaxed)).then_some(StopReason::Interrupted)
        })
    }

    /// From now on the first Ctrl-C quits as well; whether there was one before.
    pub fn quit_next(&self) -> bool {
        self.0.swap(true, Ordering::Relaxed)
    }
}
