//! What of a beam adheres: its face, the edge of its free end, the face of that end, or nothing.

use super::contact::{Sample, samples};
use super::points::DeformedShape;
use crate::model::problem::beam_problem::Beam;
use crate::solve::state::State;
use serde::{Deserialize, Serialize};

/// What of a beam adheres, that is, is nearer to the substrate than 2 r0, or than what stands for that under a cohesive law.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Adhering {
    /// Its face, along a length of at least the height of the free end, or away from that end.
    Pad,
    /// The edge of its free end alone.
    Edge,
    /// The face of its free end, which stands on the substrate with both its edges.
    EndFace,
    /// No point.
    Nothing,
}

impl Adhering {
    /// In words.
    pub fn word(self) -> &'static str {
        match self {
            Self::Pad => "pad",
            Self::Edge => "edge",
            Self::EndFace => "end face",
            Self::Nothing => "nothing",
        }
    }

    /// Of a beam in a state; what is nearer than `near`, nm, adheres ([`crate::adhesion::LineLaw::adhering_distance`]).
    pub(in crate::study) fn of(beam: &Beam, at: &State, near: f64) -> Self {
        let shape = DeformedShape::of(beam, at);
        let end_height = shape.height.first().copied().unwrap_or(0.0);
        Self::of_samples(&samples(beam.substrate(), &shape), near, end_height)
    }

    fn of_samples(samples: &[Sample], near: f64, end_height: f64) -> Self {
        let is_near = |sample: &Sample| sample.gap < near;
        let Some(first) = samples.iter().position(is_near) else { return Self::Nothing };
        let last = samples.iter().rposition(is_near).unwrap_or(first);
        let length = |from: usize, to: usize| -> f64 {
            samples[from..=to].windows(2).map(|pair| (pair[1].x - pair[0].x).hypot(pair[1].y - pair[0].y)).sum()
        };
        if length(first, last) >= end_height || length(0, first) >= end_height {
            Self::Pad
        } else if samples[0].far_gap < near {
            Self::EndFace
        } else {
            Self::Edge
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A straight beam 100 nm long and 10 nm high that leaves the ground at this angle (degrees) from a gap of 0.4 nm.
    fn leaving(angle: f64) -> Vec<Sample> {
        let (sin, cos) = angle.to_radians().sin_cos();
        (0..=1000)
            .map(|k| {
                let s = 0.1 * k as f64;
                let (x, y) = (s * cos, 0.4 + 5.0 * cos.abs() + s * sin);
                let half = 5.0 * cos.abs();
                Sample { x, y, gap: y - half, far_gap: y + half, edge: y - half, ground: 0.0, curvature: 0.0 }
            })
            .collect()
    }

    #[test]
    fn a_beam_adheres_by_its_pad_its_edge_or_its_end() {
        let of = |samples: &[Sample]| Adhering::of_samples(samples, 0.8, 10.0);
        assert_eq!(of(&leaving(0.0)), Adhering::Pad);
        assert_eq!(of(&leaving(1.0)), Adhering::Pad, "0.4 nm over sin 1 degree, 23 nm, are nearer than 2 r0");
        assert_eq!(of(&leaving(30.0)), Adhering::Edge);
        assert_eq!(of(&leaving(90.0)), Adhering::EndFace);
        assert_eq!(of(&leaving(150.0)), Adhering::Edge, "turned over");
        let mut lifted = leaving(30.0);
        lifted.iter_mut().for_each(|sample| sample.gap += 1.0);
        assert_eq!(of(&lifted), Adhering::Nothing);
        let mut bent = leaving(0.0);
        bent[..300].iter_mut().for_each(|sample| sample.gap += 5.0);
        bent[330..].iter_mut().for_each(|sample| sample.gap += 5.0);
        assert_eq!(of(&bent), Adhering::Pad, "it touches away from its end");
    }
}
