//! Shape functions at the points of the quadratures, row by row of the mesh; and where the unknowns of a column stand.
//!
//! Strain energy is integrated by one point more than the order, in either direction. The contact face takes more: the traction changes within a
//! few tenths of a nanometre, while an element is some nanometres long. So does the depth of the body force below the face.

use super::basis::{LineFunction, Shape, ShapePlace, SolidElement};
use super::mesh::StripMesh;
use crate::number::gauss::gauss_legendre;
use std::num::NonZeroUsize;

/// A point of the strain energy.
#[derive(Clone, Debug)]
pub(crate) struct BulkPoint {
    /// On the square
    pub weight: f64,
    /// ∂N/∂ξ of each shape
    pub along: Vec<f64>,
    /// ∂N/∂η of each shape
    pub through: Vec<f64>,
}

/// A point at which the ground acts, in the coordinates of its element.
#[derive(Clone, Debug)]
pub(crate) struct GroundPoint {
    /// On the edge, or on the square
    pub weight: f64,
    /// Height over the contact face in the reference, nm
    pub height: f64,
    /// N of each shape of its list
    pub values: Vec<f64>,
    /// ∂N/∂ξ likewise
    pub along: Vec<f64>,
}

/// Points at which the ground acts, and the shapes that take part there.
#[derive(Clone, Debug, Default)]
pub(crate) struct GroundPoints {
    /// Indices of shapes that do not vanish there
    pub shapes: Vec<usize>,
    /// The points
    pub points: Vec<GroundPoint>,
}

/// All of a row.
#[derive(Clone, Debug)]
pub(crate) struct RowTable {
    /// Those inside the element first
    pub shapes: Vec<Shape>,
    /// How many those are
    pub inner: usize,
    /// Of the strain energy
    pub bulk: Vec<BulkPoint>,
    /// On the lower face, of the lowest row alone
    pub lower: GroundPoints,
    /// On the upper face, of the highest row alone
    pub upper: GroundPoints,
    /// In the volume, where a body force acts
    pub volume: GroundPoints,
}

/// What the tables depend on beside the mesh.
#[derive(Clone, Copy, Debug)]
pub(crate) struct TableOptions {
    /// The element
    pub element: SolidElement,
    /// Whether rows without contact have incompatible modes
    pub modes: bool,
    /// Points along the face of an element
    pub face_points: usize,
    /// Whether a body force acts in the volume
    pub volume: bool,
    /// Whether the upper face takes part
    pub upper: bool,
}

/// Depths at which the panels of the body force end in the contact row, nm.
const PANELS: [f64; 7] = [0.05, 0.2, 0.5, 1.0, 2.0, 4.0, 8.0];
/// Points of a panel.
const PANEL_POINTS: usize = 6;

impl RowTable {
    /// Of each row.
    pub(crate) fn of(mesh: &StripMesh, options: &TableOptions) -> Vec<Self> {
        (0..mesh.rows()).map(|row| Self::new(mesh, row, options)).collect()
    }

    fn new(mesh: &StripMesh, row: usize, options: &TableOptions) -> Self {
        let element = options.element;
        let modes = options.modes && row > 0 && element.is_bilinear_inside();
        let shapes = element.shapes(row, mesh.rows(), modes);
        let inner = shapes.iter().filter(|shape| matches!(shape.place, ShapePlace::Inner(_))).count();
        let mut bulk = Vec::new();
        for (xi, weight) in gauss(element.order_along(row == 0) + 1) {
            for (eta, other) in gauss(element.order_through() + 1) {
                let at = |shape: &Shape| (shape.along.at(xi), shape.through.at(eta));
                bulk.push(BulkPoint {
                    weight: weight * other,
                    along: shapes.iter().map(|s| at(s).0[1] * at(s).1[0]).collect(),
                    through: shapes.iter().map(|s| at(s).0[0] * at(s).1[1]).collect(),
                });
            }
        }
        let face = |eta: f64, height: f64| ground_points(&shapes, options.face_points, &[(eta, 1.0, height)]);
        let nothing = GroundPoints::default;
        let lower = if row == 0 { face(-1.0, 0.0) } else { nothing() };
        let is_upper = options.upper && row + 1 == mesh.rows();
        let upper = if is_upper { face(1.0, mesh.height()) } else { nothing() };
        let volume =
            if options.volume { ground_points(&shapes, options.face_points, &depths(mesh, row)) } else { nothing() };
        Self { shapes, inner, bulk, lower, upper, volume }
    }
}

