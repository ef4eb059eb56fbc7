//! `peel uncertainty`: keys of a scene that have distributions, sampled and propagated.

use crate::studies::drive::Drive;
use crate::studies::ready::ready;
use crate::terminal::help;
use crate::terminal::input::SceneArgs;
use crate::terminal::output::OutArgs;
use crate::terminal::progress::Bar;
use crate::terminal::stop::Stop;
use crate::text_summary;
use clap::Args;
use peelkit_analyses::Uncertainty as Analysis;

/// Samples uncertain keys of a scene: mean, quantiles, sensitivity indices
#[derive(Args)]
#[command(after_help = help::UNCERTAINTY, after_long_help = help::uncertainty())]
pub struct Uncertainty {
    #[command(flatten)]
    pub scene: SceneArgs,

    #[command(flatten)]
    pub out: OutArgs,

    /// Prints one JSON object only; writes files only if --out is given
    #[arg(long)]
    pub json: bool,

    /// Discards the checkpoint of an interrupted sample and starts anew
    #[arg(long)]
    pub fresh: bool,
}

pub fn uncertainty(args: &Uncertainty) -> Result<(), Stop> {
    let scene = ready(|| args.scene.load_any())?;
    let uncertainty = Analysis::of(&scene).map_err(|why| Stop::refused(&scene, why))?;
    let drive = Drive {
        scene: &scene,
        out: &args.out,
        folder: args.out.folder(args.json, || args.scene.default_folder(&["uncertainty".to_owned()])),
        fresh: args.fresh,
        json: args.json,
        bar: Bar::counted(),
        answer: Some("stopping when the samples being computed are done; Ctrl-C again stops at once"),
    };
    drive.run(&uncertainty, |found| {
        let samples = found.analysis.design.samples();
        let taken = (found.taken > 0)
            .then(|| format!("{} of {samples} samples taken from an earlier, interrupted run", found.taken));
        text_summary::of_many::uncertainty::uncertainty(&scene, &found.analysis, taken.as_deref())
    })
}
