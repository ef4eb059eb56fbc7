//! The page: two panels in SVG, their data, and the script that plays them.

use super::frames::Pose;
use super::panel::{Panel, escaped, joined};
use super::player::{PLAYER, controls};
use crate::chart::axis::Axis;
use crate::chart::place::Frame;
use peelkit::study::Peel;
use std::fmt::Write;

const WIDTH: f64 = 940.0;
/// Of the panel with the beam and of the one with the curve.
const BEAM: Frame = Frame { left: 52.0, top: 16.0, right: 470.0, bottom: 400.0 };
const CURVE: Frame = Frame { left: 560.0, top: 16.0, right: 926.0, bottom: 400.0 };
/// Points of the surface that are drawn where it is not flat.
const DRAWN: usize = 300;
/// About how many points the curve is drawn with.
const DENSE: usize = 600;

const STYLE: &str = "body{font:15px sans-serif;color:#1e1e1e;max-width:960px;margin:1em auto}\
svg{width:100%;height:auto}text{font:13px sans-serif;fill:#1e1e1e}.frame{fill:none;stroke:#1e1e1e}\
.grid{stroke:#e8e8e8}.stable{fill:none;stroke:#0072b2;stroke-width:2}\
.unstable{fill:none;stroke:#d55e00;stroke-width:2;stroke-dasharray:8 5}.ground{fill:#e8e8e8;stroke:#1e1e1e}\
#beam{stroke-width:1.4;fill-opacity:.3}p.small{font-size:12px;color:#505050}\
div.controls{display:flex;gap:1em;align-items:center}input{flex:1}output{min-width:18em;font-size:14px}";

/// No sign of it is one that XML reads: neither a left angle bracket nor an ampersand.
const SCRIPT: &str = r#"
const data = JSON.parse(document.getElementById('data').textContent);
const beam = document.getElementById('beam');
const seconds = 12;
function show() {
  const [a, b, part] = around(data);
  const mix = (p, q) => p + part * (q - p), near = part > 0.5 ? b : a;
  beam.setAttribute('points', a.o.map((value, i) => mix(value, b.o[i]).toFixed(1)).join(' '));
  dot.setAttribute('cx', mix(a.x, b.x)); dot.setAttribute('cy', mix(a.y, b.y));
  const colour = near.s ? '#0072b2' : '#d55e00';
  for (const one of [beam, dot]) { one.setAttribute('fill', colour); one.setAttribute('stroke', colour); }
  says.textContent = 'u = ' + mix(a.u, b.u).toPrecision(4) + ' nm, P = ' + mix(a.p, b.p).toPrecision(4) + ' nN, ' + (near.s ? 'stable' : 'unstable');
}
start();
"#;

/// The page of these frames; the lines of the title behind the first stand small below.
pub(super) fn page(peel: &Peel, frames: &[Pose], title: &str) -> String {
    let mut lines = title.lines();
    let heading = escaped(lines.next().unwrap_or_default());
    let remarks: String = lines.map(|line| format!("<p class=\"small\">{}</p>\n", escaped(line))).collect();
    let beam = beam_panel(frames);
    let curve = curve_panel(frames);
    let height = CURVE.bottom + 48.0;
    let mut svg = format!("<svg viewBox=\"0 0 {WIDTH} {height}\" role=\"img\">\n<title>{heading}</title>\n");
    svg += &ground(peel, &beam);
    svg += &beam.axes("x (nm)", "y (nm)");
    svg += &curve.axes("displacement u (nm)", "force P (nN)");
    svg += &lines_of(peel, &curve);
    let first = &frames[0];
    let (x, y) = curve.pixel((first.displacement, first.force));
    let _ = writeln!(
        svg,
        "<polygon id=\"beam\" points=\"{}\"/>\n<circle id=\"dot\" cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"6\"/>\n</svg>",
        beam.around(&first.outline).map(|value| value.to_string()).collect::<Vec<_>>().join(" ")
    );
    format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head><meta charset=\"utf-8\"/><title>{heading}</title><style>{STYLE}</style></head>\n\
         <body>\n<h1 style=\"font-size:18px\">{heading}</h1>\n{svg}\
         {}\
         <p class=\"small\">The beam to scale over the substrate, and the force on its grip, along the equilibrium path. Dashed and \
         vermillion: unstable under displacement control.</p>\n{remarks}\
         <script type=\"application/json\" id=\"data\">{}</script>\n<script>{PLAYER}{SCRIPT}</script>\n</body>\n</html>\n",
        controls("place on the path"),
        data(frames, &beam, &curve)
    )
}

