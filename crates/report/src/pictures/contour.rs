//! A piece of a contour: where a function that is linear on a triangle is zero.

/// A corner: where it is, and how far the function is above the level of the contour there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Node {
    pub place: [f64; 2],
    pub above: f64,
}

impl Node {
    /// The middle of four corners.
    pub fn mean(corners: [Self; 4]) -> Self {
        let mean = |of: fn(&Self) -> f64| 0.25 * corners.iter().map(of).sum::<f64>();
        Self { place: [mean(|node| node.place[0]), mean(|node| node.place[1])], above: mean(|node| node.above) }
    }
}

/// The two ends of the piece in a triangle, if the contour goes through it.
pub(super) fn crossing(corners: [Node; 3]) -> Option<[[f64; 2]; 2]> {
    let sides = [(0, 1), (1, 2), (2, 0)].into_iter().filter_map(|(p, q)| {
        let (a, b) = (corners[p], corners[q]);
        let t = a.above / (a.above - b.above);
        let between = |k: usize| a.place[k] + t * (b.place[k] - a.place[k]);
        ((a.above < 0.0) != (b.above < 0.0)).then(|| [between(0), between(1)])
    });
    <[[f64; 2]; 2]>::try_from(sides.collect::<Vec<_>>()).ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_triangle_is_crossed_where_the_value_is_zero() {
        let corners = [([0.0, 0.0], -1.0), ([1.0, 0.0], 1.0), ([0.0, 1.0], 3.0)];
        let corners = corners.map(|(place, above)| Node { place, above });
        assert_eq!(crossing(corners), Some([[0.5, 0.0], [0.0, 0.25]]));
        assert_eq!(crossing(corners.map(|node| Node { above: node.above + 2.0, ..node })), None);
    }
}
