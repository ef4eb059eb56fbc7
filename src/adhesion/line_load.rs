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
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct LineResponse {
    /// Ψ, nN/nm
    pub energy: f64,
    /// -T_c, nN/nm²
    pub by_gap: f64,
    /// -M_c, nN/nm
    pub by_rotation: f64,
    /// ∂Ψ/∂θ, nN/nm; equal to `by_rotation` where the load has a potential
    pub energy_by_rotation: f64,
    /// ∂(-T_c)/∂y, nN/nm³
    pub gap_gap: f64,
    /// ∂(-T_c)/∂θ, nN/nm²
    pub gap_rotation: f64,
    /// ∂(-M_c)/∂y, nN/nm²; equal to `gap_rotation` where the load has a potential
    pub rotation_gap: f64,
    /// ∂(-M_c)/∂θ, nN/nm
    pub rotation_rotation: f64,
}

impl LineLaw {
    /// The response at the gap η = y - h/2 (nm) and the rotation θ, given as its sine and cosine.
    #[inline(always)]
    pub fn response(&self, gap: f64, sin: f64, cos: f64) -> LineResponse {
        match (self.line_load, self.far_face) {
            (LineLoad::AxisGap, _) => self.axis_gap(gap),
            (LineLoad::Full, true) => self.both_faces(gap, sin, cos),
            (LineLoad::Full, false) => self.near_face(gap, sin, cos),
            (LineLoad::ForceOnly, true) => without_moment(self.both_faces(gap, sin, cos)),
            (LineLoad::ForceOnly, false) => without_moment(self.near_face(gap, sin, cos)),
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
    fn both_faces(&self, gap: f64, sin: f64, cos: f64) -> LineResponse {
        let h = self.height;
        let r0_squared = self.half_space.equilibrium_distance * self.half_space.equilibrium_distance;
        let lift = if cos > 0.0 { sin * sin / (1.0 + cos) } else { 1.0 - cos };
        let r1 = gap + 0.5 * h * lift;
        let r2 = r1 + h * cos;
        let y = gap + 0.5 * h;
        let (d, a) = (r1 * r2, r1 * r1 + r2 * r2);
        let v = 1.0 / d;
        let (dd, aa, ad, yy) = (d * d, a * a, a * d, y * y);

        let g = a * (aa - 2.0 * dd);
        let g_y = y * (12.0 * aa - 8.0 * dd - 8.0 * ad);
        let g_a = 6.0 * aa - 4.0 * dd + 4.0 * ad;
        let g_yy = 12.0 * aa - 8.0 * dd - 8.0 * ad + yy * (80.0 * a - 64.0 * d);
        let g_ya = 56.0 * a * y;
        let g_aa = 20.0 * a + 16.0 * d;
        // e = g / D⁸; every derivative is v⁸ times what is in brackets
        let vg = v * g;
        let first_y = g_y - 16.0 * y * vg;
        let first_a = g_a + 8.0 * vg;
        let second_yy = g_yy - 16.0 * vg - 16.0 * y * v * g_y + 32.0 * yy * v * vg - 16.0 * y * v * first_y;
        let second_ya = g_ya - 16.0 * y * v * (g_a + vg) + 8.0 * v * first_y;
        let second_aa = g_aa + 8.0 * v * (g_a + vg) + 8.0 * v * first_a;

        let v2 = v * v;
        let v3 = v2 * v;
        let v4 = v2 * v2;
        // K (h/r0) 2 r0³ r0⁶/360 and K (h/r0) 2 r0³/6 with K = A_H/(2π r0²)
        let attract = self.half_space.hamaker_constant * h / (6.0 * std::f64::consts::PI);
        let repel = attract * r0_squared * r0_squared * r0_squared * (v4 * v4) / 60.0;

        let energy = repel * y * g - attract * y * v2;
        let by_y = repel * (g + y * first_y) - attract * (v2 - 4.0 * yy * v3);
        let by_a = repel * y * first_a - attract * 2.0 * y * v3;
        let yy2 = repel * (2.0 * first_y + y * second_yy) - attract * y * (24.0 * yy * v4 - 12.0 * v3);
        let ya = repel * (first_a + y * second_ya) - attract * (2.0 * v3 - 12.0 * yy * v4);
        let aa2 = repel * y * second_aa - attract * 6.0 * y * v4;

        let a_t = -0.5 * h * h * sin * cos;
        let a_tt = -0.5 * h * h * (cos - sin) * (cos + sin);
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
    fn near_face(&self, gap: f64, sin: f64, cos: f64) -> LineResponse {
        let (s, c) = if cos < 0.0 { (-sin, -cos) } else { (sin, cos) };
        let half = 0.5 * self.height;
        let r1 = gap + half * (s * s / (1.0 + c));
        let w = self.half_space.potential(r1);
        let t = self.half_space.traction(r1);
        let b = self.half_space.body_force(r1);
        let (ic, tan) = (1.0 / c, s / c);
        let mixed = b * half * tan - t * s * ic * ic;
        let by_rotation = -t * half * tan + w * tan * ic;
        LineResponse {
            energy: w * ic,
            by_gap: -t * ic,
            by_rotation,
            energy_by_rotation: by_rotation,
            gap_gap: b * ic,
            gap_rotation: mixed,
            rotation_gap: mixed,
            rotation_rotation: b * half * half * s * tan - t * half * (ic * ic + tan * tan)
                + w * (ic + 2.0 * tan * tan * ic),
        }
    }

    /// Blind to tilt: W(η) - W(η + h).
    #[inline(always)]
    fn axis_gap(&self, gap: f64) -> LineResponse {
        let mut response = LineResponse {
            energy: self.half_space.potential(gap),
            by_gap: -self.half_space.traction(gap),
            gap_gap: self.half_space.body_force(gap),
            ..LineResponse::default()
        };
        if self.far_face {
            let top = gap + self.height;
            response.energy -= self.half_space.potential(top);
            response.by_gap += self.half_space.traction(top);
            response.gap_gap -= self.half_space.body_force(top);
        }
        response
    }
}

#[inline(always)]
fn without_moment(full: LineResponse) -> LineResponse {
    LineResponse { by_rotation: 0.0, rotation_gap: 0.0, rotation_rotation: 0.0, ..full }
}
