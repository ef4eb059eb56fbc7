//! The picture of a test: force against the machine's displacement, there and back.

use crate::chart::axis::{Axis, with_unit};
use crate::chart::canvas::Stroke;
use crate::chart::marked::mark_found;
use crate::chart::output::save;
use crate::chart::panel::{Line, Mark, Note, Panel};
use crate::chart::picture::{Heading, Picture};
use crate::chart::place::Frame;
use crate::chart::style::{WIDTH, colour};
use crate::chart::symbol::Symbol;
use crate::records::passed::PassedAt;
use crate::writing::error::ReportError;
use crate::writing::names::jump_title;
use peelkit::study::{LoadingDirection, Observed};
use peelkit::units::{PreferredUnits, WORKS};
use std::path::{Path, PathBuf};

const HEIGHT: u32 = 460;
/// Most jumps that are labelled; all are drawn.
const LABELLED: usize = 6;

/// Draws `observed.svg` and `observed.png` into `dir`: what is recorded as the machine retreats and comes back, jumps dashed, with stations and events.
///
/// Fails where there is nothing to draw ([`ReportError::Draw`]) or a file cannot be written ([`ReportError::Write`]).
pub fn draw_observed<'h>(
    test: &Observed,
    passed: &[PassedAt],
    heading: impl Into<Heading<'h>>,
    dir: &Path,
) -> Result<Vec<PathBuf>, ReportError> {
    if test.points.len() < 2 {
        let reason = format!("the test has {} points", test.points.len());
        return Err(ReportError::Draw { path: dir.join("observed.svg"), reason });
    }
    let mut picture = picture(test, heading.into());
    mark_found(&mut picture.panels, &passed.iter().map(PassedAt::marked).collect::<Vec<_>>());
    save(&picture, dir, "observed")
}

fn picture(test: &Observed, Heading { title, units }: Heading) -> Picture {
    let farthest = test.points.iter().fold(0.0f64, |far, p| far.max(p.machine));
    let frame = Frame { left: 84.0, top: 40.0, right: f64::from(WIDTH) - 14.0, bottom: f64::from(HEIGHT) - 56.0 };
    Picture { title: title.into(), height: HEIGHT, panels: vec![panel(test, frame, 1.04 * farthest, units)] }
}

fn panel(test: &Observed, frame: Frame, to: f64, units: PreferredUnits) -> Panel {
    let shown = test.pieces.iter().flat_map(|piece| &piece.1);
    let (low, high) = shown.fold((0.0f64, 0.0f64), |(low, high), p| (low.min(p.1), high.max(p.1)));
    let room = 0.12 * (high - low).max(f64::MIN_POSITIVE);
    let bottom = if low < 0.0 { low - room } else { 0.0 };
    let x = Axis::linear("displacement of the machine U (nm)", -0.03 * to, to).in_units(units);
    let y = Axis::linear("force P (nN)", bottom, high + room).in_units(units);
    let mut panel = Panel::new(frame, x, y);
    let zero = vec![(-0.03 * to, 0.0), (to, 0.0)];
    panel.lines.push(Line { points: zero, stroke: Stroke::solid(colour::GREY, 0.9), name: None });
    for way in [LoadingDirection::Retreat, LoadingDirection::Approach] {
        let stroke = match way {
            LoadingDirection::Retreat => Stroke::solid(colour::BLUE, 2.4),
            LoadingDirection::Approach => Stroke::solid(colour::ORANGE, 1.6),
        };
        let mut name = Some(way.word().to_owned());
        for (_, points) in test.pieces.iter().filter(|piece| piece.0 == way) {
            panel.lines.push(Line { points: points.clone(), stroke, name: name.take() });
        }
    }
    let mut name = Some("jump".to_owned());
    // the pull-off force first: it has the best place of all labels
    if let Some(peak) = test.pull_off {
        let text = vec!["pull-off force".to_owned(), panel.y.text_of(peak.force, 4)];
        let note = Some(Note { badge: None, text });
        let at = (peak.machine, peak.force);
        panel.marks.push(Mark { at, symbol: Symbol::Dot, colour: colour::BLUE, name: None, note });
    }
    for (n, jump) in test.jumps.iter().enumerate() {
        let (from, landed) = ((jump.machine, jump.before.force), (jump.machine, jump.after.force));
        let stroke = Stroke::dashed(colour::INK, 1.4);
        panel.lines.push(Line { points: vec![from, landed], stroke, name: name.take() });
        let text = vec![
            jump_title(&test.jumps, n).to_owned(),
            format!("U = {}", panel.x.text_of(jump.machine, 4)),
            format!("released {}", with_unit(units.fitting(WORKS, jump.released.abs()), jump.released, 4)),
        ];
        let note = (n < LABELLED).then_some(Note { badge: None, text });
        panel.marks.push(Mark { at: from, symbol: Symbol::Diamond, colour: colour::INK, name: None, note });
        panel.marks.push(Mark::dot(landed, colour::INK));
    }
    panel
}
