//! The fields along the beam: states.csv and the files for ParaView, read by readers of their own.
//!
//! Expected: the constitutive law M = EI κ, the balance of the whole beam, ∫ line force = P, the slope of θ, and the first integral of a long
//! strip, H x' + V y' + M θ' - stored - bΨ, the same at every S (design.md, section 3). Both formats hold the same numbers.

use crate::strip::STRIP_SCENE;
use approx::assert_abs_diff_eq;
use peelkit::study::{Peel, peel};
use peelkit_report::{STATE_FIELDS, write_states, write_vtk};
use peelkit_scene::Scene;
use std::collections::HashMap;
use std::fs;
use std::path::Path;

/// EI, EA, GA_s of the strip, nN nm² and nN.
const EI: f64 = 2.0e3 / 12.0;
const EA: f64 = 20.0;
const GA: f64 = 5.0 / 6.0 * 2.0 / 2.4 * 10.0;

fn peeled(overrides: &[(&str, &str)]) -> Peel {
    let overrides: Vec<_> = overrides.iter().map(|(key, value)| ((*key).to_owned(), (*value).to_owned())).collect();
    let scene = Scene::parse("a.toml", STRIP_SCENE, &overrides).unwrap();
    peel(&scene.model, &scene.accuracy, &scene.bounds.from_now())
}

/// A state of the table: its columns by name, and of the words the first.
pub struct Read {
    pub kind: String,
    columns: HashMap<String, Vec<f64>>,
}

impl Read {
    pub fn of(&self, name: &str) -> &[f64] {
        &self.columns[name]
    }

    pub fn one(&self, name: &str) -> f64 {
        self.of(name)[0]
    }

    /// By the weights that come along.
    pub fn integral(&self, name: &str) -> f64 {
        self.of(name).iter().zip(self.of("weight_nm")).map(|(value, weight)| value * weight).sum()
    }
}

pub fn read_csv(path: &Path) -> Vec<Read> {
    let mut reader = csv::Reader::from_path(path).unwrap();
    let names = reader.headers().unwrap().clone();
    let mut states: Vec<Read> = Vec::new();
    for record in reader.records() {
        let record = record.unwrap();
        let number: usize = record[0].parse().unwrap();
        if number == states.len() {
            states.push(Read { kind: record[1].to_owned(), columns: HashMap::new() });
        }
        for (name, cell) in names.iter().zip(&record).filter(|(name, _)| !["state", "limit_point"].contains(name)) {
            states[number].columns.entry(name.to_owned()).or_default().push(cell.parse().unwrap());
        }
    }
    states
}

fn written(peel: &Peel, count: usize) -> Vec<Read> {
    let dir = tempfile::tempdir().unwrap();
    read_csv(&write_states(dir.path(), &peel.states(count)).unwrap())
}

#[test]
fn states_are_the_limit_points_and_places_evenly_between() {
    let peel = peeled(&[("accuracy.relative", "1e-4")]);
    let states = written(&peel, 5);
    let kinds = |kind: &str| states.iter().filter(|state| state.kind == kind).count();
    let (loads, displacements) = (kinds("load"), kinds("displacement"));
    assert_eq!((loads + displacements, kinds("")), (peel.limit_points.len(), 5));
    let positions: Vec<f64> = states.iter().map(|state| state.one("path_position")).collect();
    assert!(positions.is_sorted(), "{positions:?}");
    let even: Vec<f64> = states.iter().filter(|state| state.kind.is_empty()).map(|s| s.one("path_position")).collect();
    for (position, expected) in even.iter().zip([0.0, 0.25, 0.5, 0.75, 1.0]) {
        assert_abs_diff_eq!(position, &expected, epsilon = 1e-12);
    }
    let limit_points: Vec<&Read> = states.iter().filter(|state| !state.kind.is_empty()).collect();
    for (state, at) in limit_points.iter().zip(&peel.limit_points) {
        assert_abs_diff_eq!(state.one("force_nN"), at.force, epsilon = 1e-6);
        assert_abs_diff_eq!(state.one("displacement_nm"), at.displacement, epsilon = 1e-4 * at.displacement);
    }
    let (first, last) = (&states[0], &states[states.len() - 1]);
    assert_eq!(first.one("displacement_nm"), peel.points[0].displacement);
    assert_eq!(last.one("displacement_nm"), peel.points[peel.points.len() - 1].displacement);
    assert_eq!(written(&peel, 0).len(), peel.limit_points.len());
}

