//! What a testing machine records: the stable branches, the jumps between them, and the way back.
pub(super) mod balance;
pub(super) mod failure;
mod jump;
pub(super) mod model_limit;
pub(super) mod observed;
pub(super) mod result;
mod run;
mod stable_branch;
