//! A tree of joints that is given whole: as it was reconstructed from micrographs, say.
//!
//! Joints are numbered from the root on, those nearer to it first; tips from one side of the tree to the other, so that the tips behind a joint
//! are one after the other.

use serde::{Deserialize, Serialize};
use std::ops::Range;

/// Most joints, and most tips.
const MOST_JOINTS: usize = 20_000;
pub(super) const MOST_TIPS: usize = 4096;

/// A joint, and the straight branch that ends there.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct SetaJoint {
    /// Place in the stress-free configuration, nm
    pub place: [f64; 3],
    /// Diameter of the branch that leads to it from the joint nearer to the root, nm; of the root it says nothing
    pub diameter: f64,
    /// The joint nearer to the root; none of the root
    pub parent: Option<usize>,
}

/// A tree of joints with the root at joint 0. The ground is at y = 0, the mean height of its tips.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SetaTree {
    joints: Vec<SetaJoint>,
    /// Forks between the root and the branch that ends at a joint
    generations: Vec<usize>,
    /// The tips behind a joint
    behind: Vec<Range<usize>>,
    /// The joint of each tip
    tips: Vec<usize>,
}

/// Why joints are no tree of a seta: with the number of the joint, from 0, in the order in which they were given.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[allow(missing_docs)] // the message of each names its numbers
pub enum SetaTreeError {
    #[error("no joint is a root: one has to have no parent")]
    NoRoot,
    #[error("it is a second root: one joint alone has no parent")]
    SecondRoot { joint: usize },
    #[error("its parent is no joint of the tree")]
    NoParent { joint: usize },
    #[error("no way leads from it to the root: its parents go round in a circle")]
    Circle { joint: usize },
    #[error("{branches} branches begin at the root, which carries one shaft")]
    Shafts { joint: usize, branches: usize },
    #[error("its place is {place:?} nm, which is not finite")]
    Place { joint: usize, place: [f64; 3] },
    #[error("it is where its parent is")]
    NoLength { joint: usize },
    #[error("the diameter of its branch is {diameter} nm, which is not positive")]
    Diameter { joint: usize, diameter: f64 },
    #[error("the tree has {joints} joints, of which {tips} are tips: it takes at most 20000, with at most 4096 tips")]
    Size { joints: usize, tips: usize },
}

impl SetaTreeError {
    /// The joint that is wrong, if it is one.
    pub fn joint(&self) -> Option<usize> {
        match *self {
            Self::NoRoot | Self::Size { .. } => None,
            Self::SecondRoot { joint }
            | Self::NoParent { joint }
            | Self::Circle { joint }
            | Self::Shafts { joint, .. }
            | Self::Place { joint, .. }
            | Self::NoLength { joint }
            | Self::Diameter { joint, .. } => Some(joint),
        }
    }
}

impl SetaTree {
    /// The tree of joints that name their parents by their numbers, in any order. It is shifted along y so that its tips have the mean height zero.
    ///
    /// # Errors
    /// What of them is no tree with one root and one shaft.
    pub fn new(given: &[SetaJoint]) -> Result<Self, SetaTreeError> {
        let mut children = vec![Vec::new(); given.len()];
        let mut root = None;
        for (joint, own) in given.iter().enumerate() {
            if !own.place.iter().all(|x| x.is_finite()) {
                return Err(SetaTreeError::Place { joint, place: own.place });
            }
            match (own.parent, root) {
                (Some(parent), _) if parent >= given.len() => return Err(SetaTreeError::NoParent { joint }),
                (Some(parent), _) if given[parent].place == own.place => return Err(SetaTreeError::NoLength { joint }),
                (Some(_), _) if !(own.diameter > 0.0 && own.diameter.is_finite()) => {
                    return Err(SetaTreeError::Diameter { joint, diameter: own.diameter });
                }
                (Some(parent), _) => children[parent].push(joint),
                (None, Some(_)) => return Err(SetaTreeError::SecondRoot { joint }),
                (None, None) => root = Some(joint),
            }
        }
        let root = root.ok_or(SetaTreeError::NoRoot)?;
        let tips = children.iter().filter(|own| own.is_empty()).count();
        if given.len() > MOST_JOINTS || tips > MOST_TIPS {
            return Err(SetaTreeError::Size { joints: given.len(), tips });
        }
        if children[root].len() != 1 {
            return Err(SetaTreeError::Shafts { joint: root, branches: children[root].len() });
        }
        Self::of(given, &children, root)
    }

