//! What both counts of the hot loop measure: the bare law, and one Newton iteration on the elements that hold its points.

use peelkit::adhesion::LineLaw;
use peelkit::beam::{ChainFactors, ConstraintGradient, ROOT};
use peelkit::model::{BeamProblem, Form, StripModel};
use peelkit::number::F64x4;
use peelkit::solve::State;
use std::hint::black_box;

/// Points that the law is evaluated at side by side.
pub const LANES: usize = 4;

/// A problem at rest, with room to solve it.
pub struct Setting {
    pub problem: BeamProblem,
    pub at: State,
    row: ConstraintGradient,
    work: ChainFactors,
    out: Vec<f64>,
    law: LineLaw,
}

impl Setting {
    /// The paper's strip of 100 nm on elements of an order.
    pub fn new(elements: usize, order: usize) -> Self {
        let model = StripModel::of_the_paper(100.0, 1.0);
        let problem = model.problem(Form::TwoField, order).unwrap();
        let at = problem.initial(elements);
        let (out, row) = (
            vec![0.0; problem.beam.planar().unwrap().nodes(&at.values).len()],
            ConstraintGradient { coverage: 1.0, ..ConstraintGradient::default() },
        );
        Self { law: model.line_law(), problem, at, row, work: ChainFactors::default(), out }
    }

    /// Integrates the elements and eliminates all nodes but the last.
    pub fn eliminate(&mut self) {
        let root = self.problem.beam.planar().unwrap().chain.eliminate(
            black_box(self.problem.beam.planar().unwrap().configuration(&self.at)),
            &self.row,
            &mut self.work,
        );
        black_box(root.is_ok());
    }

    /// The same and the way back: what a Newton iteration takes.
    pub fn iterate(&mut self) {
        self.eliminate();
        self.problem.beam.planar().unwrap().chain.recover(&self.work, black_box(&[1e-3; ROOT]), -1.0, &mut self.out);
        black_box(&self.out);
    }

    /// The energy alone.
    pub fn energy(&mut self) {
        black_box(
            self.problem
                .beam
                .planar()
                .unwrap()
                .chain
                .energy(black_box(self.problem.beam.planar().unwrap().configuration(&self.at)), &self.out),
        );
    }

    /// The bare law with all second derivatives at so many points.
    pub fn law(&mut self, points: usize) {
        bare_law(&self.law, points / LANES);
    }
}

/// Compiled for the vector units of the machine, as the elements are.
#[multiversion::multiversion(targets("x86_64+avx2+fma"))]
fn bare_law(law: &LineLaw, times: usize) {
    let angle = [0.1f64, 0.2, 0.3, 0.4];
    let (gap, sin, cos) = (F64x4([0.3, 0.4, 0.5, 0.6]), F64x4(angle.map(f64::sin)), F64x4(angle.map(f64::cos)));
    for _ in 0..times {
        black_box(law.response(black_box(gap), black_box(sin), black_box(cos)));
    }
}
