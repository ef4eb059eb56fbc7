//! The law of a seta as an array takes it: what holds its root at a place, sheet by sheet, and where a sheet is left.
//!
//! A seta is on one of few sheets. Each is a potential of the place u = (u, v) of its root, along the ground and along its normal, and is left
//! for the next one where u·d = c; behind the last sheet the seta is detached. A seta remembers nothing but its sheet.
//! A strength s scales the law, E(u) → s² E(u/s): exits lie at s c with forces s F, and stiffnesses stay.

use super::potential::Potential;
use crate::study::coarsening::seta_law::law::{ExitPlane, SetaLaw};
use serde::{Deserialize, Serialize};

/// Along the normal of the ground.
const NORMAL: [f64; 2] = [0.0, 1.0];

/// What holds the root of a seta. Lengths in nm, stiffnesses in nN/nm = N/m.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum RootLaw {
    /// A spring along the normal that breaks: F_n = k v for v < u_c.
    Spring {
        /// k
        stiffness: f64,
        /// u_c
        reach: f64,
    },
    /// A spring that softens: F_n = k v up to u_1, and from there down to nothing at u_2. It closes as it has opened.
    Softening {
        /// k
        stiffness: f64,
        /// u_1
        first: f64,
        /// u_2
        last: f64,
    },
    /// Springs along the ground and along its normal, F = K u for u·d < c.
    Held {
        /// K, symmetric
        stiffness: [[f64; 2]; 2],
        /// d and c
        exit: ExitPlane,
    },
    /// The potentials that were fitted to resolved pulls of a seta.
    Fitted(SetaLaw),
}

/// A potential, and where it is left.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RootSheet {
    /// E(u)
    pub potential: Potential,
    /// u·d = c
    pub exit: ExitPlane,
    /// Whether the seta comes back from it to the sheet before, on the plane on which it left that one
    pub goes_back: bool,
}

/// A seta that is detached along the normal.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Lifted {
    /// Largest force off the ground, nN
    pub force: f64,
    /// aJ
    pub work: f64,
}

/// A law of a seta that is none.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[allow(missing_docs)] // the message of each names its numbers
pub enum RootLawError {
    #[error("the {name} of the law of a seta is {value}: give a finite number above zero")]
    NotPositive { name: &'static str, value: f64 },
    #[error(
        "a seta that softens from {first} nm on has to hold farther than that, not up to {last} nm: give a larger last place"
    )]
    SoftensBackwards { first: f64, last: f64 },
    #[error(
        "the stiffness {stiffness:?} nN/nm of a seta is not symmetric with eigenvalues of at least zero: check its entries"
    )]
    Stiffness { stiffness: [[f64; 2]; 2] },
    #[error("the exit plane of a seta has the direction {direction:?}, of length {length}: give one of length 1")]
    Direction { direction: [f64; 2], length: f64 },
    #[error("the exit plane of a seta lies at {distance} nm: give a finite number of at least zero")]
    Distance { distance: f64 },
}

impl RootLaw {
    /// A straight shaft with hinges for tips that let go at the normal force N*, nN.
    ///
    /// K = k_a t t' + k_b m m', k_a = EA/L, k_b = 3EI/L³, with t along the shaft and m across it; F_n = N* is the plane d = K e_n/|K e_n| at
    /// N*/|K e_n|. `length` L and `radius` R in nm, `modulus` E in GPa, `angle` in rad from the ground.
    pub fn shaft(length: f64, radius: f64, modulus: f64, angle: f64, pull_off: f64) -> Self {
        let area = std::f64::consts::PI * radius * radius;
        let along = modulus * area / length;
        let across = 3.0 * modulus * area * radius * radius / 4.0 / length.powi(3);
        let (sin, cos) = angle.sin_cos();
        let mixed = (along - across) * sin * cos;
        let stiffness =
            [[along * cos * cos + across * sin * sin, mixed], [mixed, along * sin * sin + across * cos * cos]];
        let normal = stiffness[1];
        let length = normal[0].hypot(normal[1]);
        let exit = ExitPlane { direction: normal.map(|own| own / length), distance: pull_off / length };
        Self::Held { stiffness, exit }
    }

    /// Springs that let go where F_n = F_s tan α: adhesion in proportion to shear. Its plane goes through the place without force.
    ///
    /// `normal` and `tangential` stiffness in nN/nm, `angle` α in rad.
    pub fn cone(normal: f64, tangential: f64, angle: f64) -> Self {
        let direction = [-tangential * angle.tan(), normal];
        let length = direction[0].hypot(direction[1]);
        let exit = ExitPlane { direction: direction.map(|own| own / length), distance: 0.0 };
        Self::Held { stiffness: [[tangential, 0.0], [0.0, normal]], exit }
    }

    /// How many sheets it has, without the detached one.
    pub fn sheets(&self) -> usize {
        match self {
            Self::Spring { .. } | Self::Held { .. } => 1,
            Self::Softening { .. } => 2,
            Self::Fitted(law) => law.sheets.len(),
        }
    }

