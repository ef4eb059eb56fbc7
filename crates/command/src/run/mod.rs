//! `peel run`: the whole peel of one scene.

mod kept;
mod progress;
mod rate;
mod sensitivities;
mod seta;

use crate::command_line::command_line;
use crate::help;
use crate::input::SceneArgs;
use crate::output::{OutArgs, list_files, say};
use crate::stop::Stop;
use crate::text_summary::{self, UnitsArgs};
use clap::Args;
use kept::KeptRun;
use peelkit::model::PeelModel;
use peelkit::solve::{PathOptions, Waypoint};
use peelkit::study::{
    self, Checkpoint, Failure, NoEquilibrium, NoTest, NotOutOfPlane, Observed, OutOfPlane, OutOfPlaneBranch,
    OutOfPlaneBranchError, PathEnd, Peel, TestEnd,
};
use peelkit_report::{self as report, PeelSummary, ReportError, timed};
use peelkit_scene::Scene;
use progress::RunProgress;
use sensitivities::Exponents;
use std::path::{Path, PathBuf};

/// How an unfinished run is finished.
const GOES_ON: &str = "the same command resumes from there, --fresh starts anew";

/// Computes the whole equilibrium path of one scene, with its limit points and their error bounds
#[derive(Args)]
#[command(after_help = help::RUN, after_long_help = help::run())]
pub struct Run {
    #[command(flatten)]
    scene: SceneArgs,

    #[command(flatten)]
    out: OutArgs,

    /// Adds a displacement-controlled test: stable branches and jumps
    ///
    /// The machine retreats until the beam is off, and returns. Jumps come with the energy that they release.
    #[arg(long)]
    observed: bool,

    /// Adds the stability of the planar path against leaving its plane
    ///
    /// Where a free strip rolls or buckles sideways. For a grip that is free to roll and to rotate.
    #[arg(long)]
    out_of_plane: bool,

