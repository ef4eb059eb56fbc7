//! The pull-off of a seta as a page that a browser plays: the seta and its brush seen from the side, the force, and the load of each tip. The
//! page is one file that needs no other, and well-formed XML.

use super::motion::{PullDirection, SetaPose, travels};
use super::side_view::{MICRO, Window};
use crate::animation::panel::{Panel, escaped, joined};
use crate::animation::player::{PLAYER, controls};
use crate::chart::axis::Axis;
use crate::chart::place::Frame;
use crate::chart::style::signed_shade;
use crate::writing::error::ReportError;
use crate::writing::file::write_whole;
use peelkit::model::Seta;
use peelkit::study::{SetaPoint, SetaPullOff, SetaState};
use std::fmt::Write;
use std::path::{Path, PathBuf};

const WIDTH: f64 = 940.0;
const WHOLE: Frame = Frame { left: 52.0, top: 16.0, right: 440.0, bottom: 400.0 };
const BRUSH: Frame = Frame { left: 520.0, top: 16.0, right: 926.0, bottom: 400.0 };
const CURVE: Frame = Frame { left: 72.0, top: 462.0, right: 600.0, bottom: 700.0 };
const TIPS: Frame = Frame { left: 688.0, top: 462.0, right: 926.0, bottom: 700.0 };
/// Colours of the loads, from the largest push to the largest pull.
const SHADES: usize = 32;
/// The coordinates of the tree in the page are whole numbers of so many nm.
const GRAIN: f64 = 10.0;
/// The thinnest line, pixels.
const THINNEST: f64 = 0.4;

const STYLE: &str = "body{font:15px sans-serif;color:#1e1e1e;max-width:960px;margin:1em auto}\
svg{width:100%;height:auto}text{font:13px sans-serif;fill:#1e1e1e}.frame{fill:none;stroke:#1e1e1e}\
.grid{stroke:#e8e8e8}.curve{fill:none;stroke:#0072b2;stroke-width:2}.ground{fill:#e8e8e8;stroke:#1e1e1e}\
.branch{fill:none;stroke:#505050;stroke-linecap:round;stroke-linejoin:round}\
.on{stroke:#0072b2;fill:none;stroke-linecap:round;stroke-width:4}.off{stroke:#d55e00;fill:none;stroke-linecap:round;stroke-width:4}\
p.small{font-size:12px;color:#505050}div.controls{display:flex;gap:1em;align-items:center}input{flex:1}\
output{min-width:24em;font-size:14px}";

/// No sign of it is one that XML reads: neither a left angle bracket nor an ampersand.
const SCRIPT: &str = r#"
const data = JSON.parse(document.getElementById('data').textContent), frames = data.frames;
const cells = Array.from(document.querySelectorAll('.tip'));
const panels = data.panels.map((panel, k) => ({
  map: panel, paths: Array.from(document.querySelectorAll('.p' + k)),
  on: document.getElementById('on' + k), off: document.getElementById('off' + k) }));
const seconds = 14;
function draw(panel, xy, loads) {
  const [x0, sx, y0, sy] = panel.map, ds = panel.paths.map(() => '');
  const place = i => (x0 + sx * xy[2 * i]).toFixed(1) + ' ' + (y0 + sy * xy[2 * i + 1]).toFixed(1);
  let point = 0;
  data.branches.forEach(([count, generation]) => {
    let d = 'M' + place(point);
    for (let k = 1; count > k; k++) d += 'L' + place(point + k);
    ds[generation] += d; point += count;
  });
  panel.paths.forEach((path, g) => path.setAttribute('d', ds[g]));
  let on = '', off = '';
  data.tips.forEach((point, i) => { const d = 'M' + place(point) + 'h0'; if (loads[i] === null) off += d; else on += d; });
  panel.on.setAttribute('d', on); panel.off.setAttribute('d', off);
}
function show() {
  const [a, b, share] = around(frames);
  const part = b.j ? (share >= 1 ? 1 : 0) : share, near = part > 0.5 ? b : a;
  const mix = (p, q) => p + part * (q - p);
  const xy = a.l.map((value, i) => mix(value, b.l[i]));
  panels.forEach(panel => draw(panel, xy, near.f));
  cells.forEach((cell, i) => {
    const load = near.f[i];
    cell.setAttribute('fill', load === null ? '#ffffff' : data.shades[load]);
    cell.setAttribute('stroke', load === null ? '#d55e00' : 'none');
  });
  dot.setAttribute('cx', mix(a.x, b.x)); dot.setAttribute('cy', mix(a.y, b.y));
  says.textContent = 'u = ' + mix(a.u, b.u).toPrecision(4) + ' µm, P = ' + mix(a.p, b.p).toPrecision(4) + ' µN, '
    + near.n + ' of ' + data.tips.length + ' tips attached';
}
start();
"#;

