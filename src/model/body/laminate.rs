//! Layers of several materials over the height of a strip, as one beam.
//!
//! With z from the adhering face, the layers of E, ν and t have, a unit of width,
//!
//! ```text
//! EA = ∫ E dz,   e = ∫ E z dz/EA,   EI = ∫ E (z - e)² dz,
//! GA_s = EI²/∫ S²/G dz,   S(z) = ∫ E (ζ - e) dζ from z to the upper face.
//! ```
//!
//! e is the height of the neutral axis above the face. The shear stress is V S/EI, from the equilibrium of the bending stresses, and GA_s stores what that
//! does; of one material it is 5/6 GA. The beam is that of one material and of the height h = 2e, whose face is as far from its axis; its thickness is
//! the sum of the layers. Source: E. Reissner, J. Appl. Mech. 12 (1945), for the shear; J. Whitney, J. Appl. Mech. 40 (1973), of laminates.

use crate::beam::section::{Material, rectangle_second_moment};
use crate::number::gauss::Rule;
use serde::{Deserialize, Serialize};
use std::num::NonZeroUsize;

/// One layer.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Layer {
    /// t, nm
    pub height: f64,
    /// E, GPa
    pub youngs_modulus: f64,
    /// ν
    pub poissons_ratio: f64,
}

/// Layers from the adhering face up.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "Vec<Layer>", into = "Vec<Layer>")]
pub struct Laminate {
    layers: [Layer; Laminate::MOST],
    count: usize,
}

/// What is wrong with layers; those are counted from 1.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[allow(missing_docs)] // the message of each names its numbers
pub enum LaminateError {
    #[error("has {found} layers; it takes 1 to {}", Laminate::MOST)]
    Count { found: usize },
    #[error("has in layer {layer} `{key}` = {found}{unit}, which is out of range")]
    Value { layer: usize, key: &'static str, found: f64, unit: &'static str },
}

const NOTHING: Layer = Layer { height: 0.0, youngs_modulus: 0.0, poissons_ratio: 0.0 };
/// S² is of the fourth degree.
const POINTS: NonZeroUsize = NonZeroUsize::new(3).unwrap();

impl TryFrom<Vec<Layer>> for Laminate {
    type Error = LaminateError;

    fn try_from(layers: Vec<Layer>) -> Result<Self, LaminateError> {
        Self::new(&layers)
    }
}

impl From<Laminate> for Vec<Layer> {
    fn from(laminate: Laminate) -> Self {
        laminate.layers().to_vec()
    }
}

impl Laminate {
    /// Most layers.
    pub(crate) const MOST: usize = 8;

    /// Of layers from the adhering face up.
    ///
    /// ```
    /// use peelkit::model::{Laminate, Layer};
    ///
    /// let adhesive = Layer { height: 30e3, youngs_modulus: 1e-3, poissons_ratio: 0.49 };
    /// let film = Layer { height: 50e3, youngs_modulus: 4.0, poissons_ratio: 0.35 };
    /// let laminate = Laminate::new(&[adhesive, film])?;
    /// assert_eq!(laminate.thickness(), 80e3);
    /// assert!((laminate.axis() / 55e3 - 1.0).abs() < 1e-3);
    /// # Ok::<(), peelkit::model::LaminateError>(())
    /// ```
    ///
    /// # Errors
    /// None or too many of them, and numbers out of range.
    pub fn new(layers: &[Layer]) -> Result<Self, LaminateError> {
        let count = layers.len();
        if count == 0 || count > Self::MOST {
            return Err(LaminateError::Count { found: count });
        }
        for (index, &Layer { height, youngs_modulus, poissons_ratio }) in layers.iter().enumerate() {
            let positive = |number: f64| number > 0.0 && number.is_finite();
            let numbers = [
                ("height", height, " nm", positive(height)),
                ("youngs_modulus", youngs_modulus, " GPa", positive(youngs_modulus)),
                ("poissons_ratio", poissons_ratio, "", poissons_ratio > -1.0 && poissons_ratio < 0.5),
            ];
            if let Some(&(key, found, unit, _)) = numbers.iter().find(|(.., is_right)| !is_right) {
                return Err(LaminateError::Value { layer: index + 1, key, found, unit });
            }
        }
        let mut all = [NOTHING; Self::MOST];
        all[..count].copy_from_slice(layers);
        Ok(Self { layers: all, count })
    }

