//! The bending moment of a section whose material yields, by the curvatures between which it has been bent.
//!
//! A rectangle of height h, of a material with Young's modulus E that yields at ±σ₀ and hardens with the tangent modulus Eₜ, kinematically. Its
//! surfaces yield at the curvature κ_e = 2 σ₀ / (E h). With t = Eₜ/E, bent for the first time:
//!
//! ```text
//! M(κ) = EI (t κ + (1 - t) g(κ)),    g(κ) = κ                           for |κ| <= κ_e,
//!                                    g(κ) = sgn κ (3 κ_e/2 - κ_e³/(2 κ²))  beyond.
//! ```
//!
//! Each fibre is elastic and perfectly plastic beside an elastic one, so that Masing's rule holds exactly: bent back from a turn at (κ₁, M₁) the moment is
//! M₁ + 2 M((κ - κ₁)/2), and where it comes by a turn before, it goes on from there as if the loop had not been. Three turns within one another are
//! remembered; a fourth is taken to be elastic. The axial force takes no part in yielding, nor does shear.
//! Sources: G. Masing, Proc. 2nd Int. Congr. Appl. Mech. (1926); K.-S. Kim, N. Aravas, Int. J. Solids Struct. 24 (1988), 417.

use std::ops::RangeInclusive;

/// How many turns of its curvature a section remembers.
pub(crate) const TURNS: usize = 3;
/// The turns of the curvature (1/nm) that count, from the largest curvature on; where there are fewer, the last one is repeated.
pub(crate) type Turns = [f64; TURNS];

/// The bending of a section that yields, over EI: curvatures in 1/nm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct BendingLaw {
    /// κ_e, 1/nm
    pub elastic: f64,
    /// t = Eₜ/E
    pub hardening: f64,
}

/// What a curvature makes of a section, over EI.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Bent {
    /// ∫ M dκ / EI from the last turn, 1/nm²: the energy of a step
    pub energy: f64,
    /// M/EI, 1/nm
    pub moment: f64,
    /// dM/dκ / EI
    pub stiffness: f64,
}

/// A section on its way between turns.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum On {
    /// Farther than ever before, to either side
    FirstBending,
    /// On the way back from turn number `0`, `1` or `2`
    BackFrom(usize),
}

impl BendingLaw {
    /// The first bending of a section.
    fn first(&self, curvature: f64) -> Bent {
        let (size, yields, t) = (curvature.abs(), self.elastic, self.hardening);
        if size <= yields {
            return Bent { energy: 0.5 * size * size, moment: curvature, stiffness: 1.0 };
        }
        let ratio = yields / size;
        let moment = yields * (1.5 - 0.5 * ratio * ratio);
        let energy = yields * (1.5 * (size - yields) + 0.5 * yields * ratio);
        Bent {
            energy: 0.5 * t * size * size + (1.0 - t) * energy,
            moment: (t * size + (1.0 - t) * moment).copysign(curvature),
            stiffness: t + (1.0 - t) * ratio * ratio * ratio,
        }
    }

    /// On the way back from a turn, with the energy from there.
    fn back(&self, turn: f64, moment: f64, curvature: f64) -> Bent {
        let way = curvature - turn;
        let half = self.first(0.5 * way);
        Bent { energy: moment * way + 4.0 * half.energy, moment: moment + 2.0 * half.moment, stiffness: half.stiffness }
    }

    /// M/EI at each turn.
    fn moments(&self, turns: Turns) -> Turns {
        let first = self.first(turns[0]).moment;
        let second = self.back(turns[0], first, turns[1]).moment;
        [first, second, self.back(turns[1], second, turns[2]).moment]
    }

    /// On which way a curvature lies.
    fn way(turns: Turns, curvature: f64) -> On {
        let [outer, back, inner] = turns;
        let side = 1f64.copysign(outer);
        if curvature.abs() >= outer.abs() {
            On::FirstBending
        } else if side * (curvature - back) <= 0.0 {
            On::BackFrom(0)
        } else if side * (curvature - inner) >= 0.0 {
            On::BackFrom(1)
        } else {
            On::BackFrom(2)
        }
    }