/// η, weight and height of the points through a row at which a body force acts.
fn depths(mesh: &StripMesh, row: usize) -> Vec<(f64, f64, f64)> {
    let (from, to) = (mesh.heights[row], mesh.heights[row + 1]);
    let within = |height: &f64| *height > from && *height < to;
    let cuts: Vec<f64> =
        std::iter::once(from).chain(PANELS.into_iter().filter(within)).chain(std::iter::once(to)).collect();
    let mut found = Vec::new();
    for panel in cuts.windows(2) {
        let half = 0.5 * (panel[1] - panel[0]);
        for (t, weight) in gauss(PANEL_POINTS) {
            let height = panel[0] + half * (1.0 + t);
            found.push((2.0 * (height - from) / (to - from) - 1.0, weight * 2.0 * half / (to - from), height));
        }
    }
    found
}

fn ground_points(shapes: &[Shape], along: usize, through: &[(f64, f64, f64)]) -> GroundPoints {
    // an incompatible mode is a strain, and moves nothing
    let takes_part =
        |shape: &Shape| !shape.is_mode() && through.iter().any(|&(eta, _, _)| shape.through.at(eta)[0] != 0.0);
    let used: Vec<usize> = (0..shapes.len()).filter(|&k| takes_part(&shapes[k])).collect();
    let mut points = Vec::new();
    for (xi, weight) in gauss(along) {
        for &(eta, other, height) in through {
            let of = |part: usize| {
                let value = |&k: &usize| shapes[k].along.at(xi)[part] * shapes[k].through.at(eta)[0];
                used.iter().map(value).collect()
            };
            points.push(GroundPoint { weight: weight * other, height, values: of(0), along: of(1) });
        }
    }
    GroundPoints { shapes: used, points }
}

/// Gauss's rule of so many points on [-1, 1].
pub(crate) fn gauss(points: usize) -> Vec<(f64, f64)> {
    NonZeroUsize::new(points).map_or_else(Vec::new, gauss_legendre)
}

// -- Where unknowns stand --

/// Where the unknowns of a strip stand, in columns from the left. A *function* has two unknowns, of u_x and u_y, next to one another. Of a
/// column those of its left line come first, then those that its rows share, then those inside its elements; the last line is behind the
/// last column.
#[derive(Clone, Debug)]
pub(crate) struct Layout {
    /// Functions of a line
    pub line: Vec<LineFunction>,
    /// Functions that the rows of a column share
    pub shared: usize,
    /// Functions inside the element of each row
    pub inner: Vec<usize>,
    /// Number of columns
    pub columns: usize,
}

impl Layout {
    /// Of an element on a mesh with its tables.
    pub(crate) fn new(element: SolidElement, mesh: &StripMesh, rows: &[RowTable]) -> Self {
        Self {
            line: element.line(mesh.rows()),
            shared: element.column(mesh.rows()),
            inner: rows.iter().map(|row| row.inner).collect(),
            columns: mesh.columns(),
        }
    }

    /// Functions from one line to the next.
    fn stride(&self) -> usize {
        self.line.len() + self.shared + self.inner.iter().sum::<usize>()
    }

    /// The first function of the line left of a column.
    pub(crate) fn line_start(&self, column: usize) -> usize {
        column * self.stride()
    }

    /// All functions with those of the last line.
    pub(crate) fn functions(&self) -> usize {
        self.line_start(self.columns) + self.line.len()
    }

    /// The first function inside an element.
    pub(crate) fn inner_start(&self, column: usize, row: usize) -> usize {
        self.line_start(column) + self.front(false) + self.inner[..row].iter().sum::<usize>()
    }

