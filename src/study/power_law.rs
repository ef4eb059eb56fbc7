//! A power law through points.

/// c and n of y = c xⁿ, by least squares in logarithms over points with x, y > 0.
pub fn power_law(points: impl IntoIterator<Item = (f64, f64)>) -> (f64, f64) {
    let data: Vec<(f64, f64)> = points.into_iter().map(|(x, y)| (x.ln(), y.ln())).collect();
    let count = data.len() as f64;
    let (x, y) = data.iter().fold((0.0, 0.0), |(x, y), d| (x + d.0 / count, y + d.1 / count));
    let (xy, xx) = data.iter().fold((0.0, 0.0), |(a, b), d| (a + (d.0 - x) * (d.1 - y), b + (d.0 - x).powi(2)));
    let exponent = xy / xx;
    ((y - exponent * x).exp(), exponent)
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    #[test]
    fn finds_the_law_behind_its_points() {
        let (factor, exponent) = power_law([0.1f64, 1.0, 3.0, 70.0].map(|x| (x, 2.5 * x.powf(-0.25))));
        assert_relative_eq!(factor, 2.5, max_relative = 1e-13);
        assert_relative_eq!(exponent, -0.25, max_relative = 1e-13);
    }
}
