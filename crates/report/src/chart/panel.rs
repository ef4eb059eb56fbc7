//! One panel: axes around a frame, and what is drawn inside it.

use super::axis::{Axis, Ends, Tick};
use super::canvas::{Align, Canvas, Dash, Pixel, Stroke};
use super::drawn::Drawn;
use super::place::{Frame, Places, clip, clip_area, ribbon};
use super::style::{colour, size};
use super::symbol::{Symbol, draw_symbol};
use plotters::style::RGBColor;
use std::borrow::Cow;

/// A curve; with a name it stands in the legend.
#[derive(Clone, Debug)]
pub struct Line {
    /// In the units of the axes.
    pub points: Vec<(f64, f64)>,
    /// How it looks.
    pub stroke: Stroke,
    /// What the legend calls it.
    pub name: Option<String>,
}

/// A shaded range of x over the whole height; with a name it stands in the legend.
#[derive(Clone, Debug)]
pub struct Band {
    /// Its least x, in the unit of the axis.
    pub from: f64,
    /// Its largest x, in the unit of the axis.
    pub to: f64,
    /// What it is filled with.
    pub colour: RGBColor,
    /// What the legend calls it.
    pub name: Option<String>,
}

/// A filled outline.
#[derive(Clone, Debug)]
pub struct Shape {
    /// In the units of the axes.
    pub corners: Vec<(f64, f64)>,
    /// What it is filled with.
    pub colour: RGBColor,
    /// From 0, invisible, to 1.
    pub opacity: f64,
}

/// A filled outline with lines on it. It covers what was drawn before it: faces stand in a panel from the farthest to the nearest.
#[derive(Clone, Debug)]
pub struct Face {
    /// What is filled
    pub shape: Shape,
    /// Lines on it, in the units of the axes.
    pub lines: Vec<(Vec<(f64, f64)>, Stroke)>,
}

/// A marked point; with a name its symbol stands in the legend, with a note it is labelled.
#[derive(Clone, Debug)]
pub struct Mark {
    /// In the units of the axes.
    pub at: (f64, f64),
    /// What is drawn there.
    pub symbol: Symbol,
    /// What the symbol is filled with.
    pub colour: RGBColor,
    /// What the legend calls it.
    pub name: Option<String>,
    /// What stands beside it.
    pub note: Option<Note>,
}

impl Mark {
    /// A dot without name and note.
    pub fn dot(at: (f64, f64), colour: RGBColor) -> Self {
        Mark { at, symbol: Symbol::Dot, colour, name: None, note: None }
    }
}

/// A label: a number in a disc, lines of text, or both.
#[derive(Clone, Debug, Default)]
pub struct Note {
    /// A number in a disc.
    pub badge: Option<usize>,
    /// Lines of text.
    pub text: Vec<String>,
}

/// What stands around a panel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rim {
    /// A frame with ticks, numbers and the titles of the axes
    Axes,
    /// A pale frame: the units of the axes mean nothing to a reader
    Plain,
}

/// A frame with two axes and all that is drawn inside.
#[derive(Clone, Debug)]
pub struct Panel {
    /// Where the frame stands on the sheet; ticks and labels lie outside.
    pub frame: Frame,
    /// The line above the frame; may be empty.
    pub title: String,
    /// The axis below.
    pub x: Axis,
    /// The axis on the left.
    pub y: Axis,
    /// Shaded ranges of x, behind all else.
    pub bands: Vec<Band>,
    /// Filled outlines, behind the lines.
    pub shapes: Vec<Shape>,
    /// Curves.
    pub lines: Vec<Line>,
    /// Faces of a body, over all these.
    pub faces: Vec<Face>,
    /// What stands around it.
    pub rim: Rim,
    /// Marked points, before all else.
    pub marks: Vec<Mark>,
}

/// A row of the legend.
#[derive(Clone, Copy)]
enum Key<'a> {
    Line(&'a Stroke),
    Band(RGBColor),
    Mark(Symbol, RGBColor),
    Badge(usize, RGBColor),
}

/// Radius of the disc around a number.
const BADGE: f64 = 9.0;
/// A wider line is drawn as an area, which ends at the frame, pixels.
const THICK: f64 = 4.0;
/// Room for the sample of a legend row.
const KEY: f64 = 34.0;
/// By how much an axis goes on at once for a legend that would lie over a line, over its length, and how often.
const LONGER: f64 = 0.1;
const MOST_LONGER: usize = 6;

