//! The motions of the root of a seta, one after the other: what each is called, and the force along it. In pictures the force of all of them is along
//! one direction, that of the pull.

use peelkit::model::Seta;
use peelkit::study::{SetaBranch, SetaPoint, SetaState};

/// A step of the loading, as far as it was taken.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SetaMotion {
    /// Number of the step
    pub step: usize,
    /// "press", "drag" or "pull"
    pub name: &'static str,
    /// The largest force along it by its amount, nN: positive where the root is pulled
    pub largest: f64,
    /// How far the root has moved in the step where the force along it is so large, nm
    pub displacement: f64,
}

/// A motion is along the ground where it rises or sinks by less than this share of its length.
const ALONG: f64 = 0.5;

impl SetaMotion {
    /// The motions that points belong to, in their order; one without a length is left out.
    pub fn of(points: &[SetaPoint]) -> Vec<Self> {
        points.chunk_by(|one, next| one.step == next.step).filter_map(Self::of_step).collect()
    }

    fn of_step(points: &[SetaPoint]) -> Option<Self> {
        let [first, .., last] = points else { return None };
        let way: [f64; 3] = std::array::from_fn(|axis| last.root[axis] - first.root[axis]);
        let rise = way[1] / way.iter().map(|part| part * part).sum::<f64>().sqrt();
        let name = match rise {
            rise if rise <= -ALONG => "press",
            rise if rise < ALONG => "drag",
            rise if rise.is_nan() => return None,
            _ => "pull",
        };
        let reached = points.iter().fold(first, |most, at| {
            let exceeds = at.force_along.abs() > most.force_along.abs();
            if exceeds { at } else { most }
        });
        Some(Self { step: first.step, name, largest: reached.force_along, displacement: reached.displacement })
    }
}

// -- The force along one direction --

/// The direction of the last motion, the pull, along which pictures show the force of all steps.
#[derive(Clone, Copy, Debug)]
pub struct PullDirection {
    last: usize,
    /// None where the last motion has no length
    along: Option<[f64; 3]>,
}

impl PullDirection {
    /// Of the points of a pull-off.
    pub fn of(points: &[SetaPoint]) -> Self {
        let steps = points.chunk_by(|one, next| one.step == next.step);
        let Some([first, .., last]) = steps.last() else {
            return Self { last: points.last().map_or(0, |point| point.step), along: None };
        };
        let way: [f64; 3] = std::array::from_fn(|axis| last.root[axis] - first.root[axis]);
        let length = way.iter().map(|part| part * part).sum::<f64>().sqrt();
        Self { last: last.step, along: (length > 0.0).then(|| way.map(|part| part / length)) }
    }

    /// Of the force on the root its part along the pull, nN.
    pub fn force(&self, point: &SetaPoint) -> f64 {
        match self.along {
            Some(along) if point.step != self.last => {
                point.force.iter().zip(along).map(|(part, along)| part * along).sum()
            }
            _ => point.force_along,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn point(step: usize, root: [f64; 3], force_along: f64) -> SetaPoint {
        SetaPoint { step, root, force_along, ..SetaPoint::default() }
    }

    #[test]
    fn motions_are_named_by_where_the_root_goes() {
        let points = [
            point(0, [0.0; 3], 0.0),
            point(0, [0.0, -2.0, 0.0], -5.0),
            point(1, [0.0, -2.0, 0.0], 1.0),
            point(1, [3.0, -2.1, 0.0], 7.0),
            point(2, [3.0, -2.1, 0.0], 0.0),
            point(2, [3.0, 9.0, 0.0], 4.0),
        ];
        let found = SetaMotion::of(&points);
        let named: Vec<_> = found.iter().map(|step| (step.step, step.name, step.largest)).collect();
        assert_eq!(named, [(0, "press", -5.0), (1, "drag", 7.0), (2, "pull", 4.0)]);
    }

    /// A press down, then a pull along (3, 4): a force (10, -5) has there 6 - 4. The force of the last step stays what it is.
    #[test]
    fn forces_of_all_steps_are_along_the_pull() {
        let at = |step, root, force| SetaPoint { step, root, force, force_along: 9.0, ..SetaPoint::default() };
        let before = [10.0, -5.0, 3.0];
        let points = [
            at(0, [0.0; 3], [0.0; 3]),
            at(0, [0.0, -2.0, 0.0], before),
            at(1, [0.0, -2.0, 0.0], before),
            at(1, [6.0, 6.0, 0.0], [1.0; 3]),
        ];
        let pull = PullDirection::of(&points);
        let forces: Vec<f64> = points.iter().map(|point| pull.force(point)).collect();
        assert_eq!(forces, [0.0, 2.0, 9.0, 9.0]);
        let alone = PullDirection::of(&points[..1]);
        assert_eq!(alone.force(&points[0]), 9.0);
    }
}

// -- A seta as it lies in one equilibrium: what pictures, the animation and the files for ParaView are made of --

/// A seta in one equilibrium of its pull-off.
#[derive(Clone, Debug, PartialEq)]
pub struct SetaPose {
    /// The numbers of the equilibrium
    pub point: SetaPoint,
    /// Force on each tip away from the ground, nN: positive where the ground pulls it down; none of one that is detached
    pub tip_loads: Vec<Option<f64>>,
    /// Branch b ends at joint b + 1
    pub branches: Vec<SetaBranch>,
}

impl SetaPose {
    /// Of a state of a seta.
    pub fn of(state: &SetaState, seta: &Seta) -> Self {
        let load = |tip: &peelkit::study::TipState| tip.on.adheres().then_some(-tip.load[1]);
        Self { point: state.point, tip_loads: state.tips.iter().map(load).collect(), branches: state.branches(seta) }
    }
}

// -- How far the root of a seta has come, over all steps of its loading --

/// How far the root has moved at each point since the beginning, nm: over all steps, each counted forwards.
pub fn travels(points: &[SetaPoint]) -> Vec<f64> {
    let (mut before, mut step, mut last) = (0.0, 0, 0.0);
    let travel = |point: &SetaPoint| {
        if point.step != step {
            (before, step) = (before + last, point.step);
        }
        last = point.displacement;
        before + last
    };
    points.iter().map(travel).collect()
}