    /// A sheet of a seta of a strength: 0 while all of it adheres. None behind the last one.
    pub fn sheet(&self, number: usize, strength: f64) -> Option<RootSheet> {
        let plane = |exit: &ExitPlane| ExitPlane { distance: strength * exit.distance, ..*exit };
        let normal = |reach: f64| ExitPlane { direction: NORMAL, distance: strength * reach };
        let (potential, exit) = match (self, number) {
            (Self::Spring { stiffness, reach }, 0) => {
                (Potential::of_height([0.0, 0.0, 0.5 * stiffness]), normal(*reach))
            }
            (Self::Softening { stiffness, first, .. }, 0) => {
                (Potential::of_height([0.0, 0.0, 0.5 * stiffness]), normal(*first))
            }
            (Self::Softening { stiffness, first, last }, 1) => {
                // ½ k u1 u2 - ½ b (u2 - v)², with both places of this strength
                let slope = stiffness * first / (last - first);
                let (first, last) = (strength * first, strength * last);
                let whole = 0.5 * stiffness * first * last;
                (
                    Potential::of_height([whole - 0.5 * slope * last * last, slope * last, -0.5 * slope]),
                    normal(last / strength),
                )
            }
            (Self::Held { stiffness, exit }, 0) => (Potential::quadratic(*stiffness), plane(exit)),
            (Self::Fitted(law), _) => {
                // s² E(u/s)
                let own = law.sheets.get(number)?;
                let scaled: Vec<f64> = own.coefficients.iter().map(|own| own * strength * strength).collect();
                (Potential::of(strength * law.scale, &scaled), plane(&own.exit))
            }
            _ => return None,
        };
        Some(RootSheet { potential, exit, goes_back: number > 0 && matches!(self, Self::Softening { .. }) })
    }

    /// Whether its force is linear in the place of the root, sheet by sheet.
    pub(crate) fn is_linear(&self) -> bool {
        (0..self.sheets()).filter_map(|k| self.sheet(k, 1.0)).all(|sheet| sheet.potential.is_quadratic())
    }

    /// Stiffness where all of it adheres and no force acts, nN/nm.
    pub fn stiffness(&self) -> [[f64; 2]; 2] {
        self.sheet(0, 1.0).map_or([[0.0; 2]; 2], |sheet| sheet.potential.response([0.0; 2]).stiffness)
    }

    /// Whether it carries a force along the ground.
    pub(crate) fn carries_shear(&self) -> bool {
        self.stiffness()[0][0] > 0.0
    }

    /// Largest force off the ground, nN, and work, aJ, as it is detached along the normal from where no force acts. None where that way does not lead
    /// to its exits.
    pub fn lifted(&self) -> Option<Lifted> {
        let (mut out, mut from) = (Lifted::default(), 0.0);
        for number in 0..self.sheets() {
            let RootSheet { potential, exit, .. } = self.sheet(number, 1.0)?;
            let to = exit.ahead([0.0; 2], [0.0, 1.0])?;
            if number == 0 && to <= 0.0 {
                return None;
            }
            if to > from {
                let [start, end] = [from, to].map(|height| potential.response([0.0, height]));
                out.force = out.force.max(start.force[1]).max(end.force[1]);
                out.work += end.energy - start.energy;
                from = to;
            }
        }
        Some(out)
    }

    /// What of it cannot be the law of a seta.
    ///
    /// # Errors
    /// The first number that is none.
    pub fn check(&self) -> Result<(), RootLawError> {
        let positive = |name, value: f64| {
            let good = value.is_finite() && value > 0.0;
            if good { Ok(()) } else { Err(RootLawError::NotPositive { name, value }) }
        };
        match self {
            Self::Spring { stiffness, reach } => {
                positive("stiffness", *stiffness)?;
                positive("reach", *reach)
            }
            Self::Softening { stiffness, first, last } => {
                positive("stiffness", *stiffness)?;
                positive("first place", *first)?;
                positive("last place", *last)?;
                if last > first { Ok(()) } else { Err(RootLawError::SoftensBackwards { first: *first, last: *last }) }
            }
            Self::Held { stiffness, exit } => {
                let [[a, b], [c, d]] = *stiffness;
                let good = a >= 0.0 && d > 0.0 && b == c && a * d >= b * c * (1.0 - 1e-12) && (a + d + b).is_finite();
                if good { checked_plane(exit) } else { Err(RootLawError::Stiffness { stiffness: *stiffness }) }
            }
            Self::Fitted(law) => {
                positive("scale", law.scale)?;
                law.sheets.iter().try_for_each(|sheet| checked_plane(&sheet.exit))
            }
        }
    }
}

fn checked_plane(exit: &ExitPlane) -> Result<(), RootLawError> {
    let length = exit.direction[0].hypot(exit.direction[1]);
    if length.is_nan() || (length - 1.0).abs() >= 1e-9 {
        return Err(RootLawError::Direction { direction: exit.direction, length });
    }
    if exit.distance.is_finite() && exit.distance >= 0.0 {
        Ok(())
    } else {
        Err(RootLawError::Distance { distance: exit.distance })
    }
}