    fn of(given: &[SetaJoint], children: &[Vec<usize>], root: usize) -> Result<Self, SetaTreeError> {
        let mut numbers = vec![None; given.len()];
        let (mut order, mut next) = (vec![root], 0);
        numbers[root] = Some(0);
        while let Some(&joint) = order.get(next) {
            next += 1;
            for &child in &children[joint] {
                numbers[child] = Some(order.len());
                order.push(child);
            }
        }
        if let Some(joint) = numbers.iter().position(Option::is_none) {
            return Err(SetaTreeError::Circle { joint });
        }
        let mut tree = Self {
            joints: order
                .iter()
                .map(|&joint| SetaJoint {
                    parent: given[joint].parent.and_then(|parent| numbers[parent]),
                    ..given[joint]
                })
                .collect(),
            generations: vec![0; order.len()],
            behind: vec![0..0; order.len()],
            tips: Vec::new(),
        };
        tree.number_tips(&order, children);
        for joint in 1..order.len() {
            let parent = tree.parent(joint);
            let forks = usize::from(parent > 0 && children[order[parent]].len() > 1);
            tree.generations[joint] = tree.generations[parent] + forks;
        }
        let mean = tree.tips.iter().map(|&tip| tree.joints[tip].place[1]).sum::<f64>() / tree.tips.len() as f64;
        tree.joints.iter_mut().for_each(|joint| joint.place[1] -= mean);
        Ok(tree)
    }

    /// Numbers the tips from one side to the other: each joint is entered before, and left behind, all that it carries.
    fn number_tips(&mut self, order: &[usize], children: &[Vec<usize>]) {
        let mut of_given = vec![0; order.len()];
        order.iter().enumerate().for_each(|(number, &joint)| of_given[joint] = number);
        let mut open = vec![(order[0], false)];
        while let Some((joint, is_left)) = open.pop() {
            let number = of_given[joint];
            if is_left {
                self.behind[number].end = self.tips.len();
                continue;
            }
            self.behind[number].start = self.tips.len();
            if children[joint].is_empty() {
                self.tips.push(number);
            }
            open.push((joint, true));
            open.extend(children[joint].iter().rev().map(|&child| (child, false)));
        }
    }

    /// Its joints, those nearer to the root first.
    pub fn joints(&self) -> &[SetaJoint] {
        &self.joints
    }

    /// The joint of each tip.
    pub fn tips(&self) -> &[usize] {
        &self.tips
    }

    /// Forks between the root and the branch that ends at a joint.
    pub(super) fn generation(&self, joint: usize) -> usize {
        self.generations[joint]
    }

    pub(super) fn most_forks(&self) -> usize {
        self.generations.iter().copied().max().unwrap_or(0)
    }

    pub(super) fn tips_behind(&self, joint: usize) -> Range<usize> {
        self.behind[joint].clone()
    }

    pub(super) fn parent(&self, joint: usize) -> usize {
        self.joints[joint].parent.unwrap_or(0)
    }

    /// The longest way from the root along the branches to a tip, nm.
    pub(super) fn reach(&self) -> f64 {
        let mut ways = vec![0.0f64; self.joints.len()];
        for joint in 1..ways.len() {
            let (from, to) = (self.joints[self.parent(joint)].place, self.joints[joint].place);
            let length = (0..3).map(|i| (to[i] - from[i]).powi(2)).sum::<f64>().sqrt();
            ways[joint] = ways[self.parent(joint)] + length;
        }
        ways.into_iter().fold(0.0, f64::max)
    }

    /// The least distance of two tips along x or z, whichever is larger, but no less than a quarter of what it were if all stood in rows, nm.
    pub(super) fn tip_distance(&self) -> f64 {
        let places: Vec<[f64; 2]> =
            self.tips.iter().map(|&tip| self.joints[tip].place).map(|[x, _, z]| [x, z]).collect();
        let distance = |a: [f64; 2], b: [f64; 2]| (a[0] - b[0]).abs().max((a[1] - b[1]).abs());
        let pairs = || places.iter().enumerate().flat_map(|(n, &a)| places[..n].iter().map(move |&b| distance(a, b)));
        let [least, largest] = [pairs().fold(f64::INFINITY, f64::min), pairs().fold(0.0, f64::max)];
        let in_rows = 0.25 * largest / (places.len() as f64).sqrt();
        // of a single tip no other one is near
        if places.len() == 1 { self.reach() } else { least.max(in_rows) }
    }

