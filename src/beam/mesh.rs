//! Where the elements of a beam end: a mesh that moves with the peeling front.
//!
//! Element ends lie at equal steps of  F(S) = Σ_i w_i asinh((S - c_i)/ℓ_i):  as fine as ℓ_i at each focus, geometric away
//! from it. One focus follows the front; others stay at an end that has a layer of its own.

use crate::number::root::{Bracket, Look};
use serde::{Deserialize, Serialize};

/// Whether element ends follow the front.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum MeshKind {
    /// They do.
    #[default]
    Moving,
    /// They stay, small where the peel begins and ends.
    Graded,
    /// They stay, equally far apart.
    Uniform,
}

/// One place where elements are small.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Focus {
    /// c, nm
    pub center: f64,
    /// ℓ, nm
    pub length: f64,
    /// w, relative to the others
    pub weight: f64,
    /// How elements grow away from it
    pub reach: Reach,
}

/// How elements grow away from a focus.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Reach {
    /// In proportion to the distance: w asinh x, with x = (S - c)/ℓ
    #[default]
    Far,
    /// With its square, so that the focus has elements next to it alone: w atan x
    Near,
}

/// Width of a focus that is the same everywhere, over the length of the chain.
const WIDE: f64 = 10.0;

impl Focus {
    /// So wide that elements are alike all along a chain: as long as those where a focus of weight 1 has the length `floor`, nm.
    pub(crate) fn everywhere(length: f64, floor: f64) -> Self {
        let wide = WIDE * length;
        Self { center: 0.5 * length, length: wide, weight: wide / floor, reach: Reach::Far }
    }

    /// How much of F lies between two places for these foci: what elements are shared out by.
    pub(crate) fn between(foci: &[Self], from: f64, to: f64) -> f64 {
        total(foci, to).0 - total(foci, from).0
    }

    /// Value and slope of its part of F.
    fn value(&self, s: f64) -> (f64, f64) {
        // asinh, to the absolute accuracy that a mesh needs, without the library's care for tiny arguments
        let x = (s - self.center) / self.length;
        if self.reach == Reach::Near {
            return (self.weight * x.atan(), self.weight / (self.length * (x * x + 1.0)));
        }
        let root = (x * x + 1.0).sqrt();
        (self.weight * (x.abs() + root).ln().copysign(x), self.weight / (self.length * root))
    }
}

/// F and its slope.
fn total(foci: &[Focus], s: f64) -> (f64, f64) {
    foci.iter().map(|focus| focus.value(s)).fold((0.0, 0.0), |sum, part| (sum.0 + part.0, sum.1 + part.1))
}

/// A chain cut at the places where elements have to end, with the share of the elements that each piece gets: always the same,
/// so that meshes for different fronts have their nodes in common order.
#[derive(Clone, Debug, PartialEq)]
pub struct MeshIntervals {
    /// Ends of the pieces, nm: 0, …, L
    ends: Vec<f64>,
    /// Share of each piece; they sum to one
    shares: Vec<f64>,
}

impl MeshIntervals {
    /// One piece.
    pub fn whole(length: f64) -> Self {
        Self { ends: vec![0.0, length], shares: vec![1.0] }
    }

    /// Cut at `breaks`, ascending and inside of [0, length]. Elements are shared out as `wanted` asks for, from place to place.
    pub(crate) fn cut(length: f64, breaks: &[f64], wanted: impl Fn(f64, f64) -> f64) -> Self {
        let mut ends = vec![0.0];
        ends.extend(breaks.iter().filter(|&&place| place > 0.0 && place < length));
        ends.push(length);
        let parts: Vec<f64> = ends.windows(2).map(|pair| wanted(pair[0], pair[1])).collect();
        let sum: f64 = parts.iter().sum();
        Self { ends, shares: parts.iter().map(|part| part / sum).collect() }
    }

    /// How many there are: no mesh has fewer elements.
    pub(crate) fn count(&self) -> usize {
        self.shares.len()
    }

