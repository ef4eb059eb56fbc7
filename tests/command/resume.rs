//! Analyses that are killed, interrupted or out of time, and go on where they stopped.
//!
//!     results:   o--o--o--o | o--o--o--o--o
//!     run 1      computed   ^ kill, Ctrl-C or bounds.time: what is to the left is kept in a file of the folder
//!     run 2      taken        computed
//!
//! Parameters: one row a kind of analysis, each some seconds long; stopped once its file holds so many results. Reference: the same command without an
//! interruption, on one core; the second run has two. Expected: exit status 3 after Ctrl-C, what was reached is written, and the message says how to go
//! on; behind the second run the same files, byte for byte but for the seconds that were measured, and no other. Why: what takes hours must not be
//! lost, and neither an interruption nor the machine may change a digit.
#![cfg(unix)]

use crate::frames::{Frame, frames};
use crate::interrupt::signals_are_ignored;
use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use std::sync::OnceLock;
use std::time::{Duration, Instant};
use tempfile::{TempDir, tempdir};

/// A kind of analysis.
pub struct Row {
    pub name: &'static str,
    /// The text of a.toml
    pub scene: &'static str,
    /// Behind `peel`
    pub command: &'static [&'static str],
    /// The file in which it keeps what it finds
    pub partial: &'static str,
    /// It is stopped once there are so many results
    results: usize,
    /// Whether each result is counted in what the second run says
    counts: bool,
    /// Of a run: `bounds.time` that lets it stop before its end
    time: Option<&'static str>,
}

const STRIP: &str = include_str!("../../scenes/strip-100nm.toml");
const WIDTH: &str = "[strip]\nlength = \"100 nm\"\nheight = \"10 nm\"\nwidth = \"10 nm\"\nyoungs_modulus = \"2 GPa\"\n\
    [adhesion]\nhamaker_constant = \"1e-19 J\"\nequilibrium_distance = \"0.4 nm\"\n[optimise]\n\
    objective = \"initiation_peak.force_nN\"\nwidth = { from = \"5 nm\", to = \"20 nm\", slope = 0.2 }\nvalues = 5\nneighbours = 4\n";
const STIFFNESS: &str = "[strip]\nlength = \"100 nm\"\nheight = \"10 nm\"\nyoungs_modulus = \"2 GPa\"\n\
    [adhesion]\nhamaker_constant = \"1e-19 J\"\nequilibrium_distance = \"0.4 nm\"\n[optimise]\n\
    objective = \"first_jump.work_aJ\"\nstarts = 2\nneighbours = 10\ncheck = true\n\
    parameters = [{ key = \"strip.bending_stiffness_factor\", from = 0.01, to = 100 }]\n";
const PULL_OFF: &str = "[seta]\nforks = 1\nshaft_diameter = \"2 um\"\n[spatula]\n[accuracy]\nrelative = 1e-4\n\
    [adhesion]\nhamaker_constant = \"1e-19 J\"\nequilibrium_distance = \"0.4 nm\"\n\
    [uncertainty]\nquantities = [\"peak.force_nN\"]\nsamples = 60\nindices = false\n\
    inputs = [{ key = \"seta.youngs_modulus\", distribution = \"normal\", deviation = \"0.1 GPa\" }]\n\
    [optimise]\nobjective = \"peak.force_nN\"\nstarts = 2\nevaluations = 20\nneighbours = 1\n\
    parameters = [{ key = \"seta.shaft_angle\", from = \"30 deg\", to = \"75 deg\" }]\n";
const RATE: &str = "[strip]\nlength = \"40 nm\"\nheight = \"10 nm\"\nyoungs_modulus = \"2 GPa\"\n[time]\nrate = \"10 mm/s\"\n\
    density = \"1300 kg/m3\"\nmaterial = \"kelvin-voigt\"\nretardation_time = \"0.1 us\"\ndisplacement = \"6 nm\"\ntolerance = 1e-3\n\
    [accuracy]\nelements = 12\n[adhesion]\nhamaker_constant = \"1e-19 J\"\nequilibrium_distance = \"0.4 nm\"\n";
