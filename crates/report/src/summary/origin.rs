//! Where an output comes from: which program wrote it, by which command, and which keys it has.

use crate::records::{SCHEMA, VERSION};
use peelkit_scene::Scene;
use serde::Serialize;

/// What every summary begins with.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct Origin {
    /// Of the program
    version: &'static str,
    /// Of these keys
    schema: u32,
    /// The command line; `None` where a program of another kind has written this
    command: Option<String>,
    scene: String,
    title: String,
}

impl Origin {
    pub fn of(scene: &Scene) -> Self {
        let Scene { name, title, .. } = scene;
        Self { version: VERSION, schema: SCHEMA, command: None, scene: name.clone(), title: title.clone() }
    }

    /// The same with the command line that it comes from.
    pub fn by(self, command: &str) -> Self {
        Self { command: Some(command.to_owned()), ..self }
    }
}
