//! Whole peels: how they end, how far they may be wrong, what a test records of them.

mod choice;
mod curve;
mod ends;
mod error_bounds;
mod events;
mod fit;
mod followed_until;
mod measured_law;
mod observed;
mod observed_in_space;
mod optimisation;
mod out_of_plane;
mod out_of_plane_branch;
mod peak_only;
mod sensitivities;
mod sheared;
mod space;
mod space_by_roll;
mod space_outlines;
mod special_points;
mod stability;
mod stations;
mod steady_force;
mod terms;
mod upright;
mod warnings;
