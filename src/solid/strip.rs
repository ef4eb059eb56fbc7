//! A strip as a plane solid on flat ground: its mesh, its tables, and the energy, residual and tangent of its elements.
//!
//! Unknowns are displacements from the stress-free strip, whose contact face lies flat at the equilibrium gap r_eq = 15^(-1/6) r0. There it is in
//! equilibrium with a traction, and nearly so with a body force. x of the lower left corner is held; no force is needed for that.

use super::basis::{MOST_SOLID_ORDER, SolidElement};
use super::contact::{ContactResponse, DETACHED, GAP_SCALE, SolidContact};
use super::grip::{GripDrive, GripMap, SolidGrip};
use super::material::{Elastic, Plane, SolidMaterial};
use super::mesh::{Grading, StripMesh};
use super::tables::{GroundPoints, Layout, RowTable, TableOptions};
use crate::adhesion::levels::half_space::HalfSpace;
use crate::beam::section::Material;

/// What a solid strip is made of, and how it is discretised. Lengths in nm.
#[derive(Clone, Copy, Debug)]
pub(crate) struct StripDesign {
    pub length: f64,
    pub height: f64,
    pub width: f64,
    pub material: Material,
    pub energy: SolidMaterial,
    pub plane: Plane,
    pub ground: HalfSpace,
    pub contact: SolidContact,
    pub far_face: bool,
    pub grip: SolidGrip,
    pub element: SolidElement,
    pub modes: bool,
    /// Length of a column
    pub along: f64,
    /// Rows before the grading
    pub through: usize,
    pub grading: Grading,
}

/// A discretised strip.
#[derive(Clone, Debug)]
pub struct SolidStrip {
    pub(crate) design: StripDesign,
    pub(crate) mesh: StripMesh,
    pub(crate) rows: Vec<RowTable>,
    pub(crate) layout: Layout,
    pub(crate) grip: GripMap,
    /// What the grip does to a rigid face
    pub(crate) drive: GripDrive,
    elastic: Elastic,
}

/// Points along the face of an element beyond those of its order, and one more for so much length over r0.
const FACE_POINTS: f64 = 4.0;
const A_FACE_POINT: f64 = 2.5;

/// What one element adds: filled anew for each.
#[derive(Default)]
pub(crate) struct ElementWork {
    /// Displacements of its shapes, x then y, each times the factor of its shape
    moved: [Vec<f64>; 2],
    scale: Vec<f64>,
    gradient: [Vec<f64>; 2],
    /// ∂P g of a point
    carried: [Vec<f64>; 2],
    /// Tangent by components: xx, xy, yx, yy
    blocks: [Vec<f64>; 4],
    /// Residual, two numbers a shape
    pub residual: Vec<f64>,
    /// Tangent, row by row
    pub matrix: Vec<f64>,
    pub energy: f64,
}

impl SolidStrip {
    pub(crate) fn new(design: StripDesign, drive: GripDrive) -> Self {
        let StripDesign { length, height, along, through, grading, .. } = design;
        Self::on(StripMesh::new(length, height, along, through, grading), design, drive)
    }

    /// The same on a finer discretisation: one order more of Q(p,q), every column and row cut in two of other elements.
    pub(crate) fn refined(&self) -> Self {
        let Self { design, drive, .. } = *self;
        match design.element {
            SolidElement::Full { along, through } if along.max(through) < MOST_SOLID_ORDER => {
                let element = SolidElement::Full { along: along + 1, through: through + 1 };
                Self::on(self.mesh.clone(), StripDesign { element, ..design }, drive)
            }
            _ => Self::on(self.mesh.halved(), StripDesign { along: 0.5 * design.along, ..design }, drive),
        }
    }

    fn on(mesh: StripMesh, design: StripDesign, drive: GripDrive) -> Self {
        let StripDesign { element, along, .. } = design;
        let is_traction = design.contact != SolidContact::BodyForce;
        let distance = design.ground.equilibrium_distance;
        let more = (FACE_POINTS + along / (A_FACE_POINT * distance)).ceil() as usize;
        let options = TableOptions {
            element,
            modes: design.modes,
            face_points: more.min(MOST_FACE_POINTS) + element.order_along(true).saturating_sub(3),
            volume: !is_traction,
            upper: is_traction && design.far_face,
        };
        let rows = RowTable::of(&mesh, &options);
        let layout = Layout::new(element, &mesh, &rows);
        let grip = GripMap::new(design.grip, &layout, &mesh.heights);
        let elastic = Elastic::new(design.energy, design.plane, &design.material);
        Self { design, mesh, rows, layout, grip, drive, elastic }
    }

