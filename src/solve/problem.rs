//! What is to be solved: a chain, its rest state, its grip, and the scales that measure progress and error.

use super::grip::{Direction, GripState, GripStep};
use super::{Chain, Configuration, Focus, Fronts, MOST_FIELDS, Mesh, Pieces, Slips, graded_ends};
use crate::adhesion::Substrate;
use crate::beam::{ElementEnergy, Rest};
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// A chain with its right end in a grip that drives one field; on a substrate, or on its own.
pub struct Problem {
    pub chain: Box<dyn Chain>,
    /// Reference length L, nm
    pub length: f64,
    /// x, height and rotation at rest; a chain of two fields a node leaves x out.
    pub rest: Rest,
    /// The field that the grip drives: the height, where it pulls in a `direction`.
    pub driven: usize,
    /// The direction of the pull; straight up, it drives a field and not a mixture of two.
    pub direction: Direction,
    /// The rotation, the last field of a node; the height stands before it.
    pub rotation: usize,
    /// The height field at the left end at rest, nm.
    pub rest_gap: f64,
    /// Fields that the grip holds at their rest values; of a pull in a direction, the end's displacement across it in place of
    /// x, which is the last of these where it is no field.
    pub held: [bool; MOST_FIELDS + 1],
    /// t of a grip that turns as it goes, in proportion to its own displacement u, rad/nm: it holds θ = θ_rest + t u in place of θ_rest.
    pub turn: f64,
    /// Horizontal section force at rest, nN: of a straight beam that is stretched by `stretch` from end to end before it is pulled.
    pub pretension: f64,
    /// nm
    pub stretch: f64,
    /// 1/k of a spring between the grip and what moves it, nm/nN; zero where the grip is moved itself. The displacement of
    /// [`super::Observables`] is that of the far end of the spring, U = u + P/k.
    pub compliance: f64,
    /// Scale of an error of each field: nm near the substrate, rad.
    pub scale: [f64; MOST_FIELDS],
    /// Scale of the grip's force: nN, or nN·nm where it drives the rotation.
    pub force_scale: f64,
    /// Updates of this relative size, as in [`Problem::relative_size`], may be round-off: the machine's epsilon times the ratio
    /// of the stiffest to the softest way to deform, or zero where that ratio is small.
    pub round_off: f64,
    /// Adhesion energy per length at rest at the left end, nN: negative, or zero where nothing adheres. Then there is no front:
    /// the force takes its place in the measure of the path, and the mesh has no moving focus.
    pub rest_adhesion: f64,
    /// Where the front is.
    pub fronts: Fronts,
    /// S of the front of the chain at rest, nm.
    pub rest_front: f64,
    /// Whether the mesh follows the front.
    pub mesh: Mesh,
    /// Foci of the mesh besides the front.
    pub fixed_foci: Vec<Focus>,
    /// Between which places elements lie.
    pub pieces: Pieces,
    /// Length ℓ of the process zone, nm; L where nothing adheres
    pub process_length: f64,
    /// Height of a beam that is as high everywhere and whose height field is the gap below it, nm; zero where that is the axis.
    pub height: f64,
    /// Whether the law looks at the edges of a tilted section, or only at the gap below the axis.
    pub sees_tilt: bool,
    /// What the chain is on; flat where nothing adheres.
    pub substrate: Substrate,
    /// Where the path starts, and with it what displacements count from.
    pub beginning: Beginning,
    /// What the material points remember at rest, where there is friction.
    pub slips: Option<Arc<Slips>>,
    /// The grip behind each step that it has taken before, seen from where it took hold.
    pub steps: Vec<GripState>,
    /// Whether the load has a potential, so that work is an energy difference and the tangent is symmetric.
    pub conservative: bool,
}

/// Where a path starts.
#[derive(Clone, Debug)]
pub enum Beginning {
    /// Where the chain is free of stress.
    AtRest,
    /// In an equilibrium that the chain has taken up before: without a grip, which then takes hold of it as it lies there, or led there
    /// by the grip.
    Settled(Arc<Equilibrium>),
    /// Such an equilibrium was not found; why, and what to try.
    Nowhere(String),
}

/// One configuration with its mesh, force and border.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub struct Equilibrium {
    /// Ends of the elements, nm
    pub ends: Vec<f64>,
    /// S of the mesh's moving focus, nm
    pub center: f64,
    /// Fields node by node.
    pub state: Vec<f64>,
    pub border: f64,
    /// How far the right end is along x from where it was at rest, nm, where the chain has a border and no x; else zero
    pub slide: f64,
    /// Force of the grip along the pull, nN
    pub force: f64,
    /// What the material points remembered before the step that ended here, where there is friction.
    pub slips: Option<Arc<Slips>>,
}

