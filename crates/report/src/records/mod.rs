//! What is written of each result: its tables and its summary.json.

pub(crate) mod fit;
mod located;
pub(crate) mod model;
pub(crate) mod observed;
pub(crate) mod optimisation;
mod out_of_plane;
pub(crate) mod passed;
pub(crate) mod path;
pub(crate) mod peel;
pub(crate) mod seta_law;
pub(crate) mod summary;
pub(crate) mod sweep;
pub(crate) mod tip;
pub(crate) mod uncertainty;

use super::reference::Output;

/// What is written of peels, of their sweeps, and of what is made of many peels.
pub(crate) fn outputs() -> Vec<Output> {
    let peels = [peel::outputs(), path::outputs(), passed::outputs(), observed::outputs(), sweep::outputs()].concat();
    let of_many =
        [fit::outputs(), optimisation::outputs(), uncertainty::outputs(), tip::outputs(), seta_law::outputs()].concat();
    [peels, of_many].concat()
}
