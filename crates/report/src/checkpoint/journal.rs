//! What an unfinished command has found: values under keys, in a file that grows while it computes. The next command of the same scene takes them up, bit
//! for bit.
//!
//! ```text
//! frame 1        what the file is of: analysis, version, settings, scene
//! frame 2 ...    a key with its value each; of two with the same key the later one counts
//! ```
//!
//! Keys and values are in the format of the crate `postcard`, in which a number keeps all of its bits.

use super::frames::{Frame, Scan, framed};
use super::header;
use super::kind::JournalKind;
use crate::writing::error::ReportError;
use crate::writing::file::{remove, replace};
use peelkit_scene::Scene;
use serde::Serialize;
use serde::de::DeserializeOwned;
use std::collections::HashMap;
use std::fs::{self, File, OpenOptions};
use std::io::{self, ErrorKind, Read, Seek, SeekFrom, Write};
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::Instant;

/// What an analysis keeps while it computes, and what an earlier one has kept. It may be used from any thread.
#[derive(Debug)]
pub struct Journal {
    kind: JournalKind,
    path: PathBuf,
    entries: usize,
    /// None where nothing is kept
    growing: Option<Mutex<Growing>>,
}

/// The file, and what of it counts.
#[derive(Debug)]
struct Growing {
    path: PathBuf,
    /// The first frame
    header: Vec<u8>,
    /// None before the first write
    file: Option<File>,
    /// Bytes of the file
    length: u64,
    /// What comes behind these
    waiting: Vec<u8>,
    /// The frames that count, by their keys
    places: HashMap<Vec<u8>, Range<u64>>,
    /// Bytes of frames that do not count any more
    superseded: u64,
    /// What comes next in each sequence
    next: HashMap<Vec<u8>, u64>,
    last: Instant,
    /// Whether something could not be written; nothing more is, then
    broken: bool,
    trouble: Option<ReportError>,
}

impl Journal {
    /// Keeps nothing and knows nothing.
    pub fn nowhere() -> Self {
        Self { kind: JournalKind::RUN, path: PathBuf::new(), entries: 0, growing: None }
    }

    /// Opens the file in `dir`, or begins it, of this scene with these settings, each with its name. The file of another scene, of other settings or of
    /// another version, and one in which something has changed since it was written, is refused and left as it is. What was torn at its end is cut off.
    ///
    /// Fails with [`ReportError::OtherCheckpoint`], [`ReportError::OlderCheckpoint`], [`ReportError::NoCheckpoint`], [`ReportError::Read`] or
    /// [`ReportError::Write`].
    pub fn open(dir: &Path, kind: JournalKind, scene: &Scene, settings: &[(&str, &str)]) -> Result<Self, ReportError> {
        let path = dir.join(kind.name);
        let refuse = |source: io::Error| ReportError::Write { path: path.clone(), source };
        let wanted = header::text(kind.analysis, scene, settings).map_err(refuse)?;
        let mut growing = Growing::new(&path, framed(&[], &wanted).map_err(refuse)?);
        let bytes = match fs::read(&path) {
            Err(error) if error.kind() == ErrorKind::NotFound => Vec::new(),
            read => read.map_err(|source| ReportError::Read { path: path.clone(), source })?,
        };
        kind.refuse_older(&path, &bytes)?;
        // one that was torn in its header holds nothing
        if !growing.header.starts_with(&bytes) || bytes.len() == growing.header.len() {
            let scan = Scan::of(&bytes);
            refuse_other(&path, &bytes, &scan, &wanted)?;
            growing.take_up(&bytes, &scan).map_err(refuse)?;
        }
        if kind.interval.is_zero() {
            growing.write().map_err(refuse)?;
        }
        let entries = growing.places.len();
        Ok(Self { kind, path, entries, growing: Some(Mutex::new(growing)) })
    }

    /// Whether anything is kept.
    pub fn is_kept(&self) -> bool {
        self.growing.is_some()
    }

    /// How many values an earlier command has kept.
    pub fn entries(&self) -> usize {
        self.entries
    }

