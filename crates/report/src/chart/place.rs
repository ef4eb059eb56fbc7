//! Where labels go: near what they name, off the curves and off one another.

use super::canvas::Pixel;

/// A rectangle of the sheet, pixels; y runs downwards.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame {
    /// Left edge, pixels from that of the sheet.
    pub left: f64,
    /// Upper edge, pixels from that of the sheet.
    pub top: f64,
    /// Right edge, pixels from the left edge of the sheet.
    pub right: f64,
    /// Lower edge, pixels from the upper edge of the sheet.
    pub bottom: f64,
}

impl Frame {
    /// From the left edge to the right one, pixels.
    pub fn width(&self) -> f64 {
        self.right - self.left
    }
    /// From the upper edge to the lower one, pixels.
    pub fn height(&self) -> f64 {
        self.bottom - self.top
    }
    pub(crate) fn grown(&self, by: f64) -> Frame {
        Frame { left: self.left - by, top: self.top - by, right: self.right + by, bottom: self.bottom + by }
    }
    pub(crate) fn holds(&self, p: Pixel) -> bool {
        p.0 >= self.left && p.0 <= self.right && p.1 >= self.top && p.1 <= self.bottom
    }
    pub(crate) fn corners(&self) -> [Pixel; 4] {
        [(self.left, self.top), (self.right, self.top), (self.right, self.bottom), (self.left, self.bottom)]
    }
    fn shared(&self, other: &Frame) -> f64 {
        let wide = (self.right.min(other.right) - self.left.max(other.left)).max(0.0);
        let high = (self.bottom.min(other.bottom) - self.top.max(other.top)).max(0.0);
        wide * high
    }
    /// The point of the frame nearest to `p`.
    pub(crate) fn nearest(&self, p: Pixel) -> Pixel {
        (p.0.clamp(self.left, self.right), p.1.clamp(self.top, self.bottom))
    }
}

/// How far from its point a label may stand, pixels; a number alone stands at one of the first ones.
const DISTANCES: [f64; 13] = [9.0, 14.0, 20.0, 28.0, 38.0, 50.0, 64.0, 80.0, 100.0, 125.0, 150.0, 180.0, 215.0];
const NEARBY: usize = 9;
/// What a leader counts that crosses another one: as much as a label over a curve of some 40 pixels.
const CROSSING: f64 = 13.0;
/// Places of a leader that are looked at.
const LOOKS: usize = 32;
/// What is nearer to a legend is beside it, pixels.
const NEAR: f64 = 24.0;

/// What of a panel is taken already.
pub(crate) struct Places {
    room: Frame,
    ink: Vec<Pixel>,
    taken: Vec<Frame>,
    /// The leaders of labels, which no label covers.
    leaders: Vec<[Pixel; 2]>,
}

impl Places {
    pub fn new(room: Frame) -> Self {
        Places { room, ink: Vec::new(), taken: Vec::new(), leaders: Vec::new() }
    }

    /// A line that labels should not cover.
    pub fn add_line(&mut self, points: &[Pixel]) {
        for pair in points.windows(2) {
            let ((ax, ay), (bx, by)) = (pair[0], pair[1]);
            let pieces = ((bx - ax).hypot(by - ay) / 3.0).ceil().clamp(1.0, 1000.0) as usize;
            let along = |i: usize| i as f64 / pieces as f64;
            self.ink.extend((0..pieces).map(|i| (ax + along(i) * (bx - ax), ay + along(i) * (by - ay))));
        }
        self.ink.extend(points.last());
    }

    /// A line from a label to its point.
    pub fn add_leader(&mut self, ends: [Pixel; 2]) {
        self.add_line(&ends);
        self.leaders.push(ends);
    }

    /// A spot that nothing may cover.
    pub fn add_spot(&mut self, spot: Frame) {
        self.taken.push(spot);
    }

    /// Takes the emptiest place for a block, a legend say, by preference along the rim.
    pub fn along_rim(&mut self, width: f64, height: f64) -> Frame {
        const STEPS: usize = 16;
        let free = (self.room.width() - width - 16.0, self.room.height() - height - 16.0);
        let at = |fx: f64, fy: f64| {
            let (left, top) = (self.room.left + 8.0 + fx * free.0, self.room.top + 8.0 + fy * free.1);
            Frame { left, top, right: left + width, bottom: top + height }
        };
        let part = |step: usize| step as f64 / STEPS as f64;
        let is_end = |f: f64| f == 0.0 || f == 1.0;
        // corners before rims, rims before the rest, and of these round parts first
        let toll = |fx: f64, fy: f64| -> f64 {
            let one = |f: f64| if is_end(f) { 0.0 } else { 2.0 + if (4.0 * f).fract() == 0.0 { 0.0 } else { 0.5 } };
            one(fx) + one(fy) + if is_end(fx) || is_end(fy) { 0.0 } else { 8.0 }
        };
        let tries = (0..=STEPS).flat_map(|i| (0..=STEPS).map(move |j| (part(i), part(j))));
        // and far from lines before near ones
        let near = |frame: &Frame| {
            let around = frame.grown(NEAR);
            self.ink.iter().filter(|&&p| around.holds(p)).count() as f64 * 0.02
        };
        let tries = tries.map(|(fx, fy)| (at(fx, fy), toll(fx, fy))).map(|(frame, toll)| (frame, toll + near(&frame)));
        self.take(tries.collect())
    }