    /// A section that has been bent through these turns, at a curvature.
    pub(crate) fn at(&self, turns: Turns, curvature: f64) -> Bent {
        let turns = slackened(turns);
        let moments = self.moments(turns);
        let back = |turn: usize, curvature: f64| self.back(turns[turn], moments[turn], curvature);
        let [outer, second, inner] = turns;
        // energies count from the innermost turn, and do not jump from one way to the next
        let on = |bent: Bent, from: f64| Bent { energy: bent.energy + from, ..bent };
        let outward = |curvature: f64| on(back(1, curvature), -back(1, inner).energy);
        let inward = |curvature: f64| on(back(0, curvature), back(2, second).energy - back(0, second).energy);
        match Self::way(turns, curvature) {
            On::BackFrom(2) => back(2, curvature),
            On::BackFrom(1) => outward(curvature),
            On::BackFrom(_) => inward(curvature),
            On::FirstBending => {
                let bent = self.first(curvature);
                let same = curvature * outer >= 0.0;
                let joined = if same { outward(outer) } else { inward(-outer) };
                on(bent, joined.energy - self.first(outer).energy)
            }
        }
    }

    /// Takes a section on to a curvature at the end of a step, the step before being `step_before` times as long. Where the curvature turned at the end of
    /// that one, as far as steps tell, it turned where the parabola through the newest three does.
    pub(crate) fn advance(&self, known: &mut BendingMemory, curvature: f64, step_before: f64) {
        let inner = known.turns[TURNS - 1];
        if let Some(turn) = vertex([known.before, inner, curvature], step_before) {
            self.go(known, turn);
        }
        let before = known.turns;
        self.go(known, curvature);
        // where no turn has moved the innermost one is not the newest curvature, and none is looked for beside it
        known.before = if known.turns == before { before[TURNS - 1] } else { inner };
    }

    /// Takes a section on to a curvature, with the work that this leaves in it.
    fn go(&self, known: &mut BendingMemory, curvature: f64) {
        let turns = known.turns;
        let next = Self::turned(turns, curvature);
        if next != turns {
            let (from, to) = (self.at(turns, turns[TURNS - 1]), self.at(turns, curvature));
            let released = 0.5 * (to.moment + from.moment) * (to.moment - from.moment);
            known.lost += to.energy - from.energy - released;
            known.turns = next;
        }
    }

    /// The turns behind a way that ended at a curvature.
    fn turned(turns: Turns, curvature: f64) -> Turns {
        let [outer, back, inner] = turns;
        match Self::way(turns, curvature) {
            On::FirstBending => [curvature; TURNS],
            On::BackFrom(0) => [outer, curvature, curvature],
            On::BackFrom(1) => [outer, back, curvature],
            On::BackFrom(_) => [outer, back, inner],
        }
    }
}

/// Share of the largest curvature by which a section has to be bent back before it has turned. Next to a turn the moment of a section that has yielded
/// changes slope at once, by as much as E over Eₜ, and updates of Newton's method go to and fro.
const SLACK: f64 = 1e-4;

/// The turns by which a section goes.
fn slackened([outer, back, inner]: Turns) -> Turns {
    let (side, slack) = (1f64.copysign(outer), SLACK * outer.abs());
    let first = outer - side * slack;
    let second = side * (side * back + slack).min(side * first);
    let third = side * (side * inner).clamp(side * second, side * first);
    [first, second, third]
}

/// Steps of which one is this many times as long as the other may lie on one parabola.
const COMPARABLE: RangeInclusive<f64> = 0.2..=5.0;

/// The extremum of the parabola through three curvatures, the middle one beyond both others, the second step as long as the first over `before`.
fn vertex([first, middle, last]: [f64; 3], before: f64) -> Option<f64> {
    let turns = (middle - first) * (last - middle) < 0.0;
    if !turns || !COMPARABLE.contains(&before) {
        return None;
    }
    let bend = ((first - middle) + before * (last - middle)) / (before * before + before);
    let slope = (last - middle) - bend;
    Some(middle - 0.25 * slope * slope / bend)
}

/// How many numbers [`BendingMemory`] has.
pub(crate) const BENDING: usize = TURNS + 2;

/// What a section remembers of its bending from step to step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct BendingMemory {
    /// Turns of its curvature, 1/nm
    turns: Turns,
    /// The curvature a step earlier than the newest, 1/nm
    before: f64,
    /// The work that was not given back, over EI, 1/nm²
    lost: f64,
}

impl BendingMemory {
    /// Of its numbers.
    pub(crate) fn read(numbers: &[f64]) -> Self {
        Self { turns: [numbers[0], numbers[1], numbers[2]], before: numbers[TURNS], lost: numbers[TURNS + 1] }
    }

