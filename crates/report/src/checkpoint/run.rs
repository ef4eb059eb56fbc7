//! The path points of a run that is not finished yet, kept in a file as they come: a run that was interrupted loses none
//! but the last of them, and the next run of the same scene takes them up.

use super::damaged::{Damaged, DamagedPart, check_sum};
use super::growing_file::GrowingFile;
use super::lines::first_line;
use super::partial_file::PartialFile;
use crate::error::ReportError;
use crate::record::Object;
use crate::records::parameters::parameters;
use peelkit::solve::{PathOptions, Waypoint};
use peelkit_scene::{BoundsTable, Scene};
use serde::{Deserialize, Serialize};
use std::cell::RefCell;
use std::fs::File;
use std::io::{self, BufReader, ErrorKind, Read};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

/// The file of an unfinished run: a line that identifies the run, then a frame a path point, mesh by mesh. A frame is the
/// length and the CRC-32 of what follows, four bytes each, and a record in the format of the crate `postcard`, in which
/// a number keeps all of its bits.
#[derive(Debug)]
pub struct PartialRun {
    path: PathBuf,
    header: Vec<u8>,
    interval: Duration,
    /// Points of an earlier run, a path each.
    taken: RefCell<Vec<(PathOptions, Vec<Waypoint>)>>,
    points_taken: usize,
    damaged: Option<Damaged>,
    writing: RefCell<Writing>,
}

#[derive(Debug)]
struct Writing {
    /// None before the first write.
    file: Option<GrowingFile>,
    /// Of the part of the file that is whole; none where there is no file.
    length: Option<u64>,
    waiting: Vec<Record>,
    last: Instant,
    /// Why nothing more is written.
    trouble: Option<ReportError>,
}

/// The first line. Two runs have the same points where these lines are the same, whatever their bounds.
#[derive(Serialize)]
struct Header {
    peelkit: &'static str,
    scene: Object,
}

/// A point of the path that has these options.
#[derive(Debug, Serialize, Deserialize)]
struct Record {
    options: PathOptions,
    waypoint: Waypoint,
}

/// Nothing is written before a run has lasted so long, and then no oftener.
const INTERVAL: Duration = Duration::from_secs(1);
/// Bytes before the record of a frame.
const FRAME: usize = 8;

impl PartialFile for PartialRun {
    const NAME: &'static str = "run.partial";

    fn damaged(&self) -> Option<&Damaged> {
        self.damaged.as_ref()
    }
}

impl PartialRun {
    /// Takes up what the file in `dir` holds of this scene, if there is one. The file of another scene is refused. Nothing is
    /// written yet, and nothing ever where the run is short.
    ///
    /// Fails with [`ReportError::OtherRun`] or [`ReportError::Read`].
    pub fn open(dir: &Path, scene: &Scene) -> Result<Self, ReportError> {
        Self::with_interval(dir, scene, INTERVAL)
    }

    fn with_interval(dir: &Path, scene: &Scene, interval: Duration) -> Result<Self, ReportError> {
        let path = dir.join(Self::NAME);
        let header = header_of(&path, scene)?;
        let (Kept { records, damaged }, length) = match read(&path, &header) {
            Err(error) if error.kind() == ErrorKind::NotFound => (Kept::default(), None),
            Err(error) if error.kind() == ErrorKind::InvalidData => return Err(ReportError::OtherRun { path }),
            Err(source) => return Err(ReportError::Read { path, source }),
            Ok((kept, length)) => (kept, Some(length)),
        };
        let points_taken = records.len();
        let from = DamagedPart::PointsFrom(points_taken + 1);
        let damaged = damaged.then(|| Damaged { path: path.clone(), what: from });
        let writing = Writing { file: None, length, waiting: Vec::new(), last: Instant::now(), trouble: None };
        let (taken, writing) = (RefCell::new(by_path(records)), RefCell::new(writing));
        Ok(Self { path, header, interval, taken, points_taken, damaged, writing })
    }

    /// How many points an earlier run has kept.
    pub fn points_taken(&self) -> usize {
        self.points_taken
    }

    /// The first points of the path with these options, as far as they were kept; only once.
    pub fn taken(&self, options: &PathOptions) -> Vec<Waypoint> {
        let mut taken = self.taken.borrow_mut();
        let place = taken.iter().position(|(of, _)| of == options);
        place.map(|place| taken.swap_remove(place).1).unwrap_or_default()
    }

    /// Keeps a further point: in memory, and once in a while in the file.
    pub fn keep(&self, options: &PathOptions, waypoint: Waypoint) {
        let mut writing = self.writing.borrow_mut();
        if writing.trouble.is_some() {
            return;
        }
        writing.waiting.push(Record { options: *options, waypoint });
        if writing.last.elapsed() >= self.interval {
            self.flush(&mut writing);
        }
    }

