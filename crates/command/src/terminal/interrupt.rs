//! Ctrl-C: once, nothing more is begun; twice, the command quits.

use peelkit::study::{Stage, StopCriteria, StopReason};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, OnceLock};
use std::time::{Duration, Instant};

/// The exit status that shells give to a command that Ctrl-C ended.
const QUIT: i32 = 130;

/// What was reached may be worked out for so long behind Ctrl-C.
const GRACE: Duration = Duration::from_millis(200);

/// Whether the user, or the system that shuts down, has asked to stop, and when what is being computed heard of it.
pub struct Interrupt {
    asked: Arc<AtomicBool>,
    /// Whether the first Ctrl-C quits
    quits: Arc<AtomicBool>,
    heard: Arc<OnceLock<Instant>>,
}

impl Interrupt {
    /// Listens from now on; `answer` reports to the user what the first Ctrl-C does.
    pub fn listen(answer: impl Fn() + Send + 'static) -> Self {
        let interrupt = Self::deaf();
        let (seen, quits) = (Arc::clone(&interrupt.asked), Arc::clone(&interrupt.quits));
        let heard = move || {
            if quits.load(Ordering::Relaxed) || seen.swap(true, Ordering::Relaxed) {
                std::process::exit(QUIT);
            }
            answer();
        };
        // Fails where the caller has one of the signals ignored, as nohup does: then they stay as they are.
        let _ = ctrlc::try_set_handler(heard);
        interrupt
    }

    /// Hears nothing: Ctrl-C ends the command.
    pub fn deaf() -> Self {
        Self { asked: Arc::default(), quits: Arc::default(), heard: Arc::default() }
    }

    pub fn asked(&self) -> bool {
        self.asked.load(Ordering::Relaxed)
    }

    /// These criteria, and besides: a path ends where the user has asked to stop; what was reached of it is still worked out, if that takes no longer
    /// than the user notices.
    pub fn ends(&self, stop: StopCriteria) -> StopCriteria {
        let (asked, heard) = (Arc::clone(&self.asked), Arc::clone(&self.heard));
        stop.or_when(move |stage| {
            let is_over = || heard.get_or_init(Instant::now).elapsed() > GRACE;
            let ends = asked.load(Ordering::Relaxed) && (is_over() || stage == Stage::Path);
            ends.then_some(StopReason::Interrupted)
        })
    }

    /// From now on the first Ctrl-C quits; whether there was one before, which does not end what comes.
    pub fn quit_next(&self) -> bool {
        self.quits.store(true, Ordering::Relaxed);
        self.asked.swap(false, Ordering::Relaxed)
    }
}