    /// Elements of each piece: one, and of the others its share, whose fractions go to those that have most of one.
    pub(crate) fn shared_out(&self, elements: usize) -> Vec<usize> {
        let spare = elements.saturating_sub(self.count());
        let wanted: Vec<f64> = self.shares.iter().map(|share| share * spare as f64).collect();
        let mut counts: Vec<usize> = wanted.iter().map(|wanted| 1 + *wanted as usize).collect();
        let mut order: Vec<usize> = (0..self.count()).collect();
        order.sort_by(|&a, &b| wanted[b].fract().total_cmp(&wanted[a].fract()));
        let given: usize = counts.iter().sum();
        order.iter().take((self.count() + spare).saturating_sub(given)).for_each(|&piece| counts[piece] += 1);
        counts
    }

    /// Elements that a mesh has on each piece. Where its elements do not end where these pieces do, as many elements shared out.
    pub(crate) fn counted(&self, boundaries: &[f64]) -> Vec<usize> {
        let rank = |end: &f64| boundaries.binary_search_by(|place| place.total_cmp(end)).ok();
        let inside: Option<Vec<usize>> = self.ends[1..self.count()].iter().map(rank).collect();
        let elements = boundaries.len() - 1;
        let Some(inside) = inside else { return self.shared_out(elements) };
        let mut before = 0;
        inside.into_iter().chain([elements]).map(|end| end - std::mem::replace(&mut before, end)).collect()
    }

    /// Half as many elements again as a mesh has, on each piece: what one element carries has an error there that the same one on a finer mesh
    /// would share.
    pub(crate) fn refined(&self, boundaries: &[f64]) -> Vec<usize> {
        self.counted(boundaries).into_iter().map(|elements| (3 * elements).div_ceil(2)).collect()
    }
}

/// Ends of so many elements on each of the pieces, graded towards `foci`, equally long in each piece without any; one more than there are
/// elements. `near` are the ends of a similar mesh, if there is one: where to start looking.
pub(crate) fn graded_ends(pieces: &MeshIntervals, foci: &[Focus], counts: &[usize], near: &[f64]) -> Vec<f64> {
    let mut ends = Vec::with_capacity(counts.iter().sum::<usize>() + 1);
    ends.push(0.0);
    for (pair, &elements) in pieces.ends.windows(2).zip(counts) {
        add_graded((pair[0], pair[1]), foci, elements, near, &mut ends);
    }
    ends
}

/// The length that belongs to each node of elements of an order between these boundaries, nm.
pub(crate) fn nodal_lengths(boundaries: &[f64], order: usize) -> Vec<f64> {
    let mut lengths = vec![0.0; (boundaries.len() - 1) * order + 1];
    for (e, pair) in boundaries.windows(2).enumerate() {
        let share = (pair[1] - pair[0]) / order as f64;
        for rank in 0..=order {
            let inside = rank > 0 && rank < order;
            lengths[e * order + rank] += if inside { share } else { 0.5 * share };
        }
    }
    lengths
}

/// Adds the ends of the elements of one piece, but for its first.
fn add_graded((start, end): (f64, f64), foci: &[Focus], elements: usize, near: &[f64], ends: &mut Vec<f64>) {
    if foci.is_empty() {
        ends.extend((1..=elements).map(|k| start + (end - start) * k as f64 / elements as f64));
        return;
    }
    let ((from, first_slope), (to, _)) = (total(foci, start), total(foci, end));
    let mut s = start;
    for k in 1..elements {
        let target = from + (to - from) * k as f64 / elements as f64;
        let near = near.get(ends.len()).copied();
        s = invert(
            foci,
            target,
            Bracket { low: s, high: end },
            near.unwrap_or(s + (to - from) / elements as f64 / first_slope),
        );
        ends.push(s);
    }
    ends.push(end);
}

/// Where a mesh may differ from its map, relative to how far apart its ends are.
const SLACK: f64 = 1e-11;

