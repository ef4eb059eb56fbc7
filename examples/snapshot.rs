//! What a build of `peel` computes, kept in a file and compared with what another build computes.
//!
//!   cargo run --release --example snapshot -- write --peel OLD/peel --out before.json
//!   cargo run --release --example snapshot -- write --peel NEW/peel --out after.json
//!   cargo run --release --example snapshot -- compare before.json after.json
//!
//! `write` runs the scenes of a folder and randomly sampled ones, one after the other, and keeps their summaries without what depends on
//! the machine. `compare` leaves with status 1 unless every number is the same bit for bit, or within a relative difference (`--within`).
//! The sampled scenes end by a bound on points, not on time: a time bound would end them elsewhere on another machine.

use clap::{CommandFactory, Parser, Subcommand};
use serde::{Deserialize, Serialize};
use serde_json::Value;
use std::error::Error;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};
use std::time::Instant;

#[derive(Parser)]
#[command(about = "Keeps what a build of `peel` computes, and compares two builds")]
struct Args {
    #[command(subcommand)]
    task: Option<Task>,
}

#[derive(Subcommand)]
enum Task {
    /// Runs scenes and keeps their summaries
    Write {
        /// The command `peel` of the build
        #[arg(long)]
        peel: PathBuf,
        #[arg(long)]
        out: PathBuf,
        /// Folder of the scenes
        #[arg(long, default_value = "scenes")]
        scenes: PathBuf,
        /// How many scenes are sampled
        #[arg(long, default_value_t = 60)]
        sampled: u64,
        #[arg(long, default_value_t = 1)]
        seed: u64,
        /// Runs only what has this text in its name
        #[arg(long, default_value = "")]
        only: String,
        /// Prints the time of every run
        #[arg(long)]
        times: bool,
    },
    /// Compares two files
    Compare {
        before: PathBuf,
        after: PathBuf,
        /// Largest relative difference of a number that is let pass
        #[arg(long, default_value_t = 0.0)]
        within: f64,
        /// Lets changed texts and added or removed keys pass; counts of points, ends and limit points still have to be the same
        #[arg(long)]
        numbers_only: bool,
    },
}

fn main() -> Result<ExitCode, Box<dyn Error>> {
    let Some(task) = Args::parse().task else {
        Args::command().print_help()?;
        return Ok(ExitCode::SUCCESS);
    };
    match task {
        Task::Write { peel, out, scenes, sampled, seed, only, times } => {
            let mut jobs = scenes_of(&scenes)?;
            jobs.extend((0..sampled).map(|index| sampled_scene(seed, index)));
            jobs.retain(|job| job.label().contains(&only));
            let runs = run_all(&peel.canonicalize()?, &jobs, times)?;
            std::fs::write(&out, serde_json::to_string_pretty(&Snapshot { seed, runs })?)?;
            Ok(ExitCode::SUCCESS)
        }
        Task::Compare { before, after, within, numbers_only } => {
            let [before, after] = [before, after].map(|file| -> Result<Snapshot, Box<dyn Error>> {
                Ok(serde_json::from_str(&std::fs::read_to_string(file)?)?)
            });
            Ok(if compare(&before?, &after?, within, numbers_only) { ExitCode::SUCCESS } else { ExitCode::FAILURE })
        }
    }
}

#[derive(Serialize, Deserialize)]
struct Snapshot {
    seed: u64,
    runs: Vec<Run>,
}

/// What one run left.
#[derive(Serialize, Deserialize)]
struct Run {
    label: String,
    status: Option<i32>,
    /// The summary without what depends on the machine; null where there was none.
    summary: Value,
    /// What was printed in its place.
    message: String,
    scene: String,
}

// ---------------------------------------------------------------------------------------------------------------
// Which scenes
// ---------------------------------------------------------------------------------------------------------------

struct Job {
    name: String,
    text: String,
    observed: bool,
    /// Where files are that the scene names.
    folder: Option<PathBuf>,
}

impl Job {
    fn label(&self) -> String {
        format!("{}{}", self.name, if self.observed { " --observed" } else { "" })
    }
}

