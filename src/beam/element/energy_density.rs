//! What an element integrates: an energy density along the axis and its first and second derivatives.

use crate::adhesion::section::response::LineResponse;
use crate::beam::material::yielding::PROFILE;
use crate::number::Real;

/// Numbers that a density may remember at a point.
pub(crate) const MEMORY: usize = FACE + PROFILE;
/// How many of those from step to step are of the face; behind them is the plastic strain of the film.
pub(crate) const FACE: usize = 4;

/// What a step came to at a material point.
#[derive(Clone, Copy, Debug)]
pub struct StepEnd<const F: usize> {
    /// S, nm
    pub place: f64,
    /// The fields.
    pub value: [f64; F],
    /// Their derivatives with respect to S.
    pub slope: [f64; F],
    /// Length of the step before over that of this one, along the path
    pub before: f64,
}

/// What is known at a point of the axis, or at four side by side.
#[derive(Clone, Copy, Debug)]
pub struct Point<T, const F: usize> {
    /// S, nm
    pub place: T,
    /// The fields.
    pub value: [T; F],
    /// Their derivatives with respect to S.
    pub slope: [T; F],
    /// Of a density that remembers. With friction: where the face was (nm) and what share of its limit it carried at the end of the last
    /// step. Of a face that does not heal: how far away it has been and how far it has slipped at most, nm. Of a film that yields: behind four
    /// numbers of its face, its plastic strain over the height. Of a viscous material: the strains from
    /// which the step strains, three in the plane and six in space, and the factor of its stiffness; in the plane also the distance from which the
    /// face opens, nm, and c of the step, 1/time.
    pub memory: [T; MEMORY],
}

impl<T: Real, const F: usize> Point<T, F> {
    /// All zero.
    #[inline(always)]
    pub fn zero() -> Self {
        let zero = T::splat(0.0);
        Self { place: zero, value: [zero; F], slope: [zero; F], memory: [zero; MEMORY] }
    }
}

/// Response at one point of the axis to F fields, their slopes along S and one number that is the same along the whole
/// chain (the border; the horizontal force of a held grip, say). Per length.
#[derive(Clone, Copy, Debug)]
pub struct PointResponse<T, const F: usize> {
    /// Energy density φ, nN
    pub energy: T,
    /// Its share from adhesion, nN
    pub adhesion: T,
    /// What the peeling front is counted by, nN: `LineLaw::coverage` times the width
    pub coverage: T,
    /// ∂φ/∂field
    pub by_value: [T; F],
    /// ∂φ/∂field'
    pub by_slope: [T; F],
    /// ∂²φ/∂field∂field (rows: the equation, columns: the unknown)
    pub value_value: [[T; F]; F],
    /// ∂²φ/∂field∂field'
    pub value_slope: [[T; F]; F],
    /// ∂²φ/∂field'∂field
    pub slope_value: [[T; F]; F],
    /// ∂²φ/∂field'∂field'
    pub slope_slope: [[T; F]; F],
    /// ∂(coverage)/∂field: what the path parameter needs
    pub coverage_by_value: [T; F],
    /// ∂φ/∂border
    pub by_border: T,
    /// ∂²φ/∂border²
    pub border_border: T,
    /// ∂²φ/∂border∂field
    pub border_value: [T; F],
    /// ∂²φ/∂border∂field'
    pub border_slope: [T; F],
}

impl<T: Real, const F: usize> PointResponse<T, F> {
    /// All zero.
    #[inline(always)]
    pub fn zero() -> Self {
        let zero = T::splat(0.0);
        Self {
            energy: zero,
            adhesion: zero,
            coverage: zero,
            by_value: [zero; F],
            by_slope: [zero; F],
            value_value: [[zero; F]; F],
            value_slope: [[zero; F]; F],
            slope_value: [[zero; F]; F],
            slope_slope: [[zero; F]; F],
            coverage_by_value: [zero; F],
            by_border: zero,
            border_border: zero,
            border_value: [zero; F],
            border_slope: [zero; F],
        }
    }
}

impl<T: Real, const F: usize> PointResponse<T, F> {
    /// Of the adhesion alone, on an adhering width. The last two fields are the gap and the rotation.
    #[inline(always)]
    pub(in crate::beam) fn of_adhesion(adhesion: &LineResponse<T>, coverage: [T; 3], b: T) -> Self {
        let (gap, rotation) = (F - 2, F - 1);
        let mut response = Self::zero();
        response.energy = adhesion.energy * b;
        response.adhesion = response.energy;
        response.by_value[gap] = adhesion.by_gap * b;
        response.by_value[rotation] = adhesion.by_rotation * b;
        response.value_value[gap][gap] = adhesion.gap_gap * b;
        response.value_value[gap][rotation] = adhesion.gap_rotation * b;
        response.value_value[rotation][gap] = adhesion.rotation_gap * b;
        response.value_value[rotation][rotation] = adhesion.rotation_rotation * b;
        response.set_coverage(coverage, b);
        response
    }

