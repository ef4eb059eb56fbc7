//! `peel optimise`: the best design of a scene that says what is free.

use crate::studies::drive::Drive;
use crate::studies::ready::ready;
use crate::terminal::help::{EXIT_STATUS, OUTPUTS};
use crate::terminal::input::SceneArgs;
use crate::terminal::output::OutArgs;
use crate::terminal::progress::Bar;
use crate::terminal::stop::Stop;
use crate::text_summary;
use clap::Args;
use peelkit_analyses::Optimisation;

/// Optimises keys of a scene, or width and height along the body
#[derive(Args)]
#[command(after_help = SHORT_HELP, after_long_help = long_help())]
pub struct Optimise {
    #[command(flatten)]
    pub scene: SceneArgs,

    #[command(flatten)]
    pub out: OutArgs,

    /// Prints one JSON object only; writes files only if --out is given
    #[arg(long)]
    pub json: bool,

    /// Discards the checkpoint of an interrupted optimisation and starts anew
    #[arg(long)]
    pub fresh: bool,
}

pub fn optimise(args: &Optimise) -> Result<(), Stop> {
    let scene = ready(|| args.scene.load_any())?;
    let optimisation = Optimisation::of(&scene).map_err(|why| Stop::refused(&scene, why))?;
    let drive = Drive {
        scene: &scene,
        out: &args.out,
        folder: args.out.folder(args.json, || args.scene.default_folder(&["optimise".to_owned()])),
        fresh: args.fresh,
        json: args.json,
        bar: Bar::counted(),
        answer: Some("stopping when the designs being evaluated are done; Ctrl-C again stops at once"),
    };
    drive.run(&optimisation, |found| {
        let text = text_summary::of_many::optimisation::optimum(&scene, &found.problem, &found.optimum, found.seconds);
        match found.taken {
            0 => text,
            taken => format!("{text}\n{taken} designs taken from an earlier, interrupted run\n"),
        }
    })
}

// -- The help --

/// Of `peel optimise -h`.
const SHORT_HELP: &str = "\
Example: peel optimise strip.toml, with a table [optimise] in the scene
More: peel optimise --help, on that table, files, resuming; peel keys optimise, its keys";

/// Of `peel optimise --help`.
fn long_help() -> String {
    format!(
        "\
The scene names what is free, what is to be large or small, and what has to hold:

  [optimise]
  objective = \"initiation_peak.force_nN\"      a result, by its name in the summary of peel run
  goal = \"maximise\"
  width = {{ from = \"5 nm\", to = \"20 nm\", slope = 0.2 }}
  height = {{ from = \"2 nm\", to = \"10 nm\" }}
  values = 20                                 along the body, with a monotone cubic between them
  volume = \"equal\"                            to that of the scene; \"at-most\", \"free\"
  parameters = [{{ key = \"strip.youngs_modulus\", from = \"0.1 GPa\", to = \"10 GPa\" }}]

With holding_angle and release_angle the objective is the ratio of its values in pulls at these two angles. Searches
with exact derivatives begin at the scene and at random designs. A design that cannot be computed is a bad one and does
not end them. `peel run` ignores the table.

Examples:
  peel optimise strip.toml
  peel optimise strip.toml --set drive.angle=\"30 deg\" --set optimise.starts=4
  peel run out/strip-optimise/optimum.toml

Files:
  summary.json       objective before and after with error bounds, variables, searches, certificate: projected gradient,
                     active constraints with their multipliers, random feasible neighbours
  history.csv        one row for each design of each search
  optimum.toml       the best design as a scene
  optimum.svg, .png  shape and peel before and after, and the searches
  parameters.toml    the scene with what --set has changed: peel optimise gives the same numbers
  optimise.partial   checkpoint while it runs: each evaluated design, written at once

Interrupting: after Ctrl-C the designs being evaluated are finished, and the best so far is written (exit status 3). A
second Ctrl-C stops the program at once (130).

Resuming: give the same command again. It makes the same choices and takes what is known from the checkpoint. --fresh
discards the checkpoint. With --json and without --out nothing is kept.

{OUTPUTS}

{EXIT_STATUS}"
    )
}