    /// Whether a block lies over a line or a spot.
    pub fn covers(&self, block: &Frame) -> bool {
        let spots = self.taken.iter().any(|taken| taken != block && block.shared(taken) > 0.0);
        spots || self.ink.iter().any(|&p| block.holds(p))
    }

    /// Takes a place near `at` for a block.
    pub fn beside(&mut self, at: Pixel, width: f64, height: f64) -> Frame {
        let mut tries = self.around(at, width, height, &DISTANCES[..NEARBY]);
        for (frame, toll) in &mut tries {
            *toll += self.crossing(at, frame) + if self.hides(at, frame) { CROSSING } else { 0.0 };
        }
        self.take(tries)
    }

    /// What speaks against a block near `at` whose leader crosses another one.
    fn crossing(&self, at: Pixel, frame: &Frame) -> f64 {
        let crosses = self.leaders.iter().any(|&other| cross([at, frame.nearest(at)], other));
        if crosses { CROSSING } else { 0.0 }
    }

    /// Takes a place near `at` for a block that covers no other one and stays inside; none where there is no such place.
    pub fn clear_beside(&mut self, at: Pixel, width: f64, height: f64) -> Option<Frame> {
        let mut tries = self.around(at, width, height, &DISTANCES);
        tries.retain(|(frame, _)| {
            let led_through =
                self.leaders.iter().any(|&[a, b]| clip_segment(a, b, frame).is_some()) || self.hides(at, frame);
            self.covered(frame) == 0.0 && self.outside(frame) < 1.0 && !led_through
        });
        for (frame, toll) in &mut tries {
            *toll += self.crossing(at, frame);
        }
        (!tries.is_empty()).then(|| self.take(tries))
    }

    /// Places near `at`, and what speaks against each.
    fn around(&self, at: Pixel, width: f64, height: f64, distances: &[f64]) -> Vec<(Frame, f64)> {
        let mut tries = Vec::new();
        for &distance in distances {
            for turn in 0..24 {
                let (sin, cos) = (f64::from(turn) * std::f64::consts::PI / 12.0).sin_cos();
                let (x, y) = (at.0 + distance * cos, at.1 - distance * sin);
                // The block touches (x, y) with the point of its rim that faces `at`.
                let (left, top) = (x - width * 0.5 * (1.0 - cos), y - height * 0.5 * (1.0 + sin));
                let frame = Frame { left, top, right: left + width, bottom: top + height };
                // Whatever stands between the point and its label.
                let between =
                    (1..8).map(|i| f64::from(i) / 8.0).map(|t| (at.0 + t * (x - at.0), at.1 + t * (y - at.1)));
                let hidden = between.filter(|&p| self.taken.iter().any(|t| t.holds(p) && !t.holds(at))).count();
                tries.push((frame, 0.12 * distance + 10.0 * hidden as f64));
            }
        }
        tries
    }

    /// Whether the leader of a label of the point `at` would run through another label.
    fn hides(&self, at: Pixel, label: &Frame) -> bool {
        let near = label.nearest(at);
        let along = (1..LOOKS).map(|k| k as f64 / LOOKS as f64);
        let mut leader = along.map(|t| (at.0 + t * (near.0 - at.0), at.1 + t * (near.1 - at.1)));
        leader.any(|p| self.taken.iter().any(|taken| taken.holds(p) && !taken.holds(at)))
    }

    fn take(&mut self, tries: Vec<(Frame, f64)>) -> Frame {
        let priced = tries.into_iter().map(|(frame, toll)| (frame, toll + self.cost(&frame)));
        let best = priced.min_by(|a, b| a.1.total_cmp(&b.1)).map_or(self.room, |(frame, _)| frame);
        self.taken.push(best);
        best
    }

    fn cost(&self, frame: &Frame) -> f64 {
        let wide = frame.grown(4.0);
        let crossed = self.ink.iter().filter(|&&p| wide.holds(p)).count() as f64;
        crossed + self.covered(frame) + 5.0 * self.outside(frame)
    }