/// Of these scenes the test is computed as well.
const TESTED: [&str; 3] = ["strip.toml", "strip-soft.toml", "strip-100nm.toml"];

fn scenes_of(folder: &Path) -> std::io::Result<Vec<Job>> {
    let folder = folder.canonicalize()?;
    let mut jobs = Vec::new();
    for entry in std::fs::read_dir(&folder)? {
        let path = entry?.path();
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        if path.extension().is_none_or(|extension| extension != "toml") {
            continue;
        }
        let text = std::fs::read_to_string(&path)?;
        let observed = TESTED.contains(&name.as_str());
        jobs.push(Job { name, text, observed, folder: Some(folder.clone()) });
    }
    jobs.sort_by(|a, b| a.name.cmp(&b.name));
    Ok(jobs)
}

/// Steele, Lea and Flood's SplitMix64.
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    fn uniform(&mut self, from: f64, to: f64) -> f64 {
        from + (to - from) * (self.next() >> 11) as f64 / (1u64 << 53) as f64
    }

    /// Uniform in the logarithm, to four digits: the text of the scene is then the number.
    fn log_uniform(&mut self, from: f64, to: f64) -> String {
        format!("{:.3e}", 10f64.powf(self.uniform(from.log10(), to.log10())))
    }

    fn one_in(&mut self, count: u64) -> bool {
        self.next().is_multiple_of(count)
    }

    fn pick<T: Copy>(&mut self, choices: &[T]) -> T {
        choices[(self.next() % choices.len() as u64) as usize]
    }
}

/// Most points of a path of a sampled scene.
const POINTS: usize = 1500;

fn sampled_scene(seed: u64, index: u64) -> Job {
    let mut random = Random(seed.wrapping_mul(0x2545_f491_4f6c_dd1d).wrapping_add(index));
    let random = &mut random;
    let spatula = index % 15 == 7;
    let text = scene_text(random, spatula);
    // a test is of a load with a potential, without friction
    let tested = !["force-only", "surface-traction", "[friction]"].iter().any(|word| text.contains(word));
    let observed = !spatula && tested && random.one_in(6);
    let body = if spatula { "spatula" } else { "strip" };
    Job { name: format!("sampled-{index:03}-{body}.toml"), text, observed, folder: None }
}

