//! Many parses or short runs of drawn scenes, without a fuzzer: `garbled parse 10000000 [SEED]`, `garbled run 20000 [SEED]`, or
//! one scene of a file: `garbled run FILE`.
//!
//! Prints how the scenes ended and how long it took, and each fault with its scene. Exit status 1 where there is any.

#[path = "../tests/report/garbled/generator/mod.rs"]
mod garbled;

use garbled::{BYTES, Dice, absurd_scene, check_parse, check_run, garbled_text, is_computed};
use peelkit_report::{draw_peel, end_word};
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;
use std::collections::BTreeMap;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::process::ExitCode;
use std::sync::Mutex;
use std::time::{Duration, Instant};

/// Makes a scene from bytes and checks it: the scene, and how it ended or what was wrong.
type Check = fn(&[u8]) -> (String, Result<String, String>);

const USAGE: &str = "garbled parse|run [COUNT] [SEED], or garbled run FILE";
/// A scene that takes longer than this, on a machine that may be busy, is taken to hang.
const HANGS: Duration = Duration::from_secs(300);
/// Seconds of CPU time that a run may take: its `bounds.time`, as long again and a second for the limit points, and a
/// second for what is under way then.
const OVERDUE: f64 = 2.0 * 0.2 + 2.0;

/// What is being computed, since when.
static NOW: Mutex<Option<(Instant, String)>> = Mutex::new(None);

fn main() -> ExitCode {
    let args: Vec<String> = std::env::args().skip(1).collect();
    if let [what, file] = &args[..]
        && what == "run"
        && let Ok(text) = std::fs::read_to_string(file)
    {
        println!("{:?}", check(&text, true));
        return ExitCode::SUCCESS;
    }
    let number = |index: usize, default: u64| args.get(index).map_or(Some(default), |text| text.parse().ok());
    let (what, Some(count), Some(seed)) = (args.first().map(String::as_str), number(1, 1000), number(2, 1)) else {
        eprintln!("{USAGE}");
        return ExitCode::from(2);
    };
    std::panic::set_hook(Box::new(|panic| eprintln!("{panic}")));
    std::thread::spawn(watch);
    let one: Check = match what {
        Some("parse") => parse,
        Some("run") => run,
        _ => {
            eprintln!("{USAGE}");
            return ExitCode::from(2);
        }
    };
    let started = Instant::now();
    let mut ends: BTreeMap<String, u64> = BTreeMap::new();
    let (mut faults, mut slowest) = (0, (0.0, 0));
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    for index in 0..count {
        let mut bytes = [0; BYTES];
        random.fill_bytes(&mut bytes);
        let began = Instant::now();
        let (text, outcome) = one(&bytes);
        let took = began.elapsed().as_secs_f64();
        if took > slowest.0 {
            slowest = (took, index);
        }
        match outcome {
            Ok(end) => *ends.entry(end).or_default() += 1,
            Err(fault) => {
                faults += 1;
                println!("-- fault {faults}, scene {index}: {fault}\n{text}");
            }
        }
    }
    let seconds = started.elapsed().as_secs_f64();
    println!("{count} scenes, {seconds:.1} s, slowest {:.3} s (scene {}), {faults} faults", slowest.0, slowest.1);
    println!("{ends:?}");
    ExitCode::from(u8::from(faults > 0))
}

/// Ends the program where a scene hangs, and reports which one.
fn watch() {
    loop {
        std::thread::sleep(Duration::from_secs(1));
        let now = NOW.lock().unwrap_or_else(|poisoned| poisoned.into_inner());
        if let Some((since, text)) = now.as_ref()
            && since.elapsed() > HANGS
        {
            println!("-- hangs\n{text}");
            std::process::exit(1);
        }
    }
}

/// Does it, with a panic as a fault.
fn guarded(text: &str, check: impl FnOnce() -> Result<String, String>) -> Result<String, String> {
    let set = |now| *NOW.lock().unwrap_or_else(|poisoned| poisoned.into_inner()) = now;
    set(Some((Instant::now(), text.to_owned())));
    let outcome = catch_unwind(AssertUnwindSafe(check)).unwrap_or_else(|_| Err("panicked".into()));
    set(None);
    outcome
}

fn parse(bytes: &[u8]) -> (String, Result<String, String>) {
    let text = match bytes[0] % 16 {
        0 => String::from_utf8_lossy(bytes).into_owned(),
        _ => garbled_text(&mut Dice::new(&bytes[1..])),
    };
    let outcome = guarded(&text, || check_parse(&text).map(|taken| if taken { "taken" } else { "refused" }.into()));
    (text, outcome)
}

fn run(bytes: &[u8]) -> (String, Result<String, String>) {
    let text = absurd_scene(&mut Dice::new(bytes));
    let drawn = bytes.last().is_some_and(|last| last.is_multiple_of(16));
    let outcome = check(&text, drawn);
    (text, outcome)
}

fn check(text: &str, drawn: bool) -> Result<String, String> {
    guarded(text, || {
        if !is_computed(text) {
            return Ok("too long".into());
        }
        let began = cpu_seconds();
        let (_, peel) = check_run(text)?;
        let took = cpu_seconds() - began;
        if took > OVERDUE {
            return Err(format!("took {took:.2} s, {:?}", peel.effort));
        }
        if drawn && peel.points.len() > 1 {
            let dir = tempfile::tempdir().map_err(|error| error.to_string())?;
            draw_peel(&peel, None, "drawn", dir.path()).map_err(|error| error.to_string())?;
        }
        Ok(end_word(&peel.end).into())
    })
}

/// CPU time of this thread where the system tells it, as Linux does; zero elsewhere.
fn cpu_seconds() -> f64 {
    let text = std::fs::read_to_string("/proc/thread-self/schedstat").unwrap_or_default();
    let nanoseconds = text.split(' ').next().and_then(|first| first.parse::<f64>().ok());
    nanoseconds.map_or(0.0, |nanoseconds| 1e-9 * nanoseconds)
}