    /// How much of what is taken a block and its rim cover, square pixels.
    fn covered(&self, frame: &Frame) -> f64 {
        let wide = frame.grown(4.0);
        self.taken.iter().map(|taken| wide.shared(taken)).sum()
    }

    /// How much of a block lies outside, square pixels.
    fn outside(&self, frame: &Frame) -> f64 {
        (frame.width() * frame.height() - frame.shared(&self.room.grown(-3.0))).max(0.0)
    }
}

/// Whether two segments cross.
fn cross([a, b]: [Pixel; 2], [c, d]: [Pixel; 2]) -> bool {
    let side = |p: Pixel, q: Pixel, of: Pixel| (q.0 - p.0) * (of.1 - p.1) - (q.1 - p.1) * (of.0 - p.0);
    side(a, b, c) * side(a, b, d) < 0.0 && side(c, d, a) * side(c, d, b) < 0.0
}

/// The outline of a line of this width, its ends cut off square.
pub(crate) fn ribbon(points: &[Pixel], width: f64) -> Vec<Pixel> {
    let mut apart = points.to_vec();
    apart.dedup();
    let beside = |side: f64| {
        let last = apart.len().saturating_sub(1);
        let apart = &apart;
        move |k: usize| {
            let (from, to) = (apart[k.saturating_sub(1)], apart[(k + 1).min(last)]);
            let (across, down) = (to.0 - from.0, to.1 - from.1);
            let half = 0.5 * side * width / across.hypot(down).max(f64::MIN_POSITIVE);
            (apart[k].0 - half * down, apart[k].1 + half * across)
        }
    };
    (0..apart.len()).map(beside(1.0)).chain((0..apart.len()).rev().map(beside(-1.0))).collect()
}

/// The part of an area that lies inside a frame, by Sutherland and Hodgman.
pub(crate) fn clip_area(corners: &[Pixel], frame: &Frame) -> Vec<Pixel> {
    let inside: [&dyn Fn(Pixel) -> f64; 4] =
        [&|p: Pixel| p.0 - frame.left, &|p: Pixel| frame.right - p.0, &|p: Pixel| p.1 - frame.top, &|p: Pixel| {
            frame.bottom - p.1
        }];
    let mut left = corners.to_vec();
    for depth in inside {
        let before = std::mem::take(&mut left);
        for (k, &to) in before.iter().enumerate() {
            let from = before[(k + before.len() - 1) % before.len()];
            let (a, b) = (depth(from), depth(to));
            if (a < 0.0) != (b < 0.0) {
                let t = a / (a - b);
                left.push((from.0 + t * (to.0 - from.0), from.1 + t * (to.1 - from.1)));
            }
            if b >= 0.0 {
                left.push(to);
            }
        }
    }
    left
}

/// The pieces of a line that lie inside a frame.
pub(crate) fn clip(points: &[Pixel], frame: &Frame) -> Vec<Vec<Pixel>> {
    let mut pieces: Vec<Vec<Pixel>> = Vec::new();
    let mut open = false;
    for pair in points.windows(2) {
        match clip_segment(pair[0], pair[1], frame) {
            Some((a, b)) => {
                if !open {
                    pieces.push(vec![a]);
                }
                if let Some(piece) = pieces.last_mut() {
                    piece.push(b);
                }
                open = b == pair[1];
            }
            None => open = false,
        }
    }
    pieces
}

/// Liang and Barsky's clipping.
fn clip_segment(a: Pixel, b: Pixel, frame: &Frame) -> Option<(Pixel, Pixel)> {
    let (dx, dy) = (b.0 - a.0, b.1 - a.1);
    if !(dx.is_finite() && dy.is_finite()) {
        return None;
    }
    let (mut enter, mut leave) = (0.0f64, 1.0f64);
    let sides = [(-dx, a.0 - frame.left), (dx, frame.right - a.0), (-dy, a.1 - frame.top), (dy, frame.bottom - a.1)];
    for (step, room) in sides {
        if step == 0.0 {
            if room < 0.0 {
                return None;
            }
        } else if step < 0.0 {
            enter = enter.max(room / step);
        } else {
            leave = leave.min(room / step);
        }
    }
    let at = |t: f64| (a.0 + t * dx, a.1 + t * dy);
    let start = if enter > 0.0 { at(enter) } else { a };
    let end = if leave < 1.0 { at(leave) } else { b };
    (enter <= leave).then_some((start, end))
}

#[cfg(test)]
mod tests {
    use super::*;

    const ROOM: Frame = Frame { left: 0.0, top: 0.0, right: 100.0, bottom: 100.0 };

