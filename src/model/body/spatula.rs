//! A gecko's spatula as a beam: a flat pad that narrows and thickens into a round, bent shaft.
//!
//! With s5(t) = t³(10 - 15 t + 6 t²) clipped to [0, 1] and q = s5((S - pad)/neck): height h = h_pad + (d - h_pad) q; width
//! b = b_tip + (b_neck - b_tip) S/pad on the pad and b_neck + (d - b_neck) q behind it, where rounded times
//! w + (1 - w)(1 - (1 - t)⁴) with t = S/rounding; the section goes from a rectangle to a circle with q, and the underside turns up
//! by the shaft's angle times s5((S - pad)/bend). A choice within the ranges of the literature: the paper gives no dimensions.

use super::geometry::Geometry;
use super::transition::Transition;
use crate::beam::section::Material;
use crate::beam::varying::{BeamGeometry, SectionGeometry};
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// Geometry and material of a spatula. Lengths in nm.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Spatula {
    /// Of the part that adheres, flat underneath
    pub pad_length: f64,
    /// From the pad to the shaft.
    pub neck_length: f64,
    /// From the neck to the grip
    pub shaft_length: f64,
    /// Over this length from the pad on the axis turns up.
    pub bend_length: f64,
    /// b of the pad, but for its rounded end
    pub tip_width: f64,
    /// b at the narrowest place
    pub neck_width: f64,
    /// Of its round section
    pub shaft_diameter: f64,
    /// h of the pad
    pub pad_thickness: f64,
    /// rad
    pub shaft_angle: f64,
    /// From the tip on; 0: blunt.
    pub tip_rounding_length: f64,
    /// Width of the end face where it is rounded.
    pub tip_rounding_width: f64,
    /// What it is made of
    pub material: Material,
}

impl Default for Spatula {
    fn default() -> Self {
        Self {
            pad_length: 240.0,
            neck_length: 150.0,
            shaft_length: 600.0,
            bend_length: 50.0,
            tip_width: 200.0,
            neck_width: 50.0,
            shaft_diameter: 50.0,
            pad_thickness: 10.0,
            shaft_angle: std::f64::consts::FRAC_PI_4,
            tip_rounding_length: 0.0,
            tip_rounding_width: 100.0,
            material: Material::of(2.0, 0.2),
        }
    }
}

/// Lengths along the axis that are a smaller share of the whole one are none: no element is so short, and a tip that is rounded over less is blunt.
const LEAST_SHARE: f64 = 1e-9;

impl Spatula {
    /// The shortest length along the axis that is resolved, nm.
    fn least_length(&self) -> f64 {
        LEAST_SHARE * self.length()
    }

    /// Width of the rounded tip over that of a blunt one, and its derivative by S.
    fn rounding(&self, place: f64) -> [f64; 2] {
        if place >= self.tip_rounding_length || self.tip_rounding_length < self.least_length() {
            return [1.0, 0.0];
        }
        let least = self.tip_rounding_width / self.tip_width;
        let left = 1.0 - place / self.tip_rounding_length;
        [least + (1.0 - least) * (1.0 - left.powi(4)), 4.0 * (1.0 - least) * left.powi(3) / self.tip_rounding_length]
    }

    /// Width of a spatula with a blunt tip, nm, and its derivative by S.
    fn blunt_width(&self, place: f64) -> [f64; 2] {
        let beyond = place - self.pad_length;
        if beyond < 0.0 {
            let change = self.neck_width - self.tip_width;
            return [self.tip_width + change * place / self.pad_length, change / self.pad_length];
        }
        let [q, q1, _] = Transition::Smooth.at(beyond / self.neck_length);
        let wider = self.shaft_diameter - self.neck_width;
        [self.neck_width + wider * q, wider * q1 / self.neck_length]
    }
}

impl BeamGeometry for Spatula {
    fn length(&self) -> f64 {
        self.pad_length + self.neck_length + self.shaft_length
    }

