//! What `run` and `sweep` read: a scene and the keys that replace those of its text.

use crate::terminal::folder_name::default_folder;
use crate::terminal::stop::Stop;
use clap::Args;
use peelkit_scene::{Scene, SceneError};
use std::fmt::Display;
use std::fs::{self, File};
use std::io::Read;
use std::path::{Path, PathBuf};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::thread;
use std::time::Duration;

#[derive(Args)]
pub struct SceneArgs {
    /// The scene: a TOML file; `peel new` writes a template
    #[arg(value_name = "SCENE")]
    pub path: PathBuf,

    /// Sets a key of the scene: strip.length="50 nm"; may be repeated
    #[arg(long = "set", value_name = "KEY=VALUE", value_parser = parse_override)]
    pub overrides: Vec<(String, String)>,
}

impl SceneArgs {
    /// Reads the scene of a peel: one with a seta is refused.
    pub fn load(&self) -> Result<Scene, Stop> {
        read_scene(&self.path, &self.overrides)
    }

    /// Reads the scene, which may have a seta or be pulled at a rate.
    pub fn load_any(&self) -> Result<Scene, Stop> {
        read_any_scene(&self.path, &self.overrides)
    }

    /// Where the outputs go when the user does not say; `parts` are what a command adds to the name.
    pub fn default_folder(&self, parts: &[String]) -> PathBuf {
        default_folder(&self.path, parts, &self.overrides)
    }
}

/// Reads a scene of a peel.
pub fn read_scene(path: &Path, overrides: &[(String, String)]) -> Result<Scene, Stop> {
    read(path, |name, text| Scene::parse(name, text, overrides))
}

/// Reads a scene, which may have a seta or be pulled at a rate.
pub fn read_any_scene(path: &Path, overrides: &[(String, String)]) -> Result<Scene, Stop> {
    read(path, |name, text| Scene::parse_any(name, text, overrides))
}

fn read(path: &Path, parse: impl FnOnce(&str, &str) -> Result<Scene, SceneError>) -> Result<Scene, Stop> {
    let name = path.display().to_string();
    let bytes = bytes(path)?;
    let text = String::from_utf8(bytes).map_err(|error| {
        let valid = error.utf8_error().valid_up_to();
        let line = 1 + error.as_bytes()[..valid].iter().filter(|&&byte| byte == b'\n').count();
        Stop::bad_input(
            format!("{name}, line {line}: this is not text in UTF-8"),
            "A scene is a TOML file, saved as UTF-8; `peel new` writes a template.",
        )
    })?;
    Ok(parse(&name, &text)?)
}

/// Most bytes of a scene.
const LARGEST: u64 = 10_000_000;
/// So long a pipe may say nothing.
const PATIENCE: Duration = Duration::from_secs(10);

/// The bytes of a file, or of a pipe whose other end writes.
fn bytes(path: &Path) -> Result<Vec<u8>, Stop> {
    let name = path.display().to_string();
    let refused =
        |why: &dyn Display, remedy: &str| Stop::bad_input(format!("cannot read the scene {name}: {why}"), remedy);
    const GIVE: &str = "Give the path of a scene file; `peel new` writes a template.";
    let kind = fs::metadata(path).map_err(|error| refused(&error, GIVE))?;
    if kind.is_dir() {
        return Err(refused(&"it is a folder", &in_folder(path)));
    }
    let (found, read) = channel();
    let own = path.to_path_buf();
    let reader = move || {
        let mut bytes = Vec::new();
        let whole = File::open(own).and_then(|file| file.take(LARGEST + 1).read_to_end(&mut bytes));
        // nobody listens any more where it has taken too long
        let _ = found.send(whole.map(|_| bytes));
    };
    thread::spawn(reader);
    let read = match kind.is_file() {
        true => read.recv().map_err(|_| RecvTimeoutError::Disconnected),
        false => read.recv_timeout(PATIENCE),
    };
    let seconds = PATIENCE.as_secs();
    let bytes = match read {
        Ok(whole) => whole.map_err(|error| refused(&error, GIVE))?,
        Err(_) => {
            return Err(refused(
                &format!("it is no file, and its other end was not written to and closed in {seconds} s"),
                "Give a scene file, or write the scene to the pipe at once.",
            ));
        }
    };
    if bytes.len() as u64 > LARGEST {
        return Err(refused(
            &format!("it has more than {} MB", LARGEST / 1_000_000),
            "Give a scene: a text of some lines. The table of a profile stands in a file of its own.",
        ));
    }
    Ok(bytes)
}

/// What to give in place of a folder: a scene in it, where there is one.
fn in_folder(path: &Path) -> String {
    let is_scene = |file: &PathBuf| file.extension().is_some_and(|extension| extension == "toml");
    let files = fs::read_dir(path).into_iter().flatten().flatten().map(|entry| entry.path());
    match files.filter(is_scene).min() {
        Some(scene) => format!("Give a file in it, such as {}.", scene.display()),
        None => "Give the path of a scene file; `peel new` writes a template.".to_owned(),
    }
}

pub fn parse_override(text: &str) -> Result<(String, String), String> {
    let (key, value) = text.split_once('=').ok_or("write KEY=VALUE, for example strip.length=\"50 nm\"")?;
    Ok((key.trim().to_owned(), value.to_owned()))
}
