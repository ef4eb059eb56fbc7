//! The one font of every picture, carried in the program: pictures do not depend on what a machine has installed.

use super::drawn::{DrawError, Drawn};
use plotters::style::{FontStyle, register_font};
use resvg::usvg::fontdb::Database;
use std::sync::{Arc, OnceLock};

/// What the SVG asks for: the embedded font, then the nearest in width that other machines have.
pub(crate) const FAMILY: &str = "DejaVu Sans, Verdana, sans-serif";

const BYTES: &[u8] = include_bytes!("../../font/DejaVuSans.ttf");

/// Makes the font known to plotters, once a process.
pub(crate) fn register() -> Drawn {
    static DONE: OnceLock<bool> = OnceLock::new();
    if *DONE.get_or_init(|| register_font(FAMILY, FontStyle::Normal, BYTES).is_ok()) {
        Ok(())
    } else {
        Err(DrawError("the embedded font cannot be read".into()))
    }
}

/// The fonts that an SVG is turned into pixels with: this one alone.
pub(crate) fn database() -> Arc<Database> {
    static FONTS: OnceLock<Arc<Database>> = OnceLock::new();
    FONTS
        .get_or_init(|| {
            let mut fonts = Database::new();
            fonts.load_font_data(BYTES.to_vec());
            fonts.set_sans_serif_family("DejaVu Sans");
            Arc::new(fonts)
        })
        .clone()
}
