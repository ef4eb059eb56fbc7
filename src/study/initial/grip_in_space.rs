//! What the grip of a strip in space moves and holds in a step before the pull.
//!
//! Steps are along the axes of the strip, whatever the direction of the pull: x along it, y up, z sideways. The grip's own two directions are
//! those of the pull, of azimuth β: along the substrate (cos β, 0, sin β), in which `horizontal` holds it while its height is held as well,
//! and (-sin β, 0, cos β), in which `lateral` does. A step along x or z takes hold of what it moves, and of the other one too where the
//! grip is held in one of its two directions; else a grip that is held in one of them is free in the other.

use super::grip_control::{GripControl, LettingGo};
use crate::beam::spatial::rotation::{Matrix3, apply_transposed, cross};
use crate::model::space::{ACROSS, ALONG, ROLL, ROTATION, SIDEWAYS, YAW};
use crate::model::step::Moved;
use crate::solve::end_conditions::Direction;

const X: [f64; 3] = [1.0, 0.0, 0.0];
const Y: [f64; 3] = [0.0, 1.0, 0.0];
const Z: [f64; 3] = [0.0, 0.0, 1.0];
/// The slots of the places.
const PLACES: [usize; 3] = [ALONG, ACROSS, SIDEWAYS];

/// With these columns.
fn columns(columns: [[f64; 3]; 3]) -> Matrix3 {
    std::array::from_fn(|i| std::array::from_fn(|k| columns[k][i]))
}

fn column(matrix: &Matrix3, k: usize) -> [f64; 3] {
    std::array::from_fn(|i| matrix[i][k])
}

/// In the step that moves this.
pub(super) fn moving(pull: &GripControl, azimuth: f64, moved: Moved) -> GripControl {
    let (sin, cos) = azimuth.sin_cos();
    let mut held = pull.held;
    let either = held[ACROSS] || held[SIDEWAYS];
    let beside = |axes: [[f64; 3]; 3]| (axes, [false, true, either], ALONG);
    let own = [Y, [cos, 0.0, sin], [-sin, 0.0, cos]];
    let turned = |slot: usize| (own, [true, held[ACROSS], held[SIDEWAYS]], slot);
    let (axes, places, driven) = match moved {
        Moved::Height => (own, [false, held[ACROSS], held[SIDEWAYS]], ALONG),
        Moved::Place => beside([X, Y, Z]),
        Moved::Side => beside([Z, Y, X]),
        Moved::Rotation => turned(ROTATION),
        Moved::Yaw => turned(YAW),
        Moved::Roll => turned(ROLL),
    };
    PLACES.into_iter().zip(places).for_each(|(slot, holds)| held[slot] = holds);
    held[driven] = false;
    GripControl { driven, direction: Direction::UP, held, gear: 0.0, axes: Some(columns(axes)) }
}

/// How the force on what is neither driven nor held comes to be zero: the grip moves along it, and holds all else that the control drives or holds.
pub(super) fn letting_go(control: &GripControl, axes: &Matrix3, force: [f64; 3], least: f64) -> Option<LettingGo> {
    let is_free = |slot: usize| !control.held[slot] && slot != control.driven;
    let along = apply_transposed(axes, &force);
    let free: Vec<usize> = PLACES.into_iter().filter(|&slot| is_free(slot)).collect();
    let size = free.iter().map(|&slot| along[slot].powi(2)).sum::<f64>().sqrt();
    if size < least || size == 0.0 {
        return None;
    }
    let mut way = [0.0; 3];
    for &slot in &free {
        let share = along[slot] / size;
        way.iter_mut().zip(column(axes, slot)).for_each(|(way, axis)| *way += share * axis);
    }
    let mut kept = PLACES.into_iter().filter(|&slot| !is_free(slot)).map(|slot| column(axes, slot));
    let (first, second) = (kept.next(), kept.next());
    let first = first.unwrap_or_else(|| if way[1].abs() < 0.5 { cross(way, Y) } else { cross(way, X) });
    let mut held = control.held;
    held[control.driven] = true;
    (held[ALONG], held[ACROSS], held[SIDEWAYS]) = (false, true, second.is_some());
    let axes = columns([way, first, second.unwrap_or_else(|| cross(way, first))]);
    let control = GripControl { driven: ALONG, direction: Direction::UP, held, gear: 0.0, axes: Some(axes) };
    Some(LettingGo { control, force: size })
}