    fn growing(&self) -> Option<MutexGuard<'_, Growing>> {
        self.growing.as_ref().map(|growing| growing.lock().unwrap_or_else(PoisonError::into_inner))
    }

    /// The value that was kept under this key.
    pub fn known<V: DeserializeOwned>(&self, key: &impl Serialize) -> Option<V> {
        let value = self.growing()?.value(&postcard::to_stdvec(key).ok()?)?;
        postcard::from_bytes(&value).ok()
    }

    /// Keeps a value under a key, in place of one that was there. Where it cannot be written, [`Journal::check`] says so.
    pub fn keep(&self, key: &impl Serialize, value: &impl Serialize) {
        let Some(mut growing) = self.growing() else { return };
        if growing.broken {
            return;
        }
        let kept = growing.keep(key, value);
        let due = kept.is_err() || growing.last.elapsed() >= self.kind.interval;
        let written = kept.and_then(|()| if due { growing.write() } else { Ok(()) });
        growing.note(written);
    }

    /// The first values of the sequence of this name, as far as an earlier command has kept them; only once.
    pub fn sequence<V: DeserializeOwned>(&self, name: &impl Serialize) -> Vec<V> {
        let key = postcard::to_stdvec(name).unwrap_or_default();
        let is_new = self.growing().is_some_and(|mut growing| growing.next.insert(key.clone(), 0).is_none());
        let kept = (0_u64..).map_while(|place| self.known(&(name, place)));
        let values: Vec<V> = if is_new { kept.collect() } else { Vec::new() };
        if let Some(mut growing) = self.growing() {
            growing.next.insert(key, values.len() as u64);
        }
        values
    }

    /// Keeps the next value of the sequence of this name.
    pub fn append(&self, name: &impl Serialize, value: &impl Serialize) {
        let place = self.growing().map_or(0, |mut growing| {
            let next = growing.next.entry(postcard::to_stdvec(name).unwrap_or_default()).or_default();
            *next += 1;
            *next - 1
        });
        self.keep(&(name, place), value);
    }

    /// Whether all could be written so far.
    pub fn works(&self) -> bool {
        self.growing().is_none_or(|growing| !growing.broken)
    }

    /// Tells, once, what could not be written.
    ///
    /// Fails with [`ReportError::Write`].
    pub fn check(&self) -> Result<(), ReportError> {
        self.growing().and_then(|mut growing| growing.trouble.take()).map_or(Ok(()), Err)
    }

    /// Writes what is not written yet, whatever the time; whether there is a file then: where nothing was kept there need be none.
    ///
    /// Fails as [`Journal::check`] does.
    pub fn flush(&self) -> Result<bool, ReportError> {
        if let Some(mut growing) = self.growing().filter(|growing| !growing.broken && !growing.places.is_empty()) {
            let written = growing.write();
            growing.note(written);
        }
        self.check().map(|()| self.growing().is_some_and(|growing| growing.file.is_some()))
    }

    /// To be asked once the files of a command are written, or were not. What is finished and written needs no journal any more; of what is not
    /// finished all is kept; where, in words.
    ///
    /// Fails with [`ReportError::Write`].
    pub fn settle(&self, is_finished: bool, is_written: bool) -> Result<Option<String>, ReportError> {
        let entries = self.kind.entries;
        match self.growing() {
            None => return Ok(None),
            Some(mut growing) if is_finished && is_written => {
                growing.file = None;
                return remove(self.path.clone()).map(|()| None);
            }
            Some(_) if is_finished => return Ok(None),
            Some(_) => {}
        }
        Ok(Some(match self.flush()? {
            true => format!("its {entries} are kept in {}", self.path.display()),
            false => format!("it had no {entries} to keep"),
        }))
    }
}

/// Refuses a file whose first frame is another one than that of this header, and one of which a frame is not as it was written.
fn refuse_other(path: &Path, bytes: &[u8], scan: &Scan, wanted: &[u8]) -> Result<(), ReportError> {
    let reason = match (scan.damage(), scan.frames.first()) {
        (Some(damage), _) => damage,
        (None, Some(first)) if first.key().is_empty() => match &bytes[first.value()] {
            found if found == wanted => return Ok(()),
            found => return Err(header::other(path, found, wanted)),
        },
        (None, _) => "it ends in its first frame".to_owned(),
    };
    Err(ReportError::NoCheckpoint { path: path.to_path_buf(), reason })
}

