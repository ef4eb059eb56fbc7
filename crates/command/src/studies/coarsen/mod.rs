//! `peel coarsen`: the law of a tip of a seta, from the spatula of a scene, or that of the seta.

mod help;
mod range;

use crate::studies::drive::Drive;
use crate::terminal::input::SceneArgs;
use crate::terminal::output::OutArgs;
use crate::terminal::progress::Bar;
use crate::terminal::stop::Stop;
use crate::text_summary;
use clap::Args;
use peelkit::study::coarsening::{CoarseningOptions, PadEnd, SetaLawOptions};
use peelkit_analyses::{SetaLawCoarsening, TipCoarsening};
use peelkit_scene::{Described, Dimension, Scene};

/// Computes the law of a tip of a seta from its spatula, or that of a whole seta
#[derive(Args)]
#[command(after_help = help::SHORT, after_long_help = help::LONG)]
pub struct Coarsen {
    #[command(flatten)]
    scene: SceneArgs,

    /// Error wanted, relative [default: 1e-3 of a tip, 0.03 of a seta]
    ///
    /// Of a tip that of forces and moment, over the largest. Of a seta that of peak and work of each pull.
    #[arg(long, value_name = "X")]
    tolerance: Option<f64>,

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

    /// Degree of the law of a seta: 2, 3 or 4; a band takes 2
    #[arg(long, value_name = "N")]
    degree: Option<usize>,

    /// Most sheets of the law of a seta [default: 16]
    ///
    /// With one the law is brittle: what the tips behind the first one hold is left out.
    #[arg(long, value_name = "N")]
    sheets: Option<usize>,

    #[command(flatten)]
    out: OutArgs,

    /// Prints summary.json alone; writes files only if --out is given
    #[arg(long)]
    json: bool,
}

impl Coarsen {
    /// What is asked of the table of a scene.
    fn options(&self, scene: &Scene) -> Result<CoarseningOptions, Stop> {
        let tolerance = self.tolerance.unwrap_or(1e-3);
        let mut options = CoarseningOptions { tolerance, ..TipCoarsening::usual(scene) };
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
    let scene = args.scene.load_any()?;
    match scene.describes() {
        Described::Seta(_) => return of_seta(args, &scene),
        Described::Peel => {}
        // the reader of peels says why it is none
        _ => _ = args.scene.load()?,
    }
    for (option, given) in [("--degree", args.degree), ("--sheets", args.sheets)] {
        if given.is_some() {
            return Err(Stop::bad_input(
                format!(
                    "{option} is of no use: the law of a tip is a table, and that of a seta alone has degree and sheets"
                ),
                "Omit it, or give a scene with a [seta].",
            ));
        }
    }
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

/// The law of a whole seta.
fn of_seta(args: &Coarsen, scene: &Scene) -> Result<(), Stop> {
    let of_tips = [("--press", &args.press), ("--lateral", &args.lateral), ("--rotation", &args.rotation)];
    let range = of_tips.iter().find(|(_, given)| given.is_some()).map(|(option, _)| *option);
    if let Some(option) = range {
        return Err(Stop::bad_input(
            format!("{option} is of no use: it is one of the law of a tip, and the scene has a [seta]"),
            "Omit it, or give the scene of a spatula.",
        ));
    }
    let usual = SetaLawOptions::default();
    let asked = SetaLawOptions {
        degree: args.degree.unwrap_or(usual.degree),
        sheets: args.sheets.unwrap_or(usual.sheets),
        tolerance: args.tolerance.unwrap_or(usual.tolerance),
    };
    let coarsening = SetaLawCoarsening::of(scene, asked).map_err(|why| Stop::refused(scene, why))?;
    let drive = Drive {
        scene,
        out: &args.out,
        folder: args.out.folder(args.json, || args.scene.default_folder(&["law".to_owned()])),
        fresh: false,
        json: args.json,
        bar: Bar::spinner("pulling the root of the seta"),
        answer: Some("stopping at the next equilibrium of the seta; Ctrl-C again stops at once"),
    };
    drive.run(&coarsening, |outcome| text_summary::seta::seta_law(&scene.title, &outcome.found))
}