/// A strip or a spatula over wide ranges. Combinations that the scene refuses are not sampled.
fn scene_text(random: &mut Random, spatula: bool) -> String {
    let mut text = String::new();
    let mut line = |line: String| {
        let _ = writeln!(text, "{line}");
    };
    line(format!("[{}]", if spatula { "spatula" } else { "strip" }));
    // ground that is not flat takes small elements wherever a beam lies
    let rough = !spatula && random.one_in(12);
    if spatula {
        line(format!("pad_length = \"{} nm\"", random.log_uniform(60.0, 600.0)));
        line(format!("pad_thickness = \"{} nm\"", random.log_uniform(5.0, 20.0)));
        line(format!("shaft_angle = \"{:.1} deg\"", random.uniform(5.0, 90.0)));
        line(format!("tip_rounding_length = \"{} nm\"", random.pick(&["0", "30"])));
        line(format!("youngs_modulus = \"{} GPa\"", random.log_uniform(0.5, 20.0)));
    } else {
        line(format!("length = \"{} nm\"", random.log_uniform(20.0, if rough { 500.0 } else { 2e4 })));
        line(format!("height = \"{} nm\"", random.log_uniform(2.0, 50.0)));
        line(format!("youngs_modulus = \"{} GPa\"", random.log_uniform(if rough { 1.0 } else { 0.01 }, 100.0)));
        line(format!("poissons_ratio = {:.3}", random.uniform(0.0, 0.49)));
        line(format!("bending_stiffness_factor = {}", random.log_uniform(if rough { 1.0 } else { 1e-4 }, 1e4)));
    }
    let (least, most) = if spatula || rough { (2e-20, 2e-19) } else { (1e-21, 1e-18) };
    line("[adhesion]".into());
    line(format!("hamaker_constant = \"{} J\"", random.log_uniform(least, most)));
    let (least, most) = if spatula || rough { (0.2, 0.8) } else { (0.1, 2.0) };
    line(format!("equilibrium_distance = \"{} nm\"", random.log_uniform(least, most)));
    line(format!("far_face = {}", random.one_in(2)));
    let mut law = "body-force";
    if !rough && random.one_in(3) {
        law = random.pick(&["body-force", "surface-traction", "bilinear", "exponential", "dugdale"]);
        let load = random.pick(&["full", "full", "force-only", "axis-gap"]);
        line(format!("law = \"{law}\"\nline_load = \"{load}\""));
    }
    let half_space = law.contains('-');
    let rubs = !rough && half_space && random.one_in(10);
    if rough {
        let (wave, height) = (random.log_uniform(100.0, 1000.0), random.log_uniform(0.1, 2.0));
        let sinusoid = format!("shape = \"sinusoid\"\nheight = \"{height} nm\"\nwavelength = \"{wave} nm\"");
        let round = format!("shape = \"cylinder\"\nradius = \"{} nm\"", random.log_uniform(3e4, 1e6));
        line(format!("[substrate]\n{}", if random.one_in(3) { round } else { sinusoid }));
    }
    if rubs {
        line(format!("[friction]\nstrength = \"{} MPa\"", random.log_uniform(1.0, 100.0)));
    }
    let hold = |random: &mut Random| random.pick(&["free", "fixed"]);
    line(format!("[grip]\nrotation = \"{}\"\nhorizontal = \"{}\"", hold(random), hold(random)));
    if random.one_in(3) {
        line(format!("[drive]\nangle = \"{:.1} deg\"", random.uniform(10.0, 170.0)));
    }
    let points = if rough { POINTS / 10 } else { POINTS };
    line(format!("[accuracy]\nrelative = 1e-6\n[bounds]\npoints = {points}\ntime = \"1000 s\""));
    text
}

// ---------------------------------------------------------------------------------------------------------------
// Running them
// ---------------------------------------------------------------------------------------------------------------

/// What depends on the machine or on the build, wherever it stands.
const LEFT_OUT: [&str; 3] = ["timing", "solve_s", "version"];

fn run_all(peel: &Path, jobs: &[Job], times: bool) -> Result<Vec<Run>, Box<dyn Error>> {
    let temporary = std::env::temp_dir().join(format!("peel-snapshot-{}", std::process::id()));
    std::fs::create_dir_all(&temporary)?;
    let begin = Instant::now();
    let runs = jobs.iter().map(|job| {
        let started = Instant::now();
        let folder = job.folder.as_deref().unwrap_or(&temporary);
        if job.folder.is_none() {
            std::fs::write(folder.join(&job.name), &job.text)?;
        }
        // named without a folder, so that the name in the summary is the same everywhere
        let mut command = Command::new(peel);
        command.current_dir(folder).args(["run", &job.name, "--json"]);
        if job.observed {
            command.arg("--observed");
        }
        let output = command.output()?;
        let mut summary = serde_json::from_slice(&output.stdout).unwrap_or(Value::Null);
        strip(&mut summary);
        let message =
            if summary.is_null() { String::from_utf8_lossy(&output.stderr).into_owned() } else { String::new() };
        if times {
            let [end, reason] = ["end", "reason"].map(|key| summary[key].as_str().unwrap_or("").to_owned());
            let points = summary["path"]["points"].as_u64().unwrap_or(0);
            let seconds = started.elapsed().as_secs_f64();
            eprintln!("{seconds:7.2} s  {:40} {points:6} points  {end} {reason}{message}", job.label());
        }
        let text = if job.folder.is_none() { job.text.clone() } else { String::new() };
        Ok(Run { label: job.label(), status: output.status.code(), summary, message, scene: text })
    });
    let runs: std::io::Result<Vec<Run>> = runs.collect();
    std::fs::remove_dir_all(&temporary)?;
    let runs = runs?;
    let timed = |run: &&Run| run.summary["reason"].as_str().is_some_and(|reason| reason.contains("bounds.time"));
    for run in runs.iter().filter(timed) {
        eprintln!("{}: ended by time, which depends on the machine", run.label);
    }
    eprintln!("{} runs in {:.1} s", runs.len(), begin.elapsed().as_secs_f64());
    Ok(runs)
}

