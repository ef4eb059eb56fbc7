//! A random rough profile.

use super::heights::{Heights, HeightsError};
use serde::{Deserialize, Serialize};
use std::f64::consts::TAU;
use std::fmt::Write;

/// A self-affine profile by its spectrum: waves of the wavelengths L/n of its length L, between two cut-offs, with amplitudes in
/// proportion to n^-(Hu + 1/2), so that heights apart by δ differ by about δ^Hu, and with random phases. The same for the same
/// seed, on every machine.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct SelfAffine {
    /// Hu, Hurst's exponent, 0 to 1: the smaller, the rougher in the small
    pub hurst: f64,
    /// Root mean square of the heights, nm
    pub roughness: f64,
    /// Longest and shortest wave, nm
    pub longest: f64,
    /// Shortest wave, nm
    pub shortest: f64,
    /// L, nm
    pub length: f64,
    /// Of the random phases: the same seed gives the same profile
    pub seed: u64,
}

/// Heights that are given of the shortest wave.
const A_WAVE: f64 = 8.0;

impl SelfAffine {
    /// The profile as a CSV with the columns `x_nm` and `height_nm`, to a nanometre's 1e-9; its mean is zero.
    pub fn table(&self) -> String {
        let mut text = String::from("x_nm,height_nm\n");
        for [place, height] in self.rows() {
            let _ = writeln!(text, "{place:.9},{height:.9}");
        }
        text
    }

    /// The same through a spline.
    pub fn heights(&self) -> Result<Heights, HeightsError> {
        // as a reader of the table has them
        let printed = |value: f64| format!("{value:.9}").parse().unwrap_or(value);
        let (places, values) = self.rows().into_iter().map(|[place, height]| (printed(place), printed(height))).unzip();
        Heights::new(places, values)
    }

    /// Places and heights, nm.
    fn rows(&self) -> Vec<[f64; 2]> {
        let (first, last) = ((self.length / self.longest).ceil().max(1.0), (self.length / self.shortest).floor());
        let mut phases = SplitMix(self.seed);
        let mut waves = Vec::new();
        let mut n = first;
        while n <= last {
            waves.push((n, n.powf(-self.hurst - 0.5), TAU * phases.next()));
            n += 1.0;
        }
        let square: f64 = waves.iter().map(|wave| 0.5 * wave.1 * wave.1).sum();
        let scale = self.roughness / square.sqrt();
        let rows = (A_WAVE * self.length / self.shortest).ceil() as usize;
        let row = |row: usize| {
            let part = row as f64 / rows as f64;
            let height: f64 = waves.iter().map(|(n, a, phase)| a * (TAU * n * part + phase).cos()).sum();
            [self.length * part, scale * height]
        };
        (0..=rows).map(row).collect()
    }
}

/// Steele, Lea and Flood's SplitMix64 (OOPSLA 2014). Its stream defines the profile of a seed, and with it what was computed on such
/// ground: another generator would give other profiles. The mechanics draw no other random number.
struct SplitMix(u64);

impl SplitMix {
    /// From 0 to 1.
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    const ROUGH: SelfAffine =
        SelfAffine { hurst: 0.8, roughness: 2.0, longest: 200.0, shortest: 20.0, length: 400.0, seed: 7 };

    #[test]
    fn roughness_and_mean_are_as_asked_for() {
        let heights = ROUGH.heights().unwrap();
        let values: Vec<f64> = (0..160).map(|k| heights.at(2.5 * f64::from(k))[0]).collect();
        let mean = values.iter().sum::<f64>() / 160.0;
        let square = values.iter().map(|v| v * v).sum::<f64>() / 160.0;
        assert!(mean.abs() < 1e-6, "{mean}");
        assert_relative_eq!(square.sqrt(), 2.0, max_relative = 1e-6);
        assert_eq!(ROUGH.table(), ROUGH.table());
        assert_ne!(ROUGH.table(), SelfAffine { seed: 8, ..ROUGH }.table());
    }

    /// The amplitude of each wave is the power law's, by the sum over a period.
    #[test]
    fn its_spectrum_is_a_power_law() {
        let heights = ROUGH.heights().unwrap();
        let amplitude = |n: f64| {
            let sums = (0..160).fold((0.0, 0.0), |(re, im), k| {
                let (sin, cos) = (TAU * n * f64::from(k) / 160.0).sin_cos();
                let height = heights.at(2.5 * f64::from(k))[0];
                (re + height * cos, im + height * sin)
            });
            sums.0.hypot(sums.1)
        };
        assert_relative_eq!(amplitude(16.0) / amplitude(2.0), 8f64.powf(-1.3), max_relative = 1e-6);
        assert!(amplitude(1.0) < 1e-6 && amplitude(21.0) < 1e-6);
    }
}
