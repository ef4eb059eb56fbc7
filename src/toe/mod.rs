//! Arrays of setae: a patch on a rigid backing, a lamella, a toe.
//!
//! A seta is its law ([`RootLaw`]): potentials of the place of its root, and where they are left. Arrays are followed from event to event, each
//! seta of 10⁵ of them. [`Patch`] is rigid, [`Lamella`] a band on rows of setae, [`Toe`] a pad whose branches are lamellae.
mod chain;
mod cluster;
mod events;
mod lamella;
mod law;
mod patch;
mod potential;
mod pull;
mod scatter;
mod toe_pad;

pub use chain::BandSection;
pub use events::{ArrayEnd, ArrayEvent, ArrayFailure, Followed};
pub use lamella::{ArrayDrive, ArrayError, Lamella};
pub use law::{Lifted, RootLaw, RootLawError, RootSheet};
pub use patch::{Backing, Patch, PatchFollowed, PatchStep};
pub use potential::Potential;
pub use pull::{ArrayPull, ArrayRow, SetaArray};
pub use scatter::{RootOffset, Scatter};
pub use toe_pad::Toe;
