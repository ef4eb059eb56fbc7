//! Tables of a scene beside its body: what their keys take, and what goes together in them.

mod bounded;
pub(crate) mod curves;
pub(crate) mod fit;
pub(crate) mod layers;
pub(crate) mod measured;
pub(crate) mod optimise;
pub(crate) mod output;
pub(crate) mod rate;
pub(crate) mod setae;
pub(crate) mod solid;
pub(crate) mod uncertainty;
