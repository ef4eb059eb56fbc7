//! Width and height along a body as design variables: values at places evenly along it, with the monotone cubic of
//! [`ProfileTable`] between them.

use super::problem::{ConstraintKind, DesignConstraint, DesignVariable, ProfileColumn};
use crate::model::body::Body;
use crate::model::body::profile::{Profile, ProfileColumns, ProfileForm, ProfileTable};
use crate::model::peel::PeelModel;
use crate::study::parameters::limit_point_continuation::result::Spacing;
use gauss_quad::GaussLegendre;
use std::num::NonZeroUsize;

/// The outline of a body by rows evenly along it.
#[derive(Clone, Debug, PartialEq)]
pub struct ProfileDesign {
    columns: ProfileColumns,
}

impl ProfileDesign {
    /// Fewest and most values of a profile.
    pub const VALUES: std::ops::RangeInclusive<usize> = 5..=40;

    /// The outline of a strip or a profile by `rows` rows; none of a spatula, whose outline is not a table.
    pub fn of(model: &PeelModel, rows: usize) -> Option<Self> {
        if matches!(model.body, Body::Spatula(_)) || rows < 2 {
            return None;
        }
        let (geometry, length) = (model.body.geometry(), model.length());
        let mut columns = ProfileColumns::default();
        for row in 0..rows {
            let place = if row + 1 == rows { length } else { length * row as f64 / (rows - 1) as f64 };
            let section = geometry.at(place);
            columns.places.push(place);
            columns.widths.push(section.width);
            columns.heights.push(section.height[0]);
            columns.angles.push(section.underside[0].to_degrees());
            columns.roundness.push(section.roundness);
        }
        Some(Self { columns })
    }

    /// The values of a column at the rows, nm.
    pub fn values(&self, column: ProfileColumn) -> &[f64] {
        match column {
            ProfileColumn::Width => &self.columns.widths,
            ProfileColumn::Height => &self.columns.heights,
        }
    }

    /// The design variables of a column, with the same bounds at all rows, nm.
    pub fn variables(&self, column: ProfileColumn, lower: f64, upper: f64) -> Vec<DesignVariable> {
        let length = self.columns.places.last().copied().unwrap_or(f64::NAN);
        let variable = |place: &f64| DesignVariable {
            name: format!("{}_nm at s_nm = {}", column.word(), rounded(*place)),
            lower,
            upper,
            spacing: Spacing::Linear,
            along: Some((column, place / length)),
        };
        self.columns.places.iter().map(variable).collect()
    }

    /// The model with these values in place of those of the columns; none where they are no outline.
    pub fn shaped(&self, model: &PeelModel, values: &[(ProfileColumn, &[f64])]) -> Option<PeelModel> {
        let mut columns = self.columns.clone();
        for &(column, values) in values {
            match column {
                ProfileColumn::Width => columns.widths = values.to_vec(),
                ProfileColumn::Height => columns.heights = values.to_vec(),
            }
        }
        let form = ProfileForm::Table(ProfileTable::new(columns).ok()?);
        Some(PeelModel { body: Body::Profile(Profile { form, material: model.material() }), ..model.clone() })
    }

    /// Smoothness: from row to row the value of a column changes by at most `slope` per length, up or down. The variables of the column
    /// begin at `first`. A change of 1 means one of `scale`, nm.
    pub fn smoothness(
        &self,
        column: ProfileColumn,
        first: usize,
        slope: f64,
        scale: f64,
    ) -> Vec<DesignConstraint<'static>> {
        let mut constraints = Vec::new();
        for (row, pair) in self.columns.places.windows(2).enumerate() {
            let (from, step) = (first + row, pair[1] - pair[0]);
            for (sign, word) in [(1.0, "up"), (-1.0, "down")] {
                let function = move |values: &[f64]| (sign * (values[from + 1] - values[from]) - slope * step) / scale;
                constraints.push(DesignConstraint {
                    name: format!(
                        "slope of {} {word}, s_nm = {} to {}",
                        column.word(),
                        rounded(pair[0]),
                        rounded(pair[1])
                    ),
                    kind: ConstraintKind::AtMost,
                    function: Box::new(function),
                });
            }
        }
        constraints
    }
}

/// A place as a name has it, to a thousandth of a nm.
fn rounded(place: f64) -> f64 {
    (place * 1e3).round() / 1e3
}

/// Points of a quadrature that is exact for cubics of width, height and roundness.
const POINTS: NonZeroUsize = NonZeroUsize::MIN.saturating_add(4);

/// Volume of the body of a model, ∫ A dS, nm³.
pub fn volume(model: &PeelModel) -> f64 {
    let mut ends = vec![0.0];
    ends.extend(model.breaks());
    ends.push(model.length());
    let modulus = model.material().youngs_modulus;
    let area = |place: f64| model.section_at(place).0.axial / modulus;
    let rule = GaussLegendre::new(POINTS);
    ends.windows(2).map(|pair| rule.integrate(pair[0], pair[1], area)).sum()
}
