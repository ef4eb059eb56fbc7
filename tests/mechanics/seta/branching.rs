//! Setae that do not double: branches by lists, and a tree that is given whole.
//!
//! ```text
//!            ● root, moved along the normal, never turned
//!           /    shaft, L = 70 µm, 30 degrees from the normal
//!          ●     fork, 20 nm above the tips
//!        / | \
//!       ●  ●  ●  tips on a grid as square as it can be, springs k along the normal; they slide
//!      =========
//! ```
//!
//! References: for n branches behind one fork the closed form of initial_stiffness.rs with n springs, C = along the normal that of the shaft + 1/(n k), to 1e-5, as
//! the brush is short; their number enters nowhere else. A seta that forks in two, by `forks`, by lists of the same numbers and as a tree of the same
//! joints: the same pull-off, bit for bit. Places of tips: by hand.

use super::setup::{along_normal, model, pulled, small};
use approx::assert_relative_eq;
use peelkit::model::{CurvePoint, NormalPull, PullCurve, Seta, SetaError, SetaJoint, SetaModel, SetaTree, Sideways};
use peelkit::study::{SetaLoading, SetaOptions, SetaPullOff, SetaStart, StepEnd, StopCriteria, pull_off};
use std::f64::consts::PI;
use std::sync::Arc;

const NORMAL: f64 = 0.1;

fn off(seta: Seta) -> SetaPullOff {
    pulled(&model(seta, Sideways::Free), SetaStart::Adhering, &[along_normal(1.0, StepEnd::Detached(5000.0))])
}

fn same(one: &SetaPullOff, other: &SetaPullOff) {
    assert!(one.points.len() > 20 && !one.events.is_empty(), "{} points", one.points.len());
    assert_eq!(one.points, other.points);
    assert_eq!(one.peak, other.peak);
    assert_eq!(one.events.len(), other.events.len());
}

/// The same tree, joint by joint.
fn whole(seta: &Seta) -> SetaTree {
    let joint = |joint: usize| SetaJoint {
        place: seta.joint_place(joint),
        diameter: seta.branch_diameter(joint),
        parent: (joint > 0).then(|| seta.parent(joint)),
    };
    SetaTree::new(&(0..seta.joints()).map(joint).collect::<Vec<_>>()).unwrap()
}

#[test]
fn lists_and_a_tree_give_what_doubling_gives() {
    // the mean height of the tips of a tree is zero
    let doubling = Seta { height_scatter: 0.0, ..small() };
    let (heights, diameters): (Vec<f64>, Vec<f64>) =
        [0, 1, 3].map(|end| (doubling.joint_place(end + 1)[1], doubling.branch_diameter(end + 1))).into_iter().unzip();
    let listed = Seta {
        forks: 7,
        branches: vec![2, 2],
        fork_heights: heights[..2].to_vec(),
        diameters,
        shaft_diameter: 1.0,
        brush_height: 1.0,
        ..doubling.clone()
    };
    let drawn = Seta { tree: Some(Arc::new(whole(&doubling))), tip_pitch: 1.0, ..doubling.clone() };
    let found = off(doubling);
    same(&found, &off(listed));
    same(&found, &off(drawn));
}

#[test]
fn any_number_of_branches_stands_in_rows_about_the_axis() {
    let tips = |branches: &[usize]| {
        let seta = Seta { branches: branches.to_vec(), tip_pitch: 2.0, ..small() };
        (0..seta.tips()).map(|tip| seta.joint_place(seta.tip_joint(tip))).map(|[x, _, z]| [x, z]).collect::<Vec<_>>()
    };
    assert_eq!(tips(&[3]), [[-2.0, 0.0], [0.0, 0.0], [2.0, 0.0]]);
    assert_eq!(tips(&[2, 3]), [[-1.0, -2.0], [-1.0, 0.0], [-1.0, 2.0], [1.0, -2.0], [1.0, 0.0], [1.0, 2.0]]);
    assert_eq!(tips(&[4]), [[-1.0, -1.0], [1.0, -1.0], [-1.0, 1.0], [1.0, 1.0]]);
    // one of two rows of three, then two beside one another across
    let twelve = tips(&[6, 2]);
    assert_eq!(twelve[..4], [[-2.0, -3.0], [-2.0, -1.0], [0.0, -3.0], [0.0, -1.0]]);
    assert_eq!(twelve.iter().fold([0.0; 2], |sum, at| [sum[0] + at[0], sum[1] + at[1]]), [0.0; 2]);
}

