//! What the files say of a strip in space.
//!
//! Expected: the columns of the grip behind those of the plane, angles in degrees, at full precision; none of them in
//! the plane. Why: a table that is read by column names has the same columns in the plane as before.
//!
//! Of the shapes: a panel for each numbered point of the curve, with the place, the force and the number of that; nothing reaches out of its
//! panel, the same in every run.

use crate::shared_pictures::check_pictures;
use crate::strip::STRIP_SCENE;
use peelkit::model::SpatialGrip;
use peelkit::study::{PathPoint, Peel, peel};
use peelkit_report::pictures::peel::numbered_points;
use peelkit_report::{PeelSummary, draw_peel, write_curve};
use peelkit_scene::{BoundsTable, Scene};
use serde_json::Value;
use std::fs;

fn parsed(text: &str) -> (Scene, Peel) {
    let scene = Scene::parse("a.toml", text, &[]).unwrap();
    let bounds = BoundsTable { points: 1, ..scene.bounds };
    let peel = peel(&scene.model, &scene.accuracy, &bounds.from_now());
    (scene, peel)
}

fn point(in_space: Option<SpatialGrip>) -> PathPoint {
    PathPoint {
        displacement: 40.0,
        force: 1.0 / 3.0,
        end_rotation: 0.25,
        work: 2.5,
        negative_eigenvalues: 1,
        negative_eigenvalues_load: 2,
        front: 77.5,
        iterations: 3,
        in_space,
    }
}

#[test]
fn the_curve_in_space_has_the_columns_of_the_grip() {
    let (_, mut peel) = parsed(STRIP_SCENE);
    let dir = tempfile::tempdir().unwrap();
    let mut written = |grip| {
        peel.points = vec![point(grip)];
        fs::read_to_string(write_curve(dir.path(), &peel, None).unwrap()).unwrap()
    };
    let header = "displacement_nm,force_nN,end_rotation_rad,work_aJ,negative_eigenvalues,\
                  negative_eigenvalues_load,front_nm,newton_iterations,negative_eigenvalues_out_of_plane";
    let row = "40.0,0.3333333333333333,0.25,2.5,1,2,77.5,3,";
    assert_eq!(written(None), format!("{header}\n{row}\n"));
    let grip = SpatialGrip { roll: 1f64.to_radians(), yaw: -0.5, torque: 1.5, across: 0.125, lateral: -2.0 };
    let yaw = (-0.5f64).to_degrees();
    let roll = 1f64.to_radians().to_degrees();
    let grip_columns = "torque_nN_nm,roll_deg,yaw_deg,reaction_across_nN,reaction_lateral_nN";
    assert_eq!(written(Some(grip)), format!("{header},{grip_columns}\n{row},1.5,{roll:?},{yaw:?},0.125,-2.0\n"));
}

#[test]
fn the_summary_says_where_the_scene_was_solved() {
    let solved = |text: &str| {
        let (scene, peel) = parsed(text);
        let summary: Value = serde_json::from_str(&PeelSummary::new(&scene, &peel, 0.1).to_json().unwrap()).unwrap();
        (summary["solved_in_plane"].clone(), summary["derived"].clone())
    };
    assert_eq!(solved(STRIP_SCENE).0, Value::Null);
    let drive = |azimuth: &str| format!("{STRIP_SCENE}[drive]\nangle = \"60 deg\"\nazimuth = \"{azimuth}\"\n");
    assert_eq!(solved(&drive("180 deg")).0, true);
    let (solved_in_plane, sideways) = solved(&drive("90 deg"));
    assert_eq!(solved_in_plane, false);
    // Kendall's force is that at a right angle to the strip: P + P²/(2 E h b) = w b
    let [force, work] =
        ["kendall_force_nN", "work_of_adhesion_of_section_J_per_m2"].map(|key| sideways[key].as_f64().unwrap());
    assert!((force + force * force / 40.0 - work).abs() < 1e-13, "{force} {work}");
}

/// The strip pulled sideways, up to the first fold.
fn pulled() -> Peel {
    let text = include_str!("../../scenes/strip-sideways.toml");
    let over = [("accuracy.relative", "1e-4"), ("bounds.displacement", "12.775 nm")];
    let over = over.map(|(key, value)| (key.to_owned(), value.to_owned()));
    let scene = Scene::parse("strip-sideways.toml", text, &over).unwrap();
    peel(&scene.model, &scene.accuracy, &scene.bounds.from_now())
}

#[test]
fn the_shapes_in_space_have_a_panel_for_each_numbered_point() {
    let (dir, peel) = (tempfile::tempdir().unwrap(), pulled());
    let files = draw_peel(&peel, None, "sideways", dir.path()).unwrap();
    check_pictures(&files);
    let text = fs::read_to_string(dir.path().join("shapes.svg")).unwrap();
    let picture = roxmltree::Document::parse(&text).unwrap();
    let texts: Vec<&str> =
        picture.descendants().filter(|n| n.has_tag_name("text")).filter_map(|n| n.text()).map(str::trim).collect();
    let count = |wanted: &str| texts.iter().filter(|text| **text == wanted).count();
    let numbered = numbered_points(&peel);
    assert!(numbered.len() > 3);
    for number in 1..=numbered.len() {
        assert_eq!(count(&number.to_string()), 1, "{texts:?}");
    }
    for axis in ["x", "y", "z"] {
        assert_eq!(count(axis), numbered.len(), "{texts:?}");
    }
    assert_eq!(count("u = 12.77 nm, P = 15.28 nN"), 1, "{texts:?}");
    assert!(texts.iter().any(|text| text.contains("the axes x, y and z are 20 nm long")));
    // frames are the lines of five points, in tenths of a pixel; faces lie in one of them
    let corners = |node: roxmltree::Node| -> Vec<[f64; 2]> {
        let points = node.attribute("points").unwrap_or("").split_whitespace();
        let point = |text: &str| text.split_once(',').map(|(x, y)| [x.parse().unwrap(), y.parse().unwrap()]);
        points.filter_map(point).collect()
    };
    let of = |tag: &str| -> Vec<Vec<[f64; 2]>> {
        picture.descendants().filter(|node| node.has_tag_name(tag)).map(corners).collect()
    };
    let frames: Vec<_> = of("polyline").into_iter().filter(|line| line.len() == 5 && line[0] == line[4]).collect();
    let (shapes, mut inside) = (of("polygon"), 0);
    assert_eq!(frames.len(), numbered.len());
    for shape in &shapes {
        let holds = |frame: &&Vec<[f64; 2]>| {
            let within = |at: &[f64; 2]| (0..2).all(|i| at[i] >= frame[0][i] && at[i] <= frame[2][i]);
            shape.iter().all(within)
        };
        inside += frames.iter().filter(holds).count();
    }
    assert_eq!(inside, shapes.len());
    assert!(shapes.len() > 80 * numbered.len(), "{}", shapes.len());
}

#[test]
fn a_peel_in_space_without_solutions_has_no_shapes() {
    let dir = tempfile::tempdir().unwrap();
    let error = draw_peel(&pulled().without_solutions(), None, "", dir.path()).unwrap_err().to_string();
    assert!(error.contains("shapes.svg"), "{error}");
}
