//! What a run found, laid out for a person.

mod branch;
mod fit;
mod layout;
mod number;
mod observed;
mod optimisation;
mod peel;
mod rate;
mod sensitivities;
mod seta;
mod stability;
mod sweep;
mod swept_rates;
mod swept_setae;
mod tip;
mod uncertainty;
mod units;

pub use fit::fit;
pub use number::spaced;
pub use observed::observed;
pub use optimisation::optimum;
pub use peel::{peel, taken};
pub use rate::{LawOfTips, rate};
pub use sensitivities::sensitivities;
pub use seta::{equilibria_taken, seta};
pub use sweep::{followed, sweep};
pub use swept_rates::swept_rates;
pub use swept_setae::swept_setae;
pub use tip::tip;
pub use uncertainty::uncertainty;
pub use units::{UnitsArgs, WantedUnits};
