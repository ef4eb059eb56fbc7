//! What a testing machine records: the stable branches, the jumps between them, and the way back.
mod balance;
mod failure;
mod jump;
mod model_limit;
mod observed;
mod result;
mod run;
mod stable_branch;
pub use balance::*;
pub use failure::{BranchError, TestError, TestFailure};
pub use model_limit::{LeftModel, ModelLimit};
pub use observed::{NoTest, no_test, observed, observed_retreat};
pub use result::*;
