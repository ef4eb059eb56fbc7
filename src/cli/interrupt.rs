//! Ctrl-C: once, nothing more is begun; twice, the command quits.

use indicatif::ProgressBar;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// The exit status that shells give to a command that Ctrl-C ended.
const QUIT: i32 = 130;

/// Whether the user, or the system that shuts down, has asked to stop.
pub struct Interrupt(Arc<AtomicBool>);

impl Interrupt {
    /// Listens from now on; the answer to the first Ctrl-C stands above the bar.
    pub fn listen(bar: &ProgressBar) -> Self {
        let asked = Arc::new(AtomicBool::new(false));
        let (seen, bar) = (Arc::clone(&asked), bar.clone());
        let answer = move || {
            if seen.swap(true, Ordering::Relaxed) {
                std::process::exit(QUIT);
            }
            bar.println("stopping once the values under way are done; Ctrl-C again quits at once");
        };
        // Fails where the caller has one of the signals ignored, as nohup does: then they stay as they are.
        let _ = ctrlc::try_set_handler(answer);
        Self(asked)
    }

    pub fn asked(&self) -> bool {
        self.0.load(Ordering::Relaxed)
    }
}
