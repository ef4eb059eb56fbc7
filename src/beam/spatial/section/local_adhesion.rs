//! Adhesion at a point of a beam in space, by local changes of its fields; symbols are those of the energy density.

use super::kinematics::{Kinematics, turned_twice};
use super::spatial_profile::Station;
use crate::adhesion::spatial_section::response::SpatialSectionResponse;
use crate::number::Real;

/// Adhesion at a point: energy, the derivatives by y and (α, ω), and what the front is counted by.
pub(crate) struct LocalAdhesion<T> {
    pub energy: T,
    pub by_height: T,
    pub by_value: [T; 4],
    pub height_height: T,
    pub height_value: [T; 4],
    pub value_value: [[T; 4]; 4],
    pub coverage: T,
    pub coverage_by_height: T,
    pub coverage_by_value: [T; 4],
}

impl<T: Real> LocalAdhesion<T> {
    /// None.
    #[inline(always)]
    pub(crate) fn none() -> Self {
        let zero = T::splat(0.0);
        Self {
            energy: zero,
            by_height: zero,
            by_value: [zero; 4],
            height_height: zero,
            height_value: [zero; 4],
            value_value: [[zero; 4]; 4],
            coverage: zero,
            coverage_by_height: zero,
            coverage_by_value: [zero; 4],
        }
    }

    /// Of the response of a section.
    #[inline(always)]
    pub(crate) fn of(response: &SpatialSectionResponse<T>, at: &Kinematics<T>, station: &Station<T>) -> Self {
        let zero = T::splat(0.0);
        let up = at.frame[1];
        let (b, h) = (station.width, station.height);
        let [by_y, by_a, by_c] = response.gradient;
        let [yy, ya, yc, aa, ac, cc] = response.hessian;
        // how a and c change with ω: 2 (e × ω) along d2 and d3
        let (in_a, in_c) = ([up[2] * b * 2.0, zero, -(up[0] * b * 2.0)], [-(up[1] * h * 2.0), up[0] * h * 2.0, zero]);
        let mut out = Self::none();
        (out.energy, out.by_height, out.height_height) = (response.energy, by_y, yy);
        for i in 0..3 {
            out.by_value[i + 1] = by_a * in_a[i] + by_c * in_c[i];
            out.height_value[i + 1] = ya * in_a[i] + yc * in_c[i];
            let (on_a, on_c) = (aa * in_a[i] + ac * in_c[i], ac * in_a[i] + cc * in_c[i]);
            for j in 0..3 {
                out.value_value[i + 1][j + 1] = on_a * in_a[j] + on_c * in_c[j];
            }
        }
        turned_twice([zero, by_a * b, by_c * h], up, &mut out.value_value);
        // as of the planar beam, cos²θ being what the axis covers of the ground: 1 - (d1·e_y)²
        let square = T::splat(1.0) - up[0] * up[0];
        let share = square - (square * square - 1.0) * 0.25;
        let by_rise = -(up[0] * (T::splat(2.0) - square));
        out.coverage = out.energy * share;
        out.coverage_by_height = by_y * share;
        let rise = [zero, -(up[2] * 2.0), up[1] * 2.0];
        for i in 0..3 {
            out.coverage_by_value[i + 1] = out.by_value[i + 1] * share + out.energy * by_rise * rise[i];
        }
        out
    }
}
