//! The law of a seta that an array asks for and that is not there: made before the array is computed, as `peel coarsen` makes it.

use crate::outcome::{Analysis, Outcome, Refusal};
use crate::session::Session;
use crate::seta_law::{DIRECTIONS, SetaLawCoarsening};
use peelkit::study::coarsening::SetaLawOptions;
use peelkit_report::{Existing, OutputFolder, ReportError};
use peelkit_scene::{FittedSeta, SETA_LAW, Scene};
use std::fmt;
use std::path::PathBuf;

/// What a band takes.
const OF_A_BAND: usize = 2;
/// What a patch takes at most, which is the most accurate.
const OF_A_PATCH: usize = 4;

/// The law that the setae of a scene lack: its folder, and the seta that it is to be of.
pub struct MissingLaw {
    seta: Scene,
    folder: PathBuf,
    degree: usize,
}

impl MissingLaw {
    /// Of a scene; none where it lacks none.
    ///
    /// Fails where there can be no law of the seta.
    pub fn of(scene: &Scene) -> Result<Option<Self>, Refusal> {
        let Some(table) = &scene.array else { return Ok(None) };
        let (Some(FittedSeta::Missing { folder, .. }), Some(seta)) = (&table.fitted, &table.seta) else {
            return Ok(None);
        };
        let seta = Scene::parse_any("the scene of `setae.seta`", &seta.text, &[]);
        let seta = seta.map_err(|error| Refusal::asked(&error, error.remedy()))?;
        let folder = scene.beside(folder);
        let degree = if table.patch.is_some() { OF_A_PATCH } else { OF_A_BAND };
        let made = Self { seta, folder, degree };
        SetaLawCoarsening::of(&made.seta, made.asked())?;
        Ok(Some(made))
    }

    /// What is asked of it.
    fn asked(&self) -> SetaLawOptions {
        SetaLawOptions { degree: self.degree, ..SetaLawOptions::default() }
    }

    /// The scene of its seta.
    pub fn seta(&self) -> &Scene {
        &self.seta
    }

    /// Makes it in its folder. One that another program has made there meanwhile stays.
    ///
    /// Fails where the seta cannot be pulled, its bounds stop it, and where the folder cannot be written.
    pub fn make(&self, session: &Session, command: &str) -> Result<(), Refusal> {
        let coarsening = SetaLawCoarsening::of(&self.seta, self.asked())?;
        let output = match OutputFolder::claim(&self.folder, Existing::Keep, coarsening.journal()) {
            Err(ReportError::Exists { .. }) if self.folder.join(SETA_LAW).is_file() => return Ok(()),
            claimed => claimed?,
        };
        let found = coarsening.run(session)?;
        output.write(|dir| found.write(&self.seta, dir, command))?;
        Ok(())
    }
}

impl fmt::Display for MissingLaw {
    /// What is made, where, and of what.
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let Self { seta, folder, degree } = self;
        let (title, folder, pulls) = (&seta.title, folder.display(), DIRECTIONS.len());
        write!(f, "the law of the setae is made in {folder}, of degree {degree}: {pulls} pulls of \"{title}\"")
    }
}
