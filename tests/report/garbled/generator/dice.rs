//! Choices, taken from bytes.

/// As many bytes as a scene takes.
pub const BYTES: usize = 256;

/// Choices taken from bytes; behind their end everything is zero.
pub struct Dice<'a>(std::slice::Iter<'a, u8>);

impl<'a> Dice<'a> {
    pub fn new(bytes: &'a [u8]) -> Self {
        Self(bytes.iter())
    }

    /// One of 65536 values.
    pub(super) fn number(&mut self) -> u16 {
        let mut byte = || self.0.next().copied().unwrap_or(0);
        u16::from_le_bytes([byte(), byte()])
    }

    pub fn below(&mut self, count: usize) -> usize {
        usize::from(self.number()) % count.max(1)
    }

    pub(super) fn pick<T: Copy>(&mut self, choices: &[T]) -> T {
        choices[self.below(choices.len())]
    }

    pub(super) fn between(&mut self, from: f64, to: f64) -> f64 {
        from + (to - from) * f64::from(self.number()) / 65535.0
    }

    /// At equal ratios.
    pub(super) fn decades(&mut self, from: f64, to: f64) -> f64 {
        10f64.powf(self.between(from.log10(), to.log10()))
    }
}
