//! Cohesive laws: traction against opening of the bonded face, in place of a half space's.
//!
//! A shape is a file here that says what the law is called, what its corners take, and what it is, and a line of the list below.

pub(super) mod at;
pub(crate) mod opening_rate;
mod ramp;
pub(crate) mod tabulated;

use at::At;
use tabulated::Measured;

/// Makes the list of shapes from lines `/// what it is` and `Name = file`. A file has `NAME`, as a scene calls the law, `CORNERS`, how many
/// times as many elements it takes as a law without corners, `KNOTS`, zero and the openings δ/δ_r, ascending, between which it
/// is a polynomial of degree 8 (or smooth altogether), `at`, and `primitive`, the integral from t on of the first
/// number of `at`.
macro_rules! shapes {
    ($($(#[$what:meta])* $shape:ident = $file:ident,)*) => {
        $(mod $file;)*

        /// How the traction falls with the opening.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum CohesiveShape {
            $($(#[$what])* $shape,)*
            /// Through the rows of a table.
            Measured(Measured),
        }

        impl CohesiveShape {
            /// Every shape that has a form of its own.
            pub const ALL: &'static [Self] = &[$(Self::$shape),*];

            #[inline(always)]
            pub(super) fn at(self, t: f64) -> At {
                match self {
                    $(Self::$shape => $file::at(t),)*
                    Self::Measured(curve) => curve.at(t),
                }
            }

            /// What a scene calls the law.
            pub const fn name(self) -> &'static str {
                match self {
                    $(Self::$shape => $file::NAME,)*
                    Self::Measured(_) => tabulated::NAME,
                }
            }

            /// The integral from t on of the first number of `at`.
            #[inline(always)]
            pub(super) fn primitive(self, t: f64) -> f64 {
                match self {
                    $(Self::$shape => $file::primitive(t),)*
                    Self::Measured(curve) => curve.primitive(t),
                }
            }

            /// Between these openings δ/δ_r, ascending, s is a polynomial of degree 8 at most, or smooth altogether.
            pub(crate) fn knots(self) -> &'static [f64] {
                match self.knots_of_parts().split_first() {
                    Some((_, knots)) => knots,
                    None => &[],
                }
            }

            /// The same, with zero before them, where what attracts an open face and what repels a pressed one join.
            pub(crate) fn knots_of_parts(self) -> &'static [f64] {
                match self {
                    $(Self::$shape => $file::KNOTS,)*
                    Self::Measured(curve) => curve.knots(),
                }
            }

            /// How many times as many elements its corners take: the narrower they are, the more; 1 where it has none.
            pub(crate) const fn corners(self) -> f64 {
                match self {
                    $(Self::$shape => $file::CORNERS,)*
                    Self::Measured(_) => tabulated::CORNERS,
                }
            }
        }
    };
}

shapes! {
    /// It rises and falls in straight lines, with rounded corners.
    Bilinear = bilinear,
    /// s = t exp(1 - t)
    Exponential = exponential,
    /// The same over most of its range; flanks are steep, corners rounded.
    Dugdale = dugdale,
    /// Level up to half of its range, with a long flank and rounded corners.
    Trapezoidal = trapezoidal,
}

impl CohesiveShape {
    /// ∫ s over the openings above zero: the work of adhesion over strength and range.
    pub fn work(self) -> f64 {
        self.at(0.0)[0]
    }

    /// An opening δ/δ_r at which it still pulls, and behind which it falls off.
    pub(super) fn pulling(self) -> f64 {
        match self {
            Self::Measured(curve) => curve.last_top(),
            _ => 0.5,
        }
    }
}
