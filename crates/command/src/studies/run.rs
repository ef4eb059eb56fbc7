//! `peel run`: the whole peel of one scene.

use crate::studies::drive::Drive;
use crate::studies::ready::ready;
use crate::terminal::help;
use crate::terminal::input::SceneArgs;
use crate::terminal::output::OutArgs;
use crate::terminal::progress::Bar;
use crate::terminal::stop::Stop;
use crate::text_summary;
use crate::text_summary::peel::Beside;
use crate::text_summary::rate::LawOfTips;
use crate::text_summary::units::UnitsArgs;
use clap::Args;
use peelkit::study::EventAction;
use peelkit::units::PreferredUnits;
use peelkit_analyses::{Asked, PeelOutcome, Pull, RateOutcome, Run as Analysis, RunOutcome, SetaOutcome};
use peelkit_scene::{Scene, event, refused_quantity, station};
use std::path::PathBuf;

/// Computes the whole equilibrium path of one scene, with its limit points and their error bounds
#[derive(Args)]
#[command(after_help = help::RUN, after_long_help = help::run())]
pub struct Run {
    #[command(flatten)]
    scene: SceneArgs,

    #[command(flatten)]
    out: OutArgs,

    /// Computes the path at an exact value besides, u="10 nm" say
    ///
    /// Of `u`, `P`, `front`, `end_rotation`, `free_end_gap` or, at a rate, `t`; may be repeated. Adds stations.csv.
    #[arg(long, value_name = "QUANTITY=VALUE")]
    at: Vec<String>,

    /// Records where a quantity passes a value, "P > 0.04 nN" say
    #[arg(long, value_name = "CONDITION")]
    event: Vec<String>,

    /// The same, and follows nothing beyond it: "half off: front < 50 nm"
    #[arg(long, value_name = "CONDITION", hide_short_help = true)]
    stop_at: Vec<String>,

    /// Adds a displacement-controlled test: stable branches and jumps
    ///
    /// The machine retreats until the beam is off, and returns. Jumps come with the energy that they release.
    #[arg(long)]
    observed: bool,

    /// Adds the stability of the path against rolling or buckling sideways
    #[arg(long)]
    out_of_plane: bool,

    /// Follows the branch that leaves the plane in space
    ///
    /// Implies --out-of-plane. To one side: the other is its mirror image. Adds branch.csv.
    #[arg(long)]
    branch: bool,

    /// Adds by which power of each parameter the results change
    ///
    /// d ln Q/d ln p of peaks, plateau, first jump and detachment, with bounds: sensitivities.svg, summary.json.
    #[arg(long)]
    sensitivities: bool,

    /// Writes the fields along the beam: states.csv, states.pvd
    ///
    /// At every limit point, and at N points evenly along the path, its two ends among them.
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(0..=1_000))]
    states: Option<u32>,

    /// Writes animation.html, the peel as a browser plays it
    #[arg(long)]
    animate: bool,

    /// Discards the checkpoint of an unfinished run and starts anew
    #[arg(long, hide_short_help = true)]
    fresh: bool,

    #[command(flatten)]
    units: UnitsArgs,

    /// Prints summary.json alone; writes files only if --out is given
    #[arg(long)]
    json: bool,
}

impl Run {
    /// Where files go, if they are written.
    fn folder(&self) -> Option<PathBuf> {
        self.out.folder(self.json, || self.scene.default_folder(&self.folder_parts()))
    }

    /// What the name of the folder says of the run.
    fn folder_parts(&self) -> Vec<String> {
        let states = self.states.map(|count| format!("states={count}"));
        let asked = [
            (self.observed, "observed"),
            (self.out_of_plane && !self.branch, "out-of-plane"),
            (self.branch, "branch"),
            (self.sensitivities, "sensitivities"),
        ];
        let of =
            |name: &'static str, given: &[String]| given.iter().map(|at| format!("{name}={at}")).collect::<Vec<_>>();
        let at = [("at", &self.at), ("event", &self.event), ("stop-at", &self.stop_at)];
        let at = at.into_iter().flat_map(|(name, given)| of(name, given));
        asked.iter().filter(|(is, _)| *is).map(|(_, name)| (*name).to_owned()).chain(states).chain(at).collect()
    }

    fn asked(&self) -> Asked {
        Asked {
            observed: self.observed,
            out_of_plane: self.out_of_plane,
            branch: self.branch,
            sensitivities: self.sensitivities,
            states: self.states,
            animate: self.animate,
        }
    }