impl Equilibrium {
    /// Adds a part of an update of what lies behind the chain.
    pub(super) fn add(&mut self, part: f64, step: &GripStep) {
        self.border += part * step.border;
        self.slide += part * step.slide;
        self.force += part * step.force;
    }

    /// The part of it that the chain sees.
    pub fn configuration(&self) -> Configuration<'_> {
        Configuration { ends: &self.ends, state: &self.state, border: self.border, slips: self.slips.as_deref() }
    }
}

impl Problem {
    /// Fields a node.
    pub fn fields(&self) -> usize {
        self.chain.fields()
    }

    /// Whether there is adhesion, and with it a front.
    pub fn adheres(&self) -> bool {
        self.rest_adhesion != 0.0
    }

    /// The front for an adhesion energy, or its change for a change of that, nm: how long the left end's adhesion would have to go
    /// on; zero where nothing adheres. [`Fronts`] knows where that is.
    pub fn front(&self, adhesion: f64) -> f64 {
        if self.adheres() { adhesion / self.rest_adhesion } else { 0.0 }
    }

    /// A front as the focus of a mesh: no farther than the ends of the chain.
    pub fn centered(&self, front: f64) -> f64 {
        front.clamp(0.0, self.fronts.near(self.length))
    }

    /// The fields of a node at rest.
    pub fn rest_at(&self, place: f64) -> [f64; MOST_FIELDS] {
        let all = self.rest.at(place);
        let left_out = MOST_FIELDS - self.fields();
        std::array::from_fn(|f| all.get(f + left_out).copied().unwrap_or(0.0))
    }

    /// The fields of the right end where displacements are zero.
    pub fn end_at_rest(&self) -> [f64; MOST_FIELDS] {
        match &self.beginning {
            Beginning::Settled(at) => {
                let end = &at.state[at.state.len() - self.fields()..];
                std::array::from_fn(|f| end.get(f).copied().unwrap_or(0.0))
            }
            Beginning::AtRest | Beginning::Nowhere(_) => {
                let mut end = self.rest_at(self.length);
                if self.rotation > 1 {
                    end[0] += self.stretch;
                }
                end
            }
        }
    }

    /// The right end's place along x where displacements are zero, as in [`Equilibrium::slide`].
    pub(super) fn slide_at_rest(&self) -> f64 {
        match &self.beginning {
            Beginning::Settled(at) => at.slide,
            Beginning::AtRest | Beginning::Nowhere(_) => self.stretch,
        }
    }

    /// Height of the section above the gap that the height field is, nm.
    pub fn height_at(&self, place: f64) -> f64 {
        match &self.rest {
            Rest::Curve(_) => self.height,
            Rest::Varying(rest) => rest.height(place),
        }
    }

    /// Distance of the two ends at rest along x, which a horizontally held grip keeps, nm.
    pub fn span(&self) -> f64 {
        self.rest.at(self.length)[0] - self.rest.at(0.0)[0]
    }

    /// Energy of a configuration whose chain has the energy `chain`: with that of the spring, P²/2k, and, as a held grip's
    /// multiplier H adds H times their distance, without that, aJ.
    pub fn energy(&self, at: &Equilibrium, chain: ElementEnergy) -> f64 {
        chain.total + at.border * (self.span() + at.slide) + 0.5 * self.compliance * at.force.powi(2)
    }

    /// Element ends for a front at `center`.
    pub fn ends(&self, center: f64, elements: usize) -> Vec<f64> {
        self.ends_near(center, elements, &[])
    }

    /// The same, found faster from the ends of a similar mesh.
    pub fn ends_near(&self, center: f64, elements: usize, near: &[f64]) -> Vec<f64> {
        let mut foci = Vec::with_capacity(1 + self.fixed_foci.len());
        if self.adheres() && self.mesh != Mesh::Uniform {
            let center = if self.mesh == Mesh::Moving { self.fronts.place(center) } else { self.rest_front };
            foci.push(Focus { center, length: self.process_length, weight: 1.0 });
            foci.extend(&self.fixed_foci);
        }
        graded_ends(&self.pieces, &foci, elements, near)
    }

    /// S of every node, nm.
    pub fn places(&self, ends: &[f64]) -> Vec<f64> {
        let (elements, order) = (ends.len() - 1, self.chain.order());
        let place = |node: usize| {
            let e = (node / order).min(elements - 1);
            ends[e] + (ends[e + 1] - ends[e]) * self.chain.node_fraction(node - e * order)
        };
        (0..=elements * order).map(place).collect()
    }

