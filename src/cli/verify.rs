//! `peel verify`: every check of the verification suite.

use super::help;
use super::output::{progress_bar, say};
use super::stop::Stop;
use clap::Args;
use peelkit::report::{check_line, checks_json};
use peelkit::study::verify::{Check, TOPICS, Topic};

/// Holds the program against published values, closed forms and the tables of verification/
#[derive(Args)]
#[command(after_long_help = help::verify())]
pub struct Verify {
    /// Only this topic; may be given more than once
    #[arg(long, value_name = "TOPIC")]
    only: Vec<String>,

    /// Prints one JSON object and nothing else
    #[arg(long)]
    json: bool,
}

pub fn verify(args: &Verify) -> Result<(), Stop> {
    let topics = chosen(&args.only)?;
    let bar = progress_bar(topics.len());
    let mut checks: Vec<Check> = Vec::new();
    for topic in topics {
        let found = (topic.run)();
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

fn chosen(names: &[String]) -> Result<Vec<&'static Topic>, Stop> {
    if let Some(name) = names.iter().find(|name| TOPICS.iter().all(|topic| topic.name != **name)) {
        let known: Vec<&str> = TOPICS.iter().map(|topic| topic.name).collect();
        return Err(Stop::bad_input(format!("--only {name} is no topic"), format!("topics: {}", known.join(", "))));
    }
    Ok(TOPICS.iter().filter(|topic| names.is_empty() || names.iter().any(|name| name == topic.name)).collect())
}
