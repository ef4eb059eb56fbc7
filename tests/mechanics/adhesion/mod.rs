//! What pulls a section.

mod laws;
mod line_load;
mod spatial_section;
