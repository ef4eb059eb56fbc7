//! The mean of a function over the width of a face, with its own error control.
//!
//! Each part of the width is integrated by Kronrod's rule of 15 points and by Gauss's of 7 among them, and halved until
//! the estimate of QUADPACK, r min(1, (200 |K - G|/r)^(3/2)) with r = ∫ |f - mean|, is below 1e-13 of ∫ |f|.
//!
//! Source: R. Piessens, E. de Doncker-Kapenga, C. W. Überhuber, D. K. Kahaner, QUADPACK (1983).

/// Relative to the integral of what is integrated without its sign.
const TOLERANCE: f64 = 1e-13;
/// Below this no halving helps: round-off.
const ROUND_OFF: f64 = 50.0 * f64::EPSILON;
/// How often a part is halved, and how many parts there are, at most: a function that is not computed to its round-off
/// has no better mean.
const DEEPEST: u32 = 24;
const MOST_PARTS: u32 = 1000;

/// Kronrod's points above zero on [-1, 1], their weights, and those of Gauss, which are at every other point.
const POINTS: [f64; 8] = [
    0.991_455_371_120_812_6,
    0.949_107_912_342_758_5,
    0.864_864_423_359_769_1,
    0.741_531_185_599_394_4,
    0.586_087_235_467_691_1,
    0.405_845_151_377_397_2,
    0.207_784_955_007_898_47,
    0.0,
];
const KRONROD: [f64; 8] = [
    0.022_935_322_010_529_224,
    0.063_092_092_629_978_56,
    0.104_790_010_322_250_19,
    0.140_653_259_715_525_92,
    0.169_004_726_639_267_9,
    0.190_350_578_064_785_4,
    0.204_432_940_075_298_9,
    0.209_482_141_084_727_82,
];
const GAUSS: [f64; 4] =
    [0.129_484_966_168_869_7, 0.279_705_391_489_276_64, 0.381_830_050_505_118_9, 0.417_959_183_673_469_4];

/// Of several functions at once.
struct Part<const K: usize> {
    from: f64,
    to: f64,
    integral: [f64; K],
    /// The integral without signs
    size: [f64; K],
    error: [f64; K],
}

impl<const K: usize> Part<K> {
    fn new(from: f64, to: f64, f: &impl Fn(f64) -> [f64; K]) -> Self {
        let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
        // those at -x and x in turn; the last two are the one in the middle
        let values: [[f64; K]; 16] = std::array::from_fn(|i| {
            let x = if i % 2 == 0 { -POINTS[i / 2] } else { POINTS[i / 2] };
            if i < 15 { f(middle + half * x) } else { [0.0; K] }
        });
        let (mut kronrod, mut gauss, mut size, mut spread) = ([0.0; K], [0.0; K], [0.0; K], [0.0; K]);
        for i in 0..15 {
            let weight = KRONROD[i / 2];
            let other = if (i / 2) % 2 == 1 { GAUSS[i / 4] } else { 0.0 };
            for k in 0..K {
                kronrod[k] += weight * values[i][k];
                gauss[k] += other * values[i][k];
                size[k] += half * weight * values[i][k].abs();
            }
        }
        for i in 0..15 {
            for k in 0..K {
                spread[k] += KRONROD[i / 2] * (values[i][k] - 0.5 * kronrod[k]).abs();
            }
        }
        let error = std::array::from_fn(|k| {
            let ratio = if spread[k] > 0.0 { 200.0 * (kronrod[k] - gauss[k]).abs() / spread[k] } else { 0.0 };
            half * spread[k] * (ratio * ratio.sqrt()).min(1.0)
        });
        let integral = kronrod.map(|sum| half * sum);
        Self { from, to, integral, size, error }
    }