#[test]
fn the_fields_are_in_equilibrium() {
    for state in written(&peeled(&[("accuracy.relative", "1e-6")]), 4) {
        let force = state.one("force_nN");
        assert_abs_diff_eq!(state.integral("line_force_nN_per_nm"), force, epsilon = 1e-8);
        let (moment, curvature) = (state.of("M_nN_nm"), state.of("kappa_per_nm"));
        let (s, theta) = (state.of("S_nm"), state.of("theta_rad"));
        for k in 0..s.len() {
            assert_abs_diff_eq!(moment[k], EI * curvature[k], epsilon = 1e-9);
        }
        // the rotation by the trapezoidal rule from the curvature, which knows nothing of the elements
        let turned: f64 = (1..s.len()).map(|k| 0.5 * (s[k] - s[k - 1]) * (curvature[k] + curvature[k - 1])).sum();
        assert_abs_diff_eq!(turned, theta[s.len() - 1] - theta[0], epsilon = 2e-3);
        // a free end, and a grip that is free to turn and pulls straight up
        let last = s.len() - 1;
        for (name, end) in [("N_nN", 0), ("Q_nN", 0), ("M_nN_nm", 0), ("M_nN_nm", last)] {
            assert_abs_diff_eq!(state.of(name)[end], 0.0, epsilon = 1e-8);
        }
        let (sin, cos) = theta[last].sin_cos();
        assert_abs_diff_eq!(state.of("N_nN")[last] * sin + state.of("Q_nN")[last] * cos, force, epsilon = 1e-8);
        assert!(state.of("gap_nm").iter().all(|gap| *gap > 0.2), "above the ground");
        assert_eq!((s[0], s[last]), (0.0, 100.0));
    }
}

/// Of a long strip the sum is minus bΨ at rest, the work of adhesion, everywhere and at every state.
#[test]
fn the_first_integral_is_the_work_of_adhesion_all_along_a_long_strip() {
    let peel = peeled(&[("strip.length", "300 nm"), ("bounds.displacement", "60 nm")]);
    let work = peel.model.derived().section.unwrap().work_of_adhesion;
    let states = written(&peel, 3);
    assert!(states.len() > 3);
    for state in states {
        for k in 0..state.of("S_nm").len() {
            let [n, q, m] = ["N_nN", "Q_nN", "M_nN_nm"].map(|name| state.of(name)[k]);
            let stretched = n * (1.0 + n / EA) + q * q / GA + m * m / EI;
            // H x' + V y' = N (1 + Γ1) + Q Γ2, with Γ1 = N/EA and Γ2 = Q/GA_s
            let integral =
                stretched - state.of("stored_energy_aJ_per_nm")[k] - state.of("adhesion_energy_aJ_per_nm")[k];
            assert_abs_diff_eq!(integral, work, epsilon = 2e-5 * work);
        }
    }
}

#[test]
fn paraview_is_given_the_numbers_of_the_table() {
    let peel = peeled(&[("accuracy.relative", "1e-4")]);
    let (dir, states) = (tempfile::tempdir().unwrap(), peel.states(2));
    let table = read_csv(&write_states(dir.path(), &states).unwrap());
    let files = write_vtk(dir.path(), &states).unwrap();
    assert_eq!(files.len(), states.len() + 1);
    let list = fs::read_to_string(dir.path().join("states.pvd")).unwrap();
    let list = roxmltree::Document::parse(&list).unwrap();
    assert_eq!(list.root_element().attribute("type"), Some("Collection"));
    let sets: Vec<_> = list.descendants().filter(|node| node.has_tag_name("DataSet")).collect();
    assert_eq!(sets.len(), states.len());
    for (number, (set, state)) in sets.iter().zip(&table).enumerate() {
        assert_eq!(set.attribute("timestep"), Some(number.to_string().as_str()));
        let text = fs::read_to_string(dir.path().join(set.attribute("file").unwrap())).unwrap();
        let grid = roxmltree::Document::parse(&text).unwrap();
        assert_eq!(grid.root_element().attribute("type"), Some("UnstructuredGrid"));
        let array = |parent: &str, name: &str| -> Vec<f64> {
            let inside = grid.descendants().find(|node| node.has_tag_name(parent)).expect(parent);
            let data = inside.children().find(|node| node.attribute("Name") == Some(name)).expect(name);
            assert_eq!(data.attribute("format"), Some("ascii"));
            data.text().unwrap_or("").split_whitespace().map(|number| number.parse().unwrap()).collect()
        };
        for field in STATE_FIELDS {
            assert_eq!(array("PointData", field.name), state.of(field.name), "{}", field.name);
        }
        assert_eq!(array("FieldData", "force_nN"), [state.one("force_nN")]);
        let points = state.of("S_nm").len();
        let piece = grid.descendants().find(|node| node.has_tag_name("Piece")).unwrap();
        assert_eq!(piece.attribute("NumberOfPoints"), Some(points.to_string().as_str()));
        assert_eq!(piece.attribute("NumberOfCells"), Some((points - 1).to_string().as_str()));
        let places = array("Points", "Points");
        let expected: Vec<f64> =
            state.of("x_nm").iter().zip(state.of("y_nm")).flat_map(|(x, y)| [*x, *y, 0.0]).collect();
        assert_eq!(places, expected);
        let ends: Vec<f64> = (0..points - 1).flat_map(|k| [k as f64, (k + 1) as f64]).collect();
        assert_eq!(array("Cells", "connectivity"), ends);
        assert_eq!(array("Cells", "offsets"), (1..points).map(|k| 2.0 * k as f64).collect::<Vec<_>>());
        assert!(array("Cells", "types").iter().all(|kind| *kind == 3.0));
    }
}

