//! The section forces of a film whose material yields, by what its fibres have been through.
//!
//! A rectangle of height h, of a material with Young's modulus E that yields at ±σ₀ and hardens with the tangent modulus Eₜ, kinematically. Each fibre is
//! elastic and perfectly plastic beside an elastic one. With ζ from -1 to 1 over the height, t = Eₜ/E, e_y = σ₀/E and the plastic strain q(ζ),
//!
//! ```text
//! e(ζ) = Γ1 + b ζ,   b = κ h/2,   p(ζ) = e - q between -e_y and e_y,
//! N/EA = t Γ1 + (1 - t) ∫ p dζ/2,   M/(EA h/2) = t b/3 + (1 - t) ∫ p ζ dζ/2.
//! ```
//!
//! q is linear in pieces, and so is p, so that the integrals are exact. Behind a step q has moved by what p would have gone beyond ±e_y. Pieces that
//! follow one another on one line become one; more than [`CORNERS`] allows are made fewer where that changes least. Bent alone, such a section obeys
//! M(κ)/EI = t κ + (1 - t)(3 κ_e/2 - κ_e³/(2 κ²)) for the first time, beyond κ_e = 2 e_y/h, and Masing's rule on the way back.
//! Sources: G. Masing, Proc. 2nd Int. Congr. Appl. Mech. (1926); K.-S. Kim, N. Aravas, Int. J. Solids Struct. 24 (1988), 417.

use std::cmp::Ordering;
use std::ops::RangeInclusive;

/// Corners that the plastic strain over a height has at most, its ends among them.
const CORNERS: usize = 10;
/// The plastic strain over the height, as numbers: at both ends, and then place and strain of each corner from one end to the other.
pub(crate) const PROFILE: usize = 2 * CORNERS - 2;
/// Those numbers.
pub(crate) type PlasticStrain = [f64; PROFILE];

/// A section that yields.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct FilmLaw {
    /// e_y = σ₀/E
    pub yield_strain: f64,
    /// t = Eₜ/E
    pub hardening: f64,
    /// h/2, nm, where EI = EA (h/2)²/3
    pub half_height: f64,
}

/// How a section is strained: Γ1, and b = κ h/2 of its surfaces by bending.
pub(crate) type Strain = [f64; 2];

/// What a strain makes of a section, over EA.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Strained {
    /// ∫ N dΓ1 + M dκ as if each fibre went straight from where its stress is zero
    pub energy: f64,
    /// N, and M over h/2
    pub forces: [f64; 2],
    /// ∂²/∂Γ1², ∂²/∂Γ1∂b and ∂²/∂b² of the energy
    pub stiffness: [f64; 3],
}

impl Strained {
    /// What it gives back, unloaded: N²/2EA + M²/2EI, over EA.
    pub(crate) fn given_back(&self) -> f64 {
        let [force, moment] = self.forces;
        0.5 * force * force + 1.5 * moment * moment
    }
}

/// A place over the height with a number there.
#[derive(Clone, Copy, Debug, Default)]
struct Corner {
    /// ζ
    place: f64,
    value: f64,
}

/// The plastic strain at the head of some numbers.
pub(crate) fn plastic_strain(numbers: &[f64]) -> PlasticStrain {
    std::array::from_fn(|k| numbers[k])
}

/// The corners of a plastic strain, from one surface to the other.
fn corners(profile: &PlasticStrain) -> [Corner; CORNERS] {
    let mut corners = [Corner { place: -1.0, value: profile[0] }; CORNERS];
    for (corner, pair) in corners[1..].iter_mut().zip(profile[2..].chunks_exact(2)) {
        *corner = Corner { place: pair[0], value: pair[1] };
    }
    corners[CORNERS - 1] = Corner { place: 1.0, value: profile[1] };
    corners
}

