//! A frame with two axes in SVG, and texts as they stand in it.

use crate::chart::axis::Axis;
use crate::chart::place::Frame;
use std::fmt::Write;

/// A text as it stands in XML.
pub(crate) fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}

/// A frame with two axes.
pub(crate) struct Panel {
    pub frame: Frame,
    pub x: Axis,
    pub y: Axis,
}

impl Panel {
    pub fn pixel(&self, (x, y): (f64, f64)) -> (f64, f64) {
        let Frame { left, bottom, .. } = self.frame;
        (left + self.x.place(x) * self.frame.width(), bottom - self.y.place(y) * self.frame.height())
    }

    /// Coordinates of an outline, tenths of pixels.
    pub fn around(&self, outline: &[(f64, f64)]) -> impl Iterator<Item = f64> {
        let tenth = |value: f64| (10.0 * value).round() / 10.0;
        let pixels: Vec<f64> =
            outline.iter().map(|&at| self.pixel(at)).flat_map(|(x, y)| [tenth(x), tenth(y)]).collect();
        pixels.into_iter()
    }

    /// Its rim, ticks and titles.
    pub fn axes(&self, x: &str, y: &str) -> String {
        let Frame { left, top, right, bottom } = self.frame;
        let mut svg = String::new();
        for tick in self.x.ticks(5) {
            let (at, _) = self.pixel((tick.value, self.y.from));
            let text = tick.text.unwrap_or_default();
            let _ = write!(
                svg,
                "<path class=\"grid\" d=\"M{at:.1} {top}V{bottom}\"/><text x=\"{at:.1}\" y=\"{:.1}\" text-anchor=\"middle\">{text}</text>",
                bottom + 17.0
            );
        }
        for tick in self.y.ticks(6) {
            let (_, at) = self.pixel((self.x.from, tick.value));
            let text = tick.text.unwrap_or_default();
            let _ = write!(
                svg,
                "<path class=\"grid\" d=\"M{left} {at:.1}H{right}\"/><text x=\"{:.1}\" y=\"{:.1}\" text-anchor=\"end\">{text}</text>",
                left - 6.0,
                at + 4.0
            );
        }
        let (middle, half) = (0.5 * (left + right), 0.5 * (top + bottom));
        let (x, y) = (self.with_decades(&self.x, x), self.with_decades(&self.y, y));
        let _ = writeln!(
            svg,
            "<rect class=\"frame\" x=\"{left}\" y=\"{top}\" width=\"{}\" height=\"{}\"/>\n<text x=\"{middle}\" y=\"{}\" text-anchor=\"middle\">{x}</text>\
             <text transform=\"translate({} {half}) rotate(-90)\" text-anchor=\"middle\">{y}</text>",
            right - left,
            bottom - top,
            bottom + 38.0,
            left - 52.0 + 12.0
        );
        svg
    }

    /// A title with the power of ten that the ticks of its axis leave out.
    fn with_decades(&self, axis: &Axis, label: &str) -> String {
        escaped(&Axis { label: label.to_owned(), ..axis.clone() }.title())
    }
}

/// Points as they stand in a polyline.
pub(crate) fn joined(panel: &Panel, points: &[(f64, f64)]) -> String {
    panel.around(points).map(|value| value.to_string()).collect::<Vec<_>>().join(" ")
}
