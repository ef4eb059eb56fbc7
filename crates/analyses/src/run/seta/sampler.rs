//! States of a pull-off, evenly chosen while it is computed: how many there will be is not known before.

use peelkit::study::SetaState;
use serde::{Deserialize, Serialize};

/// Keeps up to twice `most` states: every one at first, and every second one of these whenever there are too many.
#[derive(Clone, Debug, Serialize, Deserialize)]
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

    /// Whether it keeps any.
    pub fn sees(&self) -> bool {
        self.most > 0
    }

    /// Whether another one keeps the same states.
    pub fn is_like(&self, other: &Self) -> bool {
        self.most == other.most
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

    /// So many of what was kept, evenly, with these among it, in the order of the pull-off.
    pub fn evenly(&self, count: usize, others: impl IntoIterator<Item = SetaState>) -> Vec<SetaState> {
        let last = self.states.len().saturating_sub(1);
        let count = count.min(self.states.len());
        let number = |k: usize| if count > 1 { k * last / (count - 1) } else { last };
        let mut states: Vec<SetaState> = (0..count).map(|k| self.states[number(k)].clone()).collect();
        states.extend(others);
        // released energy never falls: an equilibrium before an event comes before the one behind it
        states.sort_by(|a, b| {
            let (a, b) = (&a.point, &b.point);
            let way = a.displacement.total_cmp(&b.displacement);
            a.step.cmp(&b.step).then(way).then(a.released.total_cmp(&b.released))
        });
        states.dedup_by(|a, b| a.point == b.point);
        states
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use peelkit::study::SetaPoint;

    fn state(displacement: f64) -> SetaState {
        let point = SetaPoint { displacement, ..SetaPoint::default() };
        SetaState {
            point,
            location: None,
            joints: Vec::new(),
            between: Vec::new(),
            tips: Vec::new(),
            spatulae: Vec::new(),
            raised: 0.0,
        }
    }

    #[test]
    fn few_are_kept_evenly_and_those_that_matter_among_them() {
        let mut sampler = Sampler::new(10);
        (0..1000).for_each(|k| sampler.see(&state(f64::from(k))));
        let of = |count: usize| -> Vec<f64> {
            let states = sampler.evenly(count, [state(3.5), state(0.0)]);
            states.iter().map(|state| state.point.displacement).collect()
        };
        assert_eq!(of(3), [0.0, 3.5, 448.0, 960.0]);
        let all = of(100);
        assert!((11..=22).contains(&all.len()), "{all:?}");
        assert_eq!(all[..3], [0.0, 3.5, 64.0]);
        assert!(Sampler::new(0).evenly(10, []).is_empty());
    }
}