/// A plastic strain between two, by the share of the second.
pub(crate) fn between([one, other]: [&PlasticStrain; 2], share: f64) -> PlasticStrain {
    if one == other {
        return *one;
    }
    let lines = [one, other].map(corners);
    let value = |line: &[Corner; CORNERS], place: f64| {
        let behind = line.iter().position(|corner| corner.place >= place).unwrap_or(CORNERS - 1).max(1);
        let [from, to] = [line[behind - 1], line[behind]];
        if to.place > from.place {
            from.value + (place - from.place) / (to.place - from.place) * (to.value - from.value)
        } else {
            to.value
        }
    };
    let mut places: Vec<f64> = lines.iter().flatten().map(|corner| corner.place).collect();
    places.sort_by(f64::total_cmp);
    places.dedup();
    let mixed = |place: f64| (1.0 - share) * value(&lines[0], place) + share * value(&lines[1], place);
    simplified(places.into_iter().map(|place| Corner { place, value: mixed(place) }).collect())
}

/// What the fibres would be strained by elastically, corner by corner.
fn trial(profile: &PlasticStrain, [stretch, bend]: Strain) -> [Corner; CORNERS] {
    corners(profile).map(|Corner { place, value }| Corner { place, value: stretch + bend * place - value })
}

/// Calls for each piece of a line from one corner to the next, where these are apart, cut where it goes beyond a bound to either side.
#[inline(always)]
fn pieces(from: Corner, to: Corner, bound: f64, mut with: impl FnMut(Corner, Corner)) {
    if to.place <= from.place {
        return;
    }
    let rise = to.value - from.value;
    let within = |corner: Corner| corner.value.abs() <= bound;
    let mut start = from;
    if !(within(from) && within(to)) && rise != 0.0 {
        let first = bound.copysign(-rise);
        for level in [first, -first] {
            let share = (level - from.value) / rise;
            if share > 0.0 && share < 1.0 {
                let cut = Corner { place: from.place + share * (to.place - from.place), value: level };
                with(start, cut);
                start = cut;
            }
        }
    }
    with(start, to);
}

impl FilmLaw {
    /// Elastic up to a strain.
    pub(crate) fn elastic([stretch, bend]: Strain) -> Strained {
        Strained {
            energy: 0.5 * stretch * stretch + bend * bend / 6.0,
            forces: [stretch, bend / 3.0],
            stiffness: [1.0, 0.0, 1.0 / 3.0],
        }
    }

    /// A section whose plastic strain is known, at a strain.
    pub(crate) fn at(&self, profile: &PlasticStrain, strain: Strain) -> Strained {
        let ([stretch, bend], bound, t) = (strain, self.yield_strain, self.hardening);
        let elastic = Self::elastic(strain);
        if stretch.abs() + bend.abs() <= bound && !has_yielded(profile) {
            return elastic;
        }
        let (mut energy, mut forces, mut stiffness) = (0.0, [0.0; 2], [0.0; 3]);
        for pair in trial(profile, strain).windows(2) {
            pieces(pair[0], pair[1], bound, |from, to| {
                let length = 0.5 * (to.place - from.place);
                let (place, value) = (0.5 * (from.place + to.place), 0.5 * (from.value + to.value));
                if value.abs() > bound {
                    let stress = bound.copysign(value);
                    energy += length * bound * (value.abs() - 0.5 * bound);
                    forces[0] += length * stress;
                    forces[1] += length * stress * place;
                } else {
                    // what is left of a product of two lines beside that of their middles
                    let left = |first: f64, second: f64| first * second / 12.0;
                    let (rise, way) = (to.value - from.value, to.place - from.place);
                    energy += length * 0.5 * (value * value + left(rise, rise));
                    forces[0] += length * value;
                    forces[1] += length * (value * place + left(rise, way));
                    stiffness[0] += length;
                    stiffness[1] += length * place;
                    stiffness[2] += length * (place * place + left(way, way));
                }
            });
        }
        let with = |elastic: f64, plastic: f64| t * elastic + (1.0 - t) * plastic;
        Strained {
            energy: with(elastic.energy, energy),
            forces: [0, 1].map(|k| with(elastic.forces[k], forces[k])),
            stiffness: [0, 1, 2].map(|k| with(elastic.stiffness[k], stiffness[k])),
        }
    }

