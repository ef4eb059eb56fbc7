//! The stress-free configuration of a beam on the substrate, and what follows for its mesh.

use crate::beam::mesh::{Focus, MeshIntervals, MeshKind};
use crate::beam::planar::planar_beam::FrontPosition;
use crate::beam::reference_configuration::{ReferenceConfiguration, ReferenceCurve, VaryingReference};
use crate::beam::section::SectionAt;
use crate::beam::varying::Varying;
use crate::model::ground::Ground;
use crate::model::peel::{Adhesion, PeelModel};

/// The stress-free configuration of a beam, where its front may be, and how its elements are shared out.
pub(super) struct StressFreePlacement {
    pub rest: ReferenceConfiguration,
    pub fronts: FrontPosition,
    /// S up to which it adheres once it has settled on the substrate, nm
    pub rest_front: f64,
    pub pieces: MeshIntervals,
}

/// Fronts for which a beam of varying outline is asked how fine its mesh has to be.
const FRONTS_TRIED: usize = 32;
/// Places at which it is looked at for contact, and how far in r0 that reaches.
const LOOKED_AT: usize = 400;
const REACH: f64 = 3.0;
/// Weight of the focus of the mesh where it comes down again.
const AGAIN: f64 = 0.5;

impl StressFreePlacement {
    /// S behind which a beam of this outline stays clear of the ground on which its free end lies.
    pub(crate) fn contact_extent(beam: &Varying, adhesion: &Adhesion, ground: &Ground) -> f64 {
        let law = adhesion.line_law(beam.contour().at(0.0).height[0]);
        contact_extent(&VaryingReference::new(beam.clone(), law.rest_gap()), beam.contour().length(), adhesion, ground)
    }

    /// All along the substrate, with this gap.
    pub(crate) fn flat(length: f64, gap: f64) -> Self {
        Self {
            rest: ReferenceConfiguration::Curve(ReferenceCurve::straight(0.0, gap, 0.0)),
            fronts: FrontPosition::Even,
            rest_front: length,
            pieces: MeshIntervals::whole(length),
        }
    }

    /// As its outline says, with the free end at the gap of a flat section in equilibrium. `front` are the mesh's
    /// moving foci, the first of them that of every law; to the others are added those where the beam comes down again behind its front. On ground that is not flat elements are shared out as if
    /// they were alike as far as that reaches.
    pub(crate) fn varying(
        beam: &Varying,
        adhesion: &Adhesion,
        ground: &Ground,
        front: &[Focus],
        fixed_foci: &mut Vec<Focus>,
    ) -> Self {
        let length = beam.contour().length();
        let end = beam.contour().at(0.0);
        let law = adhesion.line_law(end.height[0]);
        let rest = VaryingReference::new(beam.clone(), law.rest_gap());
        let (touching, again) = contact(&rest, length, REACH * law.gap_scale());
        let rest_front = settled_front(beam, adhesion, touching.min(beam.contour().adhering_length()));
        // the same for meshes that move and that stay: a state goes from one to the other
        let along = |front: &Focus| ground.floor(front.length, MeshKind::Graded);
        let alike = front.first().and_then(along).map(|floor| (contact_extent(&rest, length, adhesion, ground), floor));
        let again = again.into_iter().zip(front.first().into_iter().cycle());
        fixed_foci.extend(again.map(|(center, front)| Focus { center, weight: AGAIN, ..*front }));
        let meshes: Vec<Vec<Focus>> = (0..=FRONTS_TRIED)
            .map(|k| {
                let center = rest_front * k as f64 / FRONTS_TRIED as f64;
                let moved = front.iter().map(|focus| Focus { center: center + focus.center, ..*focus });
                moved.chain(fixed_foci.iter().copied()).collect()
            })
            .collect();
        let wanted = |from: f64, to: f64| {
            let fronts = meshes.iter().map(|foci| Focus::between(foci, from, to)).fold(f64::MIN_POSITIVE, f64::max);
            fronts + alike.map_or(0.0, |(reach, floor)| (reach.min(to) - from).max(0.0) / floor)
        };
        let rest_adhesion = end.width * law.rest_energy();
        let adheres = |place: f64| {
            let SectionAt { width, height, .. } = beam.at(place);
            width * adhesion.line_law(height).rest_energy() / rest_adhesion
        };
        Self {
            fronts: FrontPosition::new(beam.contour().adhering_length(), adheres),
            rest_front,
            pieces: MeshIntervals::cut(length, &beam.contour().breaks(), wanted),
            rest: ReferenceConfiguration::Varying(Box::new(rest)),
        }
    }
}

impl PeelModel {
    /// S beyond which it stays clear of the ground in its stress-free configuration, nm: L of a strip.
    pub(crate) fn contact_extent(&self) -> f64 {
        let Some(contour) = self.contour() else { return self.length() };
        StressFreePlacement::contact_extent(&Varying::new(contour, self.material()), &self.adhesion, &self.ground)
    }
}

/// S up to which a beam that touches flat ground up to `touching` adheres once it has settled: beyond, it is bent flat as long as that takes
/// less energy than adhesion gives, ½EI κ0² < bW.
fn settled_front(beam: &Varying, adhesion: &Adhesion, touching: f64) -> f64 {
    let length = beam.contour().length();
    let places = (0..=LOOKED_AT).map(|k| touching + (length - touching) * k as f64 / LOOKED_AT as f64);
    let flattened = |&place: &f64| {
        let SectionAt { section, width, height, curvature, .. } = beam.at(place);
        0.5 * section.bending * curvature * curvature < -width * adhesion.line_law(height).rest_energy()
    };
    places.take_while(flattened).last().unwrap_or(touching)
}

/// Places at which a beam is looked at for contact, and how far the edge of its section there is from flat ground.
fn distances(rest: &VaryingReference, length: f64) -> Vec<(f64, f64)> {
    let at = |k: usize| {
        let place = length * k as f64 / LOOKED_AT as f64;
        let [_, gap, rotation] = rest.at(place);
        (place, gap + 0.5 * rest.height(place) * (1.0 - rotation.cos().abs()))
    };
    (0..=LOOKED_AT).map(at).collect()
}

/// S behind which a beam is higher above flat ground than this ground rises.
fn contact_extent(rest: &VaryingReference, length: f64, adhesion: &Adhesion, ground: &Ground) -> f64 {
    let near = REACH * adhesion.line_law(rest.height(0.0)).gap_scale() + ground.substrate.peak_to_valley();
    let clear = distances(rest, length).into_iter().rev().take_while(|&(_, distance)| distance > near);
    clear.last().map_or(length, |(place, _)| place)
}

/// S up to which a beam is `near` to the substrate, and the places behind at which it comes nearest again, if it does so.
fn contact(rest: &VaryingReference, length: f64, near: f64) -> (f64, Vec<f64>) {
    let places = distances(rest, length);
    let (place, distance) = (|k: usize| places[k].0, |k: usize| places[k].1);
    let lifted = places.iter().position(|&(_, distance)| distance > near).unwrap_or(LOOKED_AT);
    let comes_down = |&k: &usize| distance(k) < near && distance(k) < distance(k - 1) && distance(k) <= distance(k + 1);
    (place(lifted), (lifted + 1..LOOKED_AT).filter(comes_down).map(place).collect())
}