    /// Functions of a column's front: those of its left line and the shared ones; with `right` those of its right line behind.
    pub(crate) fn front(&self, right: bool) -> usize {
        self.line.len() * if right { 2 } else { 1 } + self.shared
    }

    /// Where in a column's front the functions of a shape stand that is not inside an element.
    pub(crate) fn in_front(&self, place: ShapePlace) -> Option<usize> {
        match place {
            ShapePlace::Left(index) => Some(index),
            ShapePlace::Column(index) => Some(self.line.len() + index),
            ShapePlace::Right(index) => Some(self.front(false) + index),
            ShapePlace::Inner(_) => None,
        }
    }

    /// The function of a place in the front of a column.
    pub(crate) fn of_front(&self, column: usize, place: usize) -> usize {
        let own = self.front(false);
        if place < own { self.line_start(column) + place } else { self.line_start(column + 1) + place - own }
    }

    /// The function of a shape of an element.
    pub(crate) fn function(&self, column: usize, row: usize, place: ShapePlace) -> usize {
        match (place, self.in_front(place)) {
            (_, Some(front)) => self.of_front(column, front),
            (ShapePlace::Inner(index), None) => self.inner_start(column, row) + index,
            (_, None) => unreachable!("what is not inside an element has a place in the front"),
        }
    }

    /// The function of a line that is the vertex between two rows.
    pub(crate) fn vertex(&self, row: usize) -> usize {
        let is_vertex = |f: &LineFunction| f.row == row && f.bubble.is_none() && !f.slope;
        self.line.iter().position(is_vertex).unwrap_or(0)
    }
}

#[cfg(test)]
mod tests {
    use super::super::mesh::Grading;
    use super::*;
    use approx::assert_abs_diff_eq;
    use std::collections::BTreeSet;

    fn tables(name: &str) -> (StripMesh, Vec<RowTable>, Layout) {
        let mesh = StripMesh::new(20.0, 10.0, 5.0, 3, Grading::None);
        let element = SolidElement::named(name).unwrap();
        let options = TableOptions { element, modes: true, face_points: 5, volume: true, upper: true };
        let rows = RowTable::of(&mesh, &options);
        let layout = Layout::new(element, &mesh, &rows);
        (mesh, rows, layout)
    }

    /// Every function belongs to some shape, and those inside an element to one alone.
    #[test]
    fn every_function_is_used() {
        for name in ["Q1C1", "Q1C3", "Q1CH", "H1(2)", "Q(3,2)", "Q(1,1)"] {
            let (mesh, rows, layout) = tables(name);
            let mut used = BTreeSet::new();
            for column in 0..mesh.columns() {
                for (row, table) in rows.iter().enumerate() {
                    used.extend(table.shapes.iter().map(|shape| layout.function(column, row, shape.place)));
                }
            }
            assert_eq!(used.len(), layout.functions(), "{name}");
            assert_eq!(used.last(), Some(&(layout.functions() - 1)), "{name}");
        }
    }

    #[test]
    fn weights_sum_to_the_measure_of_the_element() {
        let (mesh, rows, _) = tables("Q1CH");
        for (row, table) in rows.iter().enumerate() {
            assert_abs_diff_eq!(table.bulk.iter().map(|point| point.weight).sum::<f64>(), 4.0, epsilon = 1e-13);
            assert_abs_diff_eq!(table.volume.points.iter().map(|p| p.weight).sum::<f64>(), 4.0, epsilon = 1e-13);
            let within = mesh.heights[row]..mesh.heights[row + 1];
            assert!(table.volume.points.iter().all(|point| within.contains(&point.height)));
        }
        let faces = [&rows[0].lower, &rows[2].upper];
        for face in faces {
            assert_abs_diff_eq!(face.points.iter().map(|p| p.weight).sum::<f64>(), 2.0, epsilon = 1e-14);
        }
        // on the contact face the two cubic functions of either end, on the upper one the two linear ones
        assert_eq!(faces.map(|face| face.shapes.len()), [4, 2]);
    }
}