/// The rows of a legend.
struct Legend<'a> {
    rows: Vec<(&'a str, Key<'a>)>,
    /// Pixels
    width: f64,
    /// From row to row, pixels
    leading: f64,
}

impl Legend<'_> {
    fn height(&self) -> f64 {
        self.rows.len() as f64 * self.leading + 8.0
    }
}

impl Panel {
    /// An empty panel without a title.
    pub fn new(frame: Frame, x: Axis, y: Axis) -> Self {
        let (bands, shapes, lines, faces, marks) = Default::default();
        Panel { frame, title: String::new(), x, y, bands, shapes, lines, faces, rim: Rim::Axes, marks }
    }

    /// Whether a point lies within both axes.
    pub fn shows(&self, at: (f64, f64)) -> bool {
        self.frame.grown(1.0).holds(self.pixel(at))
    }

    fn pixel(&self, (x, y): (f64, f64)) -> Pixel {
        let right = self.frame.left + self.x.place(x) * self.frame.width();
        (right, self.frame.bottom - self.y.place(y) * self.frame.height())
    }

    fn pixels(&self, points: &[(f64, f64)]) -> Vec<Pixel> {
        points.iter().map(|&p| self.pixel(p)).collect()
    }

    pub(super) fn draw(&self, canvas: &Canvas<'_>) -> Drawn {
        let legend = self.legend(canvas)?;
        let (panel, mut places, at) = self.with_room(legend.as_ref());
        panel.draw_inside(canvas)?;
        if let Some((legend, at)) = legend.zip(at) {
            draw_legend(canvas, &legend, at)?;
        }
        panel.marks.iter().filter(|mark| panel.shows(mark.at)).try_for_each(|mark| match &mark.note {
            Some(note) => draw_note(canvas, &mut places, panel.pixel(mark.at), mark, note),
            None => Ok(()),
        })
    }

    /// The same on a longer axis of y where its legend would lie over a line else, with what is taken of it, and the place of the legend.
    fn with_room(&self, legend: Option<&Legend<'_>>) -> (Cow<'_, Self>, Places, Option<Frame>) {
        let of = |panel: &Self| {
            let mut places = panel.places();
            let at = legend.map(|legend| places.along_rim(legend.width, legend.height()));
            (places, at)
        };
        let (places, at) = of(self);
        let covers = |places: &Places, at: &Option<Frame>| at.is_some_and(|at| places.covers(&at));
        if self.y.ends == Ends::Around && covers(&places, &at) {
            for share in (1..=MOST_LONGER).map(|times| LONGER * times as f64) {
                let longer = Self { y: self.y.clone().longer(share), ..self.clone() };
                let (places, at) = of(&longer);
                if !covers(&places, &at) {
                    return (Cow::Owned(longer), places, at);
                }
            }
        }
        (Cow::Borrowed(self), places, at)
    }

    /// What lines, faces and marks take.
    fn places(&self) -> Places {
        let mut places = Places::new(self.frame);
        for line in &self.lines {
            clip(&self.pixels(&line.points), &self.frame.grown(1.0)).iter().for_each(|piece| places.add_line(piece));
        }
        for (points, _) in self.faces.iter().flat_map(|face| &face.lines) {
            places.add_line(&self.pixels(points));
        }
        for mark in self.marks.iter().filter(|mark| mark.symbol != Symbol::None && self.shows(mark.at)) {
            let (x, y) = self.pixel(mark.at);
            places.add_spot(Frame { left: x, top: y, right: x, bottom: y }.grown(5.0));
        }
        places
    }

