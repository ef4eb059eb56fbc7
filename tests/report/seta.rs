//! A seta in the files for ParaView, in its tables, its pictures and its animation, read back by readers of their own.
//!
//! Reference: statics. The forces on the tips are all that loads the tree, so that at the root their sum and their moments have to be what the
//! solver's nodal forces say; each section's force is the sum of those of the tips behind it.
//!
//! ```text
//!     root ●        4 tips of the usual spatula on branches of 0.09 µm diameter, pulled along the normal by a few
//!           \       hundred nm, all tips attached; and the stress-free seta of 256 tips
//!            ●
//!           / \
//!          ●   ●    d = 240, 150, 94 nm
//!         /|   |\
//! ```
//!
//! Expected: force and moment of the root to 1e-6 of the solver's; 1 700 lines of two nodes for 256 tips, the number of the paper; pictures and
//! page that an XML reader reads. Why: sections come from statics and not from the solver, with signs of their own.

use peelkit::model::{NormalPull, Seta, SetaModel, Sideways, Spatula, TipBranch};
use peelkit::study::{
    Accuracy, EventCause, SetaEvent, SetaLoading, SetaOptions, SetaPullOff, SetaState, StopCriteria, TipChange,
    TipState, pull_off, tip_curve,
};
use peelkit_report::{
    SETA_STATE_FIELDS, SetaPose, draw_pull_off, write_seta_animation, write_seta_curve, write_seta_events,
    write_seta_states, write_tips,
};
use std::fs;
use std::path::Path;
use std::sync::Arc;

fn small() -> Seta {
    Seta {
        forks: 2,
        shaft_length: 7000.0,
        brush_height: 3000.0,
        shaft_diameter: 240.0,
        height_scatter: 20.0,
        ..Seta::default()
    }
}

/// The first points of the pull-off of the small seta.
fn pulled() -> SetaPullOff {
    let curve = tip_curve(&Spatula::default().model(), &Accuracy::to(1e-4), 50.0).unwrap();
    let law = Arc::new(NormalPull { curve, sideways: Sideways::Free, contact_height: 0.0 });
    let model = SetaModel::new(small(), law);
    let loading = SetaLoading::pull([0.0, 1.0, 0.0], 20_000.0);
    pull_off(&model, &loading, &SetaOptions::default(), &StopCriteria::after_points(40)).unwrap()
}

/// Three numbers at each point, or one.
fn array(grid: &roxmltree::Document, name: &str) -> Vec<f64> {
    let mut arrays = grid.descendants().filter(|node| node.has_tag_name("DataArray"));
    let found = arrays.rfind(|node| node.attribute("Name") == Some(name)).unwrap();
    found.text().unwrap_or_default().split_whitespace().map(|word| word.parse().unwrap()).collect()
}

fn read(path: &Path) -> String {
    fs::read_to_string(path).unwrap()
}

#[track_caller]
fn close(found: &[f64], expected: [f64; 3], scale: f64) {
    for (found, expected) in found.iter().zip(expected) {
        assert!((found - expected).abs() <= 1e-6 * scale, "{found} and {expected} by {scale}");
    }
}

#[test]
fn sections_balance_what_holds_the_root() {
    let (dir, pull_off) = (tempfile::tempdir().unwrap(), pulled());
    let last = pull_off.last.as_ref().unwrap();
    assert_eq!(last.point.attached, 4);
    assert!(last.point.force_along > 1.0, "{:?}", last.point);
    let files = write_seta_states(dir.path(), &[SetaPose::of(last, &small())]).unwrap();
    let names: Vec<String> =
        files.iter().map(|file| file.strip_prefix(dir.path()).unwrap().display().to_string()).collect();
    assert_eq!(names, ["states.pvd", "states/state-000.vtu"]);
    assert!(read(&files[0]).contains("file=\"states/state-000.vtu\""));
    let text = read(&files[1]);
    let grid = roxmltree::Document::parse(&text).unwrap();
    let (force, moment) = (array(&grid, "force_nN"), array(&grid, "moment_nN_nm"));
    // force_nN of the field data stands before that of the points
    let forces: Vec<f64> = force[..3].to_vec();
    let size = last.point.force_along;
    close(&forces, last.point.force.map(|part| -part), size);
    let arm = small().shaft_length + small().brush_height;
    close(&moment[..3], last.point.moment.map(|part| -part), size * arm);
    // the last branch carries the last tip alone, and no moment at its end
    let load = last.tips[3].load;
    close(&force[force.len() - 3..], load, size);
    close(&moment[moment.len() - 3..], [0.0; 3], size * arm);
    let end = last.joints[small().tip_joint(3)].place;
    let points = array(&grid, "Points");
    close(&points[points.len() - 3..], end, arm);
    for field in SETA_STATE_FIELDS {
        assert_eq!(array(&grid, field.name).len(), points.len() / 3 * field.components, "{}", field.name);
    }
}