impl Growing {
    fn new(path: &Path, header: Vec<u8>) -> Self {
        Self {
            path: path.to_path_buf(),
            waiting: header.clone(),
            header,
            file: None,
            length: 0,
            places: HashMap::new(),
            superseded: 0,
            next: HashMap::new(),
            last: Instant::now(),
            broken: false,
            trouble: None,
        }
    }

    /// Goes on behind what a file holds. What does not count is cut off.
    fn take_up(&mut self, bytes: &[u8], scan: &Scan) -> io::Result<()> {
        self.waiting.clear();
        let file = reopened(&self.path)?;
        // what comes next does not continue a torn frame
        file.set_len(scan.end as u64)?;
        (self.file, self.length) = (Some(file), scan.end as u64);
        for frame in &scan.frames[1..] {
            let Range { start, end } = frame.place();
            self.count(bytes[frame.key()].to_vec(), start as u64..end as u64);
        }
        Ok(())
    }

    fn count(&mut self, key: Vec<u8>, place: Range<u64>) {
        self.superseded += self.places.insert(key, place).map_or(0, |earlier| earlier.end - earlier.start);
    }

    /// The bytes at this place, of the file or of what waits.
    fn bytes(&mut self, place: Range<u64>) -> io::Result<Vec<u8>> {
        match &mut self.file {
            Some(file) if place.start < self.length => {
                let mut bytes = vec![0; (place.end - place.start) as usize];
                file.seek(SeekFrom::Start(place.start))?;
                file.read_exact(&mut bytes)?;
                Ok(bytes)
            }
            _ => {
                let [start, end] = [place.start, place.end].map(|place| (place - self.length) as usize);
                Ok(self.waiting[start..end].to_vec())
            }
        }
    }

    fn value(&mut self, key: &[u8]) -> Option<Vec<u8>> {
        let place = self.places.get(key)?.clone();
        let frame = self.bytes(place).ok()?;
        let value = Scan::of(&frame).frames.first().map(Frame::value)?;
        frame.get(value).map(<[u8]>::to_vec)
    }

    fn keep(&mut self, key: &impl Serialize, value: &impl Serialize) -> io::Result<()> {
        let [key, value] = [postcard::to_stdvec(key), postcard::to_stdvec(value)];
        let (key, value) = (key.map_err(io::Error::other)?, value.map_err(io::Error::other)?);
        let frame = framed(&key, &value)?;
        let start = self.length + self.waiting.len() as u64;
        self.count(key, start..start + frame.len() as u64);
        self.waiting.extend(frame);
        Ok(())
    }

    /// Appends what waits. A file that was removed meanwhile is written again, and so is one more than half of which does not count any more.
    fn write(&mut self) -> io::Result<()> {
        self.last = Instant::now();
        let length = self.length + self.waiting.len() as u64;
        match &mut self.file {
            Some(file) if 2 * self.superseded <= length && self.path.exists() => {
                file.write_all(&self.waiting)?;
                self.waiting.clear();
                self.length = length;
                Ok(())
            }
            _ => self.rewrite(),
        }
    }

    /// Writes the whole file, with what counts alone: what it held is still read through its handle.
    fn rewrite(&mut self) -> io::Result<()> {
        let mut kept: Vec<(Vec<u8>, Range<u64>)> = self.places.drain().collect();
        kept.sort_by_key(|(_, place)| place.start);
        let mut whole = self.header.clone();
        let mut places = HashMap::with_capacity(kept.len());
        for (key, place) in kept {
            let start = whole.len() as u64;
            whole.extend(self.bytes(place)?);
            places.insert(key, start..whole.len() as u64);
        }
        replace(&self.path, &whole)?;
        self.file = Some(reopened(&self.path)?);
        (self.length, self.superseded, self.places) = (whole.len() as u64, 0, places);
        self.waiting.clear();
        Ok(())
    }