    /// Adds the stations and events of the command line to those of the scene.
    fn add_stations(&self, scene: &mut Scene) -> Result<(), Stop> {
        for text in &self.at {
            let at = station(text).map_err(|why| Stop::bad_input(format!("--at {}", why.found), why.remedy))?;
            scene.stations.push(at);
        }
        let events = [("--event", &self.event, EventAction::Record), ("--stop-at", &self.stop_at, EventAction::Stop)];
        for (option, given, action) in events {
            for text in given {
                let at = event(text, action)
                    .map_err(|why| Stop::bad_input(format!("{option} {}", why.found), why.remedy))?;
                if scene.events.iter().any(|other| other.name == at.name) {
                    let found = format!("{option} has the name \"{}\" of another event", at.name);
                    return Err(Stop::bad_input(found, "Give it another name before a colon: \"name: condition\"."));
                }
                scene.events.push(at);
            }
        }
        match refused_quantity(scene) {
            Some((key, problem)) => Err(Stop::bad_input(format!("`{key}` {}", problem.found), problem.remedy)),
            None => Ok(()),
        }
    }

    fn refuse_states_without_files(&self) -> Result<(), Stop> {
        match (self.states, self.folder()) {
            (Some(_), None) => Err(Stop::bad_input(
                "--states writes files, and --json without --out writes none",
                "Give a folder with --out DIR, or omit --states.",
            )),
            _ => Ok(()),
        }
    }
}

pub fn run(args: &Run) -> Result<(), Stop> {
    let mut scene = ready(|| args.scene.load_any())?;
    args.add_stations(&mut scene)?;
    args.units.put(&mut scene)?;
    let scene = scene;
    args.refuse_states_without_files()?;
    let analysis = Analysis::of(&scene, args.asked()).map_err(|why| Stop::refused(&scene, why))?;
    let wanted = scene.written_units();
    let folder = args.folder();
    let answer = match analysis {
        Analysis::Peel(_) => folder.is_some().then_some(
            "stopping at the next point of the path, then locating the limit points of what was reached; Ctrl-C again stops at once",
        ),
        Analysis::Solid(_) => Some("stopping at the next point of the path; Ctrl-C again stops at once"),
        Analysis::Array(_) => None,
        Analysis::Seta(_) => Some("stopping at the next equilibrium of the seta; Ctrl-C again stops at once"),
        Analysis::Rate(_) => Some("stopping at the next step in time; Ctrl-C again stops at once"),
    };
    let (fresh, json) = (args.fresh, args.json);
    let drive = Drive { scene: &scene, out: &args.out, folder, fresh, json, bar: Bar::run(), answer };
    drive.run(&analysis, |found| match found {
        RunOutcome::Peel(found) => of_peel(&scene, found, wanted),
        RunOutcome::Solid(found) => {
            text_summary::solid::solid(&scene, &found.peel, found.long.as_ref(), found.seconds, wanted)
                + &text_summary::peel::taken(found.taken)
        }
        RunOutcome::Array(found) => {
            text_summary::array::array(&scene, &found.table, &found.pull, found.seconds, wanted)
        }
        RunOutcome::Seta(found) => of_seta(&scene, found, wanted),
        RunOutcome::Rate(found) => of_rate(&scene, found, wanted),
    })
}

fn of_peel(scene: &Scene, found: &PeelOutcome, wanted: PreferredUnits) -> String {
    let [.., test_s] = found.beside_s;
    let beside = Beside {
        stability: found.stability.as_ref(),
        branch: found.branch.as_ref(),
        stations: &found.stations,
        events: &found.events,
    };
    let mut text = text_summary::peel::peel(scene, &found.peel, beside, found.seconds, wanted);
    if let Some(test) = &found.test {
        text += &format!("\n{}", text_summary::observed::observed(test, &scene.looked_for(), test_s, wanted));
    }
    if let Some(exponents) = &found.exponents {
        let text_of =
            text_summary::of_many::sensitivities::sensitivities(&exponents.found, &exponents.keys, &exponents.refused);
        text += &format!("\n{text_of}");
    }
    text + &text_summary::peel::taken(found.taken)
}

fn of_seta(scene: &Scene, found: &SetaOutcome, wanted: PreferredUnits) -> String {
    let (law, pulled) = ((&found.tip, found.table(), found.outside.as_ref()), (found.pull_off(), found.peak.as_ref()));
    let text =
        text_summary::seta::seta(scene, (found.seta(), found.order()), law, pulled, found.seconds.iter().sum(), wanted);
    text + &text_summary::seta::equilibria_taken(found.taken)
}

fn of_rate(scene: &Scene, found: &RateOutcome, wanted: PreferredUnits) -> String {
    let law = match &found.of {
        Pull::Beam(_) => None,
        Pull::Seta(own) => {
            Some(LawOfTips { tips: own.seta.tips(), curve: &own.tip, events: &own.pulled.events, seconds: own.tip_s })
        }
    };
    let solve_s = found.seconds.iter().sum::<f64>() + law.as_ref().map_or(0.0, |law| law.seconds);
    let end = (found.failed.as_deref(), solve_s);
    text_summary::rate::rate(scene, (&found.pulled, &found.equilibria), law, end, wanted)
}
