//! The line that keeps a distance to the ground.

use super::Substrate;

impl Substrate {
    /// The place at this distance above x, nm: the y that is `distance` from the substrate.
    pub fn above(&self, x: f64, distance: f64) -> f64 {
        let mut y = self.top(x - distance, x + distance) + distance;
        // the distance is concave along a line on a convex body and at most as steep as the line: the steps stay above
        for _ in 0..MOST_LEVELLING {
            let off = self.project(x, y).distance - distance;
            y -= off;
            if off.abs() <= LEVELLED * distance {
                break;
            }
        }
        y
    }

    /// The line that keeps this distance to the substrate, from above x = 0 on: x, y and φ at each of the ascending lengths
    /// `places` along it, nm. Valleys narrower than the distance are passed over, as by a ball that rolls.
    pub fn along(&self, distance: f64, places: &[f64]) -> Vec<[f64; 3]> {
        let (mut x, mut y, mut here) = (0.0, self.above(0.0, distance), 0.0);
        let step = (0.02 * distance).min(0.005 * self.feature_length());
        let line = places.iter().map(|&place| {
            let steps = ((place - here) / step).ceil().clamp(0.0, MOST_A_PLACE);
            for _ in 0..steps as usize {
                let length = (place - here) / steps;
                let from = self.project(x, y);
                // the middle of the step, its direction, and back to the distance
                let middle = self.project(x + 0.5 * length * from.cos, y + 0.5 * length * from.sin);
                (x, y) = (x + length * middle.cos, y + length * middle.sin);
                let to = self.project(x, y);
                (x, y) = (x + (to.distance - distance) * to.sin, y - (to.distance - distance) * to.cos);
            }
            here = place;
            let foot = self.project(x, y);
            [x, y, foot.sin.atan2(foot.cos)]
        });
        line.collect()
    }
}

/// Steps that lower a point to a distance, and how near they come, relative.
const MOST_LEVELLING: usize = 200;
const LEVELLED: f64 = 1e-13;

/// Steps along a line from place to place.
const MOST_A_PLACE: f64 = 1e3;
