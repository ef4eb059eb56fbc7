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

impl<F> PullRow<F> {
    /// A number of what was found, where it was.
    pub(crate) fn of<T>(&self, of: impl FnOnce(&F) -> Option<T>) -> Option<T> {
        self.found.as_ref().ok().and_then(of)
    }
}