/// What is shown of a pull-off.
struct Playback<'a> {
    poses: Vec<SetaPose>,
    /// How far the root has moved at each of them, nm
    travels: Vec<f64>,
    /// Along which the force is shown
    pull: PullDirection,
    /// How far the root has moved (nm) and the force on it (nN), all along
    curve: Vec<(f64, f64)>,
    /// Places of the tips on the ground, nm
    tips: Vec<(f64, f64)>,
    /// From one tip to the next, nm
    pitch: f64,
    title: &'a str,
}

/// Writes `animation.html` into `dir`, of states in the order of the pull-off.
///
/// Fails where there are fewer than two states ([`ReportError::Draw`]) or the file cannot be written ([`ReportError::Write`]).
pub fn write_seta_animation(
    dir: &Path,
    pull_off: &SetaPullOff,
    states: &[SetaState],
    seta: &Seta,
    title: &str,
) -> Result<PathBuf, ReportError> {
    let path = dir.join("animation.html");
    if states.len() < 2 {
        let reason = format!("the pull-off has {} states", states.len());
        return Err(ReportError::Draw { path, reason });
    }
    let travels = travels(&pull_off.points);
    let travel = |state: &SetaState| {
        let same = |point: &SetaPoint| point.step == state.point.step;
        let first = pull_off.points.iter().position(same).unwrap_or_default();
        let before =
            travels.get(first).zip(pull_off.points.get(first)).map_or(0.0, |(at, point)| at - point.displacement);
        before + state.point.displacement
    };
    let pull = PullDirection::of(&pull_off.points);
    let playback = Playback {
        travels: states.iter().map(travel).collect(),
        poses: states.iter().map(|state| SetaPose::of(state, seta)).collect(),
        pull,
        curve: travels.iter().copied().zip(pull_off.points.iter().map(|point| pull.force(point))).collect(),
        tips: (0..seta.tips()).map(|tip| seta.joint_place(seta.tip_joint(tip))).map(|[x, _, z]| (x, z)).collect(),
        pitch: seta.tip_distance(),
        title,
    };
    write_whole(&path, page(&playback).as_bytes())?;
    Ok(path)
}

fn page(playback: &Playback<'_>) -> String {
    let mut lines = playback.title.lines();
    let heading = escaped(lines.next().unwrap_or_default());
    let remarks: String = lines.map(|line| format!("<p class=\"small\">{}</p>\n", escaped(line))).collect();
    let all = playback.poses.iter().flat_map(|pose| &pose.branches);
    let panels =
        [(WHOLE, Window::around(all)), (BRUSH, Window::of_brush(playback.poses.iter()))].map(|(frame, window)| {
            let [x, y] = window.axes(&frame);
            Panel { frame, x, y }
        });
    let curve = curve_panel(&playback.curve);
    let tips = tips_panel(playback);
    let mut svg =
        format!("<svg viewBox=\"0 0 {WIDTH} {}\" role=\"img\">\n<title>{heading}</title>\n<defs>", CURVE.bottom + 48.0);
    for (k, panel) in panels.iter().enumerate() {
        let Frame { left, top, .. } = panel.frame;
        let (wide, tall) = (panel.frame.width(), panel.frame.height());
        let _ = write!(
            svg,
            "<clipPath id=\"clip{k}\"><rect x=\"{left}\" y=\"{top}\" width=\"{wide}\" height=\"{tall}\"/></clipPath>"
        );
    }
    svg += "</defs>\n";
    for (k, panel) in panels.iter().enumerate() {
        svg += &side_view(k, panel, &playback.poses);
    }
    svg += &curve.axes("distance that the root has moved (µm)", "force on the root P (µN)");
    let points: Vec<(f64, f64)> = playback.curve.iter().map(|&(u, p)| (u / MICRO, p / MICRO)).collect();
    let _ = writeln!(svg, "<polyline class=\"curve\" points=\"{}\"/>", joined(&curve, &points));
    svg += &tips.axes("x of the tip (µm)", "z (µm)");
    svg += &cells(playback, &tips);
    svg += "<circle id=\"dot\" r=\"6\" fill=\"#0072b2\"/>\n</svg>\n";
    let largest = largest_load(&playback.poses);
    format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head><meta charset=\"utf-8\"/><title>{heading}</title><style>{STYLE}</style></head>\n\
         <body>\n<h1 style=\"font-size:18px\">{heading}</h1>\n{svg}\
         {}\
         <p class=\"small\">The tree to scale, seen from the side, whole and near the ground; the force on its root; and the load of each tip: \
         vermillion pulled, by up to {largest:.3} nN, blue pushed, framed where it is detached. Blue dots: attached tips, vermillion dots: \
         detached ones. All moments shown are equilibria that were computed; between two of them, where no tip jumps, the picture is interpolated.</p>\n{remarks}\
         <script type=\"application/json\" id=\"data\">{}</script>\n<script>{PLAYER}{SCRIPT}</script>\n</body>\n</html>\n",
        controls("place on the curve"),
        data(playback, &panels, &curve)
    )
}

