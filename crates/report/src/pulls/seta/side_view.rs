//! A seta seen from the side, along z: its branches as thick as they are, its tips and the ground.

use super::motion::SetaPose;
use crate::chart::RGBColor;
use crate::chart::axis::Axis;
use crate::chart::canvas::Stroke;
use crate::chart::panel::{Line, Mark, Panel, Shape};
use crate::chart::place::Frame;
use crate::chart::style::colour;
use crate::chart::symbol::Symbol;
use peelkit::study::SetaBranch;

/// Nanometres in a micrometre.
pub(super) const MICRO: f64 = 1e3;
/// Free around what is shown, over its size.
const MARGIN: f64 = 0.06;
/// The thinnest line, pixels.
const THINNEST: f64 = 0.4;

/// A part of space seen from the side, µm: from the lower left corner to the upper right one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Window {
    pub low: (f64, f64),
    pub high: (f64, f64),
}

impl Window {
    /// Around all sections of the branches that pass, and the ground.
    pub fn around<'a>(branches: impl Iterator<Item = &'a SetaBranch>) -> Self {
        let empty = Self { low: (f64::INFINITY, 0.0), high: (f64::NEG_INFINITY, 0.0) };
        let places = branches.flat_map(|branch| &branch.sections).map(|at| (at.place[0] / MICRO, at.place[1] / MICRO));
        let grown = places.fold(empty, |Self { low, high }, (x, y)| Self {
            low: (low.0.min(x), low.1.min(y)),
            high: (high.0.max(x), high.1.max(y)),
        });
        if grown.low.0 <= grown.high.0 { grown } else { Self { low: (0.0, 0.0), high: (1.0, 1.0) } }
    }

    /// Around the forks of the last generations, which end at the tips.
    pub fn of_brush<'a>(poses: impl Iterator<Item = &'a SetaPose> + Clone) -> Self {
        let branches = || poses.clone().flat_map(|pose| &pose.branches);
        let last = branches().map(|branch| branch.generation).max().unwrap_or(0);
        Self::around(branches().filter(|branch| branch.generation + 2 >= last))
    }

    /// Axes of equal scale in a frame.
    pub fn axes(self, frame: &Frame) -> [Axis; 2] {
        let Self { low, high } = self;
        let scale = ((high.0 - low.0) / frame.width()).max((high.1 - low.1) / frame.height()) * (1.0 + 2.0 * MARGIN);
        let scale = scale.max(f64::MIN_POSITIVE);
        let (wide, tall) = (scale * frame.width(), scale * frame.height());
        let (middle, below) = (0.5 * (low.0 + high.0), low.1 - MARGIN * tall);
        let x = Axis::linear("x (µm)", middle - 0.5 * wide, middle + 0.5 * wide);
        [x, Axis::linear("y (µm)", below, below + tall)]
    }
}

/// An empty panel with the ground.
pub(super) fn panel(frame: Frame, window: Window, title: &str) -> Panel {
    let [x, y] = window.axes(&frame);
    let ground = vec![(x.from, y.from), (x.to, y.from), (x.to, 0.0), (x.from, 0.0)];
    let shape = Shape { corners: ground, colour: colour::PALE, opacity: 1.0 };
    let line = Line::plain(vec![(x.from, 0.0), (x.to, 0.0)], Stroke::solid(colour::GREY, 1.0));
    Panel { title: title.to_owned(), shapes: vec![shape], lines: vec![line], ..Panel::new(frame, x, y) }
}

/// Adds the branches in one colour, with a name for the legend.
pub(super) fn add_branches(panel: &mut Panel, branches: &[SetaBranch], colour: RGBColor, name: &str) {
    let pixels = panel.frame.width() / (panel.x.to - panel.x.from);
    for (k, branch) in branches.iter().enumerate() {
        let width = (2.0 * branch.radius / MICRO * pixels).max(THINNEST);
        let points = branch.sections.iter().map(|at| (at.place[0] / MICRO, at.place[1] / MICRO)).collect();
        let name = (k == 0).then(|| name.to_owned());
        panel.lines.push(Line { points, stroke: Stroke::solid(colour, width), name });
    }
}

/// Adds the tips: attached and detached ones.
pub(super) fn add_tips(panel: &mut Panel, pose: &SetaPose) {
    let tips = pose.branches.iter().filter_map(|branch| Some((branch.sections.last()?.place, branch.tip?)));
    let adheres = |tip: usize| pose.tip_loads.get(tip).is_some_and(Option::is_some);
    let looks = [(true, colour::BLUE, "attached tip"), (false, colour::VERMILLION, "detached tip")];
    for (attached, colour, name) in looks {
        let mut name = Some(name.to_owned());
        for (place, _) in tips.clone().filter(|&(_, tip)| adheres(tip) == attached) {
            let at = (place[0] / MICRO, place[1] / MICRO);
            panel.marks.push(Mark { at, symbol: Symbol::Dot, colour, name: name.take(), note: None });
        }
    }
}