    /// From the adhering face up.
    pub fn layers(&self) -> &[Layer] {
        &self.layers[..self.count]
    }

    /// The sum of the layers, nm.
    pub fn thickness(&self) -> f64 {
        self.layers().iter().map(|layer| layer.height).sum()
    }

    /// EA a unit of width, nN/nm.
    fn axial(&self) -> f64 {
        self.layers().iter().map(|layer| layer.youngs_modulus * layer.height).sum()
    }

    /// Each layer with the height of its middle above the adhering face, nm.
    fn stacked(&self) -> impl Iterator<Item = (&Layer, f64)> {
        self.layers().iter().scan(0.0, |below, layer| {
            let middle = *below + 0.5 * layer.height;
            *below += layer.height;
            Some((layer, middle))
        })
    }

    /// e, the height of the neutral axis above the adhering face, nm.
    pub fn axis(&self) -> f64 {
        self.stacked().map(|(layer, middle)| layer.youngs_modulus * layer.height * middle).sum::<f64>() / self.axial()
    }

    /// EI a unit of width, nN·nm.
    fn bending(&self) -> f64 {
        let axis = self.axis();
        let one = |(layer, middle): (&Layer, f64)| {
            let own = rectangle_second_moment(layer.height, 1.0) + layer.height * (middle - axis).powi(2);
            layer.youngs_modulus * own
        };
        self.stacked().map(one).sum()
    }

    /// GA_s a unit of width, nN/nm.
    fn shear(&self) -> f64 {
        let (axis, rule) = (self.axis(), Rule::new(POINTS));
        let mut above = 0.0;
        let mut sum = 0.0;
        let stacked: Vec<_> = self.stacked().collect();
        for (layer, middle) in stacked.into_iter().rev() {
            let Layer { height, youngs_modulus, poissons_ratio } = *layer;
            let modulus = youngs_modulus / (2.0 * (1.0 + poissons_ratio));
            let upper = middle + 0.5 * height - axis;
            let moment = |z: f64| above + 0.5 * youngs_modulus * (upper * upper - z * z);
            let squares = rule.over(upper - height, upper).map(|(z, weight)| weight * moment(z).powi(2));
            sum += squares.sum::<f64>() / modulus;
            above = moment(upper - height);
        }
        self.bending().powi(2) / sum
    }

    /// h = 2e, the height of a strip of one material whose face is as far from its axis, nm.
    pub fn height(&self) -> f64 {
        2.0 * self.axis()
    }

