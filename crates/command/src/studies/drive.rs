//! What all commands have in common that analyse a scene: claim the folder, show how far it is, hear Ctrl-C, compute, write the files, say what was found,
//! and end with the exit status of how it ended.

use crate::terminal::command_line::command_line;
use crate::terminal::interrupt::Interrupt;
use crate::terminal::output::{OutArgs, list_files, note, say};
use crate::terminal::progress::Bar;
use crate::terminal::stop::Stop;
use peelkit::study::StopCriteria;
use peelkit_analyses::{Analysis, End, Keeping, Outcome, Progress, Refusal, Session, Watcher};
use peelkit_scene::Scene;
use std::path::PathBuf;

/// How an unfinished analysis is finished.
const GOES_ON: &str = "the same command resumes from there, --fresh starts anew";

/// A command that analyses a scene.
pub struct Drive<'d> {
    pub scene: &'d Scene,
    pub out: &'d OutArgs,
    /// Where files go, if they are written
    pub folder: Option<PathBuf>,
    /// Whether what an unfinished command has kept is discarded
    pub fresh: bool,
    /// Whether one JSON object is printed in place of a text
    pub json: bool,
    /// What is shown meanwhile
    pub bar: Bar,
    /// What a first Ctrl-C does, in words; nothing where it ends the command
    pub answer: Option<&'static str>,
}

/// Shows what it sees, and hears Ctrl-C.
pub(super) struct Eyes {
    pub bar: Bar,
    pub interrupt: Interrupt,
}

impl Watcher for Eyes {
    fn see(&self, progress: Progress) {
        match progress {
            Progress::Cost(cost) => self.bar.aside(|| note(cost)),
            progress => self.bar.show(progress),
        }
    }

    fn ends(&self, stop: StopCriteria) -> StopCriteria {
        self.bar.watch(self.interrupt.ends(stop))
    }

    fn asked(&self) -> bool {
        self.interrupt.asked()
    }

    fn nothing_more_is_kept(&self) -> bool {
        self.interrupt.quit_next()
    }
}

impl Drive<'_> {
    /// Runs an analysis of the scene; `text` lays out what it has found for a person.
    pub fn run<A: Analysis>(self, analysis: &A, text: impl FnOnce(&A::Found) -> String) -> Result<(), Stop> {
        let Self { scene, out, folder, fresh, json, bar, answer } = self;
        // before anything is written
        let interrupt = match answer {
            Some(answer) => Interrupt::listen(bar.above(answer)),
            None => Interrupt::deaf(),
        };
        let before = folder.as_ref().filter(|folder| out.is_again(folder, analysis.journal()));
        let output = folder.as_ref().map(|folder| out.claim(folder, analysis.journal())).transpose()?;
        let keeping = folder.as_ref().filter(|_| analysis.journal().is_some());
        let keeping = keeping.map(|folder| Keeping { folder, fresh });
        let eyes = Eyes { bar, interrupt };
        let found = analysis.run(&Session { watcher: &eyes, keeping, abrupt: false });
        eyes.bar.finish();
        let found = found.map_err(|why| Stop::refused(scene, why))?;
        let command = command_line();
        // whole results are not given up for those of an interrupted command
        let before = before.filter(|_| matches!(found.end(), End::Interrupted { .. }));
        let output = output.filter(|_| found.is_written() && before.is_none());
        let files = output.map_or(Ok(Vec::new()), |output| output.write(|dir| found.write_all(scene, dir, &command)));
        let (files, left) = match found.settle(files.is_ok()) {
            Ok(left) => (files, left),
            Err(error) => (files.and(Err(error)), None),
        };
        // the results are reported even if they could not be written
        if json {
            say(&found.json(scene, Some(&command)).map_err(Stop::other)?)?;
        } else {
            let left = left.as_ref().map(|left| format!("\n{left}: {GOES_ON}\n")).unwrap_or_default();
            let before = before.map(|folder| format!("{} keeps the files of before\n", folder.display()));
            say(&format!("{}\n{}{}{left}", text(&found), before.unwrap_or_default(), list_files(&files)))?;
        }
        files?;
        ended(found.end(), left, keeping.is_some())
    }
}

/// The exit status and the message of how an analysis ended; what is left to do, and whether anything was kept.
fn ended(end: End, left: Option<String>, kept: bool) -> Result<(), Stop> {
    let goes_on = if kept { GOES_ON } else { "nothing was kept, because no folder was given with --out" };
    let why = match (end, left) {
        (End::Done, _) => return Ok(()),
        (End::Refused { found, remedy }, _) => return Err(Stop::bad_input(found, remedy)),
        (End::CutShort(why), _) => why,
        (End::Interrupted { done: Some(done), short }, _) => [Some(format!("interrupted, {done}; {goes_on}")), short]
            .into_iter()
            .flatten()
            .collect::<Vec<_>>()
            .join("\nand "),
        (End::Interrupted { done: None, .. }, Some(left)) => format!("interrupted; {left}: {GOES_ON}"),
        (End::Interrupted { done: None, .. }, None) => "interrupted".to_owned(),
    };
    Err(Stop::cut_short(why))
}

impl Stop {
    /// Why there is no outcome of a scene.
    pub fn refused(scene: &Scene, why: Refusal) -> Self {
        match why {
            Refusal::Asked { found, remedy } => Self::bad_input(found, remedy),
            Refusal::Scene { found, remedy } => Self::bad_input(format!("{}: {found}", scene.name), remedy),
            Refusal::CutShort(why) => Self::cut_short(why),
            Refusal::Report(error) => error.into(),
            Refusal::Other(why) => Self::other(why),
        }
    }
}