const UNCERTAIN: &str = include_str!("../../scenes/strip-uncertain.toml");

/// Every kind of analysis that keeps what it finds.
pub const ROWS: [Row; 14] = [
    Row {
        name: "a path on which Newton's method is slow",
        scene: include_str!("../../scenes/hard/unshearable.toml"),
        command: &["run", "--set", "accuracy.elements=480", "--set", "accuracy.step=1e-5"],
        partial: "run.partial",
        results: 2,
        counts: true,
        time: Some("0.3 s"),
    },
    Row {
        name: "a strip as a solid",
        scene: include_str!("../../scenes/solid-strip.toml"),
        command: &["run", "--set", "bounds.displacement=10 nm", "--set", "accuracy.step=1e-4"],
        partial: "run.partial",
        results: 10,
        counts: true,
        time: Some("0.3 s"),
    },
    Row {
        name: "a seta that is pressed on, with states",
        scene: include_str!("../../scenes/seta.toml"),
        command: &["run", "--states", "4", "--set", "seta.forks=7", "--set", "seta.preload=0.1 uN"],
        partial: "run.partial",
        results: 1,
        counts: false,
        time: Some("0.3 s"),
    },
    Row {
        name: "a seta by a table",
        scene: include_str!("../../scenes/seta.toml"),
        command: &["run", "--set", "seta.tip_law=table", "--set", "seta.tip_tolerance=3e-2", "--set", "seta.forks=6"],
        partial: "run.partial",
        results: 1,
        counts: false,
        time: None,
    },
    Row {
        name: "a seta whose spatulae are beams",
        scene: include_str!("../../scenes/seta-of-beams.toml"),
        command: &["run", "--set", "bounds.displacement=800 nm"],
        partial: "run.partial",
        results: 1,
        counts: false,
        time: None,
    },
    Row {
        name: "a sweep",
        scene: STRIP,
        command: &["sweep", "--vary", "strip.length", "--from", "60 nm", "--to", "120 nm", "--points", "20"],
        partial: "sweep.partial",
        results: 3,
        counts: true,
        time: None,
    },
    Row {
        name: "a plane",
        scene: STRIP,
        command: &[
            "sweep",
            "--vary",
            "strip.height",
            "--values",
            "9,10,11 nm",
            "--vary",
            "strip.youngs_modulus",
            "--log",
            "--from",
            "1 GPa",
            "--to",
            "4 GPa",
            "--points",
            "6",
        ],
        partial: "sweep.partial",
        results: 3,
        counts: true,
        time: None,
    },
    Row {
        name: "a part of a sweep",
        scene: STRIP,
        command: &[
            "sweep",
            "--part",
            "2/2",
            "--vary",
            "strip.length",
            "--from",
            "60 nm",
            "--to",
            "120 nm",
            "--points",
            "40",
        ],
        partial: "sweep.partial",
        results: 3,
        counts: true,
        time: None,
    },
    Row {
        name: "a sweep of setae",
        scene: PULL_OFF,
        command: &["sweep", "--vary", "seta.shaft_angle", "--from", "30 deg", "--to", "60 deg", "--points", "12"],
        partial: "sweep.partial",
        results: 3,
        counts: true,
        time: None,
    },
    Row {
        name: "a sweep of pulls at a rate",
        scene: RATE,
        command: &["sweep", "--vary", "time.rate", "--from", "1 mm/s", "--to", "10 mm/s", "--points", "6"],
        partial: "sweep.partial",
        results: 2,
        counts: true,
        time: None,
    },
    Row {
        name: "a sample",
        scene: UNCERTAIN,
        command: &[
            "uncertainty",
            "--set",
            "uncertainty.quantities=[\"initiation_peak.force_nN\"]",
            "--set",
            "uncertainty.samples=240",
            "--set",
            "accuracy.relative=1e-3",
        ],
        partial: "uncertainty.partial",
        results: 20,
        counts: true,
        time: None,
    },
    Row {
        name: "a sample of setae",
        scene: PULL_OFF,
        command: &["uncertainty"],
        partial: "uncertainty.partial",
        results: 5,
        counts: true,
        time: None,
    },
    Row {
        name: "the best width, by gradients",
        scene: WIDTH,
        command: &["optimise"],
        partial: "optimise.partial",
        results: 4,
        counts: true,
        time: None,
    },
    Row {
        name: "the best stiffness, checked without gradients",
        scene: STIFFNESS,
        command: &["optimise"],
        partial: "optimise.partial",
        results: 4,
        counts: true,
        time: None,
    },
];

