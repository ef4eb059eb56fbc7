//! One Newton iteration of the strip of 100 nm, as a beam in the plane and as one in space: the tangent factorised
//! with the grip's end left, and the way back.

use peelkit::adhesion::{HalfSpace, Law, LineLaw, LineLoad, SectionShape, SpatialSection};
use peelkit::beam::{
    ALONG_X, EndRotation, Focus, Material, MeshIntervals, MeshKind, MeshPolicy, Reach, SpatialBeam, SpatialChain,
    SpatialDensity, SpatialEnd, SpatialProfile, SpatialRestCurve, SpatialStiffness,
};
use peelkit::model::{Form, StripModel};
use peelkit::solve::{Coefficients, INTERFACE, State, System, Workspace};
use std::hint::black_box;
use std::sync::Arc;

/// Nodes of these elements, for a good mesh of the strip.
pub const ELEMENTS: usize = 12;
/// Order of the elements.
pub const ORDER: usize = 7;

/// A system at rest, with room to solve it.
pub struct Iteration {
    system: Arc<dyn System>,
    at: State,
    room: Workspace,
    direction: Vec<f64>,
}

impl Iteration {
    /// The strip in the plane.
    pub fn planar(form: Form) -> Self {
        let problem = StripModel::of_the_paper(100.0, 1.0).problem(form, ORDER).unwrap();
        Self::of(problem.system.clone())
    }

    /// The strip in space, 10 nm wide, with both ends free to turn.
    pub fn spatial() -> Self {
        Self::of(Arc::new(strip_in_space()))
    }

    fn of(system: Arc<dyn System>) -> Self {
        let at = system.stress_free(ELEMENTS);
        let direction = vec![0.0; system.unknowns(&at)];
        Self { system, at, room: Workspace::default(), direction }
    }

    /// Integrates the elements and eliminates all nodes but the last.
    pub fn factorise(&mut self) {
        let (at, weights) = (black_box(&self.at), [1.0, 0.0]);
        let condensed = self.system.factorise(at, Coefficients::STATIC, weights, &mut self.room);
        black_box(condensed.is_ok());
    }

    /// The way back.
    pub fn recover(&mut self) {
        self.system.recover(&self.room, black_box(&[1e-3; INTERFACE]), -1.0, &mut self.direction);
        black_box(&self.direction);
    }

    /// The energy alone.
    pub fn evaluate(&mut self) {
        black_box(self.system.evaluate(black_box(&self.at), &self.direction));
    }

    /// A whole iteration.
    pub fn iterate(&mut self) {
        self.factorise();
        self.recover();
    }
}

/// The strip of the paper, but 10 nm wide: E = 2 GPa, ν = 0.2, h = 10 nm, A_H = 1e-19 J, r0 = 0.4 nm.
fn strip_in_space() -> SpatialBeam {
    let (side, length): (f64, f64) = (10.0, 100.0);
    let material = Material {
        youngs_modulus: 2.0,
        poissons_ratio: 0.2,
        shear_correction: 5.0 / 6.0,
        bending_stiffness_factor: 1.0,
    };
    let second = side.powi(4) / 12.0;
    let stiffness = SpatialStiffness::isotropic(&material, side * side, [second; 2], 0.140_577_014_955 * side.powi(4));
    let half_space = HalfSpace { hamaker_constant: 0.1, equilibrium_distance: 0.4 };
    let law = LineLaw { half_space, height: side, law: Law::BodyForce, line_load: LineLoad::Full, far_face: true };
    let section = SpatialSection::new(SectionShape::Rectangle, side, law).unwrap();
    let height = 0.5 * side + law.rest_gap();
    let rest = section.response(height, 0.0, side);
    let process_length = 0.7 * (4.0 * stiffness.0[4][4] / rest.hessian[0]).powf(0.25);
    let end = |rotation| SpatialEnd {
        axes: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        rotation,
        rest: ALONG_X,
        dead_load: [[0.0; 3]; 2],
    };
    let density = SpatialDensity { profile: SpatialProfile::uniform(stiffness, side, side), adhesion: Some(section) };
    let held = [Some(0.0), None, Some(0.0), None, Some(0.0), None];
    SpatialBeam {
        chain: SpatialChain::new(density, ORDER, [end(EndRotation::Angles), end(EndRotation::Free)], held),
        length,
        rest: SpatialRestCurve::along_x(height).into(),
        scale: [0.4, 0.4 / process_length],
        round_off: 0.0,
        rest_adhesion: rest.energy,
        process_length,
        mesh: MeshPolicy {
            kind: MeshKind::Moving,
            front_foci: vec![Focus { center: 0.0, length: process_length, weight: 1.0, reach: Reach::Far }],
            fixed_foci: vec![Focus { center: 0.0, length: 0.1, weight: 0.8, reach: Reach::Far }],
            pieces: MeshIntervals::whole(length),
        },
    }
}
