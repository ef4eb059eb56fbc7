//! `peel sweep`: one number of a scene varied, or two; each value peeled from rest to its end, or one point of the peel followed.

mod args;
pub mod axes;
pub mod cases;
mod conclusion;
pub mod failed;
pub mod files;
mod follow;
mod kept;
pub mod no_effect;
mod part;
mod peels;
mod pulls;
mod rates;
mod setae;
mod varied;

pub use args::Sweep;

use crate::stop::Stop;
use axes::Axis;
use cases::Cases;

pub fn sweep(args: &Sweep) -> Result<(), Stop> {
    let scene = args.scene.load_any()?;
    if scene.time.is_some() {
        rates::refuse(args)?;
    } else if scene.seta.is_some() {
        setae::refuse(args)?;
    }
    let wanted = args.units.wanted()?;
    let parameters = args.varied.parameters()?;
    let axes = parameters.iter().map(|parameter| Axis::of(&scene, parameter));
    let axes = axes.collect::<Result<Vec<_>, Stop>>()?;
    args.part.map_or(Ok(()), |part| part::check(args, part, &axes))?;
    let cases = Cases::along(&scene, &axes, args.part)?;
    no_effect::refuse(&args.scene.overrides, &scene, &cases)?;
    if scene.time.is_some() {
        return rates::pull_each(args, &scene, &cases, wanted);
    }
    if scene.seta.is_some() {
        return setae::pull_off_each(args, &scene, &cases, wanted);
    }
    match args.followed() {
        Some(kind) => follow::follow(args, kind, &scene, &cases, wanted),
        None => {
            let part = args.part.map(|part| part::header(args, &scene, &axes, part));
            peels::peel_each(args, &scene, &cases, part.as_ref(), wanted)
        }
    }
}
