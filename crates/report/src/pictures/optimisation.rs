//! An optimisation: the shape before and after, both peels, and how the searches went.

use crate::chart::RGBColor;
use crate::chart::axis::Axis;
use crate::chart::canvas::Stroke;
use crate::chart::output::save;
use crate::chart::panel::{Line, Panel};
use crate::chart::picture::{Heading, Picture};
use crate::chart::place::Frame;
use crate::chart::style::{WIDTH, colour, order_shade};
use crate::writing::error::ReportError;
use crate::writing::names::quantity_title;
use peelkit::model::PeelModel;
use peelkit::study::Peel;
use peelkit::study::optimisation::{DesignFound, DesignProblem, Objective, Optimum, ProfileColumn};
use std::path::{Path, PathBuf};

/// Height of a panel, pixels.
const HEIGHT: f64 = 250.0;
/// From one panel to the next: its axis, and the title of the next, pixels.
const BETWEEN: f64 = 86.0;
/// Points of a shape, and intervals of a curve between two points of its path.
const ALONG: usize = 400;
const DENSE: usize = 8;

/// Draws `optimum.svg` and `optimum.png` into `dir`: where a profile is free its shape before and after, force against displacement before and after,
/// and the objective against the designs of each search.
///
/// Fails where a file cannot be written ([`ReportError::Write`]) or drawn ([`ReportError::Draw`]).
pub fn draw_optimum<'h>(
    problem: &DesignProblem,
    optimum: &Optimum,
    heading: impl Into<Heading<'h>>,
    dir: &Path,
) -> Result<Vec<PathBuf>, ReportError> {
    let Heading { title: above, units } = heading.into();
    let mut sheet = Sheet::default();
    let models = [&optimum.before, &optimum.after].map(|design| (problem.model)(&design.values));
    let is_free = |column| problem.variables.iter().any(|variable| variable.along.is_some_and(|(of, _)| of == column));
    for column in [ProfileColumn::Width, ProfileColumn::Height].into_iter().filter(|&column| is_free(column)) {
        let of = |model: &Option<PeelModel>| model.as_ref().map_or_else(Vec::new, |model| outline(model, column));
        let label = format!("{} (nm)", column.word());
        sheet.add("", ["place along the body S (nm)", &label], both(models.each_ref().map(of)));
    }
    let titles = match problem.objective {
        Objective::Quantity(_) => vec![String::new()],
        Objective::Ratio { holding_angle, release_angle, .. } => {
            [("holding", holding_angle), ("release", release_angle)]
                .map(|(word, angle)| format!("{word} at {:.6} degrees", angle.to_degrees()))
                .to_vec()
        }
    };
    let [before, after] = [&optimum.before, &optimum.after].map(|design| curves(&design.of));
    for (title, (before, after)) in titles.iter().zip(before.into_iter().zip(after)) {
        sheet.add(title, ["displacement u (nm)", "force P (nN)"], both([before, after]));
    }
    let count = optimum.searches.len();
    let lines = optimum.searches.iter().enumerate().map(|(k, search)| {
        let value = |(k, log_value): (usize, Option<f64>)| log_value.map(|value| (k as f64, value.exp()));
        let points = search.evaluations.iter().map(|design| design.log_value).enumerate().filter_map(value).collect();
        line(points, order_shade(k, count), &format!("search {}", k + 1))
    });
    let lines: Vec<Line> = lines.collect();
    let objective = match problem.objective {
        Objective::Quantity(of) => quantity_title(of),
        Objective::Ratio { .. } => "holding over release".to_owned(),
    };
    sheet.add("", ["designs evaluated", &objective], lines);
    let height = sheet.top as u32;
    save(&Picture { title: above.into(), height, panels: sheet.panels }.in_units(units), dir, "optimum")
}

/// Panels below one another.
struct Sheet {
    top: f64,
    panels: Vec<Panel>,
}

impl Default for Sheet {
    fn default() -> Self {
        Self { top: 12.0, panels: Vec::new() }
    }
}

impl Sheet {
    /// A panel with these lines; none where they have no points.
    fn add(&mut self, title: &str, labels: [&str; 2], lines: Vec<Line>) {
        let points = || lines.iter().flat_map(|line| &line.points);
        if points().next().is_none() {
            return;
        }
        let top = self.top + 34.0;
        let frame = Frame { left: 88.0, top, right: f64::from(WIDTH) - 18.0, bottom: top + HEIGHT };
        let x = Axis::around(labels[0], points().map(|point| point.0), false);
        let y = Axis::around(labels[1], points().map(|point| point.1), false);
        self.panels.push(Panel { title: title.to_owned(), lines, ..Panel::new(frame, x, y) });
        self.top += HEIGHT + BETWEEN;
    }
}

fn both([before, after]: [Vec<(f64, f64)>; 2]) -> Vec<Line> {
    vec![line(before, colour::GREY, "before"), line(after, colour::BLUE, "after")]
}

fn line(points: Vec<(f64, f64)>, colour: RGBColor, name: &str) -> Line {
    Line { points, stroke: Stroke::solid(colour, 2.0), name: Some(name.to_owned()) }
}

fn outline(model: &PeelModel, column: ProfileColumn) -> Vec<(f64, f64)> {
    let place = |k: usize| model.length() * k as f64 / ALONG as f64;
    let value = |place: f64| {
        let (_, width, height) = model.section_at(place);
        if column == ProfileColumn::Width { width } else { height }
    };
    (0..=ALONG).map(|k| (place(k), value(place(k)))).collect()
}

/// Displacement and force of what was computed of a design.
fn curves(of: &DesignFound) -> Vec<Vec<(f64, f64)>> {
    let dense = |peel: &Peel| peel.dense_curve(DENSE).into_iter().map(|(u, force, _)| (u, force)).collect();
    match of {
        DesignFound::Peels(peels) => peels.iter().map(dense).collect(),
        DesignFound::Curves(curves) => curves.clone(),
    }
}
