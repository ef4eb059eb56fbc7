//! What a grip does with the right end of a solid: unknowns of the grip in place of those of the last line.
//!
//! - [`SolidGrip::Rigid`]: the end face is rigid. Its middle c moves by (place, height); with its rotation φ and the lever r = X - c of a point,
//!
//!   u = (place, height) + (R(φ) - 1) r,   ∂u/∂φ = R'(φ) r,   ∂²u/∂φ² = -R(φ) r.
//!
//!   This is the grip of a beam. Its corners are singular: grade the mesh towards them.
//! - [`SolidGrip::Parabolic`]: a dead shear traction P (3/2h)(1 - 4Y²/h²) acts on the face, which may warp; u is the mean of u_y with that
//!   weight, conjugate to P.
//!
//! Of either grip the horizontal force is zero unless the end conditions hold the place of a rigid face.

use super::basis::Factor;
use super::tables::{Layout, gauss};
use crate::solve::problem::{Direction, EndConditions};
use crate::solve::system::Unknown;

/// The grip of a solid.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum SolidGrip {
    /// A rigid end face
    #[default]
    Rigid,
    /// A parabolic shear traction
    Parabolic,
}

/// What a grip holds of a rigid end face, and which way it moves that.
#[derive(Clone, Copy, Debug)]
pub struct GripDrive {
    /// Whether it holds the rotation
    pub rotation: bool,
    /// Whether it holds the displacement across its way
    pub across: bool,
    /// Which way it goes
    pub direction: Direction,
    /// How far a held rotation goes along, rad/nm
    pub turn: f64,
}

impl GripDrive {
    /// Straight up, with nothing held.
    pub const UP: Self = Self { rotation: false, across: false, direction: Direction::UP, turn: 0.0 };

    /// As end conditions, with an error of each unknown by that of the height, nm, and the longest lever of the face, nm.
    pub(crate) fn conditions(&self, scale: f64, lever: f64) -> EndConditions {
        let mut grip = EndConditions {
            across: Some(PLACE),
            direction: self.direction,
            geared: ROTATION,
            gear: if self.rotation { self.turn } else { 0.0 },
            ..EndConditions::drive(HEIGHT)
        };
        (grip.scale[HEIGHT], grip.scale[ROTATION], grip.scale[PLACE]) = (scale, scale / lever, scale);
        (grip.held[ROTATION], grip.held[PLACE]) = (self.rotation, self.across);
        grip
    }

    /// Whether it may need a force along the ground.
    pub(crate) fn pulls_along(&self) -> bool {
        self.across || self.direction != Direction::UP
    }
}

/// Slots of the interface of a rigid face; of a parabolic traction the first alone.
pub(crate) const HEIGHT: usize = 0;
pub(crate) const ROTATION: usize = 1;
pub(crate) const PLACE: usize = 2;

pub(super) const NAMES: [Unknown; 3] = [
    Unknown { name: "height of the right end", unit: "nm" },
    Unknown { name: "rotation of the right end", unit: "rad" },
    Unknown { name: "place of the right end along the substrate", unit: "nm" },
];

/// Unknowns of the last line by those of the grip: first what stays free, then the interface.
#[derive(Clone, Debug)]
pub(crate) struct GripMap {
    grip: SolidGrip,
    /// Unknowns of the line
    line: usize,
    /// Of a rigid face: unknowns of the line that stay free
    slopes: Vec<usize>,
    /// Of a rigid face: Y of each vertex and its first unknown
    vertices: Vec<(f64, usize)>,
    /// Of a parabolic traction: the weight of each unknown of the line in u
    weights: Vec<f64>,
    /// The unknown of the line whose place u takes: that of the largest weight
    replaced: usize,
}

impl GripMap {
    /// Of a line across a strip with these heights of its rows, nm.
    pub(crate) fn new(grip: SolidGrip, layout: &Layout, heights: &[f64]) -> Self {
        let rows = heights.len() - 1;
        let middle = 0.5 * heights[rows];
        let mut map = Self {
            grip,
            line: 2 * layout.line.len(),
            slopes: Vec::new(),
            vertices: Vec::new(),
            weights: vec![0.0; 2 * layout.line.len()],
            replaced: 0,
        };
        for (index, function) in layout.line.iter().enumerate() {
            let (first, second) = (2 * index, 2 * index + 1);
            if function.slope {
                map.slopes.extend([first, second]);
            } else if function.bubble.is_none() {
                map.vertices.push((heights[function.row] - middle, first));
            }
            if !function.slope {
                map.weights[second] = shear_weight(heights, function.row, function.bubble);
            }
        }
        let largest = (0..map.line).max_by(|&a, &b| map.weights[a].abs().total_cmp(&map.weights[b].abs()));
        map.replaced = largest.unwrap_or(0);
        map
    }

