//! The page's server, over connections as a browser makes them.

mod abuse;
mod client;
mod origin;
mod page;
mod runs;
mod scenes;