/// Root of F(s) = target in a bracket, looked for from `start` on where that is inside.
fn invert(foci: &[Focus], target: f64, bracket: Bracket, start: f64) -> f64 {
    let start = if start > bracket.low && start < bracket.high { start } else { bracket.middle() };
    let miss = |s: f64| {
        let (value, slope) = total(foci, s);
        (value - target, slope)
    };
    // Newton's method leaves about the square of its step, in units of 1/F'
    let settles = |look: &Look| {
        let is_near = look.is_newton() && look.value * look.value <= SLACK;
        (is_near || look.bracket.width() <= SLACK * look.bracket.high).then_some(look.next)
    };
    bracket.newton(start, miss, settles).unwrap_or_else(|left| left.next)
}

/// How the elements of a beam are laid out.
#[derive(Clone, Debug)]
pub struct MeshPolicy {
    /// Whether the mesh follows the front.
    pub kind: MeshKind,
    /// Foci that follow the front, as they are for a front at S = 0.
    pub front_foci: Vec<Focus>,
    /// Foci that follow each of the two edges of a section in space, likewise.
    pub edge_foci: Vec<Focus>,
    /// Foci of the mesh besides those.
    pub fixed_foci: Vec<Focus>,
    /// Between which places elements lie.
    pub pieces: MeshIntervals,
}

impl MeshPolicy {
    /// Ends of so many elements on each piece for a front at this place and edges so far from it, which may be found faster from the `near` ones of
    /// a similar mesh; without a front they are graded towards nothing.
    pub fn ends(&self, front: Option<f64>, edges: &[f64], counts: &[usize], near: &[f64]) -> Vec<f64> {
        let Self { kind, front_foci, edge_foci, fixed_foci, pieces } = self;
        let mut foci = Vec::with_capacity(front_foci.len() + edges.len() * edge_foci.len() + fixed_foci.len());
        if let Some(front) = front.filter(|_| *kind != MeshKind::Uniform) {
            let at = |place: f64| move |focus: &Focus| Focus { center: place + focus.center, ..*focus };
            foci.extend(front_foci.iter().map(at(front)));
            edges.iter().for_each(|edge| foci.extend(edge_foci.iter().map(at((front + edge).max(0.0)))));
            foci.extend(fixed_foci);
        }
        graded_ends(pieces, &foci, counts, near)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ends_ascend_and_crowd_at_the_focus() {
        for center in [0.0, 30.0, 100.0, 1e4] {
            let length = 1e4;
            let foci = [
                Focus { center, length: 1.0, weight: 1.0, reach: Reach::Far },
                Focus { center: 0.0, length: 1.0, weight: 0.8, reach: Reach::Far },
            ];
            let ends = graded_ends(&MeshIntervals::whole(length), &foci, &[24], &[]);
            assert_eq!((ends.len(), ends[0], ends[24]), (25, 0.0, length));
            let smallest = ends.windows(2).map(|e| e[1] - e[0]).fold(f64::INFINITY, f64::min);
            assert!(smallest > 0.0 && smallest < 3.0, "{smallest}");
        }
    }

    #[test]
    fn elements_end_where_pieces_do_and_their_number_is_kept() {
        let foci = |center| vec![Focus { center, length: 1.0, weight: 1.0, reach: Reach::Far }];
        let most = |from, to| Focus::between(&foci(0.0), from, to).max(Focus::between(&foci(25.0), from, to));
        let pieces = MeshIntervals::cut(100.0, &[20.0, 30.0, 30.5], most);
        for elements in 1..60 {
            let counts = pieces.shared_out(elements);
            assert_eq!(counts.iter().sum::<usize>(), elements.max(4), "{counts:?}");
            let ends = graded_ends(&pieces, &foci(13.0), &counts, &[]);
            assert_eq!(pieces.counted(&ends), counts);
            assert!(pieces.refined(&ends).iter().zip(&counts).all(|(finer, elements)| finer > elements));
            assert_eq!(ends.len(), elements.max(4) + 1);
            assert!(ends.windows(2).all(|pair| pair[0] < pair[1]), "{ends:?}");
            assert!([20.0, 30.0, 30.5].iter().all(|place| ends.contains(place)), "{ends:?}");
        }
    }
}