    /// Unknowns of the interface.
    pub(crate) fn interface(&self) -> &'static [Unknown] {
        match self.grip {
            SolidGrip::Rigid => &NAMES,
            SolidGrip::Parabolic => &NAMES[..1],
        }
    }

    /// Unknowns that stay free.
    pub(crate) fn free(&self) -> usize {
        match self.grip {
            SolidGrip::Rigid => self.slopes.len(),
            SolidGrip::Parabolic => self.line - 1,
        }
    }

    /// All unknowns of the grip.
    pub(crate) fn unknowns(&self) -> usize {
        self.free() + self.interface().len()
    }

    /// Unknowns of the line of those of the grip, into `line`.
    pub(crate) fn place(&self, grip: &[f64], line: &mut [f64]) {
        line.fill(0.0);
        let free = self.free();
        match self.grip {
            SolidGrip::Rigid => {
                self.slopes.iter().zip(grip).for_each(|(&k, &value)| line[k] = value);
                for &(y, k) in &self.vertices {
                    let [along, up] = turned(grip[free + ROTATION], [0.0, y]);
                    line[k] = grip[free + PLACE] + along;
                    line[k + 1] = grip[free + HEIGHT] + up;
                }
            }
            SolidGrip::Parabolic => {
                let others = self.others();
                others.zip(grip).for_each(|(k, &value)| line[k] = value);
                let taken: f64 = self.weights.iter().zip(&*line).map(|(w, q)| w * q).sum();
                line[self.replaced] = (grip[free + HEIGHT] - taken) / self.weights[self.replaced];
            }
        }
    }

    /// Unknowns of the grip of a line, as near to it as the grip can be, of a state on another mesh.
    pub(crate) fn nearest(&self, line: &[f64]) -> Vec<f64> {
        let mut grip: Vec<f64> = match self.grip {
            SolidGrip::Rigid => self.slopes.iter().map(|&k| line[k]).collect(),
            SolidGrip::Parabolic => self.others().map(|k| line[k]).collect(),
        };
        match self.grip {
            SolidGrip::Rigid => {
                let [(low, first), (high, last)] = [self.vertices[0], self.vertices[self.vertices.len() - 1]];
                let along = line[last] - line[first];
                let up = line[last + 1] - line[first + 1] + high - low;
                let middle = |k: usize| 0.5 * (line[first + k] + line[last + k]);
                grip.extend([middle(1), (-along).atan2(up), middle(0)]);
            }
            SolidGrip::Parabolic => grip.push(self.weights.iter().zip(line).map(|(w, q)| w * q).sum()),
        }
        grip
    }

    /// Unknowns of the line that stay, where u takes the place of one.
    fn others(&self) -> impl Iterator<Item = usize> + use<> {
        let replaced = self.replaced;
        (0..self.line).filter(move |&k| k != replaced)
    }

    /// ∂line/∂grip at these unknowns of the grip, row by row of the line.
    pub(crate) fn jacobian(&self, grip: &[f64]) -> Vec<f64> {
        let (free, n) = (self.free(), self.unknowns());
        let mut found = vec![0.0; self.line * n];
        match self.grip {
            SolidGrip::Rigid => {
                self.slopes.iter().enumerate().for_each(|(column, &k)| found[k * n + column] = 1.0);
                for &(y, k) in &self.vertices {
                    let ([along, up], _) = per_turn(grip[free + ROTATION], [0.0, y]);
                    found[k * n + free + PLACE] = 1.0;
                    found[k * n + free + ROTATION] = along;
                    found[(k + 1) * n + free + HEIGHT] = 1.0;
                    found[(k + 1) * n + free + ROTATION] = up;
                }
            }
            SolidGrip::Parabolic => {
                let own = self.weights[self.replaced];
                for (column, k) in self.others().enumerate() {
                    found[k * n + column] = 1.0;
                    found[self.replaced * n + column] = -self.weights[k] / own;
                }
                found[self.replaced * n + free + HEIGHT] = 1.0 / own;
            }
        }
        found
    }

    /// Σ force ∂²line/∂θ² of a rigid face, which belongs to its rotation; zero of other grips.
    pub(crate) fn curvature(&self, grip: &[f64], force: &[f64]) -> f64 {
        if self.grip != SolidGrip::Rigid {
            return 0.0;
        }
        let bent = |&(y, k): &(f64, usize)| {
            let (_, [along, up]) = per_turn(grip[self.free() + ROTATION], [0.0, y]);
            force[k] * along + force[k + 1] * up
        };
        self.vertices.iter().map(bent).sum()
    }

    /// Whether it turns.
    pub(crate) fn is_rigid(&self) -> bool {
        self.grip == SolidGrip::Rigid
    }
}

/// (R(φ) - 1) r
pub(super) fn turned(rotation: f64, [x, y]: [f64; 2]) -> [f64; 2] {
    let (sin, cos) = rotation.sin_cos();
    [(cos - 1.0) * x - sin * y, sin * x + (cos - 1.0) * y]
}

/// R'(φ) r, and R''(φ) r.
pub(super) fn per_turn(rotation: f64, [x, y]: [f64; 2]) -> ([f64; 2], [f64; 2]) {
    let (sin, cos) = rotation.sin_cos();
    ([-sin * x - cos * y, cos * x - sin * y], [sin * y - cos * x, -sin * x - cos * y])
}

/// ∫ (3/2h)(1 - 4Y²/h²) N dY of a vertex function, or of a bubble of this order in its row.
fn shear_weight(heights: &[f64], row: usize, bubble: Option<usize>) -> f64 {
    let rows = heights.len() - 1;
    let height = heights[rows];
    let over = |row: usize, factor: Factor| -> f64 {
        let half = 0.5 * (heights[row + 1] - heights[row]);
        let at = |(t, weight): (f64, f64)| {
            let y = (heights[row] + half * (1.0 + t)) / height - 0.5;
            weight * half * 1.5 / height * (1.0 - 4.0 * y * y) * factor.at(t)[0]
        };
        gauss(8).into_iter().map(at).sum()
    };
    match bubble {
        Some(order) => over(row, Factor::Bubble(order)),
        None => {
            let above = if row < rows { over(row, Factor::First) } else { 0.0 };
            let below = if row > 0 { over(row - 1, Factor::Second) } else { 0.0 };
            above + below
        }
    }
}
