//! `peel verify`: every check of the verification suite.

use crate::terminal::help;
use crate::terminal::output::{progress_bar, say};
use crate::terminal::stop::Stop;
use crate::tools::hard_scenes::hard_scenes;
use clap::Args;
use peelkit_checks::sampled::{SampleKind, SampledScenes, WAYS, scene_text, survey_sample};
use peelkit_checks::suite::{Check, TOPICS, Topic, hard};
use peelkit_checks::{check_line, checks_json};
use peelkit_report::Part;

/// Compares the program with published values, closed forms and the tables of verification/
#[derive(Args)]
#[command(after_long_help = help::verify())]
pub struct Verify {
    /// Only this topic; may be given more than once
    #[arg(long, value_name = "TOPIC")]
    only: Vec<String>,

    /// Only the hard scenes: extreme parameters, sections on edge
    #[arg(long, conflicts_with = "only")]
    hard: bool,

    /// Checks one part of N, like 1/3
    ///
    /// The topics, or the hard scenes, are dealt out in turn.
    #[arg(long, value_name = "I/N", conflicts_with_all = ["only", "sample"])]
    part: Option<Part>,

    /// Peels so many randomly sampled scenes instead
    ///
    /// It prints how their paths end and whether their error bounds hold.
    #[arg(long, value_name = "N", group = "sample", conflicts_with_all = ["only", "hard"])]
    sampled: Option<u64>,

    /// Peels these scenes of the sample of one kind instead, like 3,17
    #[arg(long, value_name = "K,..", value_delimiter = ',', group = "sample", requires = "kind")]
    #[arg(conflicts_with_all = ["only", "hard"])]
    scenes: Vec<u64>,

    /// What is sampled; all kinds unless given
    ///
    /// Kinds: strip, angle, spatula, law, space, oblique, friction, rough, rate, seta, observed, tape, held.
    #[arg(long, value_name = "KIND")]
    kind: Option<String>,

    /// Peels them in so many ways
    ///
    /// They are: to 1e-6, to 1e-9, on elements of order 5, on a fixed mesh.
    #[arg(long, value_name = "N", default_value_t = WAYS.len(), value_parser = ways, requires = "sample")]
    ways: usize,

    /// Prints the text of this scene of the sample and peels nothing
    #[arg(long, value_name = "K", requires = "kind", conflicts_with = "sample")]
    scene: Option<u64>,

    /// Another seed gives other scenes
    #[arg(long, value_name = "S", default_value_t = 1)]
    seed: u64,

    /// Prints one JSON object and nothing else
    #[arg(long, conflicts_with = "sample")]
    json: bool,
}

pub fn verify(args: &Verify) -> Result<(), Stop> {
    if let Some(index) = args.scene {
        return kinds(args)?.into_iter().try_for_each(|kind| say(&scene_text(kind, args.seed, index)));
    }
    if let Some(count) = args.sampled {
        return sampled(args, &SampledScenes::First(count));
    }
    if !args.scenes.is_empty() {
        return sampled(args, &SampledScenes::Chosen(args.scenes.clone()));
    }
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

/// A number of ways, from 1 on.
fn ways(text: &str) -> Result<usize, String> {
    let ways = text.parse().ok().filter(|ways| (1..=WAYS.len()).contains(ways));
    ways.ok_or_else(|| format!("1 to {} are possible", WAYS.len()))
}

/// The kinds that are wanted.
fn kinds(args: &Verify) -> Result<Vec<SampleKind>, Stop> {
    let Some(name) = &args.kind else { return Ok(SampleKind::all().collect()) };
    let known = || SampleKind::all().map(SampleKind::name).collect::<Vec<_>>().join(", ");
    let kind = SampleKind::named(name);
    let kind = kind.ok_or_else(|| Stop::bad_input(format!("--kind {name} is no kind"), format!("kinds: {}", known())));
    Ok(vec![kind?])
}

/// Peels a sample of each kind that is wanted.
fn sampled(args: &Verify, scenes: &SampledScenes) -> Result<(), Stop> {
    let kinds = kinds(args)?;
    let bar = progress_bar(scenes.count().saturating_mul(kinds.len()));
    for kind in kinds {
        let survey = survey_sample(kind, args.seed, scenes, args.ways, &|| bar.inc(1)).map_err(Stop::other)?;
        bar.suspend(|| say(&survey.table()))?;
    }
    bar.finish_and_clear();
    Ok(())
}

/// What is to be run.
type Suite = Box<dyn Fn() -> Vec<Check>>;

fn chosen(args: &Verify) -> Result<Vec<Suite>, Stop> {
    if args.hard {
        let scenes: Vec<_> = Part::chosen(args.part, hard_scenes()?).collect();
        let strips: Vec<_> = Part::chosen(args.part, 0..hard::STRIPS).collect();
        return Ok(vec![Box::new(move || hard::run(&scenes, &strips))]);
    }
    let names = &args.only;
    if let Some(name) = names.iter().find(|name| TOPICS.iter().all(|topic| topic.name != **name)) {
        let known: Vec<&str> = TOPICS.iter().map(|topic| topic.name).collect();
        return Err(Stop::bad_input(format!("--only {name} is no topic"), format!("topics: {}", known.join(", "))));
    }
    let wanted = |topic: &&Topic| names.is_empty() || names.iter().any(|name| name == topic.name);
    let topics = Part::chosen(args.part, TOPICS.iter().filter(wanted));
    Ok(topics.map(|topic| Box::new(|| topic.run()) as Suite).collect())
}
