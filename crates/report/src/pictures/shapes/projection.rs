//! A parallel projection of space onto the sheet.

use plotters::style::RGBColor;

/// How far the viewer stands from straight in front of the strip, and over the ground, rad.
const ASIDE: f64 = 0.52;
const ABOVE: f64 = 0.42;
/// Where the light comes from: to the right of the sheet, upwards, towards the viewer.
const LIGHT: [f64; 3] = [-0.35, 0.75, 0.56];

/// A parallel projection: unit vectors to the right of the sheet, upwards, and towards the viewer.
pub(super) struct View {
    right: [f64; 3],
    up: [f64; 3],
    towards: [f64; 3],
}

impl View {
    /// With x to the right, y upwards, and what moves along z, or for a `side` below zero against it, going to the right as well.
    pub fn beside(side: f64) -> Self {
        let ((sin, cos), (above, level)) = ((-side * ASIDE).sin_cos(), ABOVE.sin_cos());
        Self {
            right: [cos, 0.0, -sin],
            up: [-above * sin, level, -above * cos],
            towards: [level * sin, above, level * cos],
        }
    }

    /// Where a point is on the sheet, nm.
    pub fn at(&self, point: [f64; 3]) -> (f64, f64) {
        (dot(self.right, point), dot(self.up, point))
    }

    /// How near a point is to the viewer, nm.
    pub fn depth(&self, point: [f64; 3]) -> f64 {
        dot(self.towards, point)
    }

    /// How bright a face with these corners is, anticlockwise from outside, from 0 to 1; nothing if it is turned away.
    pub fn light(&self, corners: &[[f64; 3]]) -> Option<f64> {
        // Newell's normal
        let mut normal = [0.0; 3];
        for (k, a) in corners.iter().enumerate() {
            let b = corners[(k + 1) % corners.len()];
            for (i, n) in normal.iter_mut().enumerate() {
                let (j, l) = ((i + 1) % 3, (i + 2) % 3);
                *n += (a[j] - b[j]) * (a[l] + b[l]);
            }
        }
        let size = dot(normal, normal).sqrt();
        let seen = dot(normal, self.towards);
        let [right, up, towards] = [self.right, self.up, self.towards].map(|axis| dot(axis, normal) / size);
        let lit = LIGHT[0] * right + LIGHT[1] * up + LIGHT[2] * towards;
        (seen > 0.0 && size > 0.0).then_some((0.5 * (1.0 + lit)).clamp(0.0, 1.0))
    }
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// A colour with a share of white.
pub(super) fn mixed(RGBColor(red, green, blue): RGBColor, white: f64) -> RGBColor {
    let one = |part: u8| (f64::from(part) + white * (255.0 - f64::from(part))).round() as u8;
    RGBColor(one(red), one(green), one(blue))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_seen_faces_the_viewer() {
        for side in [1.0, -1.0] {
            let view = View::beside(side);
            // orthonormal and right-handed
            let units = [view.right, view.up, view.towards];
            for (k, a) in units.iter().enumerate() {
                for (l, b) in units.iter().enumerate() {
                    assert!((dot(*a, *b) - f64::from(u8::from(k == l))).abs() < 1e-15);
                }
            }
            assert!(view.at([1.0, 0.0, 0.0]).0 > 0.8 && view.at([0.0, 1.0, 0.0]).1 > 0.8);
            assert!(view.at([0.0, 0.0, side]).0 > 0.4);
            // a square on the ground, from above and from below
            let square = [[0.0, 0.0, 0.0], [0.0, 0.0, 1.0], [1.0, 0.0, 1.0], [1.0, 0.0, 0.0]];
            assert!(view.light(&square).is_some());
            let mut below = square;
            below.reverse();
            assert_eq!(view.light(&below), None);
        }
    }
}
