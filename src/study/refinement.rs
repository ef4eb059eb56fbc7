//! Finer until the bounds hold: the same computation on one mesh after another.

use super::accuracy::Resolution;

/// Most meshes tried.
const MOST_MESHES: usize = 8;
/// Meshes in space on which a path may be unusable: what three did not cure more do not, and each takes as long as a peel that succeeds.
pub(super) const MOST_FAILED_IN_SPACE: usize = 4;

/// The best of the computations on one mesh after another, up to `most_elements`. `compute` is given a resolution and the best so far; beside
/// what it computed it says on which resolution to go on, or that it is enough.
pub(super) fn refined<A>(
    first: Resolution,
    most_elements: usize,
    is_better: impl Fn(&A, &A) -> bool,
    mut compute: impl FnMut(Resolution, Option<&A>) -> (A, Option<Resolution>),
) -> Option<A> {
    let (mut resolution, mut best) = (first, None);
    for _ in 0..MOST_MESHES {
        let (found, finer) = compute(resolution, best.as_ref());
        if best.as_ref().is_none_or(|best| is_better(&found, best)) {
            best = Some(found);
        }
        match finer {
            Some(finer) if finer.elements <= most_elements => resolution = finer,
            _ => break,
        }
    }
    best
}

#[cfg(test)]
mod tests {
    use super::*;

    fn on(elements: usize) -> Resolution {
        Resolution { order: 7, elements, step_tolerance: 1e-2, stride: 1.0 }
    }

    /// An error that falls with the elements, then is round-off: the best is kept, and none is computed beyond the most elements.
    #[test]
    fn the_best_is_kept() {
        let mut tried = Vec::new();
        let better = |a: &(usize, f64), b: &(usize, f64)| a.1 < b.1;
        let best = refined(on(8), 30, better, |resolution, _| {
            let elements = resolution.elements;
            tried.push(elements);
            ((elements, if elements > 20 { 0.5 } else { 1.0 / elements as f64 }), Some(on(elements + 6)))
        });
        assert_eq!((best.map(|best| best.0), tried), (Some(20), vec![8, 14, 20, 26]));
        let once = refined(on(8), 30, better, |_, _| ((8, 0.1), None));
        assert_eq!(once, Some((8, 0.1)));
    }
}
