//! A picture: panels on a sheet under a title.

use super::canvas::{Align, Canvas, length};
use super::drawn::{DrawError, Drawn};
use super::font;
use super::panel::Panel;
use super::style::{WIDTH, colour, size};
use peelkit::units::PreferredUnits;
use peelkit_scene::Scene;

/// What a picture is called, and the units that the user wants in it.
#[derive(Clone, Copy, Debug)]
pub struct Heading<'h> {
    /// The line above; further lines are a caption.
    pub title: &'h str,
    /// Of its axes and labels; of what has none the one that fits.
    pub units: PreferredUnits,
}

impl<'h> Heading<'h> {
    /// The same units under another title.
    pub(crate) fn titled(self, title: &'h str) -> Self {
        Self { title, ..self }
    }
}

impl<'h> From<&'h str> for Heading<'h> {
    fn from(title: &'h str) -> Self {
        Self { title, units: PreferredUnits::default() }
    }
}

impl<'h> From<&'h Scene> for Heading<'h> {
    fn from(scene: &'h Scene) -> Self {
        Self { title: &scene.title, units: scene.written_units() }
    }
}

/// Panels on a sheet under a title.
#[derive(Clone, Debug)]
pub struct Picture {
    /// The line above; a very long one is cut. Further lines are a caption, which stands small below the panels.
    pub title: String,
    /// Height of the sheet without the caption, pixels; its width is [`WIDTH`].
    pub height: u32,
    /// In the order in which they are drawn.
    pub panels: Vec<Panel>,
}

impl Picture {
    /// The same with the numbers of all axes in the units that the user wants.
    pub fn in_units(mut self, units: PreferredUnits) -> Self {
        for axis in self.panels.iter_mut().flat_map(|panel| [&mut panel.x, &mut panel.y]) {
            axis.units = units;
        }
        self
    }

    /// The picture as SVG text.
    ///
    /// # Errors
    /// A drawing that the backend refuses, and no font.
    pub fn svg(&self) -> Result<String, DrawError> {
        font::register()?;
        let caption = self.caption()?;
        let height = self.height + (LEADING * caption.len() as f64).ceil() as u32;
        Canvas::svg(WIDTH, height, |canvas| {
            let (title, size) = self.fitted_title(canvas)?;
            canvas.text(&title, (0.5 * f64::from(WIDTH), 18.0), size, colour::INK, Align::Centre)?;
            self.panels.iter().try_for_each(|panel| panel.draw(canvas))?;
            caption.iter().enumerate().try_for_each(|(line, text)| {
                let y = f64::from(self.height) - 4.0 + (line as f64 + 0.5) * LEADING;
                canvas.text(text, (MARGIN, y), SMALL, colour::CAPTION, Align::Left)
            })
        })
    }

    /// The caption in lines that fit the sheet.
    fn caption(&self) -> Drawn<Vec<String>> {
        let room = f64::from(WIDTH) - 2.0 * MARGIN;
        let mut lines = Vec::new();
        for paragraph in self.title.lines().skip(1) {
            let mut line = String::new();
            for word in paragraph.split_whitespace() {
                let longer = if line.is_empty() { word.to_owned() } else { format!("{line} {word}") };
                if !line.is_empty() && length(&longer, SMALL)? > room {
                    lines.push(std::mem::replace(&mut line, word.to_owned()));
                } else {
                    line = longer;
                }
            }
            lines.push(line);
        }
        Ok(lines)
    }

    /// A long title is set smaller, a very long one is cut.
    fn fitted_title(&self, canvas: &Canvas<'_>) -> Drawn<(String, f64)> {
        let title = self.title.lines().next().unwrap_or_default();
        let room = f64::from(WIDTH) - 20.0;
        let full = canvas.length(title, size::TITLE)?;
        if full <= room {
            return Ok((title.to_owned(), size::TITLE));
        }
        let smallest = size::TEXT - 1.0;
        let shrunk = size::TITLE * room / full;
        if shrunk >= smallest {
            return Ok((title.to_owned(), shrunk));
        }
        let letters = title.chars().count() as f64 * shrunk / smallest;
        let cut: String = title.chars().take((letters as usize).saturating_sub(2)).collect();
        Ok((format!("{}…", cut.trim_end()), smallest))
    }
}

/// Size of a caption, pixels.
const SMALL: f64 = 11.5;
/// From one line of a caption to the next, pixels.
const LEADING: f64 = 15.0;
/// Free to both sides of a caption, pixels.
const MARGIN: f64 = 16.0;
