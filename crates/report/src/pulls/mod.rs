//! What a user gets of a pull that is no peel of a beam: of a seta, of an array of setae, of a solid, and at a rate.

pub(crate) mod array;
pub(crate) mod rate;
pub(crate) mod seta;
pub(crate) mod solid;
mod swept_pulls;

use crate::writing::reference::Output;

/// What is written of them.
pub(crate) fn outputs() -> Vec<Output> {
    [seta::outputs(), rate::outputs(), solid::outputs(), array::outputs()].concat()
}