/// Friction carries the horizontal part of the pull, and nothing else does; x is a field of its own there.
#[test]
fn friction_balances_the_pull_along_the_ground() {
    let peel = peeled(&[
        ("accuracy.relative", "1e-3"),
        ("friction.strength", "20 MPa"),
        ("drive.angle", "60 deg"),
        ("bounds.points", "12"),
    ]);
    let states = written(&peel, 2);
    let last = states.last().unwrap();
    let along = 60f64.to_radians().cos() * last.one("force_nN");
    assert!(along > 1e-3);
    assert_abs_diff_eq!(last.integral("friction_traction_GPa"), along, epsilon = 1e-6);
}

#[test]
fn a_peel_without_solutions_has_no_states() {
    let peel = peeled(&[("accuracy.relative", "1e-3"), ("bounds.points", "3")]).without_solutions();
    assert!(peel.states(4).is_empty());
}

/// The loads of every state balance the section forces at the two ends: along the ground, across it, and about the origin.
#[track_caller]
fn balances(peel: &Peel) {
    for state in written(peel, 3) {
        let last = state.of("S_nm").len() - 1;
        let end = |k: usize| {
            let (sin, cos) = state.of("theta_rad")[k].sin_cos();
            let (n, q) = (state.of("N_nN")[k], state.of("Q_nN")[k]);
            let [horizontal, vertical] = [n * cos - q * sin, n * sin + q * cos];
            let turned = state.of("x_nm")[k] * vertical - state.of("y_nm")[k] * horizontal + state.of("M_nN_nm")[k];
            [horizontal, vertical, turned]
        };
        let names = ["x_nm", "y_nm", "line_force_nN_per_nm", "line_force_x_nN_per_nm", "line_moment_nN", "weight_nm"];
        let turned = (0..=last).map(|k| {
            let [x, y, across, along, moment, weight] = names.map(|name| state.of(name)[k]);
            weight * (x * across - y * along + moment)
        });
        let loads = [state.integral(names[3]), state.integral(names[2]), turned.sum()];
        let (from, to) = (end(0), end(last));
        let size = state.one("height_nm") + to[2].abs();
        for (k, size) in [1.0, 1.0, size].into_iter().enumerate() {
            assert_abs_diff_eq!(loads[k], to[k] - from[k], epsilon = 1e-6 * size);
        }
    }
}

#[test]
fn beams_balance_on_any_ground_of_any_outline_and_pulled_anywhere() {
    balances(&peeled(&[("accuracy.relative", "1e-4"), ("drive.angle", "60 deg"), ("grip.rotation", "fixed")]));
    balances(&peeled(&[
        ("accuracy.relative", "1e-3"),
        ("substrate.shape", "sinusoid"),
        ("substrate.height", "0.1 nm"),
        ("substrate.wavelength", "40 nm"),
        ("bounds.points", "30"),
    ]));
    let spatula = include_str!("../../scenes/spatula.toml");
    let roughly = [("accuracy.relative".to_owned(), "1e-4".to_owned())];
    let scene = Scene::parse("spatula.toml", spatula, &roughly).unwrap();
    balances(&peel(&scene.model, &scene.accuracy, &scene.bounds.from_now()));
}