fn strip(value: &mut Value) {
    match value {
        Value::Object(entries) => {
            entries.retain(|name, _| !LEFT_OUT.contains(&name.as_str()));
            entries.values_mut().for_each(strip);
        }
        Value::Array(items) => items.iter_mut().for_each(strip),
        _ => {}
    }
}

// ---------------------------------------------------------------------------------------------------------------
// Comparing
// ---------------------------------------------------------------------------------------------------------------

/// How two summaries differ.
#[derive(Default)]
struct Differences {
    numbers: usize,
    /// Largest relative difference, and where.
    largest: Option<(f64, String)>,
    /// Whether every number with an error bound moved by less than a tenth of the sum of both bounds.
    beyond_bounds: Vec<String>,
    /// Counts of points and the like.
    counts: Vec<String>,
    texts: Vec<String>,
    keys: Vec<String>,
    /// What is there in one alone, or of another kind.
    shapes: Vec<String>,
}

impl Differences {
    fn between(before: &Run, after: &Run) -> Self {
        let mut found = Self::default();
        if before.status != after.status {
            found.shapes.push(format!("status {:?} -> {:?}", before.status, after.status));
        }
        if before.message != after.message {
            found.texts.push("message".into());
        }
        if before.scene != after.scene {
            found.shapes.push("the scene itself".into());
        }
        found.walk(&before.summary, &after.summary, String::new());
        found
    }

    fn walk(&mut self, before: &Value, after: &Value, path: String) {
        match (before, after) {
            (Value::Object(old), Value::Object(new)) => {
                for (name, value) in old {
                    let path = if path.is_empty() { name.clone() } else { format!("{path}.{name}") };
                    match new.get(name) {
                        None => self.keys.push(format!("-{path}")),
                        Some(other) => {
                            self.against_bounds(name, [old, new], [value, other], &path);
                            self.walk(value, other, path);
                        }
                    }
                }
                let added = new.keys().filter(|name| !old.contains_key(*name));
                self.keys.extend(added.map(|name| format!("+{path}.{name}")));
            }
            (Value::Array(old), Value::Array(new)) => {
                if old.len() != new.len() {
                    self.shapes.push(format!("{path}: {} -> {}", old.len(), new.len()));
                }
                for (index, (value, other)) in old.iter().zip(new).enumerate() {
                    self.walk(value, other, format!("{path}[{index}]"));
                }
            }
            (Value::Number(old), Value::Number(new)) if old.is_u64() && new.is_u64() => {
                self.numbers += 1;
                if old != new {
                    self.counts.push(format!("{path}: {old} -> {new}"));
                }
            }
            (Value::Number(old), Value::Number(new)) => self.numbers(old.as_f64(), new.as_f64(), path),
            (Value::String(old), Value::String(new)) => {
                // how a path ended, and what kind a point is of
                let matters = path == "end" || path.ends_with(".end") || path.ends_with(".kind");
                match (old == new, matters) {
                    (true, _) => {}
                    (false, true) => self.shapes.push(format!("{path}: {old} -> {new}")),
                    (false, false) => self.texts.push(path),
                }
            }
            (old, new) if old != new => self.shapes.push(format!("{path}: {} -> {}", short(old), short(new))),
            _ => {}
        }
    }

    fn numbers(&mut self, before: Option<f64>, after: Option<f64>, path: String) {
        let (Some(before), Some(after)) = (before, after) else { return };
        self.numbers += 1;
        if before.to_bits() == after.to_bits() {
            return;
        }
        let relative = (after - before).abs() / before.abs().max(after.abs()).max(f64::MIN_POSITIVE);
        if self.largest.as_ref().is_none_or(|(largest, _)| relative > *largest) {
            self.largest = Some((relative, path));
        }
    }

