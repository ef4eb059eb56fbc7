//! The force-displacement curve of something else than a peel, as it was computed: of the pull-off of a seta, with its events, or of a pull at a rate.

use crate::model::body::profile::monotone_slopes;
use crate::solve::path::hermite::Hermite;

/// A curve of a pull: branches between events, at which the force changes while the displacement stands still.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PulledCurve {
    branches: Vec<Branch>,
    /// Where nothing adhered any more, nm; none where something did to the end
    pub detached: Option<f64>,
    /// Why it was not computed to its end, if it was not
    pub short: Option<String>,
    /// Whether that is because the caller has said so
    pub interrupted: bool,
}

/// Points between two events, with the slopes of the monotone cubic through them.
#[derive(Clone, Debug, Default, PartialEq)]
struct Branch {
    displacements: Vec<f64>,
    forces: Vec<f64>,
    slopes: Vec<f64>,
}

/// The curve at a displacement.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::study::parameters::fit) struct PulledPoint {
    /// nN
    pub force: f64,
    /// dP/dU, nN/nm
    pub slope: f64,
    /// Which branch, from 0
    pub branch: usize,
}

impl PulledCurve {
    /// Of displacements (nm) and forces (nN) in the order in which they were computed, all of one step.
    pub fn of(points: impl IntoIterator<Item = (f64, f64)>) -> Self {
        let mut branches: Vec<Branch> = Vec::new();
        for (displacement, force) in points {
            let goes_on =
                |branch: &&mut Branch| branch.displacements.last().is_some_and(|&newest| displacement > newest);
            match branches.last_mut().filter(goes_on) {
                Some(branch) => {
                    branch.displacements.push(displacement);
                    branch.forces.push(force);
                }
                None => {
                    branches.push(Branch { displacements: vec![displacement], forces: vec![force], slopes: Vec::new() })
                }
            }
        }
        for branch in &mut branches {
            branch.slopes = match branch.forces.len() {
                1 => vec![0.0],
                _ => monotone_slopes(&branch.displacements, &branch.forces),
            };
        }
        Self { branches, ..Self::default() }
    }

    /// First and last displacement, nm; none without points.
    pub(in crate::study::parameters::fit) fn range(&self) -> Option<(f64, f64)> {
        let first = self.branches.first()?.displacements.first()?;
        Some((*first, *self.branches.last()?.displacements.last()?))
    }

    /// At a displacement between its ends; behind an event where one is there.
    pub(in crate::study::parameters::fit) fn at(&self, displacement: f64) -> PulledPoint {
        let begun = self.branches.partition_point(|branch| branch.displacements[0] <= displacement).max(1) - 1;
        let Some(Branch { displacements, forces, slopes }) = self.branches.get(begun) else {
            return PulledPoint { force: 0.0, slope: 0.0, branch: 0 };
        };
        let after = displacements.partition_point(|&place| place <= displacement);
        if after == 0 || after == displacements.len() {
            let end = after.saturating_sub(1);
            return PulledPoint { force: forces[end], slope: slopes[end], branch: begun };
        }
        let node = |k: usize| (displacements[k], forces[k], slopes[k]);
        let (force, slope, _) = Hermite::new(&[node(after - 1), node(after)]).at(displacement);
        PulledPoint { force, slope, branch: begun }
    }

    /// Displacement and force of every point, in their order.
    pub fn points(&self) -> Vec<(f64, f64)> {
        let of = |branch: &Branch| branch.displacements.iter().copied().zip(branch.forces.clone()).collect::<Vec<_>>();
        self.branches.iter().flat_map(of).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// P = U² up to U = 2, where it falls to 1 and rises again: the cubics are within 1 % of a parabola, and an event is where it is.
    #[test]
    fn a_curve_is_interpolated_between_its_events() {
        let before = (0..=20).map(|k| 0.1 * f64::from(k)).map(|u| (u, u * u));
        let behind = (0..=10).map(|k| 2.0 + 0.1 * f64::from(k)).map(|u| (u, u - 1.0));
        let points: Vec<(f64, f64)> = before.chain(behind).collect();
        let curve = PulledCurve::of(points.clone());
        assert_eq!((curve.range(), curve.points()), (Some((0.0, 3.0)), points));
        let at = curve.at(1.23);
        assert!((at.force / 1.5129 - 1.0).abs() < 1e-3 && (at.slope / 2.46 - 1.0).abs() < 2e-2, "{at:?}");
        assert_eq!((at.branch, curve.at(1.999).branch, curve.at(2.0).branch), (0, 0, 1));
        assert_eq!(curve.at(2.0).force, 1.0);
        assert!((curve.at(2.55).force - 1.55).abs() < 1e-12 && (curve.at(1.9999).force - 4.0).abs() < 1e-2);
        assert_eq!(PulledCurve::default().range(), None);
    }
}
