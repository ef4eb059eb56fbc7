//! The command `peel`, run as a user runs it.

mod array;
mod checkpoints;
mod coarsen;
mod coarsen_stops;
mod collect;
mod documents;
mod fit;
#[path = "../shared/frames.rs"]
mod frames;
mod friction;
mod interrupt;
mod observed;
mod optimise;
mod out_of_plane;
mod output_folders;
mod peel;
mod plot;
mod pull;
mod resume;
mod sensitivities;
mod serve;
mod seta;
mod seta_at_a_rate;
mod seta_law;
mod seta_of_beams;
#[cfg(unix)]
mod seta_pressed;
#[cfg(unix)]
mod seta_table;
mod solid;
mod space;
mod stations;
mod statuses;
mod steps;
#[path = "../shared/strip.rs"]
mod strip;
mod studies_of_pulls;
mod sweeps;
mod uncertainty;
