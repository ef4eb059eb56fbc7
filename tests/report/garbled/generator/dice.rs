//! Choices, taken from bytes or from a seed.

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

/// Steele, Lea and Flood's SplitMix64, from a seed.
pub struct Random(pub u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// As many as a scene takes.
    pub fn bytes(&mut self) -> Vec<u8> {
        (0..32).flat_map(|_| self.next().to_le_bytes()).collect()
    }
}