/// The panel of the beam, its axes of equal scale and around every frame.
fn beam_panel(frames: &[Pose]) -> Panel {
    let all = || frames.iter().flat_map(|pose| &pose.outline);
    let [low, high] =
        [f64::min, f64::max].map(|pick| all().fold((0.0, 0.0), |(x, y), at| (pick(x, at.0), pick(y, at.1))));
    let scale = ((high.0 - low.0) / BEAM.width()).max((high.1 - low.1) / BEAM.height()).max(f64::MIN_POSITIVE) * 1.12;
    let (wide, tall) = (scale * BEAM.width(), scale * BEAM.height());
    let (middle, below) = (0.5 * (low.0 + high.0), low.1 - 0.05 * tall);
    let x = Axis::linear("", middle - 0.5 * wide, middle + 0.5 * wide);
    Panel { frame: BEAM, x, y: Axis::linear("", below, below + tall) }
}

/// The panel of the curve.
fn curve_panel(frames: &[Pose]) -> Panel {
    let x = Axis::around("", frames.iter().map(|pose| pose.displacement), false);
    let y = Axis::around("", frames.iter().map(|pose| pose.force).chain([0.0]), false);
    Panel { frame: CURVE, x, y }
}

/// What lies below the surface.
fn ground(peel: &Peel, panel: &Panel) -> String {
    let substrate = &peel.model.ground.substrate;
    let points = if substrate.is_flat() { 1 } else { DRAWN };
    let place = |k: usize| panel.x.from + (panel.x.to - panel.x.from) * k as f64 / points as f64;
    let surface = (0..=points).map(place).map(|x| (x, substrate.top(x, x).max(panel.y.from)));
    let mut corners: Vec<(f64, f64)> = surface.collect();
    corners.extend([(panel.x.to, panel.y.from), (panel.x.from, panel.y.from)]);
    format!("<polygon class=\"ground\" points=\"{}\"/>\n", joined(panel, &corners))
}

/// The curve, stable and unstable.
fn lines_of(peel: &Peel, panel: &Panel) -> String {
    let curve = peel.dense_curve((DENSE / peel.points.len().max(1)).clamp(1, 12));
    let mut svg = String::new();
    let mut start = 0;
    for pieces in curve.chunk_by(|a, b| (a.2 > 0) == (b.2 > 0)) {
        let end = start + pieces.len();
        // neighbours share their end points
        let points: Vec<(f64, f64)> = curve[start.saturating_sub(1)..end].iter().map(|&(u, p, _)| (u, p)).collect();
        let class = if pieces[0].2 > 0 { "unstable" } else { "stable" };
        let _ = writeln!(svg, "<polyline class=\"{class}\" points=\"{}\"/>", joined(panel, &points));
        start = end;
    }
    svg
}

/// The frames as JSON: t from 0 to 1, u, P, whether it is stable, the point on the curve and the outline, pixels.
fn data(frames: &[Pose], beam: &Panel, curve: &Panel) -> String {
    let one = |pose: &Pose| {
        let (x, y) = curve.pixel((pose.displacement, pose.force));
        let outline: Vec<String> = beam.around(&pose.outline).map(|value| value.to_string()).collect();
        format!(
            "{{\"t\":{:.5},\"u\":{:.6e},\"p\":{:.6e},\"s\":{},\"x\":{x:.2},\"y\":{y:.2},\"o\":[{}]}}",
            pose.time,
            pose.displacement,
            pose.force,
            !pose.unstable,
            outline.join(",")
        )
    };
    format!("[{}]", frames.iter().map(one).collect::<Vec<_>>().join(",\n"))
}
