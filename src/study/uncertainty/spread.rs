//! What independent replicates say of a number: its estimate, and how far that may be off by chance.

use statrs::distribution::{ContinuousCDF, StudentsT};

/// Probability with which a true value is within its error.
pub const CONFIDENCE: f64 = 0.95;

/// A number estimated from samples.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Estimate {
    /// The estimate
    pub value: f64,
    /// Half the width of its confidence interval of 95 %
    pub error: f64,
}

/// Half the width of the confidence interval of a mean of independent numbers of the same distribution, by Student's t.
pub(super) fn error_of_mean(numbers: &[f64]) -> f64 {
    let count = numbers.len() as f64;
    if numbers.len() < 2 {
        return f64::INFINITY;
    }
    let mean = numbers.iter().sum::<f64>() / count;
    let variance = numbers.iter().map(|x| (x - mean).powi(2)).sum::<f64>() / (count - 1.0);
    student(numbers.len() - 1) * (variance / count).sqrt()
}

/// The t of the confidence interval.
fn student(freedoms: usize) -> f64 {
    StudentsT::new(0.0, 1.0, freedoms as f64).map_or(f64::INFINITY, |law| law.inverse_cdf(0.5 * (1.0 + CONFIDENCE)))
}

/// The quotient of two sums, each over replicates, with what its spread from replicate to replicate says of its error: of x/y that is the
/// spread of (xᵣ - x/y yᵣ)/ȳ.
pub(super) fn quotient(parts: &[(f64, f64)]) -> Estimate {
    let sum = |of: fn(&(f64, f64)) -> f64| parts.iter().map(of).sum::<f64>();
    let (above, below) = (sum(|part| part.0), sum(|part| part.1));
    let value = above / below;
    let scale = below / parts.len() as f64;
    let residuals: Vec<f64> = parts.iter().map(|(x, y)| (x - value * y) / scale).collect();
    Estimate { value, error: error_of_mean(&residuals) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    #[test]
    fn students_t_is_that_of_the_tables() {
        assert_relative_eq!(student(9), 2.262_157_16, max_relative = 1e-8);
        assert_relative_eq!(student(1), 12.706_204_74, max_relative = 1e-8);
    }

    #[test]
    fn the_error_of_a_mean_is_that_of_students_t() {
        // mean 3, standard deviation √2.5
        let error = error_of_mean(&[1.0, 2.0, 3.0, 4.0, 5.0]);
        assert_relative_eq!(error, 2.776_445_105 * (2.5f64 / 5.0).sqrt(), max_relative = 1e-8);
        assert_eq!(error_of_mean(&[1.0]), f64::INFINITY);
    }

    #[test]
    fn a_quotient_that_is_the_same_in_all_replicates_has_no_error() {
        let found = quotient(&[(2.0, 1.0), (6.0, 3.0), (4.0, 2.0)]);
        assert_eq!((found.value, found.error), (2.0, 0.0));
    }
}
