//! What depends on parameters: fits, designs, uncertainties, and the derivatives that they build on.
pub(super) mod fit;
pub(super) mod limit_point_continuation;
pub mod optimisation;
pub(super) mod sensitivity;
pub(super) mod sweep;
pub mod uncertainty;
