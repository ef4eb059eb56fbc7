//! The widths at which a planar peel is stable against leaving its plane, against thickness and against stiffness.

use crate::figures::figure::{Figure, Table};
use crate::figures::runner::{ACCURACY, BOUNDS, Runner, paper_strip};
use peelkit::model::{PeelModel, StripModel};
use peelkit::study::{Peel, WidthLimit, WidthRange};
use peelkit_report::ReportError;
use peelkit_report::chart::{Axis, Frame, Line, Panel, Picture, Shape, Stroke, WIDTH, colour};
use rayon::prelude::*;
use std::path::Path;

/// Length of the strips, nm.
const LENGTH: f64 = 100.0;
const HEIGHTS: usize = 25;
const MODULI: usize = 25;
const HEIGHT: (f64, f64) = (1.0, 50.0);
const MODULUS: (f64, f64) = (0.02, 200.0);

/// How many peels the figure takes.
pub(in crate::figures) const PEELS: usize = HEIGHTS + MODULI;

/// A value that is varied, the width over which the strip is square, and the widths between which it is stable.
type Row = (f64, f64, Option<WidthRange>);

pub(in crate::figures) fn figure(runner: &Runner<'_>, dir: &Path) -> Result<Figure, ReportError> {
    let thick = |height: f64| varied(|model| model.strip.height = height);
    let stiff = |modulus: f64| varied(|model| model.strip.material.youngs_modulus = modulus);
    let by_height = ranges(runner, &spaced(HEIGHT, HEIGHTS), thick);
    let by_modulus = ranges(runner, &spaced(MODULUS, MODULI), stiff);
    let caption = format!(
        "The widths (shaded) at which all of the planar path of a strip of {LENGTH} nm, pulled straight up by a grip \
         that is free to roll, is stable against leaving its plane. Left against its thickness (E = 2 GPa), right against \
         the stiffness of its material (h = 10 nm). Narrower strips buckle sideways, wider ones roll off to one side. \
         Dotted: as wide as high. Found on one planar path for each thickness or stiffness, because its equilibria per \
         width are those of any width; the limits have error bounds (`width_error_nm`)."
    );
    let title = "Widths at which the planar peel is stable out of its plane";
    let picture = Picture { title: title.into(), height: 470, panels: panels(&by_height, &by_modulus) };
    Figure::write(dir, "out-of-plane-widths", caption, &picture, &table(&by_height, &by_modulus))
}

/// Values of even ratio, both ends included.
fn spaced((from, to): (f64, f64), count: usize) -> Vec<f64> {
    let step = (to / from).ln() / (count - 1) as f64;
    (0..count).map(|k| from * (step * k as f64).exp()).collect()
}

fn varied(change: impl FnOnce(&mut StripModel)) -> StripModel {
    let mut model = paper_strip(LENGTH);
    change(&mut model);
    model
}

fn ranges(runner: &Runner<'_>, values: &[f64], model: impl Fn(f64) -> StripModel) -> Vec<Row> {
    let models: Vec<StripModel> = values.iter().map(|&value| model(value)).collect();
    let peels = runner.peel_all(&models.iter().map(PeelModel::from).collect::<Vec<_>>(), &ACCURACY, |_| BOUNDS);
    let range = |peel: &Peel| peel.planar_widths().ok().flatten();
    let ranges: Vec<Option<WidthRange>> = peels.par_iter().map(range).collect();
    let rows = values.iter().zip(&models).zip(ranges);
    rows.map(|((&value, model), range)| (value, model.strip.height, range)).collect()
}

fn panels(by_height: &[Row], by_modulus: &[Row]) -> Vec<Panel> {
    let frame = |left: f64, right: f64| Frame { left, top: 40.0, right, bottom: 414.0 };
    let middle = 0.5 * f64::from(WIDTH);
    let widths = || Axis::log("width b (nm)", 0.5, 500.0);
    let height = Axis::log("thickness h (nm)", HEIGHT.0, HEIGHT.1);
    let modulus = Axis::log("Young's modulus E (GPa)", MODULUS.0, MODULUS.1);
    let left = panel(Panel::new(frame(74.0, middle - 12.0), height, widths()), by_height);
    let mut right = panel(Panel::new(frame(middle + 62.0, f64::from(WIDTH) - 18.0), modulus, widths()), by_modulus);
    right.lines.iter_mut().for_each(|line| line.name = None);
    vec![left, right]
}

fn panel(mut panel: Panel, rows: &[Row]) -> Panel {
    let limits = |of: fn(&WidthRange) -> Option<WidthLimit>| -> Vec<(f64, f64)> {
        rows.iter().filter_map(|(value, _, range)| Some((*value, of(range.as_ref()?)?.width))).collect()
    };
    let (narrow, wide) = (limits(|range| range.narrowest), limits(|range| range.widest));
    let corners = narrow.iter().chain(wide.iter().rev()).copied().collect();
    panel.shapes.push(Shape { corners, colour: colour::GREEN, opacity: 0.25 });
    let mut line = |points, stroke, name: &str| panel.lines.push(Line { points, stroke, name: Some(name.into()) });
    line(wide, Stroke::solid(colour::VERMILLION, 2.0), "widest: beyond it rolls");
    line(narrow, Stroke::solid(colour::BLUE, 2.0), "narrowest: below it buckles sideways");
    let square = rows.iter().map(|(value, height, _)| (*value, *height)).collect();
    line(square, Stroke::dotted(colour::GREY, 1.6), "b = h");
    panel
}

fn table(by_height: &[Row], by_modulus: &[Row]) -> Table {
    let columns = ["width_nm", "width_error_nm", "displacement_nm", "force_per_width_nN_per_nm"];
    let of = |side: &str| columns.map(|column| format!("{side}_{column}"));
    let (narrow, wide) = (of("narrowest"), of("widest"));
    let names = narrow.iter().chain(&wide).map(String::as_str);
    let mut table = Table::new(&["varied", "value"].into_iter().chain(names).collect::<Vec<_>>());
    for (varied, rows) in [("height_nm", by_height), ("youngs_modulus_GPa", by_modulus)] {
        for (value, _, range) in rows {
            let numbers = |limit: Option<WidthLimit>| {
                [
                    limit.map(|at| at.width),
                    limit.map(|at| at.width_error),
                    limit.map(|at| at.displacement),
                    limit.map(|at| at.force_per_width),
                ]
            };
            let narrow = numbers(range.and_then(|range| range.narrowest));
            let wide = numbers(range.and_then(|range| range.widest));
            let cells: Vec<Option<f64>> = std::iter::once(Some(*value)).chain(narrow).chain(wide).collect();
            table.push(&[varied], &cells, &[]);
        }
    }
    table
}