    /// All but the legend and the notes.
    fn draw_inside(&self, canvas: &Canvas<'_>) -> Drawn {
        for band in &self.bands {
            let (a, b) = (self.pixel((band.from, self.y.from)), self.pixel((band.to, self.y.to)));
            let (left, right) =
                (a.0.clamp(self.frame.left, self.frame.right), b.0.clamp(self.frame.left, self.frame.right));
            canvas.area(&Frame { left, right, ..self.frame }.corners(), band.colour, 0.16)?;
        }
        match self.rim {
            Rim::Axes => self.draw_axes(canvas)?,
            Rim::Plain => self.draw_rim(canvas, &Stroke::solid(colour::PALE, 1.0))?,
        }
        let above = (0.5 * (self.frame.left + self.frame.right), self.frame.top - 12.0);
        canvas.text(&self.title, above, size::TEXT, colour::INK, Align::Centre)?;
        for shape in &self.shapes {
            canvas.area(&clip_area(&self.pixels(&shape.corners), &self.frame), shape.colour, shape.opacity)?;
        }
        for line in &self.lines {
            let points = self.pixels(&line.points);
            if line.stroke.width > THICK && line.stroke.dash == Dash::Solid {
                canvas.area(&clip_area(&ribbon(&points, line.stroke.width), &self.frame), line.stroke.colour, 1.0)?;
            } else {
                for piece in clip(&points, &self.frame.grown(1.0)) {
                    canvas.line(&piece, &line.stroke)?;
                }
            }
        }
        for Face { shape, lines } in &self.faces {
            canvas.area(&self.pixels(&shape.corners), shape.colour, shape.opacity)?;
            for (points, stroke) in lines {
                canvas.line(&self.pixels(points), stroke)?;
            }
        }
        let mut shown = self.marks.iter().filter(|mark| self.shows(mark.at));
        shown.try_for_each(|mark| draw_symbol(canvas, mark.symbol, self.pixel(mark.at), mark.colour))
    }

    fn draw_axes(&self, canvas: &Canvas<'_>) -> Drawn {
        let Frame { left, top, right, bottom } = self.frame;
        let (thin, rule) = (Stroke::solid(colour::PALE, 0.8), Stroke::solid(colour::INK, 1.0));
        let label = |text: &str, at, align| canvas.text(text, at, size::TEXT, colour::INK, align);
        for tick in fitting(&self.x, self.frame.width(), 70.0, |text| canvas.length(text, size::TEXT))? {
            let (x, _) = self.pixel((tick.value, self.y.from));
            let depth = if tick.text.is_some() { 6.0 } else { 3.0 };
            if let Some(text) = tick.text {
                canvas.line(&[(x, top), (x, bottom)], &thin)?;
                label(&text, (x, bottom + 16.0), Align::Centre)?;
            }
            canvas.line(&[(x, bottom), (x, bottom + depth)], &rule)?;
        }
        let mut widest: f64 = 0.0;
        for tick in fitting(&self.y, self.frame.height(), 50.0, |_| Ok(size::TEXT - 4.0))? {
            let (_, y) = self.pixel((self.x.from, tick.value));
            let depth = if tick.text.is_some() { 6.0 } else { 3.0 };
            if let Some(text) = tick.text {
                widest = widest.max(canvas.length(&text, size::TEXT)?);
                canvas.line(&[(left, y), (right, y)], &thin)?;
                label(&text, (left - 9.0, y), Align::Right)?;
            }
            canvas.line(&[(left - depth, y), (left, y)], &rule)?;
        }
        self.draw_rim(canvas, &rule)?;
        let (middle, half) = (0.5 * (left + right), 0.5 * (top + bottom));
        canvas.text(&self.x.title(), (middle, bottom + 37.0), size::LABEL, colour::INK, Align::Centre)?;
        canvas.text(&self.y.title(), (left - widest - 22.0, half), size::LABEL, colour::INK, Align::Upwards)
    }

    fn draw_rim(&self, canvas: &Canvas<'_>, stroke: &Stroke) -> Drawn {
        let mut rim = self.frame.corners().to_vec();
        rim.push(rim[0]);
        canvas.line(&rim, stroke)
    }

