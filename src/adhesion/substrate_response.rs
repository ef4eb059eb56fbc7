//! The line load of a beam section on ground of any shape.
//!
//! The ground is replaced by its tangent plane at the point nearest to the axis, eqs. (8) and (9), and the section sees that
//! plane at the gap g = d - h/2 and the angle α = θ - φ. Per length and width the energy is Ψ(g, α), and the load is minus its
//! gradient,
//!
//!   ∂Ψ/∂(x, y) = Ψ_g n - Ψ_α μ t,   ∂Ψ/∂θ = Ψ_α,
//!
//! with n, t and μ as in [`super`]. Ψ_g n is the line force of eq. (17), along n_p, and Ψ_α the line moment of eq. (20); the
//! paper has no more. The second term, M_c κ/(1 - κd) along the ground, is what it takes for the load to keep its potential:
//! a section that moves along curved ground turns towards it. It vanishes where the ground is flat or the section parallel
//! to it. The second derivatives are, in the axes t and n, with the law's own derivatives of force and moment,
//!
//!   tt: μ² Ψ_αα - μ Ψ_g - κ'/(1 - κd)³ Ψ_α,   tn = nt: -μ Ψ_gα - μ² Ψ_α,   nn: Ψ_gg,
//!   tθ: -μ Ψ_αα,   nθ: Ψ_gα,   θθ: Ψ_αα.

use crate::adhesion::section::line_load::LineLaw;
use crate::adhesion::substrate::Substrate;
use crate::number::Real;

/// A line law on ground of any shape.
#[derive(Clone, Debug, PartialEq)]
pub struct GroundLaw {
    /// The law above level ground
    pub law: LineLaw,
    /// The shape of the ground
    pub substrate: Substrate,
}

/// Potential and load of a section per length and width, with the tangent, by x, y and θ. The load is minus the gradient.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GroundResponse<T> {
    /// Ψ, nN/nm
    pub energy: T,
    /// Minus the load: nN/nm², nN/nm², nN/nm
    pub gradient: [T; 3],
    /// Of Ψ; equal to `gradient` where the load has a potential
    pub energy_gradient: [T; 3],
    /// Of `gradient` (rows: the component, columns: by what)
    pub tangent: [[T; 3]; 3],
}

impl GroundLaw {
    /// The response of a section of this height (nm) whose axis is at x, h/2 above the `gap` (nm), with the rotation θ given as
    /// its sine and cosine.
    #[inline(never)]
    pub fn response<T: Real>(&self, height: T, [x, gap]: [T; 2], [sin, cos]: [T; 2]) -> GroundResponse<T> {
        let half = height * 0.5;
        let [distance, foot_sin, foot_cos, curvature, curvature_slope] = x.each_pair(gap + half, |x, y| {
            let foot = self.substrate.project(x, y);
            [foot.distance, foot.sin, foot.cos, foot.curvature, foot.curvature_slope]
        });
        let (sin, cos) = (sin * foot_cos - cos * foot_sin, cos * foot_cos + sin * foot_sin);
        let section = self.law.response_of(height, distance - half, sin, cos);

        // 1/(1 - κd), μ, and κ'/(1 - κd)³
        let widened = (T::splat(1.0) - curvature * distance).recip();
        let turn = curvature * widened;
        let turn_slope = curvature_slope * widened * widened * widened;
        // in the axes t and n
        let along = -(section.by_rotation * turn);
        let tt = section.rotation_rotation * turn * turn - section.by_gap * turn - section.by_rotation * turn_slope;
        let tn = -(section.rotation_gap * turn) - section.by_rotation * turn * turn;
        let nt = -(section.gap_rotation * turn) - section.by_rotation * turn * turn;
        let nn = section.gap_gap;
        let (t_rotation, rotation_t) = (-(section.rotation_rotation * turn), -(section.rotation_rotation * turn));

        let (s, c) = (foot_sin, foot_cos);
        let turned = |along: T, across: T| [along * c - across * s, along * s + across * c];
        // rows first, then columns
        let [x_t, y_t] = turned(tt, nt);
        let [x_n, y_n] = turned(tn, nn);
        let ([xx, xy], [yx, yy]) = (turned(x_t, x_n), turned(y_t, y_n));
        let [x_rotation, y_rotation] = turned(t_rotation, section.gap_rotation);
        let [rotation_x, rotation_y] = turned(rotation_t, section.rotation_gap);
        let [by_x, by_y] = turned(along, section.by_gap);
        let energy_along = -(section.energy_by_rotation * turn);
        let [energy_by_x, energy_by_y] = turned(energy_along, section.by_gap);
        GroundResponse {
            energy: section.energy,
            gradient: [by_x, by_y, section.by_rotation],
            energy_gradient: [energy_by_x, energy_by_y, section.energy_by_rotation],
            tangent: [[xx, xy, x_rotation], [yx, yy, y_rotation], [rotation_x, rotation_y, section.rotation_rotation]],
        }
    }
}