fn curve_panel(curve: &[(f64, f64)]) -> Panel {
    let x = Axis::around("", curve.iter().map(|at| at.0 / MICRO), false);
    let y = Axis::around("", curve.iter().map(|at| at.1 / MICRO).chain([0.0]), false);
    Panel { frame: CURVE, x, y }
}

/// The grid of tips, with axes of equal scale.
fn tips_panel(playback: &Playback<'_>) -> Panel {
    let tips = || playback.tips.iter().map(|at| (at.0 / MICRO, at.1 / MICRO));
    let [low, high] =
        [f64::min, f64::max].map(|pick| tips().reduce(|a, b| (pick(a.0, b.0), pick(a.1, b.1))).unwrap_or_default());
    let half = 0.5 * (high.0 - low.0).max(high.1 - low.1) + playback.pitch / MICRO;
    let axis = |low: f64, high: f64| Axis::linear("", 0.5 * (low + high) - half, 0.5 * (low + high) + half);
    Panel { frame: TIPS, x: axis(low.0, high.0), y: axis(low.1, high.1) }
}

/// The axes of a view of the seta, the ground, and a path for each generation of branches.
fn side_view(k: usize, panel: &Panel, poses: &[SetaPose]) -> String {
    let Frame { left, right, bottom, .. } = panel.frame;
    let (_, ground) = panel.pixel((0.0, 0.0));
    let mut svg = format!(
        "<rect class=\"ground\" x=\"{left}\" y=\"{ground:.1}\" width=\"{:.1}\" height=\"{:.1}\"/>\n",
        right - left,
        (bottom - ground).max(0.0)
    );
    svg += &panel.axes("x (µm)", "y (µm)");
    let pixels = panel.frame.width() / (panel.x.to - panel.x.from);
    let _ = write!(svg, "<g clip-path=\"url(#clip{k})\">");
    for generation in 0..=last_generation(&poses[0]) {
        let radius = poses[0].branches.iter().find(|branch| branch.generation == generation).map_or(0.0, |b| b.radius);
        let width = (2.0 * radius / MICRO * pixels).max(THINNEST);
        let _ = write!(svg, "<path class=\"branch p{k}\" stroke-width=\"{width:.2}\"/>");
    }
    let _ = writeln!(svg, "<path class=\"off\" id=\"off{k}\"/><path class=\"on\" id=\"on{k}\"/></g>");
    svg
}

fn last_generation(pose: &SetaPose) -> usize {
    pose.branches.iter().map(|branch| branch.generation).max().unwrap_or(0)
}

/// A square for each tip.
fn cells(playback: &Playback<'_>, panel: &Panel) -> String {
    let side = 0.86 * playback.pitch / MICRO * panel.frame.width() / (panel.x.to - panel.x.from);
    let mut svg = String::new();
    for tip in &playback.tips {
        let (x, y) = panel.pixel((tip.0 / MICRO, tip.1 / MICRO));
        let (left, top) = (x - 0.5 * side, y - 0.5 * side);
        let _ = write!(
            svg,
            "<rect class=\"tip\" x=\"{left:.1}\" y=\"{top:.1}\" width=\"{side:.1}\" height=\"{side:.1}\"/>"
        );
    }
    svg + "\n"
}

/// The largest load of a tip in either direction, nN.
fn largest_load(poses: &[SetaPose]) -> f64 {
    let loads = poses.iter().flat_map(|pose| pose.tip_loads.iter().flatten());
    loads.fold(f64::MIN_POSITIVE, |largest, load| largest.max(load.abs()))
}

/// The shade of a load: a whole number from 0 to [`SHADES`].
fn shade_of(load: f64, largest: f64) -> usize {
    (0.5 * (1.0 + load / largest) * SHADES as f64).round().clamp(0.0, SHADES as f64) as usize
}

