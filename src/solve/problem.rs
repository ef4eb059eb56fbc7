//! What is to be solved: a chain, its rest state, its grip, and the scales that measure progress and error.

use super::{Chain, Configuration, Focus, MOST_FIELDS, graded_ends};

/// A chain on a substrate with its right end in a grip that drives one field.
pub struct Problem {
    pub chain: Box<dyn Chain>,
    /// Reference length L, nm
    pub length: f64,
    /// Fields of a node at rest at S = 0.
    pub rest: [f64; MOST_FIELDS],
    /// How the fields at rest grow with S (1 for x, else 0).
    pub rest_slope: [f64; MOST_FIELDS],
    /// The field that the grip drives.
    pub driven: usize,
    /// The rotation.
    pub rotation: usize,
    /// Fields that the grip holds at their rest values.
    pub held: [bool; MOST_FIELDS],
    /// Scale of an error of each field: nm near the substrate, rad.
    pub scale: [f64; MOST_FIELDS],
    /// Adhesion energy per length at rest, nN (negative).
    pub rest_adhesion: f64,
    /// Foci of the mesh besides the front.
    pub fixed_foci: Vec<Focus>,
    /// Length ℓ of the process zone, nm
    pub process_length: f64,
    /// Height of the beam, nm.
    pub height: f64,
    /// Whether the law looks at the edges of a tilted section, or only at the gap below the axis.
    pub sees_tilt: bool,
    /// Whether the load has a potential, so that work is an energy difference and the tangent is symmetric.
    pub conservative: bool,
}

/// One configuration with its mesh, force and border.
#[derive(Clone, Debug, Default)]
pub struct Equilibrium {
    /// Ends of the elements, nm
    pub ends: Vec<f64>,
    /// S of the mesh's moving focus, nm
    pub center: f64,
    /// Fields node by node.
    pub state: Vec<f64>,
    pub border: f64,
    /// Force of the grip along the pull, nN
    pub force: f64,
}

impl Equilibrium {
    /// The part of it that the chain sees.
    pub fn configuration(&self) -> Configuration<'_> {
        Configuration { ends: &self.ends, state: &self.state, border: self.border }
    }
}

impl Problem {
    /// Fields a node.
    pub fn fields(&self) -> usize {
        self.chain.fields()
    }

    /// Element ends for a front at `center`.
    pub fn ends(&self, center: f64, elements: usize) -> Vec<f64> {
        self.ends_near(center, elements, &[])
    }

    /// The same, found faster from the ends of a similar mesh.
    pub fn ends_near(&self, center: f64, elements: usize, near: &[f64]) -> Vec<f64> {
        let mut foci = vec![Focus { center, length: self.process_length, weight: 1.0 }];
        foci.extend(&self.fixed_foci);
        graded_ends(self.length, &foci, elements, near)
    }

    /// The chain at rest, on `elements` elements, with the front at the grip.
    pub fn at_rest(&self, elements: usize) -> Equilibrium {
        let ends = self.ends(self.length, elements);
        let order = self.chain.order();
        let mut state = Vec::new();
        for node in 0..=elements * order {
            let (e, rank) = ((node / order).min(elements - 1), node - (node / order).min(elements - 1) * order);
            let s = ends[e] + (ends[e + 1] - ends[e]) * self.chain.node_fraction(rank);
            for f in 0..self.fields() {
                state.push(self.rest[f] + self.rest_slope[f] * s);
            }
        }
        Equilibrium { ends, center: self.length, state, border: 0.0, force: 0.0 }
    }

    /// Size of an update relative to what it changes: heights by their scale plus their lift, rotations as they are.
    pub fn relative_size(&self, update: &[f64], state: &[f64]) -> f64 {
        let (fields, driven, rotation) = (self.fields(), self.driven, self.rotation);
        let (per_rotation, scale, rest) = (1.0 / self.scale[rotation], self.scale[driven], self.rest[driven]);
        let (mut largest, mut sum) = (0.0f64, 0.0);
        for (u, s) in update.chunks_exact(fields).zip(state.chunks_exact(fields)) {
            // x, where it is an unknown, is measured like the height
            let height = if driven > 0 { u[0].abs().max(u[driven].abs()) } else { u[driven].abs() };
            largest = largest.max(height / (scale + (s[driven] - rest).abs())).max(u[rotation].abs() * per_rotation);
            sum += height + u[rotation];
        }
        // max passes over a NaN, a sum does not
        if sum.is_finite() { largest } else { f64::NAN }
    }

    /// Distance of the beam from the substrate, nm: of the lowest edge of its nodes, or the least gap below its axis where
    /// the law is blind to tilt.
    pub fn nearest(&self, at: &Equilibrium) -> f64 {
        let fields = self.fields();
        let half = if self.sees_tilt { 0.5 * self.height } else { 0.0 };
        at.state
            .chunks_exact(fields)
            .map(|node| node[self.driven] + half * (1.0 - node[self.rotation].cos().abs()))
            .fold(f64::INFINITY, f64::min)
    }
}