    /// Takes a section on to a strain at the end of a step, the step before being `step_before` times as long. Where its curvature or the strain of a
    /// surface turned at the end of that one, as far as steps tell, it turned where the parabola through the newest three does.
    pub(crate) fn advance(&self, known: &mut FilmMemory, strain: Strain, step_before: f64) {
        let values = |k: usize| [known.before[k], known.newest[k], strain[k]];
        let [stretch, bend] = [0, 1].map(|k| Steps { values: values(k), before: step_before });
        let surface = |side: f64| Steps {
            values: std::array::from_fn(|k| stretch.values[k] + side * bend.values[k]),
            before: step_before,
        };
        let mut turns = [bend, surface(-1.0), surface(1.0)].map(|steps| steps.turn());
        turns.sort_by(|one, other| one.partial_cmp(other).unwrap_or(Ordering::Equal));
        for label in turns.into_iter().flatten() {
            self.go(known, [stretch.at(label), bend.at(label)]);
        }
        known.before = [stretch.values[1], bend.values[1]];
        self.go(known, strain);
    }

    /// Takes a section straight on to a strain, with the work that this leaves in it.
    fn go(&self, known: &mut FilmMemory, strain: Strain) {
        let [from, to] = [known.newest, strain].map(|strain| self.at(&known.profile, strain));
        known.lost += to.energy - from.energy - (to.given_back() - from.given_back());
        known.profile = self.flown(&known.profile, strain);
        known.newest = strain;
        if strain[1].abs() > known.largest.abs() {
            known.largest = strain[1];
        }
    }

    /// The plastic strain behind a way that ended at a strain.
    fn flown(&self, profile: &PlasticStrain, strain: Strain) -> PlasticStrain {
        let [stretch, bend] = strain;
        let bound = self.yield_strain + SLACK * (stretch.abs() + bend.abs());
        let known = trial(profile, strain);
        if known.iter().all(|corner| corner.value.abs() <= bound) {
            return *profile;
        }
        let mut flown = Vec::with_capacity(3 * CORNERS);
        let stays = |Corner { place, value }: Corner| Corner {
            place,
            value: stretch + bend * place - value.clamp(-bound, bound),
        };
        flown.push(stays(known[0]));
        for pair in known.windows(2) {
            pieces(pair[0], pair[1], bound, |_, to| flown.push(stays(to)));
        }
        simplified(flown)
    }
}

/// Whether anything has yielded.
fn has_yielded(profile: &PlasticStrain) -> bool {
    profile[0] != 0.0 || profile[1] != 0.0 || profile[2..].chunks_exact(2).any(|corner| corner[1] != 0.0)
}

/// Corners that are nearer to a line between their neighbours than this, over the largest strain, lie on it.
const STRAIGHT: f64 = 1e-13;

/// A line with as many corners as are remembered, those left out that change least.
fn simplified(mut line: Vec<Corner>) -> PlasticStrain {
    let largest = line.iter().map(|corner| corner.value.abs()).fold(0.0, f64::max);
    // twice the area between the line with a corner and without
    let area = |three: &[Corner]| {
        let [a, b, c] = [three[0], three[1], three[2]];
        ((b.value - a.value) * (c.place - a.place) - (c.value - a.value) * (b.place - a.place)).abs()
    };
    loop {
        let least = line.windows(3).map(area).enumerate().min_by(|one, other| one.1.total_cmp(&other.1));
        match least {
            Some((before, size)) if line.len() > CORNERS || size <= STRAIGHT * largest => line.remove(before + 1),
            _ => break,
        };
    }
    let (first, last) = (line[0], line[line.len() - 1]);
    let mut profile = [0.0; PROFILE];
    (profile[0], profile[1]) = (first.value, last.value);
    for (k, pair) in profile[2..].chunks_exact_mut(2).enumerate() {
        let corner = line.get(k + 1).unwrap_or(&last);
        (pair[0], pair[1]) = (corner.place, corner.value);
    }
    profile
}

/// Share of its strain by which a fibre has to go back before it is elastic again. Next to a turn the section forces change slope at once, by as much as
/// E over Eₜ, and updates of Newton's method go to and fro.
const SLACK: f64 = 1e-4;

/// Steps of which one is this many times as long as the other may lie on one parabola.
const COMPARABLE: RangeInclusive<f64> = 0.2..=5.0;

/// A number at the ends of three steps, the last as long as the one before over `before`.
#[derive(Clone, Copy, Debug)]
struct Steps {
    values: [f64; 3],
    before: f64,
}