    fn note(&mut self, written: io::Result<()>) {
        if let Err(source) = written {
            self.broken = true;
            self.trouble = Some(ReportError::Write { path: self.path.clone(), source });
        }
    }
}

fn reopened(path: &Path) -> io::Result<File> {
    OpenOptions::new().create(true).read(true).append(true).open(path)
}

#[cfg(test)]
mod tests {
    use super::*;

    const KINDS: [JournalKind; 5] =
        [JournalKind::RUN, JournalKind::SETA, JournalKind::SWEEP, JournalKind::SAMPLE, JournalKind::OPTIMISATION];

    fn scene(height: &str) -> Scene {
        let text = format!(
            "strip = {{ length = \"100 nm\", height = \"{height} nm\", youngs_modulus = \"2 GPa\" }}\n\
             adhesion = {{ hamaker_constant = \"1e-19 J\", equilibrium_distance = \"0.4 nm\" }}"
        );
        Scene::parse("a.toml", &text, &[]).unwrap()
    }

    fn open(dir: &Path, kind: JournalKind) -> Journal {
        Journal::open(dir, kind, &scene("10"), &[("key", "strip.length")]).unwrap()
    }

    /// A file with three values.
    fn kept(dir: &Path, kind: JournalKind) -> PathBuf {
        let journal = open(dir, kind);
        for key in 1..=3_u32 {
            journal.keep(&key, &(f64::from(key) + 0.1 + 0.2));
        }
        assert!(journal.flush().unwrap());
        dir.join(kind.name)
    }

    fn values(journal: &Journal) -> Vec<Option<f64>> {
        (1..=3_u32).map(|key| journal.known(&key)).collect()
    }

    #[test]
    fn values_come_back_bit_for_bit() {
        let dir = tempfile::tempdir().unwrap();
        let numbers = [0.1 + 0.2, -0.0, 5e-324, f64::NAN, f64::INFINITY, 1.797_693_134_862_315_7e308, 1.0 / 3.0];
        let journal = open(dir.path(), JournalKind::SWEEP);
        for (key, number) in numbers.iter().enumerate() {
            journal.keep(&(key, Some(number)), number);
        }
        let again = open(dir.path(), JournalKind::SWEEP);
        for journal in [&journal, &again] {
            for (key, number) in numbers.iter().enumerate() {
                let found: f64 = journal.known(&(key, Some(number))).unwrap();
                assert_eq!(found.to_bits(), number.to_bits());
            }
            assert_eq!(journal.known::<f64>(&(0_usize, None::<f64>)), None);
        }
        assert_eq!((journal.entries(), again.entries()), (0, numbers.len()));
    }

    #[test]
    fn every_kind_survives_a_torn_end() {
        for kind in KINDS {
            let dir = tempfile::tempdir().unwrap();
            let path = kept(dir.path(), kind);
            let whole = fs::read(&path).unwrap();
            fs::write(&path, &whole[..whole.len() - 3]).unwrap();
            let torn = open(dir.path(), kind);
            assert_eq!(values(&torn), [Some(1.0 + 0.1 + 0.2), Some(2.0 + 0.1 + 0.2), None], "{kind:?}");
            torn.keep(&3_u32, &0.5);
            torn.flush().unwrap();
            assert_eq!(values(&open(dir.path(), kind))[2], Some(0.5));
        }
    }

    #[test]
    fn a_changed_byte_is_refused_with_its_frame_and_the_file_is_left() {
        for kind in KINDS {
            let dir = tempfile::tempdir().unwrap();
            let path = kept(dir.path(), kind);
            let whole = fs::read(&path).unwrap();
            for (number, frame) in Scan::of(&whole).frames.iter().enumerate() {
                for at in [frame.place().start, frame.value().start] {
                    let mut changed = whole.clone();
                    changed[at] ^= 1;
                    fs::write(&path, &changed).unwrap();
                    let error = Journal::open(dir.path(), kind, &scene("10"), &[("key", "strip.length")]).unwrap_err();
                    let place =
                        format!("frame {} (bytes {} to {})", number + 1, frame.place().start, frame.place().end - 1);
                    assert!(
                        matches!(error, ReportError::NoCheckpoint { .. }) && error.to_string().contains(&place),
                        "{error}"
                    );
                    assert_eq!(fs::read(&path).unwrap(), changed);
                }
            }
        }
    }