    #[test]
    fn a_line_through_a_frame_is_cut_at_both_sides() {
        assert_eq!(clip(&[(-50.0, 50.0), (150.0, 50.0)], &ROOM), vec![vec![(0.0, 50.0), (100.0, 50.0)]]);
        assert_eq!(clip(&[(50.0, 50.0), (150.0, 50.0), (50.0, 60.0)], &ROOM).len(), 2);
        assert!(clip(&[(-1.0, -1.0), (-2.0, 50.0)], &ROOM).is_empty());
    }

    /// A label that stands between a point and its room: the leader goes round it, and no later label lies on a leader.
    #[test]
    fn no_leader_runs_through_a_label() {
        let mut places = Places::new(ROOM);
        places.add_spot(Frame { left: 20.0, top: 40.0, right: 80.0, bottom: 52.0 });
        let at = (50.0, 56.0);
        let label = places.clear_beside(at, 30.0, 12.0).unwrap();
        assert!(label.top > 52.0, "{label:?}");
        places.add_leader([(10.0, 95.0), (90.0, 85.0)]);
        let beside = places.clear_beside((50.0, 88.0), 20.0, 8.0).unwrap();
        assert!(places.leaders.iter().all(|&[a, b]| clip_segment(a, b, &beside).is_none()), "{beside:?}");
    }

    /// Of two points one above the other the lower one has its label beside it, though there is more room above.
    #[test]
    fn no_leader_crosses_another_where_there_is_room() {
        let mut places = Places::new(ROOM);
        places.add_leader([(0.0, 60.0), (100.0, 60.0)]);
        places.add_line(&[(0.0, 95.0), (100.0, 95.0)]);
        for (left, right) in [(0.0, 40.0), (60.0, 100.0)] {
            places.add_spot(Frame { left, top: 66.0, right, bottom: 100.0 });
        }
        let at = (50.0, 75.0);
        let label = places.clear_beside(at, 12.0, 8.0).unwrap();
        assert!(!cross([at, label.nearest(at)], [(0.0, 60.0), (100.0, 60.0)]), "{label:?}");
        assert!(cross([(0.0, 0.0), (2.0, 2.0)], [(0.0, 2.0), (2.0, 0.0)]));
        assert!(!cross([(0.0, 0.0), (2.0, 2.0)], [(0.0, 1.0), (0.0, 3.0)]));
    }

    #[test]
    fn a_thick_line_ends_at_the_frame() {
        let outline = ribbon(&[(-50.0, 95.0), (50.0, 95.0), (50.0, 95.0), (150.0, 95.0)], 20.0);
        assert_eq!(
            outline,
            [(-50.0, 105.0), (50.0, 105.0), (150.0, 105.0), (150.0, 85.0), (50.0, 85.0), (-50.0, 85.0)]
        );
        let inside = clip_area(&outline, &ROOM);
        let (low, high) = inside.iter().fold((f64::INFINITY, 0.0f64), |(low, high), p| (low.min(p.1), high.max(p.1)));
        assert!(inside.iter().all(|&p| ROOM.holds(p)), "{inside:?}");
        assert_eq!((low, high), (85.0, 100.0));
        assert!(clip_area(&outline, &Frame { bottom: 50.0, ..ROOM }).is_empty());
    }

    #[test]
    fn a_label_without_room_has_no_place() {
        let mut places = Places::new(ROOM);
        places.add_spot(Frame { left: 40.0, ..ROOM });
        assert!(places.clear_beside((60.0, 50.0), 50.0, 12.0).is_none());
        let found = places.clear_beside((60.0, 50.0), 20.0, 12.0).unwrap();
        assert!(found.right < 40.0 && found.left > 0.0);
    }

    #[test]
    fn a_legend_covers_no_line_where_there_is_room() {
        let mut places = Places::new(ROOM);
        // all but a corner of the room is full of lines
        (0..20).for_each(|k| places.add_line(&[(5.0 * f64::from(k), 0.0), (5.0 * f64::from(k), 50.0)]));
        (0..12).for_each(|k| places.add_line(&[(5.0 * f64::from(k), 50.0), (5.0 * f64::from(k), 100.0)]));
        let legend = places.along_rim(25.0, 30.0);
        assert!(places.ink.iter().all(|&p| !legend.holds(p)), "{legend:?}");
    }

    #[test]
    fn two_labels_of_one_spot_do_not_overlap() {
        let mut places = Places::new(ROOM);
        places.add_line(&[(0.0, 50.0), (100.0, 50.0)]);
        let (a, b) = (places.beside((50.0, 50.0), 40.0, 12.0), places.beside((50.0, 50.0), 40.0, 12.0));
        assert_eq!(a.shared(&b), 0.0);
        assert!(!a.holds((50.0, 50.0)) && !b.holds((50.0, 50.0)));
    }
}
