//! Two peels of one model, each with its bounds: what both report, and whether they agree.

use peelkit::study::{Jump, LimitPoint, Observed, Peel};

/// A number and the bound on its error.
pub(crate) type Bounded = (f64, f64);

/// What is compared of two peels.
const QUANTITIES: [&str; 4] =
    ["displacement of the initiation peak", "initiation peak", "displacement of the snap-off", "force of the snap-off"];

/// What is compared of two displacement-controlled tests.
const OF_TESTS: [&str; 4] =
    ["displacement of the first jump", "force before the first jump", "force behind the first jump", "pull-off force"];

/// What a peel or a test reports of these, and how many maxima it has left out as ripple.
#[derive(Clone, Debug)]
pub(crate) struct Reported {
    quantities: [&'static str; 4],
    numbers: [Option<Bounded>; QUANTITIES.len()],
    ripple: usize,
}

impl Reported {
    /// By this peel.
    pub(crate) fn by(peel: &Peel) -> Self {
        let displacement = |p: &LimitPoint| (p.displacement, p.displacement_error);
        let force = |p: &LimitPoint| (p.force, p.force_error);
        let (peak, snap_off) = (peel.initiation_peak.as_ref(), peel.snap_off.as_ref());
        let numbers = [
            peak.map(|p| (p.displacement, p.displacement_error)),
            peak.map(|p| (p.force, p.force_error)),
            snap_off.map(displacement),
            snap_off.map(force),
        ];
        Self { quantities: QUANTITIES, numbers, ripple: peel.ripple }
    }

    /// By this test; of one that was not followed until the beam is off the largest force may lie ahead.
    pub(crate) fn by_test(test: &Observed) -> Self {
        let first = test.jumps.first();
        let of = |number: fn(&Jump) -> Bounded| first.map(number);
        let numbers = [
            of(|jump| (jump.machine, jump.machine_error)),
            of(|jump| (jump.before.force, jump.before.force_error)),
            of(|jump| (jump.after.force, jump.after.force_error)),
            test.pull_off.filter(|_| test.retreat.is_some()).map(|peak| (peak.force, peak.force_error)),
        ];
        Self { quantities: OF_TESTS, numbers, ripple: 0 }
    }

    /// By what reports none of these.
    pub(crate) fn nothing() -> Self {
        Self { quantities: QUANTITIES, numbers: [None; QUANTITIES.len()], ripple: 0 }
    }

    /// Every quantity with what the two report of it; nothing where ripple is left out by one alone, whose first maximum is
    /// another.
    pub(crate) fn beside(&self, other: &Self) -> impl Iterator<Item = (&'static str, [Option<Bounded>; 2])> {
        let comparable = self.ripple == other.ripple;
        let pairs = self.numbers.into_iter().zip(other.numbers).map(|(one, two)| [one, two]);
        self.quantities.into_iter().zip(pairs).filter(move |_| comparable)
    }

    #[cfg(test)]
    pub(crate) fn made(numbers: [Option<Bounded>; QUANTITIES.len()]) -> Self {
        Self { quantities: QUANTITIES, numbers, ripple: 0 }
    }
}

/// Whether two numbers lie further apart than both bounds together.
pub(crate) fn disagree([one, two]: [Bounded; 2]) -> bool {
    let apart = (one.0 - two.0).abs();
    apart.is_nan() || apart > one.1 + two.1
}