    /// Where the file is, once there is one.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Writes what is not written yet, whatever the time. Whether there is a file then: a run that got no further than paths without
    /// some terms has no points to keep.
    ///
    /// Fails with the first [`ReportError::Write`] since the last call.
    pub fn write_all(&self) -> Result<bool, ReportError> {
        let mut writing = self.writing.borrow_mut();
        self.flush(&mut writing);
        writing.trouble.take().map_or(Ok(writing.length.is_some()), Err)
    }

    fn flush(&self, writing: &mut Writing) {
        if !writing.waiting.is_empty() {
            let written = self.append(writing);
            writing.trouble = written.err().map(|source| ReportError::Write { path: self.path.clone(), source });
            writing.waiting.clear();
        }
        writing.last = Instant::now();
    }

    fn append(&self, writing: &mut Writing) -> io::Result<()> {
        let mut text = if writing.length.is_some() { Vec::new() } else { self.header.clone() };
        for record in &writing.waiting {
            let record = postcard::to_stdvec(record).map_err(io::Error::other)?;
            text.extend(u32::try_from(record.len()).map_err(io::Error::other)?.to_le_bytes());
            text.extend(check_sum(&record).to_le_bytes());
            text.extend(record);
        }
        let length = writing.length.unwrap_or(0);
        if writing.file.is_none() {
            // what comes next does not continue a torn frame
            writing.file = Some(GrowingFile::open(&self.path, length)?);
        }
        writing.file.as_mut().map_or(Ok(()), |file| file.append(&text))?;
        writing.length = Some(length + text.len() as u64);
        Ok(())
    }
}

/// The first line of the file of a scene.
pub(super) fn header_of(path: &Path, scene: &Scene) -> Result<Vec<u8>, ReportError> {
    let bounds = BoundsTable::default();
    let scene = Scene { bounds, ..scene.clone() };
    let header = Header { peelkit: env!("CARGO_PKG_VERSION"), scene: parameters(&scene) };
    first_line(&header).map_err(|source| ReportError::Write { path: path.to_path_buf(), source })
}

/// What a file holds.
#[derive(Default)]
struct Kept {
    /// Up to the first that is torn or not as it was written
    records: Vec<Record>,
    /// Whether there is one that is not as it was written
    damaged: bool,
}

/// The records of a file that begins with `header`, and how many bytes they end at.
fn read(path: &Path, header: &[u8]) -> io::Result<(Kept, u64)> {
    let file = File::open(path)?;
    let mut left = file.metadata()?.len();
    let mut file = BufReader::new(file);
    let mut begin = Vec::new();
    (&mut file).take(header.len() as u64).read_to_end(&mut begin)?;
    if begin != header {
        return Err(ErrorKind::InvalidData.into());
    }
    let mut end = header.len() as u64;
    left -= end;
    let mut kept = Kept::default();
    while let Some((record, length)) = next(&mut file, left)? {
        let Some(record) = record else {
            kept.damaged = true;
            break;
        };
        kept.records.push(record);
        end += length;
        left -= length;
    }
    Ok((kept, end))
}

/// The next record, if it is as it was written, and the length of its frame; nothing where that is torn. There are `left` bytes.
fn next(file: &mut impl Read, left: u64) -> io::Result<Option<(Option<Record>, u64)>> {
    let mut frame = [0; FRAME];
    if left < FRAME as u64 {
        return Ok(None);
    }
    file.read_exact(&mut frame)?;
    let [a, b, c, d, e, f, g, h] = frame;
    let (length, sum) = (u32::from_le_bytes([a, b, c, d]), u32::from_le_bytes([e, f, g, h]));
    let whole = FRAME as u64 + u64::from(length);
    if left < whole {
        return Ok(None);
    }
    let mut record = vec![0; length as usize];
    file.read_exact(&mut record)?;
    let record = (check_sum(&record) == sum).then(|| postcard::from_bytes(&record).ok()).flatten();
    Ok(Some((record, whole)))
}

/// The points of each path, in their order.
fn by_path(records: Vec<Record>) -> Vec<(PathOptions, Vec<Waypoint>)> {
    let mut paths: Vec<(PathOptions, Vec<Waypoint>)> = Vec::new();
    for Record { options, waypoint } in records {
        match paths.iter_mut().find(|(of, _)| *of == options) {
            Some((_, path)) => path.push(waypoint),
            None => paths.push((options, vec![waypoint])),
        }
    }
    paths
}