    /// What such a strip of the height [`Laminate::height`] is made of to have the same EA, GA_s and EI. Its ν is the mean of the layers by their Et.
    pub fn material(&self) -> Material {
        let height = self.height();
        let poissons_ratio =
            self.layers().iter().map(|layer| layer.poissons_ratio * layer.youngs_modulus * layer.height).sum::<f64>()
                / self.axial();
        let youngs_modulus = self.axial() / height;
        let modulus = youngs_modulus / (2.0 * (1.0 + poissons_ratio));
        Material {
            shear_correction: self.shear() / (modulus * height),
            bending_stiffness_factor: self.bending() / (youngs_modulus * rectangle_second_moment(height, 1.0)),
            ..Material::of(youngs_modulus, poissons_ratio)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    const FILM: Layer = Layer { height: 50.0, youngs_modulus: 4.0, poissons_ratio: 0.35 };
    const SOFT: Layer = Layer { height: 30.0, youngs_modulus: 0.1, poissons_ratio: 0.45 };

    #[test]
    fn one_layer_is_a_strip_of_one_material() {
        let laminate = Laminate::new(&[FILM]).unwrap();
        let (found, expected) = (laminate.material(), Material::of(4.0, 0.35));
        assert_relative_eq!(laminate.height(), 50.0, max_relative = 1e-15);
        assert_relative_eq!(found.youngs_modulus, expected.youngs_modulus, max_relative = 1e-15);
        assert_relative_eq!(found.shear_correction, 5.0 / 6.0, max_relative = 1e-13);
        assert_relative_eq!(found.bending_stiffness_factor, 1.0, max_relative = 1e-13);
    }

    /// A layer that is cut in three is what it was; layers upside down have the same stiffness and the axis as far from the other face.
    #[test]
    fn cuts_and_sides_change_nothing() {
        let section = |layers: &[Layer]| {
            let laminate = Laminate::new(layers).unwrap();
            (laminate.material().section(3.0, laminate.height(), 0.0), laminate.axis())
        };
        let third = Layer { height: 10.0, ..SOFT };
        let (whole, cut) = (section(&[SOFT, FILM]), section(&[third, third, third, FILM]));
        let turned = section(&[FILM, SOFT]);
        for (one, other) in [(whole, cut), (whole, (turned.0, 80.0 - turned.1))] {
            assert_relative_eq!(one.1, other.1, max_relative = 1e-13);
            assert_relative_eq!(one.0.axial, other.0.axial, max_relative = 1e-13);
            assert_relative_eq!(one.0.shear, other.0.shear, max_relative = 1e-12);
            assert_relative_eq!(one.0.bending, other.0.bending, max_relative = 1e-13);
        }
    }

    /// A bimetal of Timoshenko's: EI = [t1⁴ E1² + t2⁴ E2² + 2 t1 t2 E1 E2 (2 t1² + 2 t2² + 3 t1 t2)]/[12 (t1 E1 + t2 E2)]. The shear by a sum over thin
    /// slices.
    #[test]
    fn two_layers_bend_as_a_bimetal() {
        let laminate = Laminate::new(&[SOFT, FILM]).unwrap();
        let ([s, t], [e, f]) = ([30.0f64, 50.0], [0.1f64, 4.0]);
        let cross = 2.0 * s * t * e * f * (2.0 * s * s + 2.0 * t * t + 3.0 * s * t);
        let bending = (s.powi(4) * e * e + t.powi(4) * f * f + cross) / (12.0 * (s * e + t * f));
        assert_relative_eq!(laminate.bending(), bending, max_relative = 1e-13);
        assert_relative_eq!(laminate.axial(), 203.0, max_relative = 1e-14);
        let slices = 80_000;
        let thin = 80.0 / f64::from(slices);
        let (mut moment, mut sum) = (0.0, 0.0);
        for slice in (0..slices).rev() {
            let z = (f64::from(slice) + 0.5) * thin;
            let layer = if z < 30.0 { SOFT } else { FILM };
            let part = layer.youngs_modulus * (z - laminate.axis()) * thin;
            let modulus = layer.youngs_modulus / (2.0 * (1.0 + layer.poissons_ratio));
            sum += (moment + 0.5 * part).powi(2) / modulus * thin;
            moment += part;
        }
        assert!(moment.abs() < 1e-6 * bending / 80.0);
        assert_relative_eq!(laminate.shear(), bending * bending / sum, max_relative = 1e-5);
    }

    #[test]
    fn numbers_out_of_range_are_refused() {
        assert_eq!(Laminate::new(&[]), Err(LaminateError::Count { found: 0 }));
        assert_eq!(Laminate::new(&[FILM; 9]), Err(LaminateError::Count { found: 9 }));
        let said = Laminate::new(&[FILM, Layer { poissons_ratio: 0.5, ..SOFT }]).unwrap_err().to_string();
        assert_eq!(said, "has in layer 2 `poissons_ratio` = 0.5, which is out of range");
    }
}