    /// A number whose error bound stands beside it: `force_nN` and `error_nN`, `pull_off_force_nN` and `pull_off_error_nN`.
    fn against_bounds(
        &mut self,
        name: &str,
        objects: [&serde_json::Map<String, Value>; 2],
        values: [&Value; 2],
        path: &str,
    ) {
        let ([Some(before), Some(after)], Some((stem, unit))) = (values.map(Value::as_f64), name.rsplit_once('_'))
        else {
            return;
        };
        if name.starts_with("error_") || stem.ends_with("_error") {
            return;
        }
        let own = [format!("{stem}_error_{unit}"), format!("{}_error_{unit}", stem.trim_end_matches("_force"))];
        let shared = format!("error_{unit}");
        let bound = |object: &serde_json::Map<String, Value>| {
            own.iter().chain([&shared]).find_map(|key| object.get(key)).and_then(Value::as_f64)
        };
        if let [Some(one), Some(other)] = objects.map(bound)
            && (after - before).abs() > 0.1 * (one + other)
        {
            self.beyond_bounds.push(path.to_owned());
        }
    }

    fn is_none(&self) -> bool {
        self.largest.is_none() && self.passes(0.0, false)
    }

    fn passes(&self, within: f64, numbers_only: bool) -> bool {
        self.largest.as_ref().is_none_or(|(largest, _)| *largest <= within)
            && self.counts.is_empty()
            && self.shapes.is_empty()
            && (numbers_only || self.texts.is_empty() && self.keys.is_empty())
    }
}

fn short(value: &Value) -> String {
    match value {
        Value::Object(_) => "{...}".into(),
        Value::Array(_) => "[...]".into(),
        other => other.to_string(),
    }
}

/// The first few of a list.
fn listed(what: &str, items: &[String]) -> String {
    const FEW: usize = 3;
    if items.is_empty() {
        return String::new();
    }
    let more = if items.len() > FEW { format!(" and {} more", items.len() - FEW) } else { String::new() };
    format!("\n    {what}: {}{more}", items[..items.len().min(FEW)].join(", "))
}

/// Prints the table; whether all is the same, or near enough.
fn compare(before: &Snapshot, after: &Snapshot, within: f64, numbers_only: bool) -> bool {
    let (mut same, mut all, mut numbers) = (0, true, 0);
    for old in &before.runs {
        let Some(new) = after.runs.iter().find(|run| run.label == old.label) else {
            println!("{:42} is missing", old.label);
            all = false;
            continue;
        };
        let found = Differences::between(old, new);
        numbers += found.numbers;
        if found.is_none() {
            same += 1;
            println!("{:42} equal bit for bit, {} numbers", old.label, found.numbers);
            continue;
        }
        let passes = found.passes(within, numbers_only);
        all &= passes;
        let counts = if found.counts.is_empty() { "counts equal" } else { "COUNTS DIFFER" };
        let (size, place) = found.largest.as_ref().map_or((0.0, "no number"), |(size, path)| (*size, path.as_str()));
        let verdict = if passes { "passes" } else { "DIFFERS" };
        let bounds =
            if found.beyond_bounds.is_empty() { "within 0.1 of the bounds" } else { "BEYOND 0.1 of the bounds" };
        println!("{:42} {verdict}: {size:.1e} at {place}; {counts}; {bounds}", old.label);
        let lists = [
            ("differs in kind", &found.shapes),
            ("counts", &found.counts),
            ("beyond", &found.beyond_bounds),
            ("keys", &found.keys),
            ("texts", &found.texts),
        ];
        let details: String = lists.iter().map(|(what, items)| listed(what, items)).collect();
        if !details.is_empty() {
            println!("{}", &details[1..]);
        }
    }
    for new in after.runs.iter().filter(|new| before.runs.iter().all(|old| old.label != new.label)) {
        println!("{:42} is new", new.label);
        all = false;
    }
    println!("{same} of {} runs equal bit for bit, {numbers} numbers compared", before.runs.len());
    all
}
