//! Short runs of scenes with absurd numbers.
//!
//! Parameters: lengths of 1e-3 to 1e9 nm, moduli of 1e-9 to 1e9 GPa, Hamaker constants of 1e-30 to 1e-10 J, equilibrium
//! distances of 1e-4 to 1e4 nm, shear and bending off by 1e6 and 1e9, every load and grip, accuracy, order, elements and
//! steps in their whole ranges, beams in four pieces; drawn at equal ratios with a fixed seed; at most 60 points and 0.2 s a run. Expected: no
//! panic, an end in reasonable time, every number of summary and path finite, an error bound above zero at every peak and
//! limit point, and a reason with every failure. Why: whoever scans a parameter over decades meets such strips. Many more:
//! `fuzz/README.md`.

use super::corpus;
use super::generator::{BYTES, Dice, absurd_scene, absurd_scene_of, check_parse, check_run, is_computed};
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;
use rayon::prelude::*;

const SCENES: usize = 200;
/// Of beams in four pieces.
const IN_PIECES: usize = 60;

#[test]
fn what_broke_once_ends_well() {
    let scenes: Vec<_> = corpus().into_iter().filter(|(_, text)| check_parse(text) == Ok(true)).collect();
    assert!(!scenes.is_empty());
    for (name, text) in scenes {
        assert_eq!(check_run(&text).err(), None, "{name}");
    }
}

#[test]
fn an_absurd_scene_ends_with_finite_numbers_or_a_named_failure() {
    let mut random = ChaCha8Rng::seed_from_u64(6);
    let mut bytes = || {
        let mut bytes = [0; BYTES];
        random.fill_bytes(&mut bytes);
        bytes
    };
    let mut scenes: Vec<String> = (0..SCENES).map(|_| absurd_scene(&mut Dice::new(&bytes()))).collect();
    scenes.extend((0..IN_PIECES).map(|_| absurd_scene_of("profile", &mut Dice::new(&bytes()))));
    let drawn = scenes.len();
    scenes.retain(|text| is_computed(text));
    assert!(3 * scenes.len() > 2 * drawn, "{} of {drawn} are computed", scenes.len());
    let faults: Vec<String> = scenes
        .par_iter()
        .filter_map(|text| check_run(text).err().map(|fault| format!("{fault}\nin\n{text}")))
        .collect();
    assert!(faults.is_empty(), "{} of {} scenes:\n{}", faults.len(), scenes.len(), faults.join("\n"));
}
