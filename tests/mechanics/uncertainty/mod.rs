//! Uncertain inputs: sampled against closed forms, and peels against laws that hold exactly.

mod closed_forms;
mod designs;
mod peels;

use peelkit::study::uncertainty::{Correlation, Design, Distribution, Indices, Input, Plan};

fn input(name: &str, distribution: Distribution) -> Input {
    Input { name: name.into(), distribution }
}

/// So many samples of independent inputs, with indices.
fn plan(inputs: Vec<Input>, samples: usize, seed: u64) -> Plan {
    Plan { inputs, correlations: Vec::new(), samples, seed, indices: Indices::Estimated }
}

fn correlated(inputs: [usize; 2], coefficient: f64) -> Correlation {
    Correlation { inputs, coefficient }
}

/// The values of a function at the samples of a design.
fn values(design: &Design, f: impl Fn(&[f64]) -> f64) -> Vec<Option<f64>> {
    (0..design.samples()).map(|sample| Some(f(&design.inputs(design.place(sample))))).collect()
}