    /// Sets the coverage from that of the law, with its derivatives by the last two fields, and the adhering width.
    #[inline(always)]
    pub(in crate::beam) fn set_coverage(&mut self, [value, by_gap, by_rotation]: [T; 3], b: T) {
        self.coverage = value * b;
        self.coverage_by_value[F - 2] = by_gap * b;
        self.coverage_by_value[F - 1] = by_rotation * b;
    }
}

/// Section forces and stretch of the axis at one point, from the unknowns alone.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SectionState {
    /// x' of the axis
    pub horizontal_slope: f64,
    /// y' of the axis
    pub vertical_slope: f64,
    /// Horizontal section force H, nN
    pub horizontal_force: f64,
    /// Vertical section force V, nN
    pub vertical_force: f64,
    /// Bending moment M, nN·nm
    pub moment: f64,
    /// κ = θ', 1/nm
    pub curvature: f64,
    /// Stored energy, nN
    pub stored: f64,
}

impl SectionState {
    /// H x' + V y' + M θ' - stored, nN. Less the adhesion energy bΨ it is constant along a uniform beam in equilibrium
    /// whose load has a potential: the first integral.
    pub fn eshelby(&self) -> f64 {
        self.horizontal_force * self.horizontal_slope
            + self.vertical_force * self.vertical_slope
            + self.moment * self.curvature
            - self.stored
    }
}

/// Which second derivatives of a density may differ from zero: nothing is computed for the others.
#[derive(Clone, Copy, Debug)]
pub struct Coupling<const F: usize> {
    /// Of ∂²φ/∂field∂field
    pub value_value: [[bool; F]; F],
    /// Of ∂²φ/∂field∂field'; transposed, of ∂²φ/∂field'∂field
    pub value_slope: [[bool; F]; F],
    /// Of ∂²φ/∂field'∂field'
    pub slope_slope: [[bool; F]; F],
}

/// A beam with its line load, as an energy density of F fields. `place` is S, nm: what varies along the beam looks there.
pub trait EnergyDensity<const F: usize>: Send + Sync {
    /// Which second derivatives there are.
    const COUPLING: Coupling<F>;

    /// Openings at which the pieces of its law join, ascending; none of a law that is smooth.
    fn knots(&self) -> &'static [f64] {
        &[]
    }

    /// The opening that [`Self::knots`] speaks of, in ranges of the law, with what is remembered there.
    fn opening(&self, _place: f64, _value: [f64; F], _memory: [f64; MEMORY]) -> f64 {
        0.0
    }

    /// What the adhesion of a law that has knots gives to a response with these fields: all of it depends on the fields
    /// and on what is remembered alone.
    fn adhesion_response(&self, _place: f64, _value: [f64; F], _memory: [f64; MEMORY]) -> PointResponse<f64, F> {
        PointResponse::zero()
    }

    /// Whether one number is shared by the whole chain.
    const BORDER: bool = false;

    /// The density and its derivatives, at one point or at several side by side.
    fn response<T: Real>(&self, place: T, value: [T; F], slope: [T; F], axial_multiplier: f64) -> PointResponse<T, F>;

    /// Whether something may take part that remembers what was before the step: friction, a face that does not heal, a film that yields, or a
    /// viscous material.
    const HAS_HISTORY: bool = false;

    /// Adds that to a response at the same point.
    fn add_remembered<T: Real>(&self, _point: &Point<T, F>, _response: &mut PointResponse<T, F>) {}

    /// Turns what a material point remembered before a step into what it does behind it. An energy per length (nN): with friction what was dissipated
    /// there, of a face that does not heal what it would win if it did.
    fn remember(&self, _end: &StepEnd<F>, _known: &mut [f64]) -> f64 {
        0.0
    }

    /// Whether its face does not heal: what its law goes by is then remembered.
    fn remembers_face(&self) -> bool {
        false
    }

    /// Whether its film yields, so that its curvature does not follow from its moment alone.
    fn yields(&self) -> bool {
        false
    }

    /// Whether [`Self::slope_beyond_step`] says anything.
    const FOLLOWS_FORCE: bool = false;

    /// What the slope of the height changes by at a finite change of the fields and of the border, beyond its own change, where the vertical
    /// section force changes by what its derivatives say.
    fn slope_beyond_step<T: Real>(&self, _place: T, _from: [[T; F]; 2], _change: [[T; F]; 2], _axial: [f64; 2]) -> T {
        T::splat(0.0)
    }

    /// Whether the second derivatives are symmetric: whether there is such an energy.
    fn is_symmetric(&self) -> bool {
        true
    }

    /// Section forces and stretch.
    fn section_state(&self, point: &Point<f64, F>, axial_multiplier: f64) -> SectionState;

    /// The section where its vertical force and moment are known instead of the slopes (at a node between two
    /// elements, where the nodal forces are far more accurate than the slopes).
    fn section_state_from_forces(
        &self,
        place: f64,
        value: [f64; F],
        forces: [f64; F],
        axial_multiplier: f64,
    ) -> SectionState;
}