    /// What has a name.
    fn legend(&self, canvas: &Canvas<'_>) -> Drawn<Option<Legend<'_>>> {
        let lines = self.lines.iter().map(|l| (&l.name, Key::Line(&l.stroke)));
        let marks = self.marks.iter().map(|m| match m.note.as_ref().and_then(|note| note.badge) {
            Some(number) if m.symbol == Symbol::Dot => (&m.name, Key::Badge(number, m.colour)),
            Some(_) => (&m.name, Key::Mark(m.symbol, colour::INK)),
            None => (&m.name, Key::Mark(m.symbol, m.colour)),
        });
        let bands = self.bands.iter().map(|b| (&b.name, Key::Band(b.colour)));
        let mut rows: Vec<(&str, Key<'_>)> = Vec::new();
        for (name, key) in lines.chain(marks).chain(bands) {
            if let Some(name) = name.as_deref().filter(|&n| rows.iter().all(|row| row.0 != n)) {
                rows.push((name, key));
            }
        }
        let mut widest: f64 = 0.0;
        for (name, _) in &rows {
            widest = widest.max(canvas.length(name, size::TEXT)?);
        }
        let numbered = rows.iter().any(|row| matches!(row.1, Key::Badge(..)));
        let leading = if numbered { 2.0 * BADGE + 3.0 } else { size::LEADING };
        Ok((!rows.is_empty()).then_some(Legend { rows, width: KEY + widest + 14.0, leading }))
    }
}

fn draw_legend(canvas: &Canvas<'_>, legend: &Legend<'_>, place: Frame) -> Drawn {
    canvas.area(&place.corners(), plotters::style::WHITE, 0.85)?;
    for (i, (name, key)) in legend.rows.iter().enumerate() {
        let (left, y) = (place.left + 6.0, place.top + 4.0 + (i as f64 + 0.5) * legend.leading);
        match key {
            Key::Line(stroke) => canvas.line(&[(left, y), (left + KEY - 8.0, y)], stroke)?,
            Key::Mark(symbol, colour) => draw_symbol(canvas, *symbol, (left + 0.5 * KEY - 4.0, y), *colour)?,
            Key::Badge(number, colour) => draw_badge(canvas, *number, (left + 0.5 * KEY - 4.0, y), *colour)?,
            Key::Band(colour) => {
                let swatch = Frame { left, top: y - 6.0, right: left + KEY - 8.0, bottom: y + 6.0 };
                canvas.area(&swatch.corners(), *colour, 0.25)?;
            }
        }
        canvas.text(name, (left + KEY, y), size::TEXT, colour::INK, Align::Left)?;
    }
    Ok(())
}

fn draw_badge(canvas: &Canvas<'_>, number: usize, centre: Pixel, colour: RGBColor) -> Drawn {
    canvas.disc(centre, BADGE, colour)?;
    canvas.disc(centre, BADGE - 1.4, plotters::style::WHITE)?;
    canvas.text(&number.to_string(), centre, 12.0, colour::INK, Align::Centre)
}

/// What a note shows: all of it, its first line alone where there is no room for more, or its number alone.
fn draw_note(canvas: &Canvas<'_>, places: &mut Places, at: Pixel, mark: &Mark, note: &Note) -> Drawn {
    let indent = if note.badge.is_some() { 2.0 * BADGE } else { 0.0 };
    let size = |lines: &[String]| -> Drawn<(f64, f64)> {
        let mut width = indent;
        for text in lines {
            width = width.max(indent + 5.0 + canvas.length(text, size::TEXT)?);
        }
        Ok((width, (lines.len() as f64 * size::LEADING).max(indent)))
    };
    let mut found = None;
    for count in [note.text.len(), 1].into_iter().filter(|_| !note.text.is_empty()) {
        let lines = &note.text[..count];
        let (width, height) = size(lines)?;
        found = found.or_else(|| places.clear_beside(at, width, height).map(|place| (place, lines)));
    }
    let (place, lines) = match found {
        Some(found) => found,
        None if note.badge.is_some() => (places.beside(at, indent, indent), &[][..]),
        None => return Ok(()),
    };
    let near = place.nearest(at);
    let (across, down) = (near.0 - at.0, near.1 - at.1);
    let away = across.hypot(down);
    if away > 16.0 && mark.symbol != Symbol::None {
        let leader = [(at.0 + 7.0 * across / away, at.1 + 7.0 * down / away), near];
        canvas.line(&leader, &Stroke::solid(colour::GREY, 0.8))?;
        places.add_leader(leader);
    }
    if !lines.is_empty() {
        canvas.area(&place.corners(), plotters::style::WHITE, 0.8)?;
    }
    if let Some(number) = note.badge {
        let centre = (place.left + BADGE, 0.5 * (place.top + place.bottom));
        draw_badge(canvas, number, centre, mark.colour)?;
    }
    let left = if note.badge.is_some() { place.left + indent + 5.0 } else { place.left + 2.0 };
    for (i, text) in lines.iter().enumerate() {
        let y = 0.5 * (place.top + place.bottom) + (i as f64 - 0.5 * (lines.len() as f64 - 1.0)) * size::LEADING;
        canvas.text(text, (left, y), size::TEXT, colour::INK, Align::Left)?;
    }
    Ok(())
}

/// Free between two texts of an axis, pixels.
const APART: f64 = 8.0;

/// The ticks of an axis of so many pixels, about one text to `each` of them and as many as stand beside one another without touching;
/// `extent` is that of a text along the axis.
fn fitting(axis: &Axis, length: f64, each: f64, extent: impl Fn(&str) -> Drawn<f64>) -> Drawn<Vec<Tick>> {
    let most = ((length / each) as usize).max(1);
    for count in (1..=most).rev() {
        let ticks = axis.ticks(count);
        if touching(axis, length, &ticks, &extent)?.is_none() {
            return Ok(ticks);
        }
    }
    // not even the fewest: every text that touches the one before it goes
    let mut ticks = axis.ticks(1);
    while let Some(at) = touching(axis, length, &ticks, &extent)? {
        ticks[at].text = None;
    }
    Ok(ticks)
}

/// The first tick whose text touches that of the one before it.
fn touching(axis: &Axis, length: f64, ticks: &[Tick], extent: &impl Fn(&str) -> Drawn<f64>) -> Drawn<Option<usize>> {
    let mut ends = f64::NEG_INFINITY;
    for (index, tick) in ticks.iter().enumerate() {
        let Some(text) = &tick.text else { continue };
        let (centre, half) = (length * axis.place(tick.value), 0.5 * extent(text)?);
        if centre - half < ends + APART {
            return Ok(Some(index));
        }
        ends = centre + half;
    }
    Ok(None)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Texts of eight pixels a letter.
    fn shown(axis: &Axis, length: f64) -> Vec<String> {
        let extent = |text: &str| Ok(8.0 * text.chars().count() as f64);
        let ticks = fitting(axis, length, 70.0, extent).unwrap();
        assert_eq!(touching(axis, length, &ticks, &extent).unwrap(), None, "{ticks:?}");
        ticks.into_iter().filter_map(|tick| tick.text).collect()
    }

    /// Lines from edge to edge: a legend has room above them alone, where the axis may go on.
    #[test]
    fn a_legend_lies_over_no_line_where_the_axis_may_go_on() {
        let values = || (0..=20).map(f64::from);
        let full = |y: Axis| {
            let lines = values().map(|at| Line::plain(vec![(0.0, at), (20.0, at)], Stroke::solid(colour::INK, 1.0)));
            Panel { lines: lines.collect(), ..Panel::new(Frame::column(0, 2), Axis::around("u", values(), false), y) }
        };
        let legend = Legend { rows: vec![("law", Key::Band(colour::INK)); 5], width: 120.0, leading: 16.0 };
        let around = full(Axis::around("P", values(), false));
        let (panel, places, at) = around.with_room(Some(&legend));
        assert!(panel.y.to > around.y.to && panel.y.from == around.y.from && !places.covers(&at.unwrap()));
        let fixed = full(Axis::linear("P", around.y.from, around.y.to));
        let (panel, places, at) = fixed.with_room(Some(&legend));
        assert!(panel.y == fixed.y && places.covers(&at.unwrap()));
    }

    #[test]
    fn texts_of_ticks_do_not_touch() {
        assert_eq!(shown(&Axis::linear("u", 0.0, 3.0), 280.0), ["0", "1", "2", "3"]);
        for length in [60.0, 120.0, 200.0, 300.0, 700.0] {
            for axis in [
                Axis::linear("u", 0.0, 0.00345),
                Axis::linear("u", 123_456.0, 123_457.0),
                Axis::linear("u", -12_345.0, 67_890.0),
                Axis::log("u", 2.1e-5, 8.7e-5),
                Axis::log("u", 1e-12, 1e12),
                Axis::log("u", 0.7, 130.0),
            ] {
                assert!(!shown(&axis, length).is_empty() || length < 100.0, "{axis:?} over {length} pixels");
            }
        }
    }
}