impl Steps {
    /// Slope and half of the second derivative at the middle one, over steps of the last length.
    fn derivatives(&self) -> [f64; 2] {
        let [first, middle, last] = self.values;
        let bend = ((first - middle) + self.before * (last - middle)) / (self.before * self.before + self.before);
        [(last - middle) - bend, bend]
    }

    /// The label of the extremum, where the middle one is beyond both others.
    fn turn(&self) -> Option<f64> {
        let [first, middle, last] = self.values;
        let turns = (middle - first) * (last - middle) < 0.0;
        (turns && COMPARABLE.contains(&self.before)).then(|| {
            let [slope, bend] = self.derivatives();
            -0.5 * slope / bend
        })
    }

    /// What it is at a label.
    fn at(&self, label: f64) -> f64 {
        let [slope, bend] = self.derivatives();
        self.values[1] + label * (slope + label * bend)
    }
}

/// How many numbers [`FilmMemory`] has.
pub(crate) const FILM: usize = PROFILE + 6;

/// What a section remembers from step to step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct FilmMemory {
    /// The plastic strain
    profile: PlasticStrain,
    /// The newest strain, and that a step earlier
    newest: Strain,
    before: Strain,
    /// The work that was not given back, over EA
    lost: f64,
    /// The largest b so far, with its sign
    largest: f64,
}

impl FilmMemory {
    /// Of its numbers.
    pub(crate) fn read(numbers: &[f64]) -> Self {
        let (profile, rest) = numbers.split_at(PROFILE);
        Self {
            profile: plastic_strain(profile),
            newest: [rest[0], rest[1]],
            before: [rest[2], rest[3]],
            lost: rest[4],
            largest: rest[5],
        }
    }

    /// As its numbers.
    pub(crate) fn write(&self, numbers: &mut [f64]) {
        let Self { newest, before, lost, largest, .. } = *self;
        numbers[..PROFILE].copy_from_slice(&self.profile);
        numbers[PROFILE..].copy_from_slice(&[newest[0], newest[1], before[0], before[1], lost, largest]);
    }

    /// The work that was not given back, over EA.
    pub(crate) fn lost(&self) -> f64 {
        self.lost
    }

    /// The largest strain of its surfaces by bending so far, with its sign.
    pub(crate) fn largest(&self) -> f64 {
        self.largest
    }

    /// Whether any fibre of it has yielded.
    pub(crate) fn has_yielded(&self) -> bool {
        has_yielded(&self.profile)
    }

