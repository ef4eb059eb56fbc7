//! The line load of a beam section above a flat half space, eqs. (17)-(22), and its potential.
//!
//! A section of height h at the angle θ has its axis at y, its bottom edge at r1 = y - (h/2) cos θ and its top edge at
//! r2 = y + (h/2) cos θ. Per length and width
//!
//!   Ψ(y, θ) = [W(r1) - W(r2)] / cos θ,   T_c = -∂Ψ/∂y,   M_c = -∂Ψ/∂θ.
//!
//! The paper gives T_c and M_c and does not say that they have this potential. At cos θ = 0 the quotient is 0/0; with
//! D = r1 r2 and α = r1² + r2² the differences of powers divide out,
//!
//!   Ψ = (A_H h/π) y [ r0⁶ α (α² - 2D²) / (360 D⁸) - 1 / (6 D²) ],
//!
//! which has no cancellation at any angle and is even in cos θ. Heights enter as the gap η = y - h/2, so that the small
//! number is stored and not recovered from a difference.

use super::HalfSpace;
use crate::number::Real;

/// Which distributed load the adhesion puts on the axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LineLoad {
    /// Line force and line moment, eqs. (17)-(22).
    Full,
    /// The line force of eq. (17) without the moment of eq. (20); it has no potential.
    ForceOnly,
    /// The traction at the gap below the axis, blind to tilt: Ψ = W(y - h/2) - W(y + h/2).
    AxisGap,
}

/// The law of one section: half space, height, which load, which faces.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LineLaw {
    pub half_space: HalfSpace,
    /// nm
    pub height: f64,
    pub line_load: LineLoad,
    /// Whether the top face counts (the r2 terms).
    pub far_face: bool,
}

/// Potential and load of a section per length and width, with the tangent. The load is minus the gradient.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LineResponse<T> {
    /// Ψ, nN/nm
    pub energy: T,
    /// -T_c, nN/nm²
    pub by_gap: T,
    /// -M_c, nN/nm
    pub by_rotation: T,
    /// ∂Ψ/∂θ, nN/nm; equal to `by_rotation` where the load has a potential
    pub energy_by_rotation: T,
    /// ∂(-T_c)/∂y, nN/nm³
    pub gap_gap: T,
    /// ∂(-T_c)/∂θ, nN/nm²
    pub gap_rotation: T,
    /// ∂(-M_c)/∂y, nN/nm²; equal to `gap_rotation` where the load has a potential
    pub rotation_gap: T,
    /// ∂(-M_c)/∂θ, nN/nm
    pub rotation_rotation: T,
}

impl LineLaw {
    /// The response at the gap η = y - h/2 (nm) and the rotation θ, given as its sine and cosine.
    #[inline(always)]
    pub fn response<T: Real>(&self, gap: T, sin: T, cos: T) -> LineResponse<T> {
        self.response_of(T::splat(self.height), gap, sin, cos)
    }

    /// The same for a section of another height, nm.
    #[inline(always)]
    pub fn response_of<T: Real>(&self, height: T, gap: T, sin: T, cos: T) -> LineResponse<T> {
        match (self.line_load, self.far_face) {
            (LineLoad::AxisGap, _) => self.axis_gap(height, gap),
            (LineLoad::Full, true) => self.both_faces(height, gap, sin, cos),
            (LineLoad::Full, false) => self.near_face(height, gap, sin, cos),
            (LineLoad::ForceOnly, true) => without_moment(self.both_faces(height, gap, sin, cos)),
            (LineLoad::ForceOnly, false) => without_moment(self.near_face(height, gap, sin, cos)),
        }
    }

    /// Whether the load derives from a potential, so that the tangent is symmetric and energy is conserved.
    pub fn has_potential(&self) -> bool {
        self.line_load != LineLoad::ForceOnly
    }

    /// The gap η at which a flat section is at rest, T_c(η, θ = 0) = 0, nm.
    ///
    /// It lies between the half space's equilibrium gap (no far face) and its strongest gap, because T(r1) = T(r2) < 0.
    pub fn rest_gap(&self) -> f64 {
        let (mut low, mut high) = (self.half_space.equilibrium_gap() * (1.0 - 1e-9), self.half_space.strongest_gap());
        let mut gap = self.half_space.equilibrium_gap();
        for _ in 0..200 {
            let at = self.response(gap, 0.0, 1.0);
            if at.by_gap < 0.0 {
                low = gap
            } else {
                high = gap
            }
            let newton = gap - at.by_gap / at.gap_gap;
            let next = if newton > low && newton < high { newton } else { 0.5 * (low + high) };
            if (next - gap).abs() <= 2.0 * f64::EPSILON * gap {
                return next;
            }
            gap = next;
        }
        gap
    }

    /// Ψ of the flat section at rest, nN/nm: minus the work of adhesion of the strip.
    pub fn rest_energy(&self) -> f64 {
        self.response(self.rest_gap(), 0.0, 1.0).energy
    }

