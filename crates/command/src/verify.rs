//! `peel verify`: every check of the verification suite.

use crate::hard_scenes::hard_scenes;
use crate::help;
use crate::output::{progress_bar, say};
use crate::stop::Stop;
use clap::Args;
use peelkit_checks::suite::{Check, TOPICS, Topic, hard};
use peelkit_checks::{check_line, checks_json};

/// Compares the program with published values, closed forms and the tables of verification/
#[derive(Args)]
#[command(after_long_help = help::verify())]
pub struct Verify {
    /// Only this topic; may be given more than once
    #[arg(long, value_name = "TOPIC")]
    only: Vec<String>,

    /// Only the hard scenes: extreme parameters, sections on edge, limit points that meet
    #[arg(long, conflicts_with = "only")]
    hard: bool,

    /// Prints one JSON object and nothing else
    #[arg(long)]
    json: bool,
}

pub fn verify(args: &Verify) -> Result<(), Stop> {
    let suites = chosen(args)?;
    let bar = progress_bar(suites.len());
    let mut checks: Vec<Check> = Vec::new();
    for suite in suites {
        let found = suite();
        bar.inc(1);
        if !args.json {
            let lines: String = found.iter().map(|check| check_line(check) + "\n").collect();
            bar.suspend(|| say(&lines))?;
        }
        checks.extend(found);
    }
    bar.finish_and_clear();
    let failed = checks.iter().filter(|check| !check.passes()).count();
    if args.json {
        say(&checks_json(&checks).map_err(Stop::other)?)?;
    } else {
        say(&format!("{} checks: {} passed, {failed} failed\n", checks.len(), checks.len() - failed))?;
    }
    if failed == 0 { Ok(()) } else { Err(Stop::other(format!("{failed} of {} checks failed", checks.len()))) }
}

/// What is to be run.
type Suite = Box<dyn Fn() -> Vec<Check>>;

fn chosen(args: &Verify) -> Result<Vec<Suite>, Stop> {
    if args.hard {
        let scenes = hard_scenes()?;
        return Ok(vec![Box::new(move || hard::run(&scenes))]);
    }
    let names = &args.only;
    if let Some(name) = names.iter().find(|name| TOPICS.iter().all(|topic| topic.name != **name)) {
        let known: Vec<&str> = TOPICS.iter().map(|topic| topic.name).collect();
        return Err(Stop::bad_input(format!("--only {name} is no topic"), format!("topics: {}", known.join(", "))));
    }
    let wanted = |topic: &&Topic| names.is_empty() || names.iter().any(|name| name == topic.name);
    Ok(TOPICS.iter().filter(wanted).map(|topic| Box::new(|| topic.run()) as Suite).collect())
}
