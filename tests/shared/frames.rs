//! The frames of a checkpoint, taken apart and made without the code that is tested.
//!
//!     length of the key | length of the value | CRC-32 of both | CRC-32 of these twelve bytes | key | value

// each program takes a part of this
#![allow(dead_code)]

use std::ops::Range;

/// Bytes before the key.
pub const HEAD: usize = 16;

/// Where a frame lies in its file.
#[derive(Clone, Debug)]
pub struct Frame {
    /// All of it
    pub place: Range<usize>,
    /// Its key
    pub key: Range<usize>,
    /// Its value
    pub value: Range<usize>,
}

/// The frames of a file that are whole by their lengths.
pub fn frames(bytes: &[u8]) -> Vec<Frame> {
    let mut frames = Vec::new();
    let mut start = 0;
    let number = |at: usize| u32::from_le_bytes(bytes[at..at + 4].try_into().unwrap()) as usize;
    while start + HEAD <= bytes.len() {
        // zeros are none
        if crc32fast::hash(&bytes[start..start + HEAD - 4]) as usize != number(start + HEAD - 4) {
            break;
        }
        let key = start + HEAD..start + HEAD + number(start);
        let value = key.end..key.end + number(start + 4);
        if value.end > bytes.len() {
            break;
        }
        let place = start..value.end;
        start = place.end;
        frames.push(Frame { place, key, value });
    }
    frames
}

/// A key with its value as a frame.
pub fn framed(key: &[u8], value: &[u8]) -> Vec<u8> {
    let body = [key, value].concat();
    let numbers = [key.len() as u32, value.len() as u32, crc32fast::hash(&body)].map(u32::to_le_bytes).concat();
    [&numbers[..], &crc32fast::hash(&numbers).to_le_bytes(), &body].concat()
}