    /// Both faces, exact and free of cancellation at any rotation. In (y, A) with A = (h/2)² cos²θ,
    /// D = y² - A and α = 2(y² + A); g = α(α² - 2D²).
    #[inline(always)]
    fn both_faces<T: Real>(&self, h: T, gap: T, sin: T, cos: T) -> LineResponse<T> {
        let r0_squared = self.half_space.equilibrium_distance * self.half_space.equilibrium_distance;
        let r1 = gap + one_minus(sin, cos) * (h * 0.5);
        let r2 = r1 + cos * h;
        let y = gap + h * 0.5;
        let (d, a) = (r1 * r2, r1 * r1 + r2 * r2);
        let v = d.recip();
        let (dd, aa, ad, yy) = (d * d, a * a, a * d, y * y);
        let yv = y * v;

        let g = a * (aa - dd * 2.0);
        let g_y = y * (aa * 12.0 - dd * 8.0 - ad * 8.0);
        let g_a = aa * 6.0 - dd * 4.0 + ad * 4.0;
        let g_yy = aa * 12.0 - dd * 8.0 - ad * 8.0 + yy * (a * 80.0 - d * 64.0);
        let g_ya = a * y * 56.0;
        let g_aa = a * 20.0 + d * 16.0;
        // e = g / D⁸; every derivative is v⁸ times what is in brackets
        let vg = v * g;
        let first_y = g_y - y * vg * 16.0;
        let first_a = g_a + vg * 8.0;
        let second_yy = g_yy - vg * 16.0 - yv * g_y * 16.0 + yy * v * vg * 32.0 - yv * first_y * 16.0;
        let second_ya = g_ya - yv * (g_a + vg) * 16.0 + v * first_y * 8.0;
        let second_aa = g_aa + v * (g_a + vg) * 8.0 + v * first_a * 8.0;

        let v2 = v * v;
        let v3 = v2 * v;
        let v4 = v2 * v2;
        let attract = h * (self.half_space.hamaker_constant / (6.0 * std::f64::consts::PI));
        let repel = v4 * v4 * (attract * (r0_squared * r0_squared * r0_squared / 60.0));

        let energy = repel * y * g - y * v2 * attract;
        let by_y = repel * (g + y * first_y) - (v2 - yy * v3 * 4.0) * attract;
        let by_a = repel * y * first_a - y * v3 * (attract * 2.0);
        let yy2 = repel * (first_y * 2.0 + y * second_yy) - y * (yy * v4 * 24.0 - v3 * 12.0) * attract;
        let ya = repel * (first_a + y * second_ya) - (v3 * 2.0 - yy * v4 * 12.0) * attract;
        let aa2 = repel * y * second_aa - y * v4 * (attract * 6.0);

        let a_t = sin * cos * (h * h * -0.5);
        let a_tt = (cos - sin) * (cos + sin) * (h * h * -0.5);
        LineResponse {
            energy,
            by_gap: by_y,
            by_rotation: by_a * a_t,
            energy_by_rotation: by_a * a_t,
            gap_gap: yy2,
            gap_rotation: ya * a_t,
            rotation_gap: ya * a_t,
            rotation_rotation: aa2 * a_t * a_t + by_a * a_tt,
        }
    }

    /// The bottom face alone, Ψ = W(r1)/|cos θ|; singular where the section stands on edge.
    #[inline(always)]
    fn near_face<T: Real>(&self, height: T, gap: T, sin: T, cos: T) -> LineResponse<T> {
        let (s, c) = (cos.choose(sin, -sin), cos.choose(cos, -cos));
        let half = height * 0.5;
        let r1 = gap + one_minus(s, c) * half;
        let w = self.half_space.potential(r1);
        let t = self.half_space.traction(r1);
        let b = self.half_space.body_force(r1);
        let ic = c.recip();
        let tan = s * ic;
        let by_rotation = w * tan * ic - t * tan * half;
        let mixed = b * tan * half - t * s * ic * ic;
        LineResponse {
            energy: w * ic,
            by_gap: -t * ic,
            by_rotation,
            energy_by_rotation: by_rotation,
            gap_gap: b * ic,
            gap_rotation: mixed,
            rotation_gap: mixed,
            rotation_rotation: b * s * tan * (half * half) - t * (ic * ic + tan * tan) * half
                + w * (ic + tan * tan * ic * 2.0),
        }
    }

    /// Blind to tilt: W(η) - W(η + h).
    #[inline(always)]
    fn axis_gap<T: Real>(&self, height: T, gap: T) -> LineResponse<T> {
        let near = (self.half_space.potential(gap), self.half_space.traction(gap), self.half_space.body_force(gap));
        let far = if self.far_face {
            let top = gap + height;
            (self.half_space.potential(top), self.half_space.traction(top), self.half_space.body_force(top))
        } else {
            (T::splat(0.0), T::splat(0.0), T::splat(0.0))
        };
        let zero = T::splat(0.0);
        LineResponse {
            energy: near.0 - far.0,
            by_gap: far.1 - near.1,
            by_rotation: zero,
            energy_by_rotation: zero,
            gap_gap: near.2 - far.2,
            gap_rotation: zero,
            rotation_gap: zero,
            rotation_rotation: zero,
        }
    }
}

/// 1 - cos θ without cancellation.
#[inline(always)]
fn one_minus<T: Real>(sin: T, cos: T) -> T {
    cos.choose(sin * sin / (cos + 1.0), T::splat(1.0) - cos)
}

#[inline(always)]
fn without_moment<T: Real>(full: LineResponse<T>) -> LineResponse<T> {
    let zero = T::splat(0.0);
    LineResponse { by_rotation: zero, rotation_gap: zero, rotation_rotation: zero, ..full }
}