    /// As its numbers.
    pub(crate) fn write(&self, numbers: &mut [f64]) {
        numbers[..TURNS].copy_from_slice(&self.turns);
        (numbers[TURNS], numbers[TURNS + 1]) = (self.before, self.lost);
    }

    /// The work that was not given back, over EI, 1/nm².
    pub(crate) fn lost(&self) -> f64 {
        self.lost
    }

    /// The largest curvature so far, with its sign, 1/nm.
    pub(crate) fn largest(&self) -> f64 {
        self.turns[0]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const LAW: BendingLaw = BendingLaw { elastic: 0.01, hardening: 0.1 };
    /// Through five turns, in curvatures.
    const WAY: [f64; 7] = [0.0, 0.035, -0.02, 0.01, -0.005, 0.03, 0.05];

    /// The moment over EI of fibres over half of the height, each elastic and perfectly plastic beside an elastic one, whose slips are `slips`.
    fn fibres(slips: &mut [f64], curvature: f64) -> f64 {
        let count = slips.len() as f64;
        let one = |(k, slip): (usize, &mut f64)| {
            let height = (k as f64 + 0.5) / count;
            let strain = curvature * height;
            let over = (strain - *slip).abs() - LAW.elastic;
            if over > 0.0 {
                *slip += over.copysign(strain - *slip);
            }
            let stress = (1.0 - LAW.hardening) * (strain - *slip) + LAW.hardening * strain;
            3.0 * stress * height / count
        };
        slips.iter_mut().enumerate().map(one).sum()
    }

    /// By steps of a thousandth of each way the moments are those of 4000 fibres, and what is left in the section is the work of all steps less what a
    /// moment gives back; with the slack by which a section has to be bent back before it turns, a thousandth of the moment at which it yields.
    #[test]
    fn a_section_is_bent_as_its_fibres_are() {
        let (mut slips, mut known) = (vec![0.0; 4000], BendingMemory::read(&[0.0; BENDING]));
        let (mut work, mut before, mut at) = (0.0, 0.0, 0.0);
        for pair in WAY.windows(2) {
            for k in 1..=1000 {
                let curvature = pair[0] + f64::from(k) / 1000.0 * (pair[1] - pair[0]);
                let moment = LAW.at(known.turns, curvature).moment;
                assert!((moment - fibres(&mut slips, curvature)).abs() < 1e-3 * LAW.elastic, "at {curvature}");
                work += 0.5 * (before + moment) * (curvature - at);
                LAW.advance(&mut known, curvature, 1.0);
                (before, at) = (moment, curvature);
            }
        }
        let left = work - 0.5 * before * before;
        assert!((known.lost() / left - 1.0).abs() < 2e-3, "{} {left}", known.lost());
    }

    /// Moments are the slopes of energies, and stiffnesses those of moments, on every way; nothing jumps between two of them.
    #[test]
    fn derivatives_are_those_of_differences() {
        for turns in [[0.0; 3], [0.03; 3], [0.03, -0.02, -0.02], [-0.04, 0.03, -0.01]] {
            for k in -1000..1000 {
                let curvature = 5e-5 * (f64::from(k) + 0.37);
                let step = 1e-8;
                let [low, high] = [curvature - step, curvature + step].map(|at| LAW.at(turns, at));
                let bent = LAW.at(turns, curvature);
                assert!(
                    ((high.energy - low.energy) / (2.0 * step) - bent.moment).abs() < 1e-8,
                    "{turns:?} {curvature}"
                );
                assert!((high.moment - low.moment).abs() < 4.0 * step, "{turns:?} {curvature}");
                assert!(
                    ((high.moment - low.moment) / (2.0 * step) - bent.stiffness).abs() < 1e-4,
                    "{turns:?} {curvature}"
                );
            }
        }
    }

    /// A curvature that rose and falls turned between two steps.
    #[test]
    fn a_turn_between_steps_is_found() {
        let rising = |label: f64| 0.02 - 0.003 * (label - 0.3).powi(2);
        let found = vertex([-2.0, 0.0, 1.0].map(rising), 2.0).unwrap();
        assert!((found - 0.02).abs() < 1e-15);
        assert_eq!(vertex([0.0, 1.0, 2.0], 1.0), None);
    }
}
