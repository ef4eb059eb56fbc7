//! Tables of a scene beside its body: what their keys take, and what goes together in them.

pub(crate) mod array;
mod bounded;
pub(crate) mod branching;
pub(crate) mod fit;
pub(crate) mod layers;
pub(crate) mod measured;
pub(crate) mod optimise;
pub(crate) mod output;
pub(crate) mod rate;
pub(crate) mod seta;
pub(crate) mod solid;
pub(crate) mod uncertainty;