#[test]
fn a_seta_of_256_tips_has_the_lines_of_the_paper() {
    let (dir, seta) = (tempfile::tempdir().unwrap(), Seta::default());
    let mut state = SetaState::stress_free(&seta);
    let pulled = |k: usize, tip: TipState| TipState { load: [0.0, -(k as f64), 0.0], ..tip };
    state.tips = state.tips.iter().enumerate().map(|(k, &tip)| pulled(k, tip)).collect();
    let files = write_seta_states(dir.path(), &[SetaPose::of(&state, &seta)]).unwrap();
    let text = read(&files[1]);
    let grid = roxmltree::Document::parse(&text).unwrap();
    let types = array(&grid, "types");
    assert_eq!(types.len(), 1700);
    assert!(types.iter().all(|&kind| kind == 3.0), "lines of two nodes");
    let corners = array(&grid, "connectivity");
    assert!(corners.chunks(2).all(|line| line[1] == line[0] + 1.0));
    let [least, most] = [f64::min, f64::max].map(|pick| array(&grid, "radius_nm").into_iter().reduce(pick).unwrap());
    approx::assert_relative_eq!(most, 2000.0);
    approx::assert_relative_eq!(least, 2000.0 * 0.625f64.powi(8));
    assert_eq!(array(&grid, "force_nN")[..3], [0.0, -f64::from(255 * 128), 0.0]);
    assert!(array(&grid, "attached").iter().all(|&flag| flag == 0.0));
    // straight branches, each from its joint to the next
    let points = array(&grid, "Points");
    let [root, fork] = [0, 12].map(|k| &points[3 * k..3 * k + 3]);
    close(root, seta.joint_place(0), 1e5);
    close(fork, seta.joint_place(1), 1e5);
    let middle: Vec<f64> = (0..3).map(|i| 0.5 * (root[i] + fork[i])).collect();
    close(&points[18..21], [middle[0], middle[1], middle[2]], 1e5);
}

#[test]
fn pictures_tables_and_the_page_can_be_read() {
    let (dir, pull_off, seta) = (tempfile::tempdir().unwrap(), pulled(), small());
    let last = pull_off.last.clone().unwrap();
    let mut first = last.clone();
    first.point = pull_off.points[0];
    let drawn = draw_pull_off(dir.path(), &pull_off, &seta, &[], "Four tips & <more>").unwrap();
    for svg in drawn.iter().filter(|file| file.extension().is_some_and(|ending| ending == "svg")) {
        let text = read(svg);
        let picture = roxmltree::Document::parse(&text).unwrap();
        assert!(picture.descendants().any(|node| node.text().is_some_and(|text| text.contains("µ"))), "units");
    }
    let page =
        write_seta_animation(dir.path(), &pull_off, &[first, last.clone()], &seta, "Four tips & <more>").unwrap();
    let text = read(&page);
    let page = roxmltree::Document::parse_with_options(
        &text,
        roxmltree::ParsingOptions { allow_dtd: true, ..Default::default() },
    )
    .unwrap();
    let data = page.descendants().find(|node| node.attribute("id") == Some("data")).unwrap().text().unwrap();
    let data: serde_json::Value = serde_json::from_str(data).unwrap();
    assert_eq!(data["frames"].as_array().unwrap().len(), 2);
    assert_eq!(data["tips"].as_array().unwrap().len(), 4);
    let sections: u64 = data["branches"].as_array().unwrap().iter().map(|branch| branch[0].as_u64().unwrap()).sum();
    assert_eq!(data["frames"][1]["l"].as_array().unwrap().len() as u64, 2 * sections);
    assert_eq!(page.descendants().filter(|node| node.attribute("class") == Some("tip")).count(), 4);
    let curve = read(&write_seta_curve(dir.path(), &pull_off).unwrap());
    assert_eq!(curve.lines().count(), 1 + pull_off.points.len());
    let tips = read(&write_tips(dir.path(), &seta, &[("end", &last)]).unwrap());
    let loads: f64 = tips.lines().skip(1).map(|line| line.split(',').nth(7).unwrap().parse::<f64>().unwrap()).sum();
    approx::assert_relative_eq!(loads, last.point.force[1], max_relative = 1e-6);
}

/// Beams that buckle at a first event, and a tip that follows them; then a tip that lets go.
#[test]
fn an_event_that_no_tip_begins_has_a_row() {
    let (dir, mut pull_off) = (tempfile::tempdir().unwrap(), pulled());
    let before = *pull_off.points.last().unwrap();
    let tip = TipChange { tip: 2, to: TipBranch::Detached, load: [0.0, -3.0, 0.0] };
    let event = |cause, tips| SetaEvent { before, after: before, cause, tips, released: 1.0 };
    pull_off.events = vec![event(EventCause::Buckling, vec![tip]), event(EventCause::Tips, vec![tip])];
    let table = read(&write_seta_events(dir.path(), &pull_off, &small()).unwrap());
    let rows: Vec<Vec<&str>> = table.lines().skip(1).map(|line| line.split(',').collect()).collect();
    let cells = |row: usize| [0, 3, 4, 6, 7].map(|column| rows[row][column]);
    assert_eq!(rows.len(), 3);
    assert_eq!(cells(0), ["1", "", "", "buckles", ""]);
    assert_eq!(cells(1)[..2], ["1", "2"]);
    assert_eq!([cells(1)[3], cells(1)[4]], ["detaches", "3.0"]);
    assert_eq!(cells(2)[0], "2");
}
