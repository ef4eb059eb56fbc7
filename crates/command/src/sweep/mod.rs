//! `peel sweep`: one number of a scene varied, or two; each value peeled from rest to its end, or one point of the peel followed.

mod args;
mod cases;
mod failed;
mod follow;
mod no_effect;
mod peels;
mod varied;

pub use args::Sweep;

use crate::stop::Stop;
use cases::Cases;

pub fn sweep(args: &Sweep) -> Result<(), Stop> {
    let scene = args.scene.load()?;
    let wanted = args.units.wanted()?;
    let cases = Cases::of(&scene, &args.varied.parameters()?)?;
    no_effect::refuse(&args.scene.overrides, &scene, &cases)?;
    match args.followed() {
        Some(kind) => follow::follow(args, kind, &scene, &cases, wanted),
        None => peels::peel_each(args, &scene, &cases, wanted),
    }
}
