//! Short runs of scenes with absurd numbers, which the bytes choose.
#![no_main]

#[path = "../../tests/report/garbled/generator/mod.rs"]
mod garbled;

use garbled::{Dice, absurd_scene, check_run, is_computed};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    let text = absurd_scene(&mut Dice::new(bytes));
    if is_computed(&text)
        && let Err(fault) = check_run(&text)
    {
        panic!("{fault}\nin\n{text}");
    }
});
