//! One value of a sweep of pulls.

/// One value of a sweep and what was found of its pull.
#[derive(Clone, Debug)]
pub struct PullRow<F> {
    /// The value of the varied parameter, in its own unit.
    pub value: f64,
    /// The value of the second one, where two are varied.
    pub second: Option<f64>,
    /// What was found, or why there is no pull.
    pub found: Result<F, String>,
    /// Wall clock that it took, s.
    pub solve_s: f64,
}