    /// Unknowns, those of the grip in place of those of the last line.
    pub fn unknowns(&self) -> usize {
        self.inside() + self.grip.unknowns()
    }

    /// Unknowns left of the last line.
    pub(crate) fn inside(&self) -> usize {
        2 * self.layout.line_start(self.layout.columns)
    }

    /// Number of elements.
    pub fn elements(&self) -> usize {
        self.mesh.columns() * self.mesh.rows()
    }

    /// Length of its longest column, nm.
    pub(crate) fn longest_column(&self) -> f64 {
        (0..self.mesh.columns()).map(|column| self.mesh.length_of(column)).fold(0.0, f64::max)
    }

    /// S of the lines of the mesh across the strip, and heights over the contact face of those along it, ascending, nm.
    pub fn mesh_lines(&self) -> (&[f64], &[f64]) {
        (&self.mesh.lines, &self.mesh.heights)
    }

    /// The element that it is made of.
    pub fn element(&self) -> SolidElement {
        self.design.element
    }

    /// r_eq, the gap at rest, nm.
    pub(crate) fn rest_gap(&self) -> f64 {
        self.design.ground.equilibrium_gap()
    }

    /// What is added to a gap before changes are taken relative to it, nm.
    pub(crate) fn gap_scale(&self) -> f64 {
        GAP_SCALE * self.design.ground.equilibrium_distance
    }

    /// Whether the load has a potential.
    pub(crate) fn has_potential(&self) -> bool {
        self.design.contact.has_potential()
    }

    /// Displacements of all functions, two numbers each, of the unknowns.
    pub(crate) fn displacements(&self, values: &[f64]) -> Vec<f64> {
        let inside = self.inside();
        let mut all = vec![0.0; 2 * self.layout.functions()];
        all[..inside].copy_from_slice(&values[..inside]);
        self.grip.place(&values[inside..], &mut all[inside..]);
        all
    }

    /// Gaps at the vertices of the contact face, from the left, of displacements, nm.
    pub(crate) fn gaps(&self, displacements: &[f64]) -> Vec<f64> {
        let vertex = self.layout.vertex(0);
        let gap = |line: usize| self.rest_gap() + displacements[2 * (self.layout.line_start(line) + vertex) + 1];
        (0..=self.layout.columns).map(gap).collect()
    }

    /// Whether no vertex of the contact face is nearer to the ground than 10 r0.
    pub(crate) fn is_detached(&self, values: &[f64]) -> bool {
        let cutoff = DETACHED * self.design.ground.equilibrium_distance;
        self.gaps(&self.displacements(values)).into_iter().all(|gap| gap > cutoff)
    }

    /// Displacement (u_x, u_y) of the point at S and this height over the contact face, nm.
    pub fn displacement_at(&self, values: &[f64], place: f64, height: f64) -> [f64; 2] {
        self.field_at(&self.displacements(values), place, height, false).displacement
    }

    /// Displacement and its derivatives at a point, of displacements of all functions; incompatible modes are a strain that moves nothing, and are
    /// in it where `modes` says so.
    pub(crate) fn field_at(&self, displacements: &[f64], place: f64, height: f64, modes: bool) -> Field {
        let (column, xi) = StripMesh::located(&self.mesh.lines, place);
        let (row, eta) = StripMesh::located(&self.mesh.heights, height);
        let (length, height) = (self.mesh.length_of(column), self.mesh.height_of(row));
        let mut field = Field::default();
        for shape in self.rows[row].shapes.iter().filter(|shape| modes || !shape.is_mode()) {
            let first = 2 * self.layout.function(column, row, shape.place);
            let scale = shape.scale(length);
            let ([f, f1], [g, g1]) = (shape.along.at(xi), shape.through.at(eta));
            for i in 0..2 {
                let q = displacements[first + i] * scale;
                field.displacement[i] += q * f * g;
                field.along[i] += q * f1 * g * 2.0 / length;
                field.through[i] += q * f * g1 * 2.0 / height;
                field.mixed[i] += q * f1 * g1 * 4.0 / (length * height);
            }
        }
        field
    }

