//! One Newton iteration of the strip of 100 nm, as a beam in the plane and as one in space: the tangent factorised
//! with the grip's end left, and the way back.

use peelkit::model::{Body, Form, PeelModel, Space, StripModel};
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
        let mut model = PeelModel::from(StripModel::of_the_paper(100.0, 1.0));
        model.space = Some(Space::default());
        if let Body::Strip(strip) = &mut model.body {
            strip.width = 10.0;
        }
        Self::of(model.problem(Form::ThreeField, ORDER).unwrap().system.clone())
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
