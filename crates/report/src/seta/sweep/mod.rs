//! Setae whose keys are varied: a row each, their table and their picture.

mod picture;
mod row;
mod table;

pub use picture::draw_swept_setae;
pub use row::SetaRow;
pub use table::write_swept_setae;
