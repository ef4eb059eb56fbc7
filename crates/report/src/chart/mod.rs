//! The small vocabulary that every picture is drawn with: a picture has panels; a panel has two axes, bands, shapes,
//! lines and marks. Labels and the legend find their own places.

pub(crate) mod axis;
pub(crate) mod canvas;
mod drawn;
mod font;
pub(crate) mod marked;
pub(crate) mod output;
pub(crate) mod panel;
pub(crate) mod picture;
pub(crate) mod place;
mod shorthand;
pub(crate) mod style;
pub(crate) mod symbol;

pub use axis::{Axis, significant, with_unit};
pub use canvas::{Dash, Stroke};
pub use drawn::DrawError;
pub use output::save;
pub use panel::{Band, Face, Line, Mark, Note, Panel, Rim, Shape};
pub use picture::{Heading, Picture};
pub use place::Frame;
pub use plotters::style::RGBColor;
pub use style::{WIDTH, colour, order_shade, signed_shade};
pub use symbol::Symbol;