    /// The integral, of halves of the part where it is not yet good enough beside that of the whole width without
    /// signs.
    fn refined(self, f: &impl Fn(f64) -> [f64; K], whole: &[f64; K], depth: u32, halved: &mut u32) -> [f64; K] {
        let poor = (0..K).any(|k| {
            let allowed = (TOLERANCE * whole[k]).max(ROUND_OFF * self.size[k]);
            self.error[k] > allowed
        });
        if !poor || depth == DEEPEST || *halved >= MOST_PARTS {
            return self.integral;
        }
        *halved += 1;
        let middle = 0.5 * (self.from + self.to);
        let low = Self::new(self.from, middle, f);
        let high = Self::new(middle, self.to, f);
        let low = low.refined(f, whole, depth + 1, halved);
        let high = high.refined(f, whole, depth + 1, halved);
        std::array::from_fn(|k| low[k] + high[k])
    }
}

/// ∫ f(s) ds from -1/2 to 1/2. Between the `breaks`, ascending, f is smooth; those outside do not count.
pub(super) fn mean<const K: usize>(breaks: impl Iterator<Item = f64>, f: impl Fn(f64) -> [f64; K]) -> [f64; K] {
    const MOST: usize = 32;
    let mut ends = [0.5; MOST];
    let mut count = 0;
    for place in breaks.filter(|place| place.abs() < 0.5) {
        if count < MOST - 1 {
            ends[count] = place;
            count += 1;
        }
    }
    let part = |i: usize| Part::new(if i == 0 { -0.5 } else { ends[i - 1] }, ends[i], &f);
    let parts: [Option<Part<K>>; MOST] = std::array::from_fn(|i| (i <= count).then(|| part(i)));
    let mut whole = [0.0; K];
    for part in parts.iter().flatten() {
        whole = std::array::from_fn(|k| whole[k] + part.size[k]);
    }
    let (mut sum, mut halved) = ([0.0; K], 0);
    for part in parts.into_iter().flatten() {
        let integral = part.refined(&f, &whole, 0, &mut halved);
        sum = std::array::from_fn(|k| sum[k] + integral[k]);
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// Kronrod's rule of 15 points is exact up to degree 23, Gauss's of 7 up to 13.
    #[test]
    fn the_rules_are_exact_up_to_their_degrees() {
        for degree in (0..=22).step_by(2) {
            let moment = |weights: &[f64], step: usize| -> f64 {
                let points = POINTS.iter().skip(step - 1).step_by(step);
                let sum: f64 = points.zip(weights).map(|(x, w)| w * x.powi(degree)).sum();
                // the one in the middle is there once
                2.0 * sum - if degree == 0 { weights[weights.len() - 1] } else { 0.0 }
            };
            let exact = 2.0 / (f64::from(degree) + 1.0);
            assert_relative_eq!(moment(&KRONROD, 1), exact, max_relative = 1e-14);
            if degree <= 12 {
                assert_relative_eq!(moment(&GAUSS, 2), exact, max_relative = 1e-14);
            }
        }
    }

    /// Smooth, steep, and with a kink, at a break and not at one.
    #[test]
    fn means_are_those_of_the_primitive() {
        for rise in [1e-3, 1.0, 30.0, 400.0f64] {
            let at = |breaks: &[f64]| mean(breaks.iter().copied(), |s| [(-rise * (s + 0.5)).exp(), (s - 0.1).abs()]);
            for [steep, kinked] in [at(&[]), at(&[0.1]), at(&[-0.4, 0.1, 0.3])] {
                assert_relative_eq!(steep, -(-rise).exp_m1() / rise, max_relative = 1e-13);
                assert_relative_eq!(kinked, 0.5 * (0.36 + 0.16), max_relative = 1e-12);
            }
        }
    }

    /// What is not a number, or has no digits, ends.
    #[test]
    fn there_is_an_end() {
        assert!(mean(std::iter::empty(), |_| [f64::NAN])[0].is_nan());
        let count = std::cell::Cell::new(0);
        let noise = |s: f64| {
            count.set(count.get() + 1);
            [1.0 + 1e-3 * (s * 1e9).sin()]
        };
        assert!((mean(std::iter::empty(), noise)[0] - 1.0).abs() < 1e-3);
        assert!(count.get() <= 30 * MOST_PARTS);
    }
}