/// Two commands that are tried before a machine counts as one on which they cannot be stopped in time.
const TRIES: usize = 12;

impl Row {
    /// The command in this folder, which writes to out/ in it, on so many cores.
    pub fn peel(&self, dir: &Path, cores: &str, more: &[&str]) -> Command {
        fs::write(dir.join("a.toml"), self.scene).unwrap();
        let mut command = Command::new(env!("CARGO_BIN_EXE_peel"));
        command.current_dir(dir).env("RAYON_NUM_THREADS", cores).stdout(Stdio::piped()).stderr(Stdio::piped());
        command.args([self.command[0], "a.toml", "--out", "out"]).args(&self.command[1..]).args(more);
        command
    }

    /// Runs it to a good end; what it printed.
    #[track_caller]
    pub fn finish(&self, dir: &Path, cores: &str, more: &[&str]) -> String {
        let output = self.peel(dir, cores, more).output().unwrap();
        let (stdout, stderr) = texts(&output);
        let notes = stderr.lines().all(|line| line.starts_with("note: "));
        assert!(output.status.code() == Some(0) && notes, "{}: {stderr}", self.name);
        stdout
    }

    /// Where it keeps what it finds.
    pub fn file(&self, dir: &Path) -> PathBuf {
        dir.join("out").join(self.partial)
    }

    /// How many results are kept.
    pub fn kept(&self, dir: &Path) -> usize {
        frames(&fs::read(self.file(dir)).unwrap_or_default()).len().saturating_sub(1)
    }

    /// The folder of a command that got this signal once it had kept some results, and how it ended.
    pub fn stopped(&self, signal: &str) -> (TempDir, Output) {
        for _ in 0..TRIES {
            let dir = tempdir().unwrap();
            let mut child = self.peel(dir.path(), "1", &[]).spawn().unwrap();
            let began = Instant::now();
            while self.kept(dir.path()) < self.results && child.try_wait().unwrap().is_none() {
                assert!(began.elapsed() < Duration::from_secs(120), "{}: nothing is kept", self.name);
                std::thread::sleep(Duration::from_millis(1));
            }
            let sent = Command::new("kill").args([&format!("-{signal}"), &child.id().to_string()]).status().unwrap();
            let output = child.wait_with_output().unwrap();
            if sent.success() && output.status.code() != Some(0) {
                return (dir, output);
            }
        }
        panic!("{}: it was over before the signal came, {TRIES} times", self.name);
    }

    /// The files of the same command without an interruption, on one core.
    fn reference(&self) -> &'static Files {
        static REFERENCES: [OnceLock<Files>; ROWS.len()] = [const { OnceLock::new() }; ROWS.len()];
        let place = ROWS.iter().position(|row| row.name == self.name).unwrap();
        REFERENCES[place].get_or_init(|| {
            let dir = tempdir().unwrap();
            let stdout = self.finish(dir.path(), "1", &[]);
            assert!(!stdout.contains("taken from"), "{}: {stdout}", self.name);
            files(dir.path())
        })
    }

    /// Goes on with what a folder keeps, to the files of the reference.
    #[track_caller]
    pub fn goes_on(&self, dir: &Path) {
        let kept = self.kept(dir);
        let stdout = self.finish(dir, "2", &[]);
        let line = stdout.lines().find(|line| line.contains("taken from an earlier"));
        let line = line.unwrap_or_else(|| panic!("{}: nothing is taken up: {stdout}", self.name));
        let taken: usize = line.split_whitespace().find_map(|word| word.parse().ok()).unwrap();
        assert!(if self.counts { taken == kept } else { taken > 0 }, "{}: {line}, and {kept} were kept", self.name);
        let (found, expected) = (files(dir), self.reference());
        assert_eq!(found.keys().collect::<Vec<_>>(), expected.keys().collect::<Vec<_>>(), "{}", self.name);
        for (name, bytes) in expected {
            assert!(found[name] == *bytes, "{}: {name} differs", self.name);
        }
    }
}