    /// Γ1 that stays when it is unloaded.
    pub(crate) fn permanent_stretch(&self, law: &FilmLaw) -> f64 {
        self.newest[0] - law.at(&self.profile, self.newest).forces[0]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const LAW: FilmLaw = FilmLaw { yield_strain: 0.01, hardening: 0.1, half_height: 1.0 };
    /// Through five turns of the curvature under a tension that rises and falls, in stretches and strains of the surfaces.
    const WAY: [Strain; 8] = [
        [0.0, 0.0],
        [0.002, 0.05],
        [0.006, -0.02],
        [0.005, 0.012],
        [0.008, -0.004],
        [0.012, 0.0],
        [0.009, 0.03],
        [0.003, 0.06],
    ];

    /// N and M over h/2, over EA, of fibres each elastic and perfectly plastic beside an elastic one, whose slips are `slips`.
    fn fibres(slips: &mut [f64], [stretch, bend]: Strain) -> [f64; 2] {
        let count = slips.len() as f64;
        let mut forces = [0.0; 2];
        for (k, slip) in slips.iter_mut().enumerate() {
            let place = (2.0 * k as f64 + 1.0) / count - 1.0;
            let strain = stretch + bend * place;
            let over = (strain - *slip).abs() - LAW.yield_strain;
            if over > 0.0 {
                *slip += over.copysign(strain - *slip);
            }
            let stress = (1.0 - LAW.hardening) * (strain - *slip) + LAW.hardening * strain;
            forces[0] += stress / count;
            forces[1] += stress * place / count;
        }
        forces
    }

    /// By steps of a thousandth of each way the section forces are those of 4000 fibres, and what is left in the section is the work of all steps less
    /// what they give back; with the slack by which a fibre has to go back before it turns, a thousandth of the stress at which it yields.
    #[test]
    fn a_section_is_strained_as_its_fibres_are() {
        let (mut slips, mut known) = (vec![0.0; 4000], FilmMemory::read(&[0.0; FILM]));
        let (mut work, mut before, mut at) = (0.0, [0.0; 2], [0.0; 2]);
        for pair in WAY.windows(2) {
            for k in 1..=1000 {
                let share = f64::from(k) / 1000.0;
                let strain: Strain = std::array::from_fn(|i| pair[0][i] + share * (pair[1][i] - pair[0][i]));
                let forces = LAW.at(&known.profile, strain).forces;
                let expected = fibres(&mut slips, strain);
                for i in 0..2 {
                    assert!(
                        (forces[i] - expected[i]).abs() < 1e-3 * LAW.yield_strain,
                        "{strain:?} {forces:?} {expected:?}"
                    );
                    work += 0.5 * (before[i] + forces[i]) * (strain[i] - at[i]);
                }
                LAW.advance(&mut known, strain, 1.0);
                (before, at) = (forces, strain);
            }
        }
        let left = work - Strained { forces: before, ..Strained::default() }.given_back();
        assert!((known.lost() / left - 1.0).abs() < 2e-3, "{} {left}", known.lost());
    }

    /// The corners that are remembered are enough for three turns of the curvature, where nothing is left out.
    #[test]
    fn bent_alone_it_obeys_masings_rule() {
        let first = |bend: f64| {
            let (size, yields, t) = (bend.abs(), LAW.yield_strain, LAW.hardening);
            let plastic = yields * (1.5 - 0.5 * (yields / size).powi(2));
            (if size <= yields { size } else { t * size + (1.0 - t) * plastic }).copysign(bend) / 3.0
        };
        let turns = [0.07, -0.05, 0.045];
        let mut known = FilmMemory::read(&[0.0; FILM]);
        let (mut moment, mut from) = (first(turns[0]), turns[0]);
        LAW.go(&mut known, [0.0, turns[0]]);
        for to in [turns[1], turns[2], 0.0] {
            moment += 2.0 * first(0.5 * (to - from));
            let found = LAW.at(&known.profile, [0.0, to]).forces;
            // within the slack of each turn
            assert!(found[0].abs() < 1e-15 && (found[1] - moment).abs() < 3.0 * SLACK * 0.07, "{found:?} {moment}");
            LAW.go(&mut known, [0.0, to]);
            from = to;
        }
    }

    /// Forces are the slopes of energies, and stiffnesses those of forces, wherever a section has been; nothing jumps.
    #[test]
    fn derivatives_are_those_of_differences() {
        let mut known = FilmMemory::read(&[0.0; FILM]);
        for strain in WAY {
            LAW.go(&mut known, strain);
            for k in -100..100 {
                let around = [0.003 + 1e-5 * f64::from(k), 4e-4 * (f64::from(k) + 0.37)];
                let step = 1e-8;
                let here = LAW.at(&known.profile, around);
                for i in 0..2 {
                    let moved = |by: f64| {
                        let mut strain = around;
                        strain[i] += by;
                        LAW.at(&known.profile, strain)
                    };
                    let [low, high] = [moved(-step), moved(step)];
                    let slope = |low: f64, high: f64| (high - low) / (2.0 * step);
                    assert!((slope(low.energy, high.energy) - here.forces[i]).abs() < 1e-8, "{around:?}");
                    for j in 0..2 {
                        assert!(
                            (slope(low.forces[j], high.forces[j]) - here.stiffness[i + j]).abs() < 1e-4,
                            "{around:?}"
                        );
                    }
                }
            }
        }
    }

    /// A number that rose and falls turned between two steps, and what goes beside it is known there too.
    #[test]
    fn a_turn_between_steps_is_found() {
        let rising = |label: f64| 0.02 - 0.003 * (label - 0.3).powi(2);
        let steps = Steps { values: [-2.0, 0.0, 1.0].map(rising), before: 2.0 };
        let label = steps.turn().unwrap();
        assert!((label - 0.3).abs() < 1e-14 && (steps.at(label) - 0.02).abs() < 1e-15);
        assert_eq!(Steps { values: [0.0, 1.0, 2.0], before: 1.0 }.turn(), None);
    }
}
