//! What is no tree is refused, with the names of what is wrong.
//!
//! ```text
//!   1 o---o 2        a triangle is a loop: two ways lead from every joint to the root
//!      \ /
//!       o 0
//! ```

use super::setup::{four_tips, stiffness};
use peelkit::beam::{
    Branch, BranchMesh, BranchSections, BranchingBeam, JointCondition, JointUnknown, MeshIntervals, MeshKind,
    MeshPolicy, SpatialStiffness, TreeError, TreeMonitor,
};
use std::sync::Arc;

const PLACES: [[f64; 3]; 5] = [[0.0; 3], [-1.0, 0.0, 2.0], [1.0, 0.0, 2.0], [5.0, 0.0, 0.0], [6.0, 0.0, 0.0]];

fn straight(joints: [usize; 2]) -> Branch {
    Branch::straight(joints, joints.map(|joint| PLACES[joint]), [0.0, 1.0, 0.0], stiffness(1), 2)
}

fn refused(branches: Vec<Branch>, root: usize) -> TreeError {
    BranchingBeam::new(branches, root).build().unwrap_err()
}

#[test]
fn loops_are_refused_with_the_two_branches_that_close_them() {
    let error = refused(vec![straight([0, 1]), straight([0, 2]), straight([2, 1])], 0);
    assert_eq!(error, TreeError::Loop { first: 1, second: 2, joint: 2 });
    assert!(error.to_string().starts_with("branches 1 and 2 close a loop at joint 2"), "{error}");
    let twice = refused(vec![straight([0, 1]), straight([1, 0])], 0);
    assert_eq!(twice, TreeError::Loop { first: 0, second: 1, joint: 1 });
    // a tip that is held to another one
    let mut tips = four_tips(3, 2);
    let ends = [tips.branches[3].end().0, tips.branches[5].end().0];
    tips.branches.push(Branch::straight([3, 5], ends, [0.0, 1.0, 0.0], stiffness(2), 2));
    assert!(matches!(tips.build().unwrap_err(), TreeError::Loop { .. }));
}

#[test]
fn rings_parts_and_numbers_that_no_tree_has_are_refused() {
    let ring = Branch { joints: [1, 1], ..straight([0, 1]) };
    assert_eq!(refused(vec![straight([0, 1]), ring], 0), TreeError::Ring { branch: 1, joint: 1 });
    let apart = refused(vec![straight([0, 1]), straight([2, 3])], 0);
    assert_eq!(apart, TreeError::Number { branch: 1, joint: 3, branches: 2 });
    let apart = refused(vec![straight([0, 1]), straight([0, 2]), straight([3, 4]), straight([3, 4])], 0);
    assert_eq!(apart, TreeError::Apart { branch: 2, first: 3, last: 4, root: 0 });
    assert_eq!(refused(vec![straight([0, 1])], 7), TreeError::Root { root: 7 });
    assert_eq!(refused(Vec::new(), 0), TreeError::Empty);
}

#[test]
fn lengths_stiffnesses_and_gaps_are_checked() {
    let short = Branch { length: 0.0, ..straight([0, 1]) };
    assert_eq!(refused(vec![short], 0), TreeError::Length { branch: 0, length: 0.0, elements: 2 });
    let empty = Branch { mesh: BranchMesh::Fixed(vec![0.0]), ..straight([0, 1]) };
    assert!(matches!(refused(vec![empty], 0), TreeError::Length { elements: 0, .. }));
    let soft = BranchSections::Uniform(Box::new(SpatialStiffness::diagonal(1.0, [1.0; 2], 0.0, [1.0; 2])));
    let soft = Branch { sections: soft, ..straight([0, 1]) };
    assert_eq!(refused(vec![soft], 0), TreeError::Stiffness { branch: 0 });
    let ends = vec![0.0, 1.5, 1.0, straight([0, 1]).length];
    let back = Branch { mesh: BranchMesh::Fixed(ends.clone()), ..straight([0, 1]) };
    let length = back.length;
    assert_eq!(refused(vec![back], 0), TreeError::Ends { branch: 0, length, ends });
    let policy = Arc::new(MeshPolicy {
        kind: MeshKind::Moving,
        front_foci: Vec::new(),
        edge_foci: Vec::new(),
        fixed_foci: Vec::new(),
        pieces: MeshIntervals::whole(length),
    });
    let loose = Branch { mesh: BranchMesh::Following { policy, elements: 4 }, ..straight([0, 1]) };
    assert_eq!(refused(vec![loose], 0), TreeError::NoFront { branch: 0 });
    let long = Branch { length: 2.5, mesh: BranchMesh::even(2.5, 2), ..straight([0, 1]) };
    let gap = refused(vec![long, straight([1, 2])], 0);
    assert!(matches!(gap, TreeError::Gap { first: 0, second: 1, joint: 1, .. }), "{gap}");
}

#[test]
fn conditions_of_what_is_not_there_are_refused() {
    let with = |conditions| BranchingBeam { conditions, ..four_tips(3, 2) }.build().unwrap_err();
    assert_eq!(with(vec![JointCondition::free(8)]), TreeError::Condition { joint: 8, count: 1, last: 7 });
    let twice = with(vec![JointCondition::free(3), JointCondition::free(3)]);
    assert_eq!(twice, TreeError::Condition { joint: 3, count: 2, last: 7 });
    assert_eq!(with(vec![JointCondition::pinned(7, [0.0; 3])]), TreeError::Held { joint: 7, branches: 3 });
    assert_eq!(with(vec![JointCondition::pinned(0, [0.0; 3])]), TreeError::Held { joint: 0, branches: 1 });
    let mut turned = JointCondition::loaded(3, [0.0; 3], [0.0; 3]);
    turned.held[4] = Some(0.0);
    assert!(matches!(with(vec![turned]), TreeError::Axes { joint: 3, .. }));
    let monitors = [Some(TreeMonitor::Joint(JointUnknown { joint: 3, slot: 4 })), None];
    let error = BranchingBeam { monitors, ..four_tips(3, 2) }.build().unwrap_err();
    assert_eq!(error, TreeError::Monitor { joint: 3, slot: 4 });
    assert_eq!(four_tips(9, 2).build().unwrap_err(), TreeError::Order { order: 9 });
    let scale = BranchingBeam { scale: [0.0, 1.0], ..four_tips(3, 2) };
    assert_eq!(scale.build().unwrap_err(), TreeError::Scale { place: 0.0, turn: 1.0 });
}
