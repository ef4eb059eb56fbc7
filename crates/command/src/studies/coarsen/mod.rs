//! `peel coarsen`: the law of a tip of a seta, from the spatula of a scene.

mod help;
mod range;

use crate::studies::drive::Drive;
use crate::terminal::input::SceneArgs;
use crate::terminal::output::OutArgs;
use crate::terminal::progress::Bar;
use crate::terminal::stop::Stop;
use crate::text_summary;
use clap::Args;
use peelkit::study::coarsening::{CoarseningOptions, PadEnd};
use peelkit_analyses::TipCoarsening;
use peelkit_scene::{Dimension, Scene};

/// Computes the force law of a tip of a seta from its spatula, as a table with error bounds
#[derive(Args)]
#[command(after_help = help::SHORT, after_long_help = help::LONG)]
pub struct Coarsen {
    #[command(flatten)]
    scene: SceneArgs,

    /// Error wanted of forces and moment, relative to the largest
    #[arg(long, value_name = "X", default_value_t = 1e-3)]
    tolerance: f64,

    /// How far the tip is pressed [default: 50 nm; 5 nm if the pad is held]
    ///
    /// The table begins so far below the height without a normal force.
    #[arg(long, value_name = "LENGTH", allow_hyphen_values = true)]
    press: Option<String>,

    /// Range of v, if the pad is held [default: -10 nm,10 nm]
    #[arg(long, value_name = "FROM,TO", allow_hyphen_values = true)]
    lateral: Option<String>,

    /// Range of θ [default: -0.4 rad,0.4 rad; -0.1 rad,0.1 rad if the pad is held]
    #[arg(long, value_name = "FROM,TO", allow_hyphen_values = true)]
    rotation: Option<String>,

    #[command(flatten)]
    out: OutArgs,

    /// Prints summary.json alone; writes files only if --out is given
    #[arg(long)]
    json: bool,
}

impl Coarsen {
    /// What is asked of the table of a scene.
    fn options(&self, scene: &Scene) -> Result<CoarseningOptions, Stop> {
        let mut options = CoarseningOptions { tolerance: self.tolerance, ..TipCoarsening::usual(scene) };
        if let Some(text) = &self.press {
            options.range.press = range::number("--press", text, Dimension::Length)?;
        }
        if let Some(text) = &self.lateral {
            if options.pad_end == PadEnd::Sliding {
                return Err(Stop::bad_input(
                    "--lateral is of no use: the pad of this scene slides, and v changes nothing",
                    "Omit it, or give --set grip.horizontal=fixed, which holds the free end of the pad.",
                ));
            }
            options.range.lateral = range::pair("--lateral", text, Dimension::Length)?;
        }
        if let Some(text) = &self.rotation {
            options.range.rotation = range::pair("--rotation", text, Dimension::Angle)?;
        }
        Ok(options)
    }
}

pub fn coarsen(args: &Coarsen) -> Result<(), Stop> {
    let scene = args.scene.load()?;
    let coarsening = TipCoarsening::of(&scene, args.options(&scene)?).map_err(|why| Stop::refused(&scene, why))?;
    let drive = Drive {
        scene: &scene,
        out: &args.out,
        folder: args.out.folder(args.json, || args.scene.default_folder(&["tip".to_owned()])),
        fresh: false,
        json: args.json,
        bar: Bar::spinner("solving the spatula"),
        answer: Some("stopping at the next equilibrium of the spatula; Ctrl-C again stops at once"),
    };
    drive.run(&coarsening, |found| text_summary::of_many::tip::tip(&scene.title, &found.table, found.seconds))
}
