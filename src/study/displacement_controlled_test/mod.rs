//! What a testing machine records: the stable branches, the jumps between them, and the way back.
mod jump;
mod looked_over;
pub(super) mod observed;
pub(super) mod result;
mod run;
pub(super) mod stable_branch;
