//! A scene that is ready to be computed: where its setae lack their law it is made first.

use crate::studies::drive::Eyes;
use crate::terminal::command_line::command_line;
use crate::terminal::interrupt::Interrupt;
use crate::terminal::output::note;
use crate::terminal::progress::Bar;
use crate::terminal::stop::Stop;
use peelkit_analyses::{MissingLaw, Session};
use peelkit_scene::Scene;

/// What is read, and read again once the law of its setae is made. Ctrl-C meanwhile ends the command, with nothing written.
pub fn ready(read: impl Fn() -> Result<Scene, Stop>) -> Result<Scene, Stop> {
    let scene = read()?;
    let Some(missing) = MissingLaw::of(&scene).map_err(|why| Stop::refused(&scene, why))? else { return Ok(scene) };
    note(&missing);
    let eyes = Eyes { bar: Bar::counted(), interrupt: Interrupt::deaf() };
    let made = missing.make(&Session { watcher: &eyes, keeping: None, abrupt: true }, &command_line());
    eyes.bar.finish();
    made.map_err(|why| Stop::refused(missing.seta(), why))?;
    read()
}
