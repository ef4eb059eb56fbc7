//! Where unknowns stand: station by station along S, at each of them the nodes of the section, at each node u and its slope by S.
//!
//! On the plane of symmetry u_z is zero. The end face moves and turns as a whole ([`super::end_face`]), by the unknowns of a rigid grip of a strip; its
//! slopes stay free.

use crate::solid::grip::{HEIGHT, NAMES, PLACE};

/// Unknowns of the interface.
pub(super) const OF_FACE: usize = NAMES.len();

/// Nodes of an element through the thickness, and across it.
pub(super) const THROUGH: usize = 3;
pub(super) const ACROSS: usize = 3;
/// Functions along S of an element: value and slope at the left end, and at the right end.
pub(super) const ALONG: usize = 4;
/// Functions of an element: function along S, node through, node across.
pub(super) const FUNCTIONS: usize = ALONG * THROUGH * ACROSS;
/// Unknowns of an element: x, y, z of each function.
pub(super) const ELEMENT: usize = 3 * FUNCTIONS;

/// What a number at a station is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct StationUnknown {
    /// Through the thickness, from the underside
    pub through: usize,
    /// Across the half width, from the plane of symmetry
    pub across: usize,
    /// Whether it is the slope
    pub slope: bool,
    /// x, y or z
    pub axis: usize,
}

/// The unknowns of a body of so many elements along S and across.
#[derive(Clone, Debug)]
pub(super) struct Layout {
    /// Elements along S
    pub columns: usize,
    /// Elements across the half width
    pub strips: usize,
    /// Unknowns of a station but the last
    pub station: Vec<StationUnknown>,
    /// Where a number of a station stands among its unknowns
    inner: Vec<Option<usize>>,
    /// The same of the end face
    last: Vec<Option<usize>>,
    /// Unknowns of the end face: its slopes, then the interface
    pub face: usize,
}

impl Layout {
    pub(crate) fn new(columns: usize, strips: usize) -> Self {
        let lines = 2 * strips + 1;
        let mut layout = Self { columns, strips, station: Vec::new(), inner: Vec::new(), last: Vec::new(), face: 0 };
        let mut slopes = 0;
        for node in 0..THROUGH * lines {
            for slope in [false, true] {
                for axis in 0..3 {
                    let (through, across) = (node / lines, node % lines);
                    let is_free = axis != 2 || across > 0;
                    layout.inner.push(is_free.then_some(layout.station.len()));
                    layout.last.push((is_free && slope).then_some(slopes));
                    slopes += usize::from(is_free && slope);
                    if is_free {
                        layout.station.push(StationUnknown { through, across, slope, axis });
                    }
                }
            }
        }
        layout.face = slopes + OF_FACE;
        for (number, place) in layout.last.iter_mut().enumerate() {
            match number % 6 {
                0 => *place = Some(slopes + PLACE),
                1 => *place = Some(slopes + HEIGHT),
                _ => {}
            }
        }
        layout
    }

    /// Lines of nodes across the half width.
    pub(crate) fn lines(&self) -> usize {
        2 * self.strips + 1
    }

    /// All unknowns.
    pub(crate) fn unknowns(&self) -> usize {
        self.columns * self.station.len() + self.face
    }

    /// The first unknown of a station.
    pub(crate) fn start(&self, station: usize) -> usize {
        station * self.station.len()
    }

    /// Unknowns of a station.
    pub(crate) fn at(&self, station: usize) -> usize {
        if station == self.columns { self.face } else { self.station.len() }
    }

    /// The unknown of a number of a station: of a node through and across, value or slope, x, y or z.
    pub(crate) fn unknown(
        &self,
        station: usize,
        (through, across): (usize, usize),
        slope: bool,
        axis: usize,
    ) -> Option<usize> {
        let number = 6 * (through * self.lines() + across) + 3 * usize::from(slope) + axis;
        let own = if station == self.columns { self.last[number] } else { self.inner[number] };
        own.map(|own| self.start(station) + own)
    }

    /// Where the unknowns of an element stand in the front of its column, function by function.
    pub(crate) fn places(&self, column: usize, strip: usize) -> Vec<Option<usize>> {
        let start = self.start(column);
        let mut places = Vec::with_capacity(ELEMENT);
        for along in 0..ALONG {
            for through in 0..THROUGH {
                for across in 0..ACROSS {
                    for axis in 0..3 {
                        let node = (through, 2 * strip + across);
                        let unknown = self.unknown(column + along / 2, node, along % 2 == 1, axis);
                        places.push(unknown.map(|unknown| unknown - start));
                    }
                }
            }
        }
        places
    }
}
