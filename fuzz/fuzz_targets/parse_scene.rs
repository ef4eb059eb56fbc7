//! Texts as they are, and good scenes garbled as the bytes say.
#![no_main]

#[path = "../../tests/report/garbled/generator/mod.rs"]
mod garbled;

use garbled::{Dice, check_parse, garbled_text};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    for text in [String::from_utf8_lossy(bytes).into_owned(), garbled_text(&mut Dice::new(bytes))] {
        if let Err(fault) = check_parse(&text) {
            panic!("{fault}\nin\n{text}");
        }
    }
});
