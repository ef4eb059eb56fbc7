//! Setae whose keys are varied: a row each, their table and their picture.

pub(crate) mod picture;
pub(crate) mod row;
pub(crate) mod table;