    /// σ, Cauchy's stress xx, yy, xy at a point, GPa.
    pub fn stress_at(&self, values: &[f64], place: f64, height: f64) -> [f64; 3] {
        let f = self.field_at(&self.displacements(values), place, height, true).gradient();
        let p = self.elastic.at(f).stress;
        // σ = P Fᵀ/J; in plane stress the area shrinks by λ3 as well, which these stresses leave out
        let volume = f[0] * f[3] - f[1] * f[2];
        let of = |i: usize, j: usize| (p[2 * i] * f[2 * j] + p[2 * i + 1] * f[2 * j + 1]) / volume;
        [of(0, 0), of(1, 1), of(0, 1)]
    }

    /// What an element adds at these displacements; the tangent where it is asked for.
    pub(crate) fn element_at(
        &self,
        displacements: &[f64],
        (column, row): (usize, usize),
        tangent: bool,
        work: &mut ElementWork,
    ) {
        let table = &self.rows[row];
        let n = table.shapes.len();
        let (length, height) = (self.mesh.length_of(column), self.mesh.height_of(row));
        work.begin(n, tangent);
        for (k, shape) in table.shapes.iter().enumerate() {
            let first = 2 * self.layout.function(column, row, shape.place);
            work.scale[k] = shape.scale(length);
            for i in 0..2 {
                work.moved[i][k] = displacements[first + i] * work.scale[k];
            }
        }
        let measure = 0.25 * length * height * self.design.width;
        for point in &table.bulk {
            for k in 0..n {
                work.gradient[0][k] = point.along[k] * 2.0 / length;
                work.gradient[1][k] = point.through[k] * 2.0 / height;
            }
            let mut f = [1.0, 0.0, 0.0, 1.0];
            for i in 0..2 {
                for j in 0..2 {
                    f[2 * i + j] += dot(&work.moved[i], &work.gradient[j]);
                }
            }
            let stress = self.elastic.at(f);
            let weight = point.weight * measure;
            work.energy += weight * stress.energy;
            work.add_stress(n, weight, &stress.stress, tangent.then_some(&stress.tangent));
        }
        self.add_ground(work, n, (column, row), height);
        work.finish(n, tangent);
    }

    fn add_ground(&self, work: &mut ElementWork, n: usize, (column, row): (usize, usize), height: f64) {
        let table = &self.rows[row];
        let (ground, contact) = (&self.design.ground, self.design.contact);
        let half = 0.5 * self.mesh.length_of(column);
        let face = half * self.design.width;
        if contact == SolidContact::BodyForce {
            let volume = face * 0.5 * height;
            work.add_ground(n, &table.volume, self.rest_gap(), half, volume, |y, _| SolidContact::in_volume(ground, y));
        } else {
            for (points, sign) in [(&table.lower, 1.0), (&table.upper, -1.0)] {
                work.add_ground(n, points, self.rest_gap(), half, face, |y, stretch| {
                    contact.on_face(ground, y, stretch, sign)
                });
            }
        }
    }

    /// Σ over the points of the contact face of `at` (gap y, weight in length), with what adds N of each function to a gradient.
    pub(crate) fn over_contact(
        &self,
        displacements: &[f64],
        mut at: impl FnMut(f64, f64, &mut dyn FnMut(f64, &mut [f64])),
    ) {
        let table = &self.rows[0];
        for column in 0..self.mesh.columns() {
            let length = self.mesh.length_of(column);
            let place = |k: usize| {
                let shape = &table.shapes[k];
                (2 * self.layout.function(column, 0, shape.place) + 1, shape.scale(length))
            };
            for point in &table.lower.points {
                let used = table.lower.shapes.iter().zip(&point.values);
                let moved: f64 = used.clone().map(|(&k, value)| displacements[place(k).0] * place(k).1 * value).sum();
                let mut add = |factor: f64, gradient: &mut [f64]| {
                    used.clone().for_each(|(&k, value)| gradient[place(k).0] += factor * place(k).1 * value);
                };
                at(self.rest_gap() + moved, 0.5 * length * point.weight, &mut add);
            }
        }
    }
}

/// Most points along the face of an element of the lowest order.
const MOST_FACE_POINTS: usize = 16;

/// Displacement and its derivatives by S and by the height, at a point.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Field {
    pub displacement: [f64; 2],
    pub along: [f64; 2],
    pub through: [f64; 2],
    /// ∂²u/∂S∂Y
    pub mixed: [f64; 2],
}