pub fn texts(output: &Output) -> (String, String) {
    (String::from_utf8(output.stdout.clone()).unwrap(), String::from_utf8(output.stderr.clone()).unwrap())
}

/// What is in a folder, without the seconds that were measured.
type Files = BTreeMap<String, Vec<u8>>;

/// The files of out/ and of the folders in it.
fn files(dir: &Path) -> Files {
    let (mut found, mut folders) = (Files::new(), vec![dir.join("out")]);
    while let Some(folder) = folders.pop() {
        for path in fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()) {
            if path.is_dir() {
                folders.push(path);
                continue;
            }
            let name = path.strip_prefix(dir).unwrap().to_str().unwrap().to_owned();
            found.insert(name, without_seconds(&path));
        }
    }
    found
}

fn without_seconds(path: &Path) -> Vec<u8> {
    let bytes = fs::read(path).unwrap();
    match path.extension().and_then(|extension| extension.to_str()) {
        Some("csv") => {
            let mut table = csv::Reader::from_reader(&bytes[..]);
            let names = table.headers().unwrap().clone();
            let line = |row: &csv::StringRecord| {
                let cells = row.iter().zip(&names).filter(|(_, name)| *name != "solve_s").map(|(cell, _)| cell);
                cells.collect::<Vec<_>>().join(",") + "\n"
            };
            let rows: String = table.records().map(|row| line(&row.unwrap())).collect();
            (line(&names) + &rows).into_bytes()
        }
        Some("json") => {
            let text = String::from_utf8(bytes).unwrap();
            let measured = |line: &&str| ["solve_s", "tip_s", "mesh_error_s"].iter().any(|key| line.contains(key));
            text.split_inclusive('\n').filter(|line| !measured(line)).collect::<String>().into_bytes()
        }
        // a value ends in the seconds that it took
        Some("part") => {
            let body = |frame: Frame| bytes[frame.key.start..frame.place.end - 8].to_vec();
            frames(&bytes).into_iter().flat_map(body).collect()
        }
        _ => bytes,
    }
}

#[test]
fn what_is_killed_goes_on() {
    for row in &ROWS {
        let (dir, output) = row.stopped("KILL");
        assert_eq!(output.status.code(), None, "{}", row.name);
        let left: Vec<_> =
            fs::read_dir(dir.path().join("out")).unwrap().map(|entry| entry.unwrap().file_name()).collect();
        assert_eq!(left, [row.partial], "{}", row.name);
        row.goes_on(dir.path());
    }
}

#[test]
fn what_is_interrupted_is_written_and_goes_on() {
    if signals_are_ignored() {
        return;
    }
    for row in &ROWS {
        let (dir, output) = row.stopped("INT");
        let (stdout, stderr) = texts(&output);
        assert_eq!(output.status.code(), Some(3), "{}: {stderr}", row.name);
        for part in ["interrupted", "the same command", "--fresh"] {
            assert!(stderr.contains(part), "{}: {part:?} is not in\n{stderr}", row.name);
        }
        assert!(stdout.contains(&format!("are kept in out/{}", row.partial)), "{}: {stdout}", row.name);
        assert!(dir.path().join("out/parameters.toml").exists(), "{}: what was reached is written", row.name);
        row.goes_on(dir.path());
    }
}

#[test]
fn what_is_out_of_time_goes_on() {
    for row in ROWS.iter().filter(|row| row.time.is_some()) {
        let dir = tempdir().unwrap();
        let bound = format!("bounds.time={}", row.time.unwrap());
        let first = row.finish(dir.path(), "1", &["--set", &bound]);
        let told = format!("bounds.time = {}", row.time.unwrap());
        assert!(first.contains(&told) && first.contains(&format!("are kept in out/{}", row.partial)), "{first}");
        row.goes_on(dir.path());
    }
}
