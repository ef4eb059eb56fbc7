//! A seta whose root is pulled at a rate: branches of viscous material, tips that leave their branch at events. With mass or without.
mod events;
pub(super) mod result;
pub(super) mod run;
pub(super) mod settings;