fn data(playback: &Playback<'_>, panels: &[Panel; 2], curve: &Panel) -> String {
    let poses = &playback.poses;
    let largest = largest_load(poses);
    let shades = (0..=SHADES).map(|k| {
        let colour = signed_shade(2.0 * k as f64 / SHADES as f64 - 1.0);
        format!("\"#{:02x}{:02x}{:02x}\"", colour.0, colour.1, colour.2)
    });
    let branches = poses[0].branches.iter().map(|branch| format!("[{},{}]", branch.sections.len(), branch.generation));
    let maps = panels.iter().map(|panel| {
        let (from, to) = (panel.pixel((0.0, 0.0)), panel.pixel((GRAIN / MICRO, GRAIN / MICRO)));
        format!("[{:.3},{:.6},{:.3},{:.6}]", from.0, to.0 - from.0, from.1, to.1 - from.1)
    });
    let times = times(playback);
    let frames = (0..poses.len()).map(|k| frame(playback, k, times[k], (curve, largest)));
    format!(
        "{{\"shades\":[{}],\"branches\":[{}],\"panels\":[{}],\"tips\":[{}],\"frames\":[{}]}}",
        words(shades),
        words(branches),
        words(maps),
        words(tip_points(&poses[0]).into_iter()),
        frames.collect::<Vec<_>>().join(",\n")
    )
}

/// A state as JSON: its place in time and on the curve, whether a tip jumps on the way to it, loads as shades, and sections in grains.
fn frame(playback: &Playback<'_>, k: usize, time: f64, (curve, largest): (&Panel, f64)) -> String {
    let (pose, travel) = (&playback.poses[k], playback.travels[k]);
    let (x, y) = curve.pixel((travel / MICRO, playback.pull.force(&pose.point) / MICRO));
    let before = &playback.poses[k.saturating_sub(1)].tip_loads;
    let jump = before.iter().zip(&pose.tip_loads).any(|(before, load)| before.is_some() != load.is_some());
    let sections = pose.branches.iter().flat_map(|branch| &branch.sections);
    let coordinates = sections.flat_map(|at| [at.place[0], at.place[1]].map(|v| (v / GRAIN).round() as i64));
    let loads = pose.tip_loads.iter().map(|load| match load {
        Some(load) => shade_of(*load, largest).to_string(),
        None => "null".to_owned(),
    });
    format!(
        "{{\"t\":{time:.5},\"u\":{:.6e},\"p\":{:.6e},\"n\":{},\"x\":{x:.2},\"y\":{y:.2},\"j\":{jump},\"f\":[{}],\"l\":[{}]}}",
        travel / MICRO,
        playback.pull.force(&pose.point) / MICRO,
        pose.point.attached,
        words(loads),
        words(coordinates)
    )
}

fn words(items: impl Iterator<Item = impl ToString>) -> String {
    items.map(|item| item.to_string()).collect::<Vec<_>>().join(",")
}

/// Of each tip the number of its section among all sections.
fn tip_points(pose: &SetaPose) -> Vec<usize> {
    let mut before = 0;
    let mut ends = vec![0; pose.tip_loads.len()];
    for branch in &pose.branches {
        before += branch.sections.len();
        if let Some(end) = branch.tip.and_then(|tip| ends.get_mut(tip)) {
            *end = before - 1;
        }
    }
    ends
}

/// How far along the curve each state is, from 0 to 1.
fn times(playback: &Playback<'_>) -> Vec<f64> {
    let places: Vec<(f64, f64)> = playback
        .travels
        .iter()
        .copied()
        .zip(playback.poses.iter().map(|pose| playback.pull.force(&pose.point)))
        .collect();
    let range = |of: fn(&(f64, f64)) -> f64| {
        let (low, high) = places.iter().map(of).fold((0.0f64, 0.0f64), |(a, b), v| (a.min(v), b.max(v)));
        (high - low).max(f64::MIN_POSITIVE)
    };
    let (wide, high) = (range(|at| at.0), range(|at| at.1));
    let mut lengths = vec![0.0];
    for pair in places.windows(2) {
        let step = ((pair[1].0 - pair[0].0) / wide).hypot((pair[1].1 - pair[0].1) / high);
        lengths.push(lengths[lengths.len() - 1] + step);
    }
    let whole = lengths.last().copied().unwrap_or_default().max(f64::MIN_POSITIVE);
    lengths.iter().map(|length| length / whole).collect()
}
