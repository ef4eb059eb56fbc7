//! A picture: panels on a sheet under a title.

use super::canvas::{Align, Canvas};
use super::drawn::Drawn;
use super::panel::Panel;
use super::style::{WIDTH, colour, size};

/// Panels on a sheet under a title.
#[derive(Clone, Debug)]
pub struct Picture {
    /// The line above; a very long one is cut.
    pub title: String,
    /// Height of the sheet, pixels; its width is [`WIDTH`].
    pub height: u32,
    /// In the order in which they are drawn.
    pub panels: Vec<Panel>,
}

impl Picture {
    /// The picture as SVG text.
    pub(crate) fn svg(&self) -> Drawn<String> {
        Canvas::svg(WIDTH, self.height, |canvas| {
            let (title, size) = self.fitted_title(canvas)?;
            canvas.text(&title, (0.5 * f64::from(WIDTH), 18.0), size, colour::INK, Align::Centre)?;
            self.panels.iter().try_for_each(|panel| panel.draw(canvas))
        })
    }

    /// A long title is set smaller, a very long one is cut.
    fn fitted_title(&self, canvas: &Canvas<'_>) -> Drawn<(String, f64)> {
        let room = f64::from(WIDTH) - 20.0;
        let full = canvas.length(&self.title, size::TITLE)?;
        if full <= room {
            return Ok((self.title.clone(), size::TITLE));
        }
        let smallest = size::TEXT - 1.0;
        let shrunk = size::TITLE * room / full;
        if shrunk >= smallest {
            return Ok((self.title.clone(), shrunk));
        }
        let letters = self.title.chars().count() as f64 * shrunk / smallest;
        let cut: String = self.title.chars().take((letters as usize).saturating_sub(2)).collect();
        Ok((format!("{}…", cut.trim_end()), smallest))
    }
}
