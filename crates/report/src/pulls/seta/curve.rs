//! The force on the root of a seta and the number of attached tips, against how far the root has moved.

use super::motion::{PullDirection, SetaMotion, travels};
use super::side_view::MICRO;
use crate::chart::axis::Axis;
use crate::chart::canvas::Stroke;
use crate::chart::marked::{Marked, mark_found};
use crate::chart::panel::{Band, Line, Mark, Panel};
use crate::chart::picture::{Heading, Picture};
use crate::chart::place::Frame;
use crate::chart::style::{WIDTH, colour};
use crate::records::passed::PassedAt;
use peelkit::study::{SetaPoint, SetaPullOff, SetaState, SetaStation};

/// Heights of the two panels, and where the first one begins and the second one, pixels.
const TOP: f64 = 40.0;
const FORCE: f64 = 260.0;
const BETWEEN: f64 = 24.0;
const TIPS: f64 = 130.0;

/// The picture of a pull-off with two or more points.
pub(super) fn picture(pull_off: &SetaPullOff, passed: &[PassedAt], Heading { title, units }: Heading) -> Picture {
    let travels = travels(&pull_off.points);
    let micro: Vec<f64> = travels.iter().map(|travel| travel / MICRO).collect();
    let of = |value: &dyn Fn(&SetaPoint) -> f64| -> Vec<(f64, f64)> {
        micro.iter().copied().zip(pull_off.points.iter().map(value)).collect()
    };
    let pull = PullDirection::of(&pull_off.points);
    let (forces, attached) = (of(&|point| pull.force(point)), of(&|point| point.attached as f64));
    let (left, right) = (84.0, f64::from(WIDTH) - 14.0);
    let first = Frame { left, top: TOP, right, bottom: TOP + FORCE };
    let second = Frame { left, top: first.bottom + BETWEEN, right, bottom: first.bottom + BETWEEN + TIPS };
    let x = |label: &str| Axis::around(label, micro.iter().copied(), false);
    let y = Axis::around("force P on the root along the pull (nN)", forces.iter().map(|at| at.1).chain([0.0]), false)
        .in_units(units);
    let stroke = Stroke::solid(colour::BLUE, 1.8);
    let mut force = Panel::of_lines(first, x("(µm)"), y, vec![Line::plain(forces, stroke)]);
    let zero = vec![(force.x.from, 0.0), (force.x.to, 0.0)];
    force.lines.insert(0, Line::plain(zero, Stroke::solid(colour::GREY, 0.9)));
    force.bands = bands(&pull_off.points, &micro);
    force.marks = marks(pull_off, &micro, &force.y);
    let place = |(at, SetaStation { point, .. }): (&PassedAt, &SetaStation)| {
        let first = pull_off.points.iter().position(|other| other.step == point.step)?;
        let before = micro[first] - pull_off.points[first].displacement / MICRO;
        Some(Marked { name: at.name.clone(), at: (before + point.displacement / MICRO, pull.force(point)) })
    };
    let found: Vec<Marked> = passed.iter().zip(&pull_off.stations).filter_map(place).collect();
    mark_found(std::slice::from_mut(&mut force), &found);
    let y = Axis::around("tips attached", attached.iter().map(|at| at.1).chain([0.0]), false);
    let label = "distance that the root has moved (µm)";
    let mut tips = Panel::of_lines(second, x(label), y, vec![Line::plain(attached, stroke)]);
    tips.bands = bands(&pull_off.points, &micro).into_iter().map(|band| Band { name: None, ..band }).collect();
    Picture { title: title.into(), height: (second.bottom + 54.0) as u32, panels: vec![force, tips] }.in_units(units)
}

/// The steps before the last one, each under its name.
fn bands(points: &[SetaPoint], micro: &[f64]) -> Vec<Band> {
    let steps = SetaMotion::of(points);
    let before = &steps[..steps.len().saturating_sub(1)];
    let band = |(index, step): (usize, &SetaMotion)| {
        let own = || points.iter().zip(micro).filter(|(point, _)| point.step == step.step).map(|(_, &at)| at);
        let colour = if index % 2 == 0 { colour::ORANGE } else { colour::GREEN };
        Some(Band { from: own().next()?, to: own().next_back()?, colour, name: Some(step.name.to_owned()) })
    };
    before.iter().enumerate().filter_map(band).collect()
}

fn marks(pull_off: &SetaPullOff, micro: &[f64], y: &Axis) -> Vec<Mark> {
    let place = |state: &SetaState| {
        let same = |point: &&SetaPoint| point.step == state.point.step;
        let first = pull_off.points.iter().position(|point| same(&point))?;
        Some(micro.get(first)? - pull_off.points[first].displacement / MICRO + state.point.displacement / MICRO)
    };
    let moments = [
        ("first detachment", &pull_off.first_detachment),
        ("peak", &pull_off.peak),
        ("last detachment", &pull_off.last_detachment),
    ];
    let mark = |(name, state): (&str, &Option<SetaState>)| {
        let state = state.as_ref()?;
        let force = state.point.force_along;
        let text = format!("{}, {} tips", y.text_of(force, 4), state.point.attached);
        Some(Mark::labelled((place(state)?, force), colour::INK, &[name, &text]))
    };
    moments.into_iter().filter_map(mark).collect()
}
