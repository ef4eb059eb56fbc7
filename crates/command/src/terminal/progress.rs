//! How far an analysis is, on standard error.

use crate::terminal::output::{progress_bar, terminal};
use crate::terminal::run_progress::RunProgress;
use indicatif::ProgressBar;
use peelkit::study::StopCriteria;
use peelkit_analyses::Progress;
use std::io::{self, Write};
use std::time::Duration;

/// From one drawing of a spinner to the next.
const TICK: Duration = Duration::from_millis(200);

/// What is shown meanwhile, if standard error is a terminal.
pub enum Bar {
    /// Of a single run, once it takes long
    Run(RunProgress),
    /// Of many runs
    Counted(ProgressBar),
    /// Of something of which nothing is known before its end
    Spinner(ProgressBar),
}

impl Bar {
    pub fn run() -> Self {
        Self::Run(RunProgress::begin())
    }

    pub fn counted() -> Self {
        Self::Counted(progress_bar(0))
    }

    pub fn spinner(message: &'static str) -> Self {
        let bar = ProgressBar::new_spinner().with_message(message);
        bar.set_draw_target(terminal());
        bar.enable_steady_tick(TICK);
        Self::Spinner(bar)
    }

    /// Shows how far it is.
    pub fn show(&self, progress: Progress) {
        match (self, progress) {
            (Self::Run(bar), Progress::Stage(next)) => bar.stage(next),
            (Self::Run(bar), Progress::Point(options, waypoint)) => bar.point(options, waypoint),
            (Self::Run(bar), Progress::Equilibrium(point)) => bar.seta(point),
            (Self::Counted(bar), Progress::Begin(all)) => bar.set_length(all as u64),
            (Self::Counted(bar), Progress::Done) => bar.inc(1),
            (Self::Counted(bar), Progress::Known) => {
                bar.inc(1);
                // what was taken says nothing about the time to go
                bar.reset_eta();
            }
            _ => {}
        }
    }

    /// These criteria, which show how far it is whenever they are asked.
    pub fn watch(&self, stop: StopCriteria) -> StopCriteria {
        match self {
            Self::Run(bar) => bar.watch(stop),
            Self::Counted(_) | Self::Spinner(_) => stop,
        }
    }

    /// Writes something above.
    pub fn aside(&self, write: impl FnOnce()) {
        match self {
            Self::Run(bar) => bar.above(write),
            Self::Counted(bar) | Self::Spinner(bar) => bar.suspend(write),
        }
    }

    /// What writes this line above.
    pub fn above(&self, line: &'static str) -> Box<dyn Fn() + Send> {
        match self {
            Self::Run(bar) => {
                let bar = bar.clone();
                // nobody reads it where standard error is closed
                Box::new(move || bar.above(|| drop(writeln!(io::stderr(), "{line}"))))
            }
            Self::Counted(bar) | Self::Spinner(bar) => {
                let bar = bar.clone();
                Box::new(move || bar.println(line))
            }
        }
    }

    pub fn finish(&self) {
        match self {
            Self::Run(bar) => bar.finish(),
            Self::Counted(bar) | Self::Spinner(bar) => bar.finish_and_clear(),
        }
    }
}
