//! What an unfinished pull-off of a seta has reached, kept in a file: the next run of the same scene goes on from there, bit for bit.

use super::damaged::{Damaged, DamagedPart, check_sum};
use super::partial_file::PartialFile;
use super::run::{PartialRun, header_of};
use crate::error::ReportError;
use crate::file::write_whole;
use peelkit::study::SetaProgress;
use peelkit_scene::Scene;
use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};
use std::fs;
use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};

/// The file of an unfinished pull-off, [`PartialRun::NAME`]: the line of a [`PartialRun`], the CRC-32 of what follows in four bytes, and what was
/// reached, in the format of the crate `postcard`. It is written anew, whole or not at all.
#[derive(Debug)]
pub struct PartialSeta {
    path: PathBuf,
    header: Vec<u8>,
    damaged: Option<Damaged>,
}

/// What is kept: where the pull-off stands, and what was seen on the way.
#[derive(Debug, Serialize, Deserialize)]
pub struct SetaCheckpoint<S> {
    /// Where it stands
    pub progress: SetaProgress,
    /// What the caller has gathered so far
    pub seen: S,
}

impl PartialFile for PartialSeta {
    const NAME: &'static str = PartialRun::NAME;

    fn damaged(&self) -> Option<&Damaged> {
        self.damaged.as_ref()
    }
}

impl PartialSeta {
    /// What the file in `dir` holds of this scene, if there is one. The file of another scene is refused. Nothing is written yet.
    ///
    /// Fails with [`ReportError::OtherRun`] or [`ReportError::Read`].
    pub fn open<S: DeserializeOwned>(
        dir: &Path,
        scene: &Scene,
    ) -> Result<(Self, Option<SetaCheckpoint<S>>), ReportError> {
        let path = dir.join(Self::NAME);
        let header = header_of(&path, scene)?;
        let mut damaged = None;
        let kept = match fs::read(&path) {
            Err(error) if error.kind() == ErrorKind::NotFound => None,
            Err(source) => return Err(ReportError::Read { path, source }),
            Ok(bytes) => match bytes.strip_prefix(header.as_slice()) {
                Some(kept) => {
                    let whole = whole(kept);
                    let all = || Damaged { path: path.clone(), what: DamagedPart::Everything };
                    damaged = whole.is_none().then(all);
                    whole
                }
                None => return Err(ReportError::OtherRun { path }),
            },
        };
        Ok((Self { path, header, damaged }, kept))
    }

    /// Writes what was reached, in place of what was there.
    ///
    /// Fails with [`ReportError::Write`].
    pub fn write<S: Serialize>(&self, progress: &SetaProgress, seen: &S) -> Result<(), ReportError> {
        #[derive(Serialize)]
        struct Kept<'k, S> {
            progress: &'k SetaProgress,
            seen: &'k S,
        }
        let refuse = |source: io::Error| ReportError::Write { path: self.path.clone(), source };
        let record = postcard::to_stdvec(&Kept { progress, seen }).map_err(|error| refuse(io::Error::other(error)))?;
        let mut bytes = self.header.clone();
        bytes.extend(check_sum(&record).to_le_bytes());
        bytes.extend(record);
        self.path.parent().map_or(Ok(()), fs::create_dir_all).map_err(refuse)?;
        write_whole(&self.path, &bytes)
    }

    /// Where the file is.
    pub fn path(&self) -> &Path {
        &self.path
    }
}

/// What stands behind the first line, if it is as it was written.
fn whole<S: DeserializeOwned>(kept: &[u8]) -> Option<SetaCheckpoint<S>> {
    let (sum, record) = kept.split_first_chunk()?;
    (check_sum(record).to_le_bytes() == *sum).then(|| postcard::from_bytes(record).ok()).flatten()
}
