//! Potential and load of a tilted section, and what the laws have in common in computing them.

use crate::number::Real;

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

impl<T: Real> LineResponse<T> {
    /// Nothing.
    #[inline(always)]
    pub(super) fn zero() -> Self {
        Self::blind([T::splat(0.0); 3], None)
    }

    /// Of a nominal traction, per area of reference, on the face that looks down. `levels` gives W (nN/nm), the traction T = -W' (nN/nm²)
    /// and b = -T' (nN/nm³) at the distance r of a face, nm. At the `gap` of a section that is not tilted, nm,
    ///
    ///   Ψ(y, θ) = W(r),  r = y - (h/2) |cos θ|,   T_c = -∂Ψ/∂y,   M_c = -∂Ψ/∂θ = T_c (h/2) sin θ.
    ///
    /// Where the section is upright, cos θ = 0, the face that looks down is another one, and M_c changes its sign.
    #[inline(always)]
    pub(crate) fn of_face(levels: impl FnOnce(T) -> [T; 3], height: T, gap: T, sin: T, cos: T) -> Self {
        Self::of_bonded_face(levels, height, gap, cos.select(sin, -sin), cos.select(cos, -cos))
    }

    /// The same on the face that looks down where the section is not tilted, however it is turned: r = y - (h/2) cos θ.
    #[inline(always)]
    pub(super) fn of_bonded_face(levels: impl FnOnce(T) -> [T; 3], height: T, gap: T, s: T, c: T) -> Self {
        let half = height * 0.5;
        let [w, t, b] = levels(gap + one_minus(s, c) * half);
        let lever = half * s;
        let by_rotation = -t * lever;
        let mixed = b * lever;
        Self {
            energy: w,
            by_gap: -t,
            by_rotation,
            energy_by_rotation: by_rotation,
            gap_gap: b,
            gap_rotation: mixed,
            rotation_gap: mixed,
            rotation_rotation: b * lever * lever - t * half * c,
        }
    }

    /// Of a load that does not depend on the rotation: of W, T and b at the near face and, if it counts, at the far one.
    #[inline(always)]
    pub(super) fn blind(near: [T; 3], far: Option<[T; 3]>) -> Self {
        let zero = T::splat(0.0);
        let far = far.unwrap_or([zero; 3]);
        Self {
            energy: near[0] - far[0],
            by_gap: far[1] - near[1],
            by_rotation: zero,
            energy_by_rotation: zero,
            gap_gap: near[2] - far[2],
            gap_rotation: zero,
            rotation_gap: zero,
            rotation_rotation: zero,
        }
    }

    /// That of two loads together.
    #[inline(always)]
    pub(super) fn plus(self, other: Self) -> Self {
        Self {
            energy: self.energy + other.energy,
            by_gap: self.by_gap + other.by_gap,
            by_rotation: self.by_rotation + other.by_rotation,
            energy_by_rotation: self.energy_by_rotation + other.energy_by_rotation,
            gap_gap: self.gap_gap + other.gap_gap,
            gap_rotation: self.gap_rotation + other.gap_rotation,
            rotation_gap: self.rotation_gap + other.rotation_gap,
            rotation_rotation: self.rotation_rotation + other.rotation_rotation,
        }
    }

    /// One section's response after the other, side by side.
    #[inline(always)]
    pub(super) fn each_of<const N: usize>(of: [T; N], response: impl Fn([f64; N]) -> LineResponse<f64>) -> Self {
        let [energy, by_gap, by_rotation, energy_by_rotation, gap_gap, gap_rotation, rotation_gap, rotation_rotation] =
            T::each_of(of, |of| {
                let at = response(of);
                [
                    at.energy,
                    at.by_gap,
                    at.by_rotation,
                    at.energy_by_rotation,
                    at.gap_gap,
                    at.gap_rotation,
                    at.rotation_gap,
                    at.rotation_rotation,
                ]
            });
        Self { energy, by_gap, by_rotation, energy_by_rotation, gap_gap, gap_rotation, rotation_gap, rotation_rotation }
    }

    /// The same without the moment.
    #[inline(always)]
    pub(super) fn without_moment(self) -> Self {
        let zero = T::splat(0.0);
        Self { by_rotation: zero, rotation_gap: zero, rotation_rotation: zero, ..self }
    }
}

/// 1 - cos θ without cancellation.
#[inline(always)]
pub(super) fn one_minus<T: Real>(sin: T, cos: T) -> T {
    cos.select(sin * sin / (cos + 1.0), T::splat(1.0) - cos)
}
