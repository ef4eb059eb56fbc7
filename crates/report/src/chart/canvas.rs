//! A white sheet on which lines, areas, discs and text are drawn, in pixels; it comes out as SVG text.
//!
//! plotters rounds every point to a whole unit, in SVG too: the sheet is drawn ten times as large and scaled by its
//! viewBox.

use super::drawn::{DrawError, Drawn};
use super::font;
use plotters::coord::Shift;
use plotters::element::DashedPathElement;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

/// Units of the drawing to a pixel of the picture.
const FINE: f64 = 10.0;

/// plotters asks for a text 1.24 times as large as the em square that it writes into the SVG.
const EM: f64 = 1.24;

/// A point of the sheet, pixels from its upper left corner.
pub(crate) type Pixel = (f64, f64);

/// How a line looks.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stroke {
    /// Its colour.
    pub colour: RGBColor,
    /// Its width, pixels.
    pub width: f64,
    /// Its pattern.
    pub dash: Dash,
}

/// The pattern of a line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Dash {
    /// Without gaps.
    Solid,
    /// Dashes.
    Dashed,
    /// Dots.
    Dotted,
}

impl Stroke {
    /// A line without gaps, `width` in pixels.
    pub fn solid(colour: RGBColor, width: f64) -> Self {
        Stroke { colour, width, dash: Dash::Solid }
    }
    /// A line of dashes, `width` in pixels.
    pub fn dashed(colour: RGBColor, width: f64) -> Self {
        Stroke { colour, width, dash: Dash::Dashed }
    }
    /// A line of dots, `width` in pixels.
    pub fn dotted(colour: RGBColor, width: f64) -> Self {
        Stroke { colour, width, dash: Dash::Dotted }
    }
}

/// Which point of a text is put at the given place, and how it runs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Align {
    Left,
    Centre,
    Right,
    /// Centred, reading upwards.
    Upwards,
}

/// The sheet.
pub(crate) struct Canvas<'a> {
    area: DrawingArea<SVGBackend<'a>, Shift>,
}

impl Canvas<'_> {
    /// Draws on a sheet of `width` × `height` pixels and returns it as SVG text.
    pub fn svg(width: u32, height: u32, draw: impl FnOnce(&Canvas<'_>) -> Drawn) -> Drawn<String> {
        font::register()?;
        let (fine_width, fine_height) = (width * FINE as u32, height * FINE as u32);
        let mut text = String::new();
        {
            let area = SVGBackend::with_string(&mut text, (fine_width, fine_height)).into_drawing_area();
            area.fill(&WHITE)?;
            draw(&Canvas { area: area.clone() })?;
            area.present()?;
        }
        let fine = format!("<svg width=\"{fine_width}\" height=\"{fine_height}\"");
        let scaled = format!("<svg width=\"{width}\" height=\"{height}\" stroke-linejoin=\"round\"");
        Ok(text.replacen(&fine, &scaled, 1))
    }

    pub fn line(&self, points: &[Pixel], stroke: &Stroke) -> Drawn {
        if points.len() < 2 {
            return Ok(());
        }
        let style = stroke.colour.stroke_width(fine(stroke.width).max(1) as u32);
        let path: Vec<_> = points.iter().map(|&p| fine_point(p)).collect();
        let broken =
            |on: f64, off: f64| self.area.draw(&DashedPathElement::new(path.clone(), fine(on), fine(off), style));
        match stroke.dash {
            Dash::Dashed => broken(8.0, 5.0)?,
            Dash::Dotted => broken(2.0, 3.6)?,
            Dash::Solid => self.area.draw(&PathElement::new(path, style))?,
        }
        Ok(())
    }

    pub fn area(&self, corners: &[Pixel], colour: RGBColor, opacity: f64) -> Drawn {
        let path: Vec<_> = corners.iter().map(|&p| fine_point(p)).collect();
        Ok(self.area.draw(&Polygon::new(path, colour.mix(opacity).filled()))?)
    }

    pub fn disc(&self, centre: Pixel, radius: f64, colour: RGBColor) -> Drawn {
        Ok(self.area.draw(&Circle::new(fine_point(centre), fine(radius), colour.filled()))?)
    }

    /// One line of text, `size` the em in pixels, its middle height at `at`.
    pub fn text(&self, text: &str, at: Pixel, size: f64, colour: RGBColor, align: Align) -> Drawn {
        let side = match align {
            Align::Left => HPos::Left,
            Align::Centre | Align::Upwards => HPos::Center,
            Align::Right => HPos::Right,
        };
        let upright = (font::FAMILY, size * EM * FINE).into_font();
        let turned = if align == Align::Upwards { upright.transform(FontTransform::Rotate270) } else { upright };
        let style = TextStyle::from(turned).color(&colour).pos(Pos::new(side, VPos::Center));
        Ok(self.area.draw(&Text::new(text, fine_point(at), style))?)
    }

    /// The length of a line of text, pixels.
    pub fn length(&self, text: &str, size: f64) -> Drawn<f64> {
        length(text, size)
    }
}

/// The length of a line of text, pixels; the font is registered.
pub(super) fn length(text: &str, size: f64) -> Drawn<f64> {
    let font = (font::FAMILY, size * EM * FINE).into_font();
    let (wide, _) = font.box_size(text).map_err(|e| DrawError(format!("the text {text:?} cannot be measured: {e}")))?;
    Ok(f64::from(wide) / FINE)
}

fn fine(pixels: f64) -> i32 {
    (pixels * FINE).round() as i32
}

fn fine_point(p: Pixel) -> (i32, i32) {
    (fine(p.0), fine(p.1))
}