    /// By how much the highest tip is above the lowest one, nm.
    pub(super) fn spread(&self) -> f64 {
        let heights = || self.tips.iter().map(|&tip| self.joints[tip].place[1]);
        heights().fold(f64::NEG_INFINITY, f64::max) - heights().fold(f64::INFINITY, f64::min)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn joint(parent: Option<usize>, place: [f64; 3]) -> SetaJoint {
        SetaJoint { place, diameter: 10.0, parent }
    }

    /// A shaft in two pieces, which forks in three, the middle one in two; given from the tips on.
    fn given() -> Vec<SetaJoint> {
        vec![
            joint(Some(4), [-100.0, 10.0, 0.0]),
            joint(Some(3), [20.0, 0.0, 0.0]),
            joint(Some(3), [30.0, -10.0, 5.0]),
            joint(Some(4), [10.0, 50.0, 0.0]),
            joint(Some(6), [0.0, 100.0, 0.0]),
            joint(Some(4), [100.0, 20.0, 0.0]),
            joint(Some(7), [0.0, 200.0, 0.0]),
            joint(None, [0.0, 300.0, 0.0]),
        ]
    }

    #[test]
    fn joints_are_numbered_from_the_root_and_tips_from_side_to_side() {
        let tree = SetaTree::new(&given()).unwrap();
        let heights: Vec<f64> = tree.joints().iter().map(|joint| joint.place[1] + 5.0).collect();
        assert_eq!(heights, [300.0, 200.0, 100.0, 10.0, 50.0, 20.0, 0.0, -10.0]);
        assert_eq!(tree.tips(), [3, 6, 7, 5]);
        assert_eq!(
            (0..8).map(|j| tree.tips_behind(j)).collect::<Vec<_>>(),
            [0..4, 0..4, 0..4, 0..1, 1..3, 3..4, 1..2, 2..3]
        );
        assert_eq!((0..8).map(|j| tree.generation(j)).collect::<Vec<_>>(), [0, 0, 0, 1, 1, 1, 2, 2]);
        assert_eq!((1..8).map(|j| tree.parent(j)).collect::<Vec<_>>(), [0, 1, 2, 2, 2, 4, 4]);
        assert_eq!(tree.spread(), 30.0);
    }

    #[test]
    fn what_is_no_tree_of_a_seta_is_refused_by_its_joint() {
        let refused = |change: fn(&mut Vec<SetaJoint>)| {
            let mut joints = given();
            change(&mut joints);
            SetaTree::new(&joints).unwrap_err()
        };
        assert_eq!(refused(|joints| joints[7].parent = Some(0)), SetaTreeError::NoRoot);
        assert_eq!(refused(|joints| joints[2].parent = None), SetaTreeError::SecondRoot { joint: 7 });
        assert_eq!(refused(|joints| joints[2].parent = Some(8)), SetaTreeError::NoParent { joint: 2 });
        assert_eq!(refused(|joints| joints[3].parent = Some(1)), SetaTreeError::Circle { joint: 1 });
        assert_eq!(refused(|joints| joints[0].parent = Some(7)), SetaTreeError::Shafts { joint: 7, branches: 2 });
        assert_eq!(refused(|joints| joints[1].place = joints[3].place), SetaTreeError::NoLength { joint: 1 });
        assert_eq!(refused(|joints| joints[1].diameter = 0.0), SetaTreeError::Diameter { joint: 1, diameter: 0.0 });
        assert!(matches!(refused(|joints| joints[1].place[2] = f64::NAN), SetaTreeError::Place { joint: 1, .. }));
        let many =
            |joints: &mut Vec<SetaJoint>| (0..4096).for_each(|k| joints.push(joint(Some(4), [k as f64, 1.0, 1.0])));
        assert_eq!(refused(many), SetaTreeError::Size { joints: 4104, tips: 4100 });
    }
}
