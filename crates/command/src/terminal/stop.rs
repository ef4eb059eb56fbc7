//! Why the command stops before its end, and the exit status that says so.

use peelkit_report::ReportError;
use peelkit_scene::{SceneError, ValueError};
use std::io::Write;
use std::process::ExitCode;

/// A message for standard error and an exit status.
#[derive(Debug)]
pub struct Stop {
    status: Status,
    report: miette::Report,
}

#[derive(Clone, Copy, Debug)]
enum Status {
    Other = 1,
    BadInput = 2,
    CutShort = 3,
}

impl Stop {
    /// Something in what the user gave: what, and what would be right.
    pub fn bad_input(found: impl std::fmt::Display, remedy: impl std::fmt::Display) -> Self {
        Self { status: Status::BadInput, report: miette::miette!(help = remedy.to_string(), "{found}") }
    }

    /// An argument of the command line that is as the problem says.
    pub fn bad_argument(argument: impl std::fmt::Display, problem: &ValueError) -> Self {
        Self::bad_input(format!("{argument} {}", problem.found), &problem.remedy)
    }

    /// The computation stopped short; everything that was reached is written.
    pub fn cut_short(reason: impl std::fmt::Display) -> Self {
        Self { status: Status::CutShort, report: miette::miette!("the computation stopped short: {reason}") }
    }

    /// Something that neither the input nor the computation is to blame for.
    pub fn other(reason: impl std::fmt::Display) -> Self {
        Self { status: Status::Other, report: miette::miette!("{reason}") }
    }

    /// The same with what to try.
    pub fn other_with(reason: impl std::fmt::Display, remedy: &'static str) -> Self {
        Self { status: Status::Other, report: miette::miette!(help = remedy, "{reason}") }
    }

    /// Reports the message on standard error.
    pub fn report(self) -> ExitCode {
        // Where standard error is closed nobody reads it; the status still says it.
        let _ = writeln!(std::io::stderr(), "{:?}", self.report);
        ExitCode::from(self.status as u8)
    }
}

impl From<SceneError> for Stop {
    fn from(error: SceneError) -> Self {
        Self { status: Status::BadInput, report: error.into() }
    }
}

impl From<ReportError> for Stop {
    fn from(error: ReportError) -> Self {
        match &error {
            ReportError::Exists { .. } => Self::bad_input(
                &error,
                "Give another folder with --out DIR, or --force to replace the files of the same names.",
            ),
            ReportError::InUse { .. } => {
                Self::bad_input(&error, "Wait until it has ended, or give another folder with --out DIR.")
            }
            ReportError::OtherCheckpoint { analysis, of, .. } => Self::bad_input(
                &error,
                format!(
                    "Finish that {analysis} with its own {}, or give another folder with --out DIR, or --fresh to discard what it has kept.",
                    if of == "version" { "version of peel" } else { "command" }
                ),
            ),
            ReportError::OlderCheckpoint { analysis, version, .. } => Self::bad_input(
                &error,
                format!(
                    "Finish that {analysis} with {}, or give another folder with --out DIR, or --fresh to discard what it has kept.",
                    version
                        .as_ref()
                        .map_or("the version that began it".to_owned(), |version| format!("peel {version}"))
                ),
            ),
            ReportError::NoCheckpoint { .. } => Self::bad_input(
                &error,
                "Put back a copy of the file, or give another folder with --out DIR, or --fresh to discard it and begin anew.",
            ),
            ReportError::NoPart { .. } => {
                Self::bad_input(&error, "Compute this part again with peel sweep --part, or omit its folder.")
            }
            ReportError::Write { .. } => Self::other_with(
                &error,
                "Give a folder in which you may write with --out DIR, and make room on the disk where it is full.",
            ),
            _ => Self::other(error),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_kind_has_its_exit_status() {
        let status = |stop: Stop| stop.status as u8;
        assert_eq!(status(Stop::other("x")), 1);
        assert_eq!(status(Stop::bad_input("x", "y")), 2);
        assert_eq!(status(Stop::cut_short("x")), 3);
        let scene = peelkit_scene::Scene::parse("a.toml", "", &[]).unwrap_err();
        assert_eq!(status(scene.into()), 2);
        let report = ReportError::Draw { path: "x".into(), reason: "y".into() };
        assert_eq!(status(report.into()), 1);
        assert_eq!(status(ReportError::Exists { path: "x".into() }.into()), 2);
        assert_eq!(status(ReportError::InUse { path: "x".into(), process: Some(1) }.into()), 2);
        let no_checkpoint = ReportError::NoCheckpoint { path: "x".into(), reason: "y".into() };
        assert_eq!(status(no_checkpoint.into()), 2);
    }
}
