//! `peel optimise`: the best design of a scene that says what is free.

mod help;

use crate::studies::drive::Drive;
use crate::terminal::input::SceneArgs;
use crate::terminal::output::OutArgs;
use crate::terminal::progress::Bar;
use crate::terminal::stop::Stop;
use crate::text_summary;
use clap::Args;
use peelkit_analyses::Optimisation;

/// Optimises keys of a scene, or width and height along the body
#[derive(Args)]
#[command(after_help = help::SHORT, after_long_help = help::long())]
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
    let scene = args.scene.load_any()?;
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
