//! `peel sweep`: one number of a scene varied, or two; each value peeled from rest to its end, or one point of the peel followed.

pub(crate) mod args;
mod axes;
mod part;
mod varied;

use args::Sweep;

use crate::studies::drive::Drive;
use crate::studies::ready::ready;
use crate::terminal::progress::Bar;
use crate::terminal::stop::Stop;
use crate::text_summary;
use peelkit::units::PreferredUnits;
use peelkit_analyses::{Axis, Cases, Rows, Sweep as Analysis, SweepOutcome};
use peelkit_report::SweptKeys;
use peelkit_scene::{Key, Scene};

pub fn sweep(args: &Sweep) -> Result<(), Stop> {
    let mut scene = ready(|| args.scene.load_any())?;
    args.units.put(&mut scene)?;
    let scene = scene;
    let refused = |why| Stop::refused(&scene, why);
    Analysis::allows(&scene, args.followed().is_some(), args.part.is_some()).map_err(refused)?;
    let wanted = scene.written_units();
    let parameters = args.varied.parameters()?;
    let axes = parameters.iter().map(|parameter| axes::read(&scene, parameter));
    let axes = axes.collect::<Result<Vec<Axis>, Stop>>()?;
    args.part.map_or(Ok(()), |part| part::check(args, part, &axes))?;
    let cases = Cases::along(&scene, &axes, args.part).map_err(refused)?;
    args.units.check(&scene, cases.keys.keys().map(Key::path))?;
    refuse_set_keys(&args.scene.overrides, cases.keys)?;
    let part = args.part.map(|part| part::header(args, &scene, &axes, part));
    let sweep = Analysis::of(&scene, cases, args.followed(), part).map_err(refused)?;
    let folder = args.folder();
    let is_kept = folder.is_some() && args.followed().is_none();
    let answer = is_kept.then_some("stopping when the values being computed are done; Ctrl-C again stops at once");
    let (fresh, json) = (args.fresh, args.json);
    let drive = Drive { scene: &scene, out: &args.out, folder, fresh, json, bar: Bar::counted(), answer };
    drive.run(&sweep, |found| table(&scene, found, wanted))
}

/// Refuses a key that `--set` gives as well.
fn refuse_set_keys(overrides: &[(String, String)], keys: SweptKeys) -> Result<(), Stop> {
    let set = |key: &Key| overrides.iter().find(|(set, _)| set.trim() == key.path());
    match keys.keys().find_map(set) {
        Some((path, value)) => Err(Stop::bad_input(
            format!(
                "--set {path}={value} sets the key that --vary varies, and would have no effect",
                path = path.trim()
            ),
            "Remove the --set, or vary another key.",
        )),
        None => Ok(()),
    }
}

/// The rows for a person.
pub fn table(scene: &Scene, found: &SweepOutcome, wanted: PreferredUnits) -> String {
    let (keys, remarks) = (found.keys, &found.remarks);
    match &found.rows {
        Rows::Peels(rows) => text_summary::of_many::sweep::sweep(scene, keys, rows, remarks, wanted),
        Rows::Setae(rows) => text_summary::of_many::swept_pulls::swept_setae(scene, keys, rows, remarks, wanted),
        Rows::Solids(rows) => text_summary::solid::swept_solids(scene, keys, rows, remarks, wanted),
        Rows::Arrays(rows) => text_summary::array::swept_arrays(scene, keys, rows, remarks, wanted),
        Rows::Rates(rows) => text_summary::of_many::swept_pulls::swept_rates(scene, keys, rows, remarks, wanted),
        Rows::Followed(sweep, seconds) => {
            text_summary::of_many::sweep::followed(scene, keys.first, sweep, seconds, wanted)
        }
    }
}
