//! The frames of which a checkpoint is made: one for each result, so that a torn end is cut off, and a changed byte is found and named.
//!
//! ```text
//! length of the key | length of the value | CRC-32 of both | CRC-32 of these twelve bytes | key | value
//! ```
//!
//! The first four have four bytes each, the lowest first. The first frame of a file has no key: its value is a JSON text that says of what the file is.

use std::io;
use std::ops::Range;

/// Bytes before the key.
const HEAD: usize = 16;
/// So many damaged frames are named.
const NAMED: usize = 5;

/// A key with its value, framed.
pub(super) fn framed(key: &[u8], value: &[u8]) -> io::Result<Vec<u8>> {
    let length = |bytes: &[u8]| u32::try_from(bytes.len()).map_err(io::Error::other);
    let body = [key, value].concat();
    let mut frame = Vec::with_capacity(HEAD + body.len());
    for number in [length(key)?, length(value)?, crc32fast::hash(&body)] {
        frame.extend(number.to_le_bytes());
    }
    frame.extend(crc32fast::hash(&frame).to_le_bytes());
    frame.extend(body);
    Ok(frame)
}

/// Where a frame lies among the bytes of a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Frame {
    start: usize,
    key: usize,
    value: usize,
}

impl Frame {
    /// The frame at this place, if its head is as it was written, and the check sum of its key and value.
    fn at(bytes: &[u8], start: usize) -> Option<(Self, u32)> {
        let (numbers, rest) = bytes.get(start..)?.as_chunks::<4>().0.split_at_checked(3)?;
        let numbers: Vec<u32> = numbers.iter().map(|number| u32::from_le_bytes(*number)).collect();
        let sum = u32::from_le_bytes(*rest.first()?);
        (crc32fast::hash(&bytes[start..start + HEAD - 4]) == sum).then_some(())?;
        Some((Self { start, key: numbers[0] as usize, value: numbers[1] as usize }, numbers[2]))
    }

    /// All of its bytes.
    pub fn place(&self) -> Range<usize> {
        self.start..self.value().end
    }

    /// Those of its key.
    pub fn key(&self) -> Range<usize> {
        let start = self.start + HEAD;
        start..start + self.key
    }

    /// Those of its value.
    pub fn value(&self) -> Range<usize> {
        let start = self.key().end;
        start..start + self.value
    }
}

/// What a file holds.
#[derive(Debug, Default)]
pub(super) struct Scan {
    /// The frames that are as they were written, in their order
    pub frames: Vec<Frame>,
    /// Those that are not: their numbers, counted from 1, and the bytes that they take
    pub damaged: Vec<(usize, Range<usize>)>,
    /// Where the last whole frame ends. What is behind it was torn when a process was killed or a machine crashed.
    pub end: usize,
}

impl Scan {
    /// Looks through all bytes of a file.
    pub fn of(bytes: &[u8]) -> Self {
        let mut scan = Self::default();
        for number in 1.. {
            let (start, rest) = (scan.end, &bytes[scan.end..]);
            let end = match Frame::at(bytes, start) {
                Some((frame, _)) if frame.place().end > bytes.len() => break,
                Some((frame, sum)) if crc32fast::hash(&bytes[frame.key().start..frame.place().end]) == sum => {
                    let end = frame.place().end;
                    scan.frames.push(frame);
                    end
                }
                Some((frame, _)) => frame.place().end,
                // as much as a write of zeros, or of part of a head, that nothing came behind
                None if rest.len() < HEAD || rest.iter().all(|&byte| byte == 0) => break,
                // it ends where another one begins
                None => (start + 1..bytes.len())
                    .find(|&next| Frame::at(bytes, next).is_some_and(|(frame, _)| frame.place().end <= bytes.len()))
                    .unwrap_or(bytes.len()),
            };
            if scan.frames.last().is_none_or(|last| last.start != start) {
                scan.damaged.push((number, start..end));
            }
            scan.end = end;
        }
        scan
    }

    /// What is not as it was written, in words, if anything is: the first few of such frames with their places.
    pub fn damage(&self) -> Option<String> {
        let named = |(number, bytes): &(usize, Range<usize>)| {
            format!("{number} (bytes {} to {})", bytes.start, bytes.end.saturating_sub(1))
        };
        let names: Vec<String> = self.damaged.iter().take(NAMED).map(named).collect();
        match self.damaged.len() {
            0 => None,
            1 => Some(format!("frame {} does not match its check sum", names[0])),
            all if all > NAMED => {
                Some(format!("frames {} and {} more do not match their check sums", names.join(", "), all - NAMED))
            }
            _ => Some(format!("frames {} do not match their check sums", names.join(", "))),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn file() -> Vec<u8> {
        let frames = [("", "header"), ("a", "first"), ("b", ""), ("c", "third")];
        frames.iter().flat_map(|(key, value)| framed(key.as_bytes(), value.as_bytes()).unwrap()).collect()
    }

    fn keys(bytes: &[u8], scan: &Scan) -> String {
        scan.frames.iter().map(|frame| String::from_utf8_lossy(&bytes[frame.key()]).into_owned()).collect()
    }

    #[test]
    fn a_byte_that_changes_anywhere_costs_its_frame_alone_and_is_named() {
        let whole = file();
        let frames = Scan::of(&whole).frames;
        assert_eq!((frames.len(), frames[3].place().end), (4, whole.len()));
        for at in 0..whole.len() {
            for bit in 0..8 {
                let mut bytes = whole.clone();
                bytes[at] ^= 1 << bit;
                let scan = Scan::of(&bytes);
                let hit = frames.iter().position(|frame| frame.place().contains(&at)).unwrap();
                assert_eq!(scan.damaged, [(hit + 1, frames[hit].place())], "bit {bit} of byte {at}");
                let others: Vec<_> = frames.iter().filter(|frame| **frame != frames[hit]).cloned().collect();
                assert_eq!((scan.frames, scan.end), (others, whole.len()));
            }
        }
    }

    #[test]
    fn a_torn_end_is_cut_off_without_a_word() {
        let whole = file();
        let last = Scan::of(&whole).frames[3].place();
        for end in last.start..last.end {
            for zeros in [0, 100] {
                let torn = [&whole[..end], &vec![0; if end == last.start { zeros } else { 0 }]].concat();
                let scan = Scan::of(&torn);
                assert_eq!((keys(&torn, &scan), scan.damaged.len(), scan.end), ("ab".into(), 0, last.start), "{end}");
            }
        }
    }

    #[test]
    fn few_are_named_and_the_rest_is_counted() {
        let scan = |count| Scan { damaged: (1..=count).map(|n| (n, 10 * n..10 * n + 9)).collect(), ..Scan::default() };
        assert_eq!(scan(0).damage(), None);
        assert_eq!(scan(1).damage().unwrap(), "frame 1 (bytes 10 to 18) does not match its check sum");
        let many = scan(7).damage().unwrap();
        assert!(many.ends_with("5 (bytes 50 to 58) and 2 more do not match their check sums"), "{many}");
    }
}
