//! Whether a design problem has a meaning, before anything is computed.

use super::failure::NoOptimum;
use super::problem::{ConstraintKind, DesignConstraint, DesignProblem, DesignVariable};

/// How far outside its bounds a variable has a model, in coordinates from 0 to 1: gradients at a bound need that.
const MARGIN: f64 = 1e-3;

impl DesignProblem<'_> {
    /// Whether there is something free, with bounds inside which there are models.
    ///
    /// # Errors
    /// Names the variable, or the constraint, and what is wrong with it.
    pub fn check(&self) -> Result<(), NoOptimum> {
        if self.variables.is_empty() {
            return Err(NoOptimum::NothingFree);
        }
        for DesignVariable { name, lower, upper, .. } in &self.variables {
            let are_bounds = lower.is_finite() && upper.is_finite() && lower < upper;
            if !are_bounds {
                return Err(NoOptimum::Bounds { name: name.clone(), lower: *lower, upper: *upper });
            }
        }
        self.model_at(&self.coordinates(&self.start)).ok_or(NoOptimum::NoModel)?.check()?;
        self.check_bounds()
    }

    /// Whether there is a model at and next to every bound, with the other variables as at the start.
    fn check_bounds(&self) -> Result<(), NoOptimum> {
        let start = self.coordinates(&self.start);
        for (index, variable) in self.variables.iter().enumerate() {
            for end in [-MARGIN, 1.0 + MARGIN] {
                let mut at = start.clone();
                at[index] = end;
                let cause = match self.model_at(&at) {
                    None => Some("it is no such body".to_owned()),
                    Some(model) => model.check().err().map(|error| format!("{} {}", error.key(), error.found())),
                };
                if let Some(cause) = cause {
                    let DesignVariable { name, lower, upper, .. } = variable.clone();
                    return Err(NoOptimum::OutsideRange { name, lower, upper, at: variable.value(end), cause });
                }
            }
        }
        Ok(())
    }

    /// The constraint that is violated most, and by how much.
    pub(super) fn worst_constraint(&self, coordinates: &[f64]) -> Option<(String, f64)> {
        let values = self.values(coordinates);
        let violation = |constraint: &DesignConstraint| {
            let value = (constraint.function)(&values);
            if constraint.kind == ConstraintKind::Equal { value.abs() } else { value }
        };
        let worst = self.constraints.iter().max_by(|a, b| violation(a).total_cmp(&violation(b)))?;
        Some((worst.name.clone(), violation(worst)))
    }
}
