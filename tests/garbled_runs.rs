//! Short runs of scenes with absurd numbers.
//!
//! Parameters: lengths of 1e-3 to 1e9 nm, moduli of 1e-9 to 1e9 GPa, Hamaker constants of 1e-30 to 1e-10 J, equilibrium
//! distances of 1e-4 to 1e4 nm, shear and bending off by 1e6 and 1e9, every load and grip, accuracy, order, elements and
//! steps in their whole ranges; drawn at equal ratios with a fixed seed; at most 60 points and 0.2 s a run. Expected: no
//! panic, an end in reasonable time, every number of summary and path finite, an error bound above zero at every peak and
//! limit point, and a reason with every failure. Why: whoever scans a parameter over decades meets such strips. Many more:
//! `fuzz/README.md`.

mod common {
    pub mod garbled;
}

use common::garbled::{Dice, absurd_scene, check_run};
use proptest::prelude::*;
use proptest::test_runner::RngSeed;

proptest! {
    #![proptest_config(ProptestConfig {
        rng_seed: RngSeed::Fixed(6),
        failure_persistence: None,
        max_shrink_iters: 0,
        ..ProptestConfig::with_cases(300)
    })]

    #[test]
    fn an_absurd_scene_ends_with_finite_numbers_or_a_named_failure(bytes in prop::collection::vec(any::<u8>(), 64)) {
        let text = absurd_scene(&mut Dice::new(&bytes));
        if let Err(fault) = check_run(&text) {
            return Err(TestCaseError::fail(format!("{fault}\nin\n{text}")));
        }
    }
}
