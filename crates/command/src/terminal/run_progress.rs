//! How far a single run is, on a terminal, once it has taken a second; nothing in a pipe.

use crate::terminal::output::terminal;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use peelkit::solve::{PathOptions, Waypoint};
use peelkit::study::{SetaPoint, StopCriteria};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::time::{Duration, Instant};

/// A run of less than this shows nothing.
const AFTER: Duration = Duration::from_secs(1);
/// From one drawing to the next.
const TICK: Duration = Duration::from_millis(200);

/// A line on standard error while a run takes long.
#[derive(Clone)]
pub struct RunProgress {
    bar: ProgressBar,
    began: Instant,
    after: Duration,
    target: fn() -> ProgressDrawTarget,
    shown: Arc<AtomicBool>,
    points: Arc<AtomicUsize>,
}

impl RunProgress {
    pub fn begin() -> Self {
        Self::on(terminal, AFTER)
    }

    /// The same on another terminal and after another time.
    fn on(target: fn() -> ProgressDrawTarget, after: Duration) -> Self {
        let bar = ProgressBar::hidden();
        let style = ProgressStyle::with_template("{spinner} {elapsed} elapsed, {wide_msg}");
        let bar = if let Ok(style) = style { bar.with_style(style) } else { bar };
        bar.set_message("preparing the path");
        let (shown, points) = (Arc::new(AtomicBool::new(false)), Arc::new(AtomicUsize::new(0)));
        Self { bar, began: Instant::now(), after, target, shown, points }
    }

    /// A point of the path on a mesh has been computed.
    pub fn point(&self, options: &PathOptions, waypoint: &Waypoint) {
        let count = self.points.fetch_add(1, Ordering::Relaxed) + 1;
        let at = &waypoint.point.observables;
        self.bar.set_message(format!(
            "{count} path points computed; at u = {:.4} nm, P = {:.4} nN on {} elements",
            at.displacement, at.force, options.elements
        ));
        self.look();
    }

    /// An equilibrium of a seta has been computed.
    pub fn seta(&self, point: &SetaPoint) {
        let count = self.points.fetch_add(1, Ordering::Relaxed) + 1;
        self.bar.set_message(format!(
            "{count} equilibria computed; in step {} at {:.1} nm, force {:.3} nN, {} tips attached",
            point.step + 1,
            point.displacement,
            point.force_along,
            point.attached
        ));
        self.look();
    }

    /// What comes next.
    pub fn stage(&self, message: &'static str) {
        self.bar.set_message(message);
        self.look();
    }

    /// These criteria, which are asked all the time, and never stop the run by what they see here.
    pub fn watch(&self, stop: StopCriteria) -> StopCriteria {
        let progress = self.clone();
        stop.or_when(move |_| {
            progress.look();
            None
        })
    }

    /// Shows the line once it is time.
    fn look(&self) {
        if self.began.elapsed() > self.after && !self.shown.swap(true, Ordering::Relaxed) {
            self.bar.set_draw_target((self.target)());
            self.bar.enable_steady_tick(TICK);
        }
    }

    /// Writes a line above.
    pub fn above(&self, write: impl FnOnce()) {
        self.bar.suspend(write);
    }

    pub fn finish(&self) {
        self.bar.finish_and_clear();
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use indicatif::TermLike;
    use peelkit::study::{Checkpoint, peel_on};
    use peelkit_scene::Scene;
    use std::io;
    use std::sync::Mutex;

    static WRITTEN: Mutex<String> = Mutex::new(String::new());

    /// A terminal that keeps all that is written to it.
    #[derive(Debug)]
    struct Terminal;

    impl TermLike for Terminal {
        fn width(&self) -> u16 {
            200
        }
        fn move_cursor_up(&self, _: usize) -> io::Result<()> {
            Ok(())
        }
        fn move_cursor_down(&self, _: usize) -> io::Result<()> {
            Ok(())
        }
        fn move_cursor_right(&self, _: usize) -> io::Result<()> {
            Ok(())
        }
        fn move_cursor_left(&self, _: usize) -> io::Result<()> {
            Ok(())
        }
        fn write_line(&self, text: &str) -> io::Result<()> {
            self.write_str(text)
        }
        fn write_str(&self, text: &str) -> io::Result<()> {
            WRITTEN.lock().unwrap().push_str(text);
            Ok(())
        }
        fn clear_line(&self) -> io::Result<()> {
            Ok(())
        }
        fn flush(&self) -> io::Result<()> {
            Ok(())
        }
    }

    /// Peels a strip roughly under the eye of this progress.
    fn peeled(progress: &RunProgress) {
        let text = "strip = { length = \"100 nm\", height = \"10 nm\", youngs_modulus = \"2 GPa\" }\n\
                    adhesion = { hamaker_constant = \"1e-19 J\", equilibrium_distance = \"0.4 nm\" }\n\
                    accuracy = { relative = 1e-3 }\n";
        let scene = Scene::parse("a.toml", text, &[]).unwrap();
        let keep = |options: &PathOptions, waypoint: Waypoint| {
            progress.point(options, &waypoint);
            std::thread::sleep(Duration::from_millis(5));
        };
        let checkpoint = Checkpoint { taken: &|_| Vec::new(), keep: &keep };
        let stop = progress.watch(scene.bounds.from_now());
        assert!(peel_on(&scene.model, &scene.accuracy, &stop, &checkpoint).peak.is_some());
        progress.finish();
    }

    #[test]
    fn a_long_run_tells_a_terminal_how_far_it_is_and_a_short_one_does_not() {
        let terminal = || ProgressDrawTarget::term_like(Box::new(Terminal));
        peeled(&RunProgress::on(terminal, Duration::from_secs(3600)));
        assert_eq!(*WRITTEN.lock().unwrap(), "");
        peeled(&RunProgress::on(terminal, Duration::ZERO));
        let written = WRITTEN.lock().unwrap().clone();
        assert!(written.contains("path points computed; at u = ") && written.contains(" elements"), "{written}");
    }
}
