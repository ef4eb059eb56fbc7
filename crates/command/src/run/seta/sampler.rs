//! States of a pull-off, evenly chosen while it is computed: how many there will be is not known before.

use peelkit::study::SetaState;

/// Keeps up to twice `most` states: every one at first, and every second one of these whenever there are too many.
pub struct Sampler {
    most: usize,
    every: usize,
    seen: usize,
    states: Vec<SetaState>,
}

impl Sampler {
    pub fn new(most: usize) -> Self {
        Self { most, every: 1, seen: 0, states: Vec::new() }
    }

    /// Looks at the next state.
    pub fn see(&mut self, state: &SetaState) {
        if self.most > 0 && self.seen.is_multiple_of(self.every) {
            self.states.push(state.clone());
        }
        self.seen += 1;
        if self.states.len() > 2 * self.most {
            let mut number = 0;
            self.states.retain(|_| {
                number += 1;
                number % 2 == 1
            });
            self.every *= 2;
        }
    }

    /// What was kept, with these among it, in the order of the pull-off.
    pub fn with(mut self, others: impl IntoIterator<Item = SetaState>) -> Vec<SetaState> {
        self.states.extend(others);
        // work and released energy never fall together: an equilibrium before an event comes before the one behind it
        let place = |state: &SetaState| (state.point.step, state.point.displacement, state.point.released);
        self.states.sort_by(|a, b| {
            let ((a, b), (u, v), (r, s)) = {
                let (p, q) = (place(a), place(b));
                ((p.0, q.0), (p.1, q.1), (p.2, q.2))
            };
            a.cmp(&b).then(u.total_cmp(&v)).then(r.total_cmp(&s))
        });
        self.states.dedup();
        self.states
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use peelkit::study::SetaPoint;

    fn state(displacement: f64) -> SetaState {
        let point = SetaPoint { displacement, ..SetaPoint::default() };
        SetaState { point, joints: Vec::new(), tips: Vec::new() }
    }

    #[test]
    fn few_are_kept_evenly_and_those_that_matter_among_them() {
        let mut sampler = Sampler::new(10);
        (0..1000).for_each(|k| sampler.see(&state(f64::from(k))));
        let found: Vec<f64> =
            sampler.with([state(3.5), state(0.0)]).iter().map(|state| state.point.displacement).collect();
        assert!((11..=22).contains(&found.len()), "{found:?}");
        assert_eq!(found[..3], [0.0, 3.5, 64.0]);
        assert!(Sampler::new(0).with([]).is_empty());
    }
}