    fn breaks(&self) -> Vec<f64> {
        let pad = self.pad_length;
        let mut breaks = vec![pad, pad + self.neck_length];
        if self.shaft_angle != 0.0 {
            breaks.push(pad + self.bend_length);
        }
        let least = self.least_length();
        if self.tip_rounding_length >= least {
            breaks.push(self.tip_rounding_length);
        }
        breaks.sort_by(f64::total_cmp);
        breaks.dedup_by(|next, before| *next - *before < least);
        breaks
    }

    fn at(&self, place: f64) -> SectionGeometry {
        let beyond = place - self.pad_length;
        let [q, q1, q2] = Transition::Smooth.at(beyond / self.neck_length);
        let thicker = self.shaft_diameter - self.pad_thickness;
        let [turned, turning, _] = Transition::Smooth.at(beyond / self.bend_length);
        SectionGeometry {
            width: self.blunt_width(place)[0] * self.rounding(place)[0],
            height: [
                self.pad_thickness + thicker * q,
                thicker * q1 / self.neck_length,
                thicker * q2 / (self.neck_length * self.neck_length),
            ],
            roundness: q,
            underside: [self.shaft_angle * turned, self.shaft_angle * turning / self.bend_length],
        }
    }

    fn slopes(&self, place: f64) -> [f64; 2] {
        let ([width, slope], [share, growth]) = (self.blunt_width(place), self.rounding(place));
        let [_, rounding, _] = Transition::Smooth.at((place - self.pad_length) / self.neck_length);
        [slope * share + width * growth, rounding / self.neck_length]
    }
}

impl Geometry for Spatula {
    fn name(&self) -> &'static str {
        "spatula"
    }

    fn material(&self) -> Material {
        self.material
    }

    fn shared(&self) -> Arc<dyn BeamGeometry> {
        Arc::new(self.clone())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_abs_diff_eq;

    /// Derivatives of the outline against central differences, on both sides of every break.
    #[test]
    fn slopes_are_those_of_the_outline() {
        let spatula = Spatula { tip_rounding_length: 60.0, ..Spatula::default() };
        let step = 1e-4;
        for k in 1..99 {
            let place = 10.0 * f64::from(k) + 0.3;
            let [before, here, after] = [place - step, place, place + step].map(|s| spatula.at(s));
            let slope = |of: fn(&SectionGeometry) -> f64| (of(&after) - of(&before)) / (2.0 * step);
            assert_abs_diff_eq!(here.height[1], slope(|o| o.height[0]), epsilon = 1e-9);
            assert_abs_diff_eq!(here.height[2], slope(|o| o.height[1]), epsilon = 1e-9);
            assert_abs_diff_eq!(here.underside[1], slope(|o| o.underside[0]), epsilon = 1e-9);
            let [width, roundness] = spatula.slopes(place);
            assert_abs_diff_eq!(width, slope(|o| o.width), epsilon = 1e-7);
            assert_abs_diff_eq!(roundness, slope(|o| o.roundness), epsilon = 1e-9);
        }
        assert_eq!(spatula.at(0.0).width, 100.0);
        assert_eq!(spatula.breaks(), [60.0, 240.0, 290.0, 390.0]);
    }

    /// A length that no element can have is none.
    #[test]
    fn what_is_too_short_to_be_resolved_is_left_out() {
        let blunt = Spatula::default();
        for tip_rounding_length in [1e-300, 1e-12, 1e-8] {
            let spatula = Spatula { tip_rounding_length, ..blunt.clone() };
            assert_eq!((spatula.breaks(), spatula.at(0.0).width), (blunt.breaks(), blunt.at(0.0).width));
        }
        let rounded = Spatula { tip_rounding_length: 1e-5, ..blunt.clone() };
        assert_eq!((rounded.breaks()[0], rounded.at(0.0).width), (1e-5, 100.0));
        let bent = Spatula { bend_length: 150.0 * (1.0 + 1e-14), ..blunt };
        assert_eq!(bent.breaks(), [240.0, 390.0]);
    }
}