    /// The chain where its path starts, on `elements` elements. Where a beam of varying outline would lie within the
    /// substrate it is lifted onto that.
    pub fn at_rest(&self, elements: usize) -> Equilibrium {
        if let Beginning::Settled(at) = &self.beginning {
            return self.on_elements(at, elements);
        }
        let center = self.fronts.near(self.rest_front);
        let ends = self.ends(center, elements);
        let mut state = Vec::new();
        for s in self.places(&ends) {
            let mut node = self.rest_at(s);
            if self.rotation > 1 {
                node[0] += self.stretch * s / self.length;
            }
            if let Rest::Varying(rest) = &self.rest {
                let up = self.rotation - 1;
                let tilted = 0.5 * rest.height(s) * (1.0 - node[self.rotation].cos().abs());
                node[up] = node[up].max(self.rest_gap - tilted);
            }
            state.extend_from_slice(&node[..self.fields()]);
        }
        let (border, slide) = if self.chain.has_border() { (self.pretension, self.stretch) } else { (0.0, 0.0) };
        Equilibrium { ends, center, state, border, slide, force: 0.0, slips: self.slips.clone() }
    }

    /// The same configuration on another number of elements.
    pub fn on_elements(&self, at: &Equilibrium, elements: usize) -> Equilibrium {
        let ends = self.ends(at.center, elements);
        let state = self.chain.resampled(at.configuration(), &ends);
        Equilibrium { state, ends, ..at.clone() }
    }

    /// Size of an update relative to what it changes: heights by their scale plus their lift, rotations by their scale.
    pub fn relative_size(&self, update: &[f64], state: &[f64]) -> f64 {
        let (fields, rotation, up) = (self.fields(), self.rotation, self.rotation - 1);
        let per_rotation = 1.0 / self.scale[rotation];
        let (mut largest, mut sum) = (0.0f64, 0.0);
        for (u, s) in update.chunks_exact(fields).zip(state.chunks_exact(fields)) {
            // x, where it is an unknown, is measured like the height
            let height = if up > 0 { u[0].abs().max(u[up].abs()) } else { u[up].abs() };
            let size = height / self.height_unit(s);
            let turn = u[rotation].abs() * per_rotation;
            largest = if size > largest { size } else { largest };
            largest = if turn > largest { turn } else { largest };
            sum += height + turn;
        }
        // a comparison passes over a NaN, a sum does not
        if sum.is_finite() { largest } else { f64::NAN }
    }

    /// What the height of a node is measured by: its scale plus its lift, nm.
    fn height_unit(&self, node: &[f64]) -> f64 {
        let up = self.rotation - 1;
        let lift = match &self.substrate {
            Substrate::Flat => node[up] - self.rest_gap,
            substrate => substrate.clearance(node[0], node[up] + 0.5 * self.height) - 0.5 * self.height - self.rest_gap,
        };
        self.scale[up] + lift.abs()
    }

    /// What each number of an update is multiplied with to be measured as in [`Problem::relative_size`].
    pub fn per_unit(&self, state: &[f64]) -> Vec<f64> {
        let rotation = self.rotation;
        let mut units = vec![1.0 / self.scale[rotation]; state.len()];
        for (units, s) in units.chunks_exact_mut(self.fields()).zip(state.chunks_exact(self.fields())) {
            units[..rotation].fill(1.0 / self.height_unit(s));
        }
        units
    }

    /// Distance of the beam from the substrate, nm: of the lowest edge of its nodes, or the least gap below its axis where
    /// the law is blind to tilt.
    pub fn nearest(&self, at: &Equilibrium) -> f64 {
        self.distances(at).fold(f64::INFINITY, f64::min)
    }

    /// Whether no part of the beam is nearer to the substrate than `far`, nm.
    pub fn is_clear(&self, at: &Equilibrium, far: f64) -> bool {
        self.distances(at).all(|distance| distance > far)
    }

    /// Distance of each node from the substrate, nm.
    fn distances<'a>(&'a self, at: &'a Equilibrium) -> impl Iterator<Item = f64> + 'a {
        let order = self.chain.order();
        at.state.chunks_exact(self.fields()).enumerate().map(move |(k, node)| {
            let half = if self.sees_tilt {
                // a node inside of an element is taken to be as high as the left end of that
                0.5 * self.height_at(at.ends[k / order])
            } else {
                0.0
            };
            if self.substrate.is_flat() {
                return node[self.rotation - 1] + half * (1.0 - node[self.rotation].cos().abs());
            }
            let full = self.height_at(at.ends[k / order]);
            let foot = self.substrate.foot(node[0], node[self.rotation - 1] + 0.5 * full);
            let tilt = (node[self.rotation] - foot.sin.atan2(foot.cos)).cos().abs();
            foot.distance - 0.5 * full + half * (1.0 - tilt)
        })
    }
}
