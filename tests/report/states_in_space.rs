//! The fields along a beam in space, read by readers of their own.
//!
//! Reference: the balance of the whole beam, force by force and moment by moment; the constitutive law, with stiffnesses by hand; a director
//! frame is orthonormal.
//!
//! ```text
//!      y                        P, 60 degrees up and along z
//!      |_______________________/____ x       b × h = 40 × 10 nm, L = 100 nm, E = 2 GPa, ν = 0.2;
//!      |=======================             an ellipse of 12 × 8 nm, its grip held against rolling
//!      z
//! ```
//!
//! Expected: to round-off of the section force, 1e-8 nN and nN·nm. Both formats hold the same numbers, and the surface is the outline of the
//! sections. Why: loads, sections and directors come from three pieces of code, each with signs of its own.

use crate::states::{Read, read_csv};
use approx::assert_abs_diff_eq;
use peelkit::study::{Peel, peel};
use peelkit_report::{SPATIAL_STATE_FIELDS, write_states, write_vtk};
use peelkit_scene::Scene;
use std::fs;
use std::path::Path;

const SIDEWAYS: &str = include_str!("../../scenes/strip-sideways.toml");
const ELLIPSE: [(&str, &str); 6] = [
    ("strip.section", "ellipse"),
    ("strip.width", "12 nm"),
    ("strip.height", "8 nm"),
    ("grip.roll", "fixed"),
    ("drive.azimuth", "50 deg"),
    ("bounds.points", "60"),
];

fn peeled(overrides: &[(&str, &str)]) -> Peel {
    let overrides: Vec<_> = overrides.iter().map(|(key, value)| ((*key).to_owned(), (*value).to_owned())).collect();
    let scene = Scene::parse("strip-sideways.toml", SIDEWAYS, &overrides).unwrap();
    peel(&scene.model, &scene.accuracy, &scene.bounds.from_now())
}

fn written(peel: &Peel, count: usize) -> Vec<Read> {
    let dir = tempfile::tempdir().unwrap();
    read_csv(&write_states(dir.path(), &peel.states(count)).unwrap())
}

fn vector(state: &Read, names: [&str; 3], k: usize) -> [f64; 3] {
    names.map(|name| state.of(name)[k])
}