    #[test]
    fn another_scene_setting_or_version_is_refused_with_the_difference_and_kept() {
        for kind in KINDS {
            let dir = tempfile::tempdir().unwrap();
            let path = kept(dir.path(), kind);
            let whole = fs::read(&path).unwrap();
            let header = Scan::of(&whole).frames[0].clone();
            let with_header = |text: String| {
                [framed(&[], text.as_bytes()).unwrap().as_slice(), &whole[header.place().end..]].concat()
            };
            let text = String::from_utf8(whole[header.value()].to_vec()).unwrap();
            let part = [("key", "strip.length"), ("part", "1/2")];
            let of = format!("is the checkpoint of an interrupted {} of another ", kind.analysis);
            for (bytes, height, settings, words) in [
                (&whole, "9", &part[..1], format!("{of}scene: strip.height_nm is 10.0 there, and 9.0 here")),
                (
                    &whole,
                    "10",
                    &[("key", "strip.height")],
                    format!("{of}key: key is strip.length there, and strip.height here"),
                ),
                (&whole, "10", &part, format!("{of}part: part is not given there, and 1/2 here")),
                (
                    &with_header(text.replacen(env!("CARGO_PKG_VERSION"), "0.0.9", 1)),
                    "10",
                    &part[..1],
                    format!("{of}version: version is 0.0.9 there, and {} here", env!("CARGO_PKG_VERSION")),
                ),
                (
                    &b"garbled".to_vec(),
                    "10",
                    &part[..1],
                    "is not a checkpoint that this version of peel can read".to_owned(),
                ),
            ] {
                fs::write(&path, bytes).unwrap();
                let error = Journal::open(dir.path(), kind, &scene(height), settings).unwrap_err().to_string();
                assert!(error.contains(&words) && error.contains(kind.name), "{words}\n{error}");
                assert_eq!(fs::read(&path).unwrap(), *bytes);
            }
            // of another analysis
            let other = KINDS[(KINDS.iter().position(|other| *other == kind).unwrap() + 2) % KINDS.len()];
            fs::write(dir.path().join(other.name), &whole).unwrap();
            let error = Journal::open(dir.path(), other, &scene("10"), &part[..1]).unwrap_err().to_string();
            let words = format!("{of}kind: kind is {} there, and {} here", kind.analysis, other.analysis);
            assert!(error.contains(&words), "{error}");
            // of an older version
            let name =
                if path.ends_with("run.partial") { kind.name.to_owned() } else { format!("{}.jsonl", kind.name) };
            kind.discard(dir.path()).unwrap();
            fs::write(dir.path().join(&name), "{\"peelkit\":\"0.1.0\",\"scene\":{}}\n\u{0}").unwrap();
            assert!(kind.is_in(dir.path()));
            let error = Journal::open(dir.path(), kind, &scene("10"), &part[..1]).unwrap_err();
            assert!(
                matches!(&error, ReportError::OlderCheckpoint { version: Some(version), .. } if version == "0.1.0")
            );
            assert!(
                error.to_string().contains(&format!("{name} is a checkpoint that peel 0.1.0 has written")),
                "{error}"
            );
            kind.discard(dir.path()).unwrap();
            assert!(!kind.is_in(dir.path()) && values(&open(dir.path(), kind)) == [None; 3]);
        }
    }

    #[test]
    fn one_that_was_torn_in_its_header_is_begun_anew() {
        let dir = tempfile::tempdir().unwrap();
        let path = kept(dir.path(), JournalKind::SWEEP);
        let whole = fs::read(&path).unwrap();
        for end in [0, 1, 100] {
            fs::write(&path, &whole[..end]).unwrap();
            assert_eq!(open(dir.path(), JournalKind::SWEEP).entries(), 0);
            assert_eq!(fs::read(&path).unwrap(), whole[..Scan::of(&whole).frames[0].place().end]);
        }
    }