impl Field {
    /// F in the order 11, 12, 21, 22.
    pub(crate) fn gradient(&self) -> [f64; 4] {
        [1.0 + self.along[0], self.through[0], self.along[1], 1.0 + self.through[1]]
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

impl ElementWork {
    fn begin(&mut self, n: usize, tangent: bool) {
        let cleared = |vector: &mut Vec<f64>, size: usize| {
            vector.clear();
            vector.resize(size, 0.0);
        };
        cleared(&mut self.scale, n);
        for pair in [&mut self.moved, &mut self.gradient, &mut self.carried] {
            pair.iter_mut().for_each(|vector| cleared(vector, n));
        }
        cleared(&mut self.residual, 2 * n);
        self.blocks.iter_mut().for_each(|block| cleared(block, if tangent { n * n } else { 0 }));
        self.energy = 0.0;
    }

    /// Stress and tangent of a point; of the blocks xx and yy their upper triangles.
    fn add_stress(&mut self, n: usize, weight: f64, stress: &[f64; 4], tangent: Option<&[[f64; 4]; 4]>) {
        let Self { gradient: [gx, gy], carried: [cx, cy], blocks, residual, .. } = self;
        for k in 0..n {
            residual[2 * k] += weight * (stress[0] * gx[k] + stress[1] * gy[k]);
            residual[2 * k + 1] += weight * (stress[2] * gx[k] + stress[3] * gy[k]);
        }
        let Some(tangent) = tangent else { return };
        for (a, b) in [(0, 0), (0, 1), (1, 1)] {
            let t = |j: usize, l: usize| weight * tangent[2 * a + j][2 * b + l];
            let (xx, xy, yx, yy) = (t(0, 0), t(0, 1), t(1, 0), t(1, 1));
            for k in 0..n {
                cx[k] = xx * gx[k] + xy * gy[k];
                cy[k] = yx * gx[k] + yy * gy[k];
            }
            let block = &mut blocks[2 * a + b];
            for i in 0..n {
                let from = if a == b { i } else { 0 };
                let row = &mut block[i * n + from..(i + 1) * n];
                let (x, y) = (gx[i], gy[i]);
                let columns = cx[from..n].iter().zip(&cy[from..n]);
                row.iter_mut().zip(columns).for_each(|(own, (cx, cy))| *own += x * cx + y * cy);
            }
        }
    }

    /// What the ground does at points; of a block yy its upper triangle, of yx what xy has not.
    fn add_ground(
        &mut self,
        n: usize,
        ground: &GroundPoints,
        rest: f64,
        half: f64,
        measure: f64,
        respond: impl Fn(f64, f64) -> ContactResponse,
    ) {
        let used = &ground.shapes;
        for point in &ground.points {
            let sum = |component: usize, of: &[f64]| -> f64 {
                used.iter().zip(of).map(|(&k, value)| self.moved[component][k] * value).sum()
            };
            let y = rest + point.height + sum(1, &point.values);
            let response = respond(y, 1.0 + sum(0, &point.along) / half);
            let weight = point.weight * measure;
            self.energy += weight * response.energy;
            for (&i, value) in used.iter().zip(&point.values) {
                self.residual[2 * i + 1] -= weight * response.force * value;
            }
            if self.blocks[3].is_empty() {
                continue;
            }
            let (by_height, by_stretch) = (weight * response.by_height, weight * response.by_stretch / half);
            for (p, &i) in used.iter().enumerate() {
                for (q, &j) in used.iter().enumerate() {
                    if j >= i {
                        self.blocks[3][i * n + j] -= by_height * point.values[p] * point.values[q];
                    }
                    self.blocks[2][i * n + j] -= by_stretch * point.values[p] * point.along[q];
                }
            }
        }
    }

    /// Residual and tangent by the unknowns, from those by the scaled ones.
    fn finish(&mut self, n: usize, tangent: bool) {
        for k in 0..n {
            self.residual[2 * k] *= self.scale[k];
            self.residual[2 * k + 1] *= self.scale[k];
        }
        if !tangent {
            return;
        }
        self.matrix.clear();
        self.matrix.resize(4 * n * n, 0.0);
        let [xx, xy, yx, yy] = &self.blocks;
        for i in 0..n {
            for j in 0..n {
                let scale = self.scale[i] * self.scale[j];
                let upper = if i <= j { i * n + j } else { j * n + i };
                let (first, second) = (4 * n * i + 2 * j, 4 * n * i + 2 * n + 2 * j);
                self.matrix[first] = scale * xx[upper];
                self.matrix[first + 1] = scale * xy[i * n + j];
                self.matrix[second] = scale * (yx[i * n + j] + xy[j * n + i]);
                self.matrix[second + 1] = scale * yy[upper];
            }
        }
    }
}
