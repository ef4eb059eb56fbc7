//! From where a solid spatula settles: stress-free on the crests of its ground, or with its pad along the surface.

use super::layout::THROUGH;
use super::solid_spatula::SolidSpatula;
use crate::solve::state::State;

/// Distance of the places from which slopes are taken, nm.
const BESIDE: f64 = 0.05;

/// How a section is moved: its underside in the plane of symmetry, nm, and by which angle it is turned.
#[derive(Clone, Copy, Debug)]
struct Moved {
    by: [f64; 2],
    angle: f64,
}

impl SolidSpatula {
    /// The guess with the underside of the pad, up to S = `pad`, along the surface at the gap at rest, as where it has been pressed on; what lies behind
    /// the pad is moved the less, the farther away it is.
    pub(crate) fn conformed(&self, pad: f64) -> State {
        let mut state = self.at_rest();
        if self.ground.substrate.is_flat() {
            return state;
        }
        let places: Vec<f64> =
            self.mesh.stations.iter().flat_map(|&s| [(s - BESIDE).max(0.0), s, s + BESIDE]).collect();
        let moved = self.moves(pad, &places);
        let lines = self.layout.lines();
        for station in 0..self.layout.columns {
            let around = 3 * station..3 * station + 3;
            let (own, sections) = (&places[around.clone()], &moved[around]);
            for (through, across) in (0..THROUGH).flat_map(|through| (0..lines).map(move |across| (through, across))) {
                let ends: Vec<[f64; 2]> =
                    own.iter().zip(sections).map(|(&s, by)| self.moved_by(s, through, by)).collect();
                for axis in 0..2 {
                    let slope = (ends[2][axis] - ends[0][axis]) / (own[2] - own[0]);
                    for (is_slope, value) in [(false, ends[1][axis]), (true, slope)] {
                        if let Some(unknown) = self.layout.unknown(station, (through, across), is_slope, axis) {
                            state.values[unknown] = value;
                        }
                    }
                }
            }
        }
        state
    }

    /// How sections at ascending places are moved.
    fn moves(&self, pad: f64, places: &[f64]) -> Vec<Moved> {
        let on_pad = places.partition_point(|&s| s <= pad);
        let mut along: Vec<f64> = places[..on_pad].to_vec();
        along.push(pad);
        let gap = self.half_space.equilibrium_gap();
        let line = self.ground.substrate.along(gap, &along);
        let follows = |(&s, at): (&f64, &[f64; 3])| Moved { by: [at[0] - s, at[1] - gap], angle: at[2] };
        let mut moved: Vec<Moved> = along.iter().zip(&line).map(follows).collect();
        let Some(end) = moved.pop() else { return moved };
        let behind = |&s: &f64| {
            let way = ((s - pad) / self.mesh.adhering).min(1.0);
            let left = (1.0 - way) * (1.0 - way) * (1.0 + 2.0 * way);
            let [x, y]: [f64; 2] = {
                let [rest, ..] = self.at_rest_in_plane(s);
                std::array::from_fn(|axis| rest[axis] + left * end.by[axis])
            };
            // no nearer to the surface than where it is bonded
            let lifted = (self.ground.substrate.above(x, gap) - y).max(0.0);
            Moved { by: [left * end.by[0], left * end.by[1] + lifted], angle: left * end.angle }
        };
        moved.extend(places[on_pad..].iter().map(behind));
        moved
    }

    /// By how much a point of a section in the plane of symmetry is moved that turns about its underside.
    fn moved_by(&self, place: f64, through: usize, &Moved { by, angle }: &Moved) -> [f64; 2] {
        let rest = self.at_rest_in_plane(place);
        let off: [f64; 2] = std::array::from_fn(|axis| rest[through][axis] - rest[0][axis]);
        let (sin, cos) = angle.sin_cos();
        [by[0] + (cos - 1.0) * off[0] - sin * off[1], by[1] + sin * off[0] + (cos - 1.0) * off[1]]
    }

    /// x and y of the nodes through the thickness in the plane of symmetry, from the underside on, nm.
    fn at_rest_in_plane(&self, place: f64) -> [[f64; 2]; THROUGH] {
        let place = place.min(self.mesh.stations[self.layout.columns]);
        [-1.0, 0.0, 1.0].map(|zeta| self.rest_at(place, zeta))
    }
}