    #[test]
    fn a_folder_that_is_removed_meanwhile_is_made_again_with_all_values() {
        for kind in KINDS {
            let dir = tempfile::tempdir().unwrap();
            let out = dir.path().join("deep/out");
            kept(&out, kind);
            let journal = open(&out, kind);
            for value in [4_u32, 5] {
                fs::remove_dir_all(&out).unwrap();
                journal.keep(&value, &f64::from(value));
                journal.flush().unwrap();
            }
            assert_eq!(open(&out, kind).entries(), 5);
        }
    }

    #[test]
    fn a_value_in_place_of_another_one_does_not_let_the_file_grow() {
        let dir = tempfile::tempdir().unwrap();
        let journal = open(dir.path(), JournalKind::SWEEP);
        let large = vec![1.0; 1000];
        for round in 0..50_u32 {
            journal.keep(&"where", &(round, &large));
            let length = fs::metadata(dir.path().join("sweep.partial")).unwrap().len();
            assert!(length < 3 * 8 * 1000, "{length} bytes in round {round}");
        }
        for journal in [journal, open(dir.path(), JournalKind::SWEEP)] {
            assert_eq!(journal.known::<(u32, Vec<f64>)>(&"where").unwrap().0, 49);
        }
    }

    #[test]
    fn a_sequence_is_known_once() {
        let dir = tempfile::tempdir().unwrap();
        let journal = open(dir.path(), JournalKind::RUN);
        for (name, value) in [("a", 0_u32), ("b", 10), ("a", 1), ("a", 2), ("b", 11)] {
            journal.append(&name, &value);
        }
        journal.flush().unwrap();
        let journal = open(dir.path(), JournalKind::RUN);
        let of = |name: &str| journal.sequence::<u32>(&name);
        assert_eq!((of("a"), of("b"), of("b"), of("c")), (vec![0, 1, 2], vec![10, 11], vec![], vec![]));
        journal.append(&"a", &3_u32);
        journal.flush().unwrap();
        assert_eq!(open(dir.path(), JournalKind::RUN).sequence::<u32>(&"a"), [0, 1, 2, 3]);
    }

    #[test]
    fn of_a_short_run_nothing_is_written_before_it_is_settled() {
        let dir = tempfile::tempdir().unwrap();
        for (finished, words) in [(true, None), (false, Some("its points are kept in "))] {
            let journal = open(dir.path(), JournalKind::RUN);
            assert!(!JournalKind::RUN.is_in(dir.path()));
            let nothing = journal.settle(false, true).unwrap().unwrap();
            assert_eq!(nothing, "it had no points to keep");
            journal.append(&"path", &1.0);
            assert!(!JournalKind::RUN.is_in(dir.path()));
            let settled = journal.settle(finished, true).unwrap();
            assert_eq!(settled.is_some(), words.is_some());
            assert!(settled.unwrap_or_default().starts_with(words.unwrap_or_default()));
            assert_eq!(JournalKind::RUN.is_in(dir.path()), !finished);
        }
        assert_eq!(open(dir.path(), JournalKind::RUN).settle(true, false).unwrap(), None);
        assert!(JournalKind::RUN.is_in(dir.path()), "what was not written is kept");
        assert_eq!(Journal::nowhere().settle(false, true).unwrap(), None);
    }

    #[test]
    fn what_cannot_be_written_is_told_once_and_nothing_more_is_written() {
        let dir = tempfile::tempdir().unwrap();
        let out = dir.path().join("out");
        let journal = open(&out, JournalKind::SWEEP);
        fs::remove_dir_all(&out).unwrap();
        fs::write(&out, "in the way").unwrap();
        journal.keep(&1_u32, &1.0);
        assert!(!journal.works());
        assert!(journal.check().unwrap_err().to_string().contains("sweep.partial"));
        journal.keep(&2_u32, &1.0);
        assert!(journal.check().is_ok() && !journal.works());
    }
}