/// Pulled along the normal with free tips: 1/C_yy.
#[test]
fn the_stiffness_is_that_of_a_cantilever_on_as_many_springs() {
    let known = [(-50.0, -5.0, NORMAL), (0.0, 0.0, NORMAL), (50.0, 5.0, NORMAL), (60.0, 5.5, 0.0), (64.0, 5.3, -0.2)];
    let point = |(displacement, force, slope): (f64, f64, f64)| CurvePoint { displacement, force, slope };
    let curve = PullCurve::new(known.map(point).to_vec(), -900.0).unwrap();
    for branches in [1, 3, 5, 6] {
        let seta = Seta {
            branches: vec![branches],
            tip_pitch: 20.0,
            fork_heights: vec![20.0],
            brush_angle: 0.0,
            shaft_angle: 30f64.to_radians(),
            diameters: vec![4000.0, 3600.0],
            height_scatter: 0.0,
            ..Seta::default()
        };
        let (l, d, material) = (seta.shaft_length, 4000.0f64, seta.material);
        let law = NormalPull { curve: curve.clone(), sideways: Sideways::Free, contact_height: 0.0 };
        let on = SetaModel { law: Arc::new(law), ..model(seta, Sideways::Free) };
        let loading = SetaLoading::pull([0.0, 1.0, 0.0], 20_000.0);
        let stop = StopCriteria::after_points(2);
        let found = pull_off(&on, &loading, &SetaOptions::default(), &stop).unwrap().initial_stiffness.unwrap();
        let (e, area, inertia) = (material.youngs_modulus, PI * d * d / 4.0, PI * d.powi(4) / 64.0);
        let shear = material.shear_correction * e / (2.0 * (1.0 + material.poissons_ratio)) * area;
        let (sin, cos) = 30f64.to_radians().sin_cos();
        let shaft = cos * cos * l / (e * area) + sin * sin * (l.powi(3) / (3.0 * e * inertia) + l / shear);
        assert_relative_eq!(found, 1.0 / (shaft + 1.0 / (branches as f64 * NORMAL)), max_relative = 1e-5);
    }
}

#[test]
fn lists_that_do_not_fit_are_refused_by_their_key() {
    let refused = |seta: Seta| match seta.check().unwrap_err() {
        SetaError::OutOfRange { key, .. } | SetaError::Levels { key, .. } => key,
        SetaError::Tips { .. } => "tips",
        other => panic!("{other}"),
    };
    let branches = |branches: &[usize]| Seta { branches: branches.to_vec(), ..small() };
    assert_eq!(refused(branches(&[2, 0])), "branches");
    assert_eq!(refused(branches(&[65])), "branches");
    assert_eq!(refused(branches(&[1; 13])), "branches");
    assert_eq!(refused(branches(&[64, 64, 2])), "tips");
    assert_eq!(refused(Seta { fork_heights: vec![1500.0], ..small() }), "fork_heights");
    assert_eq!(refused(Seta { fork_heights: vec![1500.0, 1500.0], ..small() }), "fork_heights");
    assert_eq!(refused(Seta { fork_heights: vec![1500.0, 0.0], ..small() }), "fork_heights");
    assert_eq!(refused(Seta { diameters: vec![200.0, 100.0], ..small() }), "diameters");
    assert_eq!(refused(Seta { diameters: vec![200.0, 100.0, -1.0], ..small() }), "diameters");
    assert!(branches(&[4, 1, 16]).check().is_ok());
}