    /// Follows the branch that leaves the plane in space; implies --out-of-plane
    ///
    /// To one side: the other is its mirror image. Adds branch.csv, and the branch to summary.json and curve.svg.
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
    #[arg(long)]
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
        match &self.out.out {
            None if self.json => None,
            None => Some(self.scene.default_folder(&self.folder_parts())),
            given => given.clone(),
        }
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
        asked.iter().filter(|(is, _)| *is).map(|(_, name)| (*name).to_owned()).chain(states).collect()
    }

    fn refuse_out_of_plane(&self, scene: &Scene) -> Result<(), Stop> {
        match NotOutOfPlane::of(&scene.model).filter(|_| self.looks_out_of_plane()) {
            Some(why) => {
                let (what, option) = match self.branch {
                    true => ("the branch out of the plane is not followed", "--branch"),
                    false => ("the stability out of the plane is not computed", "--out-of-plane"),
                };
                Err(Stop::bad_input(format!("{what}: {why}"), why.remedy().replace("--out-of-plane", option)))
            }
            None => Ok(()),
        }
    }

    fn looks_out_of_plane(&self) -> bool {
        self.out_of_plane || self.branch
    }

    /// Refuses a scene whose branch is none that is computed in space.
    fn refuse_branch(&self, scene: &Scene) -> Result<(), Stop> {
        match PeelModel::left_plane(&scene.model).check().err().filter(|_| self.branch) {
            Some(why) => Err(Stop::bad_input(
                format!("the branch out of the plane is not followed: in space `{}` {}", why.key(), why.found()),
                "Omit --branch: --out-of-plane alone says where the planar path loses its stability.",
            )),
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

/// Refuses the first of these options that is asked for: it has no meaning for what the scene describes, with the reason, and what to do instead.
fn refuse_asked(options: &[(bool, &str, &str)], scene_of: &str, instead: &str) -> Result<(), Stop> {
    match options.iter().find(|(is_asked, ..)| *is_asked) {
        Some((_, option, why)) => Err(Stop::bad_input(
            format!("{option} has no meaning for {scene_of}: {why}"),
            format!("Omit {option}{instead}"),
        )),
        None => Ok(()),
    }
}

pub fn run(args: &Run) -> Result<(), Stop> {
    let scene = args.scene.load_any()?;
    args.refuse_states_without_files()?;
    match (&scene.time, &scene.seta) {
        (Some(table), _) => rate::run(args, &scene, table),
        (None, Some(table)) => seta::run(args, &scene, table),
        (None, None) => peel(args, &scene),
    }
}

/// The peel of a scene.
fn peel(args: &Run, scene: &Scene) -> Result<(), Stop> {
    args.refuse_out_of_plane(scene)?;
    args.refuse_branch(scene)?;
    if args.sensitivities {
        sensitivities::refuse(scene)?;
    }
    if args.observed {
        refuse_test(scene)?;
    }
    let wanted = args.units.wanted()?;
    let progress = RunProgress::begin();
    let open = |folder: PathBuf| KeptRun::open(&args.out, args.fresh, &folder, scene, &progress);
    let mut kept = args.folder().map(open).transpose()?;
    let (peel, peel_s) = timed(|| match &mut kept {
        Some(kept) => kept.peel(scene, &progress),
        None => unkept(scene, &progress),
    });
    let interrupted = kept.as_ref().is_some_and(|kept| kept.interrupted);
    let looked_at = args.looks_out_of_plane() && !peel.points.is_empty();
    let (stability, stability_s) = timed(|| looked_at.then(|| peel.out_of_plane()).transpose());
    let (stability, unknown) = match stability {
        Ok(stability) => (stability, None),
        Err(why) => (None, Some(why)),
    };
    let follows = args.branch && !interrupted && stability.is_some();
    let (branch, branch_s) = timed(|| follows.then(|| branch(scene, &peel, &progress)).transpose());
    let (branch, not_followed) = match branch {
        Ok(branch) => (branch, None),
        Err(why) => (None, Some(why)),
    };
    let differentiated = args.sensitivities && !interrupted && peel.points.len() > 1;
    let (exponents, no_exponents) = match differentiated.then(|| Exponents::of(scene, &peel, &progress)).transpose() {
        Ok(exponents) => (exponents, None),
        Err(why) => (None, Some(why)),
    };
    let (test, test_s) = timed(|| (args.observed && !interrupted).then(|| observed(scene, &progress)));
    progress.finish();
    let test = test.transpose()?;
    let command = command_line();
    let summary = PeelSummary::new(scene, &peel, peel_s).with_command(&command);
    let summary = match &test {
        Some(test) => summary.with_observed(test, test_s),
        None => summary,
    };
    let summary = match &stability {
        Some(stability) => summary.with_out_of_plane(stability, stability_s),
        None => summary,
    };
    let summary = match &branch {
        Some(branch) => summary.with_branch(branch.as_ref(), branch_s),
        None => summary,
    };
    let summary = match &exponents {
        Some(Exponents { found, keys, .. }) => summary.with_sensitivities(found, keys),
        None => summary,
    };
    let (files, left) = kept.as_ref().map_or((Ok(Vec::new()), None), |kept| {
        kept.write(&peel, |dir| {
            let branch = branch.iter().flatten().next();
            let found = Found {
                peel: &peel,
                stability: stability.as_ref(),
                branch,
                test: test.as_ref(),
                exponents: exponents.as_ref(),
            };
            let mut files = write(dir, scene, &found, (&summary, &command), args.states)?;
            if args.animate && peel.points.len() > 1 {
                files.push(report::write_animation(dir, &peel, &scene.title)?);
            }
            Ok(files)
        })
    });
    // the results are reported even if they could not be written
    if args.json {
        say(&summary.to_json().map_err(Stop::other)?)?;
    } else {
        let recorded =
            test.as_ref().map(|test| format!("\n{}", text_summary::observed(test, test_s, wanted))).unwrap_or_default();
        let exponents = exponents.as_ref().map(|found| format!("\n{}", found.text())).unwrap_or_default();
        let taken = text_summary::taken(kept.as_ref().map_or(0, KeptRun::taken));
        let left = left.as_ref().map(|left| format!("\n{left}: {GOES_ON}\n")).unwrap_or_default();
        say(&format!(
            "{}{recorded}{exponents}{taken}\n{}{left}",
            text_summary::peel(scene, &peel, (stability.as_ref(), branch.as_ref()), peel_s, wanted),
            list_files(&files)
        ))?;
    }
    files?;
    if interrupted {
        return Err(Stop::cut_short(format!("interrupted; {}: {GOES_ON}", left.unwrap_or_default())));
    }
    match (&peel.end, test.map(|test| test.end)) {
        (PathEnd::Failed(Failure::NoStart(NoEquilibrium::Unstable { why })), _) => {
            Err(Stop::bad_input(format!("the model is refused, there is no stable state at rest: {why}"), why.remedy()))
        }
        (PathEnd::Failed(reason), _) => Err(Stop::cut_short(reason)),
        (_, Some(TestEnd::Failed(reason))) => {
            Err(Stop::cut_short(format!("in the displacement-controlled test, {reason}")))
        }
        _ if no_exponents.is_some() => {
            Err(Stop::cut_short(no_exponents.map(|why| why.to_string()).unwrap_or_default()))
        }
        _ => match (unknown, not_followed, branch.flatten().map(|branch| branch.peel.end)) {
            (Some(why), ..) => Err(Stop::cut_short(why)),
            (_, Some(why), _) => Err(Stop::cut_short(why)),
            (.., Some(PathEnd::Failed(reason))) => {
                Err(Stop::cut_short(format!("on the branch out of the plane, {reason}")))
            }
            _ => Ok(()),
        },
    }
}

/// The branch of a peel that leaves the plane, if there is one.
fn branch(
    scene: &Scene,
    peel: &Peel,
    progress: &RunProgress,
) -> Result<Option<OutOfPlaneBranch>, OutOfPlaneBranchError> {
    progress.stage("branch out of the plane");
    peel.branch(&progress.watch(scene.bounds.from_now()))
}

/// The peel of a scene of which nothing is written.
fn unkept(scene: &Scene, progress: &RunProgress) -> Peel {
    let keep = |options: &PathOptions, waypoint: Waypoint| progress.point(options, &waypoint);
    let checkpoint = Checkpoint { taken: &|_| Vec::new(), keep: &keep };
    study::peel_on(&scene.model, &scene.accuracy, &progress.watch(scene.bounds.from_now()), &checkpoint)
}

/// The displacement-controlled test of the scene.
fn observed(scene: &Scene, progress: &RunProgress) -> Result<Observed, Stop> {
    progress.stage("displacement-controlled test");
    study::observed(&scene.model, &scene.accuracy, &progress.watch(scene.bounds.from_now()))
        .map_err(|none| without_test(&none))
}

/// Refuses a scene that has no displacement-controlled test before its path is computed. What is wrong with its model is told with its path.
fn refuse_test(scene: &Scene) -> Result<(), Stop> {
    match study::no_test(&scene.model, &scene.accuracy) {
        None | Some(NoTest::Model(_)) => Ok(()),
        Some(none) => Err(without_test(&none)),
    }
}

fn without_test(none: &NoTest) -> Stop {
    Stop::bad_input(format!("there is no observed test: {none}"), none.remedy())
}

/// What a run found.
struct Found<'f> {
    peel: &'f Peel,
    stability: Option<&'f OutOfPlane>,
    branch: Option<&'f OutOfPlaneBranch>,
    test: Option<&'f Observed>,
    exponents: Option<&'f Exponents>,
}

fn write(
    folder: &Path,
    scene: &Scene,
    &Found { peel, stability, branch, test, exponents }: &Found,
    (summary, command): (&PeelSummary, &str),
    states: Option<u32>,
) -> Result<Vec<PathBuf>, ReportError> {
    let mut files = vec![
        summary.write(folder)?,
        report::write_curve(folder, peel, stability)?,
        report::write_limit_points(folder, peel)?,
    ];
    files.push(report::write_parameters(folder, scene, command)?);
    if peel.points.len() > 1 {
        files.extend(report::draw_peel_with_branch(peel, stability, branch, &scene.title, folder)?);
    }
    if let Some(branch) = branch {
        files.push(report::write_branch(folder, branch)?);
    }
    if let Some(count) = states {
        let states = peel.states(count as usize);
        files.push(report::write_states(folder, &states)?);
        files.extend(report::write_vtk(folder, &states)?);
    }
    if let Some(Exponents { found, keys, .. }) = exponents.filter(|exponents| !exponents.found.is_empty()) {
        files.extend(report::draw_sensitivities(found, keys, &scene.title, folder)?);
    }
    if let Some(test) = test {
        files.push(report::write_observed(folder, test)?);
        if test.points.len() > 1 {
            files.extend(report::draw_observed(test, &scene.title, folder)?);
        }
    }
    Ok(files)
}
