//! The pictures of a pull-off: the curve, the load of each tip at three moments, and the seta at its peak.

use super::load_map::{Moment, picture as load_map};
use super::motion::SetaPose;
use super::side_view::{MICRO, Window, add_branches, add_tips, panel};
use super::{curve, names};
use crate::chart::axis::with_unit;
use crate::chart::output::save_all;
use crate::chart::picture::{Heading, Picture};
use crate::chart::place::Frame;
use crate::chart::style::{WIDTH, colour};
use crate::records::passed::PassedAt;
use crate::writing::error::ReportError;
use peelkit::model::Seta;
use peelkit::study::{SetaPullOff, SetaState};
use peelkit::units::FORCES;
use std::path::{Path, PathBuf};

/// Height of the picture of the seta, pixels.
const HEIGHT: u32 = 480;

/// Draws into `dir`, each as SVG and PNG: `curve`, the force on the root and the number of attached tips; `tips`, maps of the load of each tip
/// at the first detachment, at the peak and at the last detachment; `seta`, the seta at its peak, seen from the side.
///
/// Fails where there are fewer than two points ([`ReportError::Draw`]), or a file cannot be written ([`ReportError::Write`]).
pub fn draw_pull_off<'h>(
    dir: &Path,
    pull_off: &SetaPullOff,
    seta: &Seta,
    passed: &[PassedAt],
    heading: impl Into<Heading<'h>>,
) -> Result<Vec<PathBuf>, ReportError> {
    let Heading { title, units } = heading.into();
    let caption = match names::seta_end_reason(&pull_off.end) {
        Some(reason) => format!("{title}\nThe pull-off stopped short: {reason}."),
        None => title.to_owned(),
    };
    if pull_off.points.len() < 2 {
        let reason = format!("the pull-off has {} points", pull_off.points.len());
        return Err(ReportError::Draw { path: dir.join("curve.svg"), reason });
    }
    let heading = Heading { title: &caption, units };
    let mut pictures = vec![(curve::picture(pull_off, passed, heading), "curve")];
    let moments: Vec<(&str, &SetaState)> = [
        ("first detachment", &pull_off.first_detachment),
        ("peak", &pull_off.peak),
        ("last detachment", &pull_off.last_detachment),
    ]
    .into_iter()
    .filter_map(|(name, state)| Some((name, state.as_ref()?)))
    .collect();
    if !moments.is_empty() {
        pictures.push((maps(&moments, seta, heading), "tips"));
    }
    if let Some(state) = pull_off.peak.as_ref().or(pull_off.last.as_ref()) {
        pictures.push((side_views(state, seta, heading), "seta"));
    }
    save_all(&pictures, dir)
}

/// Maps of the load of each tip.
fn maps(moments: &[(&str, &SetaState)], seta: &Seta, Heading { title, units }: Heading) -> Picture {
    let places: Vec<(f64, f64)> = (0..seta.tips())
        .map(|tip| seta.joint_place(seta.tip_joint(tip)))
        .map(|[x, _, z]| (x / MICRO, z / MICRO))
        .collect();
    let largest = moments.iter().map(|(_, state)| state.point.force_along.abs()).fold(0.0, f64::max);
    let unit = units.fitting(FORCES, largest);
    let moment = |(name, state): &(&str, &SetaState)| Moment {
        title: format!("{name}: {}", with_unit(unit, state.point.force_along, 3)),
        loads: SetaPose::of(state, seta).tip_loads,
    };
    let moments: Vec<Moment> = moments.iter().map(moment).collect();
    let title = format!(
        "{title}\nLoad of each tip on its stress-free place, at three moments of the pull: vermillion pulled, blue pushed, a cross where it is detached."
    );
    load_map(&places, seta.tip_distance() / MICRO, &moments, &title).in_units(units)
}

/// The whole seta beside where it was stress-free, and its tips.
fn side_views(state: &SetaState, seta: &Seta, Heading { title, units }: Heading) -> Picture {
    let pose = SetaPose::of(state, seta);
    let rest = SetaState::stress_free(seta).raised_by(state.raised).branches(seta);
    let frame = |left: f64, right: f64| Frame { left, top: 56.0, right, bottom: f64::from(HEIGHT) - 56.0 };
    let middle = 0.5 * f64::from(WIDTH);
    let window = Window::around(pose.branches.iter().chain(&rest));
    let mut whole = panel(frame(70.0, middle - 14.0), window, "the whole seta");
    add_branches(&mut whole, &rest, colour::ORANGE, "stress-free");
    add_branches(&mut whole, &pose.branches, colour::CAPTION, "pulled");
    let mut brush =
        panel(frame(middle + 56.0, f64::from(WIDTH) - 14.0), Window::of_brush([&pose].into_iter()), "its tips");
    add_branches(&mut brush, &pose.branches, colour::CAPTION, "");
    brush.lines.iter_mut().for_each(|line| line.name = None);
    add_tips(&mut brush, &pose);
    let force = state.point.force_along;
    let force = with_unit(units.fitting(FORCES, force.abs()), force, 4);
    let title = format!(
        "{title}\nThe seta to scale, seen from the side along z, under {force} with {} of {} tips attached.",
        state.point.attached,
        seta.tips()
    );
    Picture { title, height: HEIGHT, panels: vec![whole, brush] }.in_units(units)
}
