//! A law of the user's own: what a [`SectionLaw`] answers is all that the library asks of it.

use super::response::LineResponse;
use crate::number::Real;
use std::fmt::Debug;

/// A section at one place of a beam.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TiltedSection {
    /// h, nm
    pub height: f64,
    /// η = y - h/2 of the axis, nm: the gap below the section where it is not tilted
    pub gap: f64,
    /// sin θ and cos θ of its rotation
    pub sin: f64,
    /// cos θ
    pub cos: f64,
}

impl TiltedSection {
    /// The load of a nominal traction on the face that looks down: `LineResponse::of_face`. A law that is a traction against the
    /// distance of a face needs no more.
    pub fn face_load(&self, levels: impl FnOnce(f64) -> [f64; 3]) -> LineResponse<f64> {
        LineResponse::of_face(levels, self.height, self.gap, self.sin, self.cos)
    }
}

/// The adhesion of a section by a law of the user's own. `examples/own_law.rs` is one.
///
/// The derivatives of a response have to be those of its energy and load; what they are not costs Newton's method its convergence.
pub trait SectionLaw: Debug + Send + Sync {
    /// What outputs call it.
    fn name(&self) -> &'static str;

    /// Potential, load and tangent.
    fn response(&self, section: &TiltedSection) -> LineResponse<f64>;

    /// The distance from which on hardly anything pulls, nm: a beam of which no point is nearer is detached.
    fn cutoff_distance(&self) -> f64;

    /// The gap at which a flat section of this height (nm) is at rest, T_c = 0 with a stable equilibrium, nm.
    fn rest_gap(&self, height: f64) -> f64;

    /// The stiffness (nN/nm³) by which the length of the process zone is estimated, of a flat section of this height, nm: that at
    /// rest. A law that rises steeply over a small part of its range has better strength over range.
    fn rest_stiffness(&self, height: f64) -> f64 {
        self.response(&TiltedSection { height, gap: self.rest_gap(height), sin: 0.0, cos: 1.0 }).gap_gap
    }

    /// Whether the load derives from the energy, so that the tangent is symmetric and energy is conserved.
    fn has_potential(&self) -> bool {
        true
    }

    /// How many times as many elements its corners take: 1 for a law that is smooth everywhere, 5 to 10 for one of which a derivative jumps
    /// or changes within a tenth of its range. For a jump of the traction's slope no number of elements makes up: round it.
    fn corners(&self) -> f64 {
        1.0
    }
}

/// A [`SectionLaw`] that lives as long as the program, so that a model that has one is copied like any other.
#[derive(Clone, Copy, Debug)]
pub struct OwnLaw(&'static dyn SectionLaw);

impl OwnLaw {
    /// Of a law in a `static`.
    pub const fn of(law: &'static dyn SectionLaw) -> Self {
        Self(law)
    }

    /// Of a law that is made when the program runs. Its memory is kept to the end of the program: make one a law, not one a peel.
    pub fn kept(law: impl SectionLaw + 'static) -> Self {
        Self(Box::leak(Box::new(law)))
    }

    /// The law itself.
    pub(crate) fn law(self) -> &'static dyn SectionLaw {
        self.0
    }

    /// At one section or at several side by side, which are computed one by one.
    #[inline(never)]
    pub(super) fn response<T: Real>(self, height: T, gap: T, sin: T, cos: T) -> LineResponse<T> {
        LineResponse::each_of([height, gap, sin, cos], |[height, gap, sin, cos]| {
            self.0.response(&TiltedSection { height, gap, sin, cos })
        })
    }
}

/// The same object.
impl PartialEq for OwnLaw {
    fn eq(&self, other: &Self) -> bool {
        // objects without a size may share an address
        std::ptr::addr_eq(self.0, other.0) && self.0.name() == other.0.name()
    }
}

impl Eq for OwnLaw {}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::adhesion::{Cohesive, CohesiveShape, HalfSpace, Law, LineLaw, LineLoad};
    use crate::number::F64x4;

    const PAPER: HalfSpace = HalfSpace { hamaker_constant: 0.1, equilibrium_distance: 0.4 };

    /// A law of the library, told from outside.
    #[derive(Debug)]
    struct Told(Cohesive);

    impl SectionLaw for Told {
        fn name(&self) -> &'static str {
            "told"
        }

        fn response(&self, section: &TiltedSection) -> LineResponse<f64> {
            section.face_load(|r| self.0.levels(r))
        }

        fn cutoff_distance(&self) -> f64 {
            self.0.cutoff_distance()
        }

        fn rest_gap(&self, _height: f64) -> f64 {
            self.0.closed
        }
    }

    /// Under every load, one by one and four side by side; of sections that have not turned over, where a cohesive law knows which face is bonded.
    #[test]
    fn a_law_of_the_library_told_from_outside_is_that_law() {
        let cohesive = Cohesive::calibrated(CohesiveShape::Exponential, 0.1, 0.03, &PAPER);
        let own = OwnLaw::kept(Told(cohesive));
        for line_load in [LineLoad::Full, LineLoad::ForceOnly, LineLoad::AxisGap] {
            let of = |law| LineLaw { half_space: PAPER, height: 10.0, law, line_load, far_face: true };
            let (own, cohesive) = (of(Law::Own(own)), of(Law::Cohesive(cohesive)));
            assert_eq!(
                (own.has_potential(), own.cutoff_distance()),
                (cohesive.has_potential(), cohesive.cutoff_distance())
            );
            assert!(!own.has_far_face());
            for gap in [0.2, 0.26, 0.5, 2.0] {
                let angles = [-0.3, 0.0, 0.4, 1.5];
                let (sin, cos) = (angles.map(f64::sin), angles.map(f64::cos));
                let four = own.response(F64x4([gap; 4]), F64x4(sin), F64x4(cos));
                for l in 0..4 {
                    let one = own.response(gap, sin[l], cos[l]);
                    assert_eq!(one, cohesive.response(gap, sin[l], cos[l]));
                    assert_eq!((four.energy.0[l], four.rotation_gap.0[l]), (one.energy, one.rotation_gap));
                }
            }
        }
    }

    #[test]
    fn a_law_is_equal_to_itself_alone() {
        let law = || OwnLaw::kept(Told(Cohesive::calibrated(CohesiveShape::Dugdale, 0.1, 0.03, &PAPER)));
        let one = law();
        assert_eq!(one, one);
        assert_ne!(one, law());
    }
}