fn director(state: &Read, number: usize, k: usize) -> [f64; 3] {
    [format!("d{number}_x"), format!("d{number}_y"), format!("d{number}_z")].map(|name| state.of(&name)[k])
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    (0..3).map(|i| a[i] * b[i]).sum()
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

const PLACE: [&str; 3] = ["x_nm", "y_nm", "z_nm"];
const LINE_FORCE: [&str; 3] = ["line_force_x_nN_per_nm", "line_force_y_nN_per_nm", "line_force_z_nN_per_nm"];
const LINE_MOMENT: [&str; 3] = ["line_moment_x_nN", "line_moment_y_nN", "line_moment_z_nN"];

/// Numbers along the directors in the axes of space.
fn in_space(state: &Read, names: [&str; 3], k: usize) -> [f64; 3] {
    let along = vector(state, names, k);
    std::array::from_fn(|i| (0..3).map(|d| director(state, d + 1, k)[i] * along[d]).sum())
}

/// Force and moment about the origin of what holds an end.
fn held(state: &Read, k: usize) -> [[f64; 3]; 2] {
    let force = in_space(state, ["N_nN", "Q2_nN", "Q3_nN"], k);
    let [moment, arm] = [in_space(state, ["T_nN_nm", "M2_nN_nm", "M3_nN_nm"], k), vector(state, PLACE, k)];
    let turned = cross(arm, force);
    [force, std::array::from_fn(|i| moment[i] + turned[i])]
}

/// What the ground exerts balances the section forces at the two ends, and their moments about the origin.
#[track_caller]
fn balances(states: &[Read]) {
    for state in states {
        let last = state.of("S_nm").len() - 1;
        let [mut force, mut moment] = [[0.0; 3]; 2];
        for k in 0..=last {
            let (load, weight) = (vector(state, LINE_FORCE, k), state.of("weight_nm")[k]);
            let (turned, twisted) = (cross(vector(state, PLACE, k), load), vector(state, LINE_MOMENT, k));
            (0..3).for_each(|i| {
                force[i] += weight * load[i];
                moment[i] += weight * (turned[i] + twisted[i]);
            });
            let along = dot(director(state, 1, k), twisted);
            assert_abs_diff_eq!(state.of("line_moment_d1_nN")[k], along, epsilon = 1e-12);
        }
        let (from, to) = (held(state, 0), held(state, last));
        for i in 0..3 {
            assert_abs_diff_eq!(force[i], to[0][i] - from[0][i], epsilon = 1e-8);
            assert_abs_diff_eq!(moment[i], to[1][i] - from[1][i], epsilon = 1e-8);
        }
    }
}

#[test]
fn a_strip_pulled_sideways_is_in_equilibrium() {
    let peel = peeled(&[]);
    let states = written(&peel, 4);
    assert_eq!(states.len(), peel.limit_points.len() + 4);
    assert_eq!(states.iter().filter(|state| state.kind == "load").count(), 1);
    balances(&states);
    let [width, height, shear]: [f64; 3] = [40.0, 10.0, 2.0 / 2.4];
    let bending = [2.0 * width * height.powi(3) / 12.0, 2.0 * height * width.powi(3) / 12.0];
    let (sin, cos) = 60f64.to_radians().sin_cos();
    let mut tilted = 0.0f64;
    for state in &states {
        let last = state.of("S_nm").len() - 1;
        // the grip pulls along z at 60 degrees, and holds no moment
        let [force, _] = held(state, last);
        let pull = state.one("force_nN");
        for (found, expected) in force.into_iter().zip([0.0, pull * sin, pull * cos]) {
            assert_abs_diff_eq!(found, expected, epsilon = 1e-8);
        }
        assert_abs_diff_eq!(state.integral("line_force_y_nN_per_nm"), pull * sin, epsilon = 1e-8);
        for k in 0..=last {
            let [d1, d2, d3] = [1, 2, 3].map(|number| director(state, number, k));
            let right = cross(d1, d2);
            (0..3).for_each(|i| assert_abs_diff_eq!(right[i], d3[i], epsilon = 1e-14));
            assert_abs_diff_eq!(dot(d1, d2), 0.0, epsilon = 1e-14);
            let [m2, m3] = ["M2_nN_nm", "M3_nN_nm"].map(|name| state.of(name)[k]);
            assert_abs_diff_eq!(m2, bending[0] * state.of("kappa2_per_nm")[k], epsilon = 1e-9);
            assert_abs_diff_eq!(m3, bending[1] * state.of("kappa3_per_nm")[k], epsilon = 1e-9);
            // lowest corner, and ½ Σ force × strain
            let lowest = state.of("y_nm")[k] - 0.5 * (width * d2[1].abs() + height * d3[1].abs());
            assert_abs_diff_eq!(state.of("gap_nm")[k], lowest, epsilon = 1e-12);
            let [n, q2, q3, torsion] = ["N_nN", "Q2_nN", "Q3_nN", "T_nN_nm"].map(|name| state.of(name)[k]);
            let area = width * height;
            let stored = 0.5
                * (n * n / (2.0 * area)
                    + (q2 * q2 + q3 * q3) / (5.0 / 6.0 * shear * area)
                    + torsion * state.of("twist_per_nm")[k]
                    + m2 * m2 / bending[0]
                    + m3 * m3 / bending[1]);
            assert_abs_diff_eq!(state.of("stored_energy_aJ_per_nm")[k], stored, epsilon = 1e-9);
            tilted = tilted.max(d2[1].abs());
        }
    }
    // by up to 5.6 degrees
    assert!(tilted > 0.05, "it rolls: {tilted}");
}

#[test]
fn an_ellipse_is_in_equilibrium() {
    let states = written(&peeled(&ELLIPSE), 3);
    balances(&states);
    for state in &states {
        for k in 0..state.of("S_nm").len() {
            let below = (12.0 * director(state, 2, k)[1]).hypot(8.0 * director(state, 3, k)[1]);
            assert_abs_diff_eq!(state.of("gap_nm")[k], state.of("y_nm")[k] - 0.5 * below, epsilon = 1e-12);
        }
    }
}

/// A grid as a reader of XML finds it.
struct Grid {
    text: String,
}

impl Grid {
    fn read(path: &Path) -> Self {
        Self { text: fs::read_to_string(path).unwrap() }
    }

    /// An array by its place and name, and how many numbers a point has.
    fn array(&self, parent: &str, name: &str) -> (Vec<f64>, usize) {
        let grid = roxmltree::Document::parse(&self.text).unwrap();
        let inside = grid.descendants().find(|node| node.has_tag_name(parent)).expect(parent);
        let data = inside.children().find(|node| node.attribute("Name") == Some(name)).expect(name);
        let components = data.attribute("NumberOfComponents").map_or(1, |count| count.parse().unwrap());
        (data.text().unwrap_or("").split_whitespace().map(|number| number.parse().unwrap()).collect(), components)
    }

    fn points(&self) -> Vec<[f64; 3]> {
        self.array("Points", "Points").0.as_chunks().0.to_vec()
    }

    /// Corners of the cells, with VTK's numbers of their types.
    fn cells(&self) -> Vec<(usize, Vec<usize>)> {
        let [corners, ends, types] = ["connectivity", "offsets", "types"]
            .map(|name| self.array("Cells", name).0.into_iter().map(|x| x as usize));
        let (corners, mut from) = (corners.collect::<Vec<_>>(), 0);
        let cell = |(end, kind)| {
            let cell = corners[from..end].to_vec();
            from = end;
            (kind, cell)
        };
        ends.zip(types).map(cell).collect()
    }
}

/// Names of the grids of a list, in its order.
fn listed(path: &Path) -> Vec<String> {
    let text = fs::read_to_string(path).unwrap();
    let list = roxmltree::Document::parse(&text).unwrap();
    let sets = list.descendants().filter(|node| node.has_tag_name("DataSet"));
    sets.map(|set| set.attribute("file").unwrap().to_owned()).collect()
}

#[test]
fn paraview_is_given_the_numbers_of_the_table_and_the_surface() {
    let peel = peeled(&[("accuracy.relative", "1e-4")]);
    let (dir, states) = (tempfile::tempdir().unwrap(), peel.states(2));
    let table = read_csv(&write_states(dir.path(), &states).unwrap());
    let files = write_vtk(dir.path(), &states).unwrap();
    assert_eq!(files.len(), 2 * (states.len() + 1));
    let [axes, surfaces] = ["states.pvd", "states-surface.pvd"].map(|name| listed(&dir.path().join(name)));
    assert_eq!((axes.len(), surfaces.len()), (states.len(), states.len()));
    let vectors = [
        ("d1", ["d1_x", "d1_y", "d1_z"]),
        ("d2", ["d2_x", "d2_y", "d2_z"]),
        ("d3", ["d3_x", "d3_y", "d3_z"]),
        ("line_force_nN_per_nm", LINE_FORCE),
        ("line_moment_nN", LINE_MOMENT),
        ("Points", PLACE),
    ];
    for ((axis, surface), state) in axes.iter().zip(&surfaces).zip(&table) {
        let (axis, surface) = (Grid::read(&dir.path().join(axis)), Grid::read(&dir.path().join(surface)));
        let sections = state.of("S_nm").len();
        for (name, parts) in vectors {
            let (found, components) = axis.array(if name == "Points" { "Points" } else { "PointData" }, name);
            let expected: Vec<f64> = (0..sections).flat_map(|k| vector(state, parts, k)).collect();
            assert_eq!((found, components), (expected, 3), "{name}");
        }
        let part_of_a_vector = |name: &str| vectors.iter().any(|(_, parts)| parts.contains(&name));
        for field in SPATIAL_STATE_FIELDS.iter().filter(|field| !part_of_a_vector(field.name)) {
            assert_eq!(axis.array("PointData", field.name), (state.of(field.name).to_vec(), 1), "{}", field.name);
        }
        let expected: Vec<_> = (1..sections).map(|k| (3, vec![k - 1, k])).collect();
        assert_eq!(axis.cells(), expected);
        // four corners a section, and the middle of each end face
        let points = surface.points();
        assert_eq!(points.len(), 4 * sections + 2);
        for k in 0..sections {
            let (place, d2, d3) = (vector(state, PLACE, k), director(state, 2, k), director(state, 3, k));
            let ring = &points[4 * k..4 * k + 4];
            for (corner, [across, up]) in ring.iter().zip([[-20.0, -5.0], [20.0, -5.0], [20.0, 5.0], [-20.0, 5.0]]) {
                (0..3).for_each(|i| {
                    assert_abs_diff_eq!(corner[i], place[i] + across * d2[i] + up * d3[i], epsilon = 1e-11);
                });
            }
            let lowest = ring.iter().map(|corner| corner[1]).fold(f64::INFINITY, f64::min);
            assert_abs_diff_eq!(lowest, state.of("gap_nm")[k], epsilon = 1e-11);
        }
        let (gaps, _) = surface.array("PointData", "gap_nm");
        assert_eq!((gaps[4 * sections - 1], gaps.len()), (state.of("gap_nm")[sections - 1], points.len()));
        closed(&surface.cells(), &points, 40.0 * 10.0 * 100.0);
    }
}

#[test]
fn the_surface_of_an_ellipse_is_closed() {
    let (dir, states) = (tempfile::tempdir().unwrap(), peeled(&ELLIPSE).states(2));
    write_vtk(dir.path(), &states).unwrap();
    let last = listed(&dir.path().join("states-surface.pvd")).pop().unwrap();
    let surface = Grid::read(&dir.path().join(last));
    // of 24 corners: the area is less than that of the ellipse by sin(2π/24)/(2π/24)
    let angle = std::f64::consts::TAU / 24.0;
    closed(&surface.cells(), &surface.points(), 12.0 * angle.sin() * 12.0 * 0.25 * 8.0 * 100.0);
}

/// Each edge is one of two cells, in opposite directions, and the enclosed volume is positive and about that of the beam: all cells face
/// outwards.
#[track_caller]
fn closed(cells: &[(usize, Vec<usize>)], points: &[[f64; 3]], volume: f64) {
    let mut edges = std::collections::HashMap::new();
    let mut enclosed = 0.0;
    for (kind, cell) in cells {
        assert_eq!(*kind, if cell.len() == 3 { 5 } else { 9 });
        for k in 0..cell.len() {
            let (a, b) = (cell[k], cell[(k + 1) % cell.len()]);
            *edges.entry((a.min(b), a.max(b))).or_insert(0) += if a < b { 1 } else { -1 };
        }
        for k in 1..cell.len() - 1 {
            let [a, b, c] = [cell[0], cell[k], cell[k + 1]].map(|corner| points[corner]);
            enclosed += dot(a, cross(b, c)) / 6.0;
        }
    }
    assert!(edges.values().all(|&sum| sum == 0));
    assert!((enclosed / volume - 1.0).abs() < 0.05, "{enclosed} {volume}");
}
