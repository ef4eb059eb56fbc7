//! What a user gets: tables, pictures, summaries, and checkpoints of what is not finished.

#![forbid(unsafe_code)]
#![warn(missing_docs)]

mod animation;
pub mod chart;
mod checkpoint;
mod outputs;
pub mod overlay;
pub mod pictures;
mod pulls;
mod records;
mod states;
mod swept;
mod writing;

pub use animation::frames::{Pose, poses};
pub use animation::write_animation;
pub use chart::marked::Marked;
pub use checkpoint::folder::{Existing, OutputFolder};
pub use checkpoint::journal::Journal;
pub use checkpoint::kind::JournalKind;
pub use checkpoint::part::{DividedSweep, Part, PartAxis, PartHeader, PartialCollection, SweepPart};
pub use outputs::outputs;
pub use pictures::fit::draw_fit;
pub use pictures::laws::seta::draw_seta_law;
pub use pictures::laws::tip::draw_tip_law;
pub use pictures::observed::draw_observed;
pub use pictures::optimisation::draw_optimum;
pub use pictures::peel::{curve_svg, draw_peel, draw_peel_with_branch};
pub use pictures::sensitivities::draw_sensitivities;
pub use pictures::steps::draw_steps;
pub use pictures::sweep::draw_sweep;
pub use pictures::swept::followed::draw_followed;
pub use pictures::swept::plane::draw_plane;
pub use pictures::uncertainty::draw_uncertainty;
pub use pulls::array::picture::draw_array;
pub use pulls::array::summary::{ArrayFound, ArraySummary, array_end_reason, array_end_word};
pub use pulls::array::sweep::{ArrayResult, SweptArray, draw_swept_arrays, write_swept_arrays};
pub use pulls::array::tables::{array_columns, write_array_tables};
pub use pulls::rate::curve::{rate_columns, write_rate_curve};
pub use pulls::rate::picture::draw_rate;
pub use pulls::rate::summary::{RateFound, RateSummary};
pub use pulls::rate::sweep::{RateResult, RateRow, draw_swept_rates, write_swept_rates};
pub use pulls::seta::animation::write_seta_animation;
pub use pulls::seta::motion::{SetaMotion, SetaPose};
pub use pulls::seta::names::{TipEvents, seta_end_reason, seta_end_word};
pub use pulls::seta::picture::draw_pull_off;
pub use pulls::seta::summary::{SetaFound, SetaSummary, tip_peak};
pub use pulls::seta::sweep::{SetaRow, draw_swept_setae, write_swept_setae};
pub use pulls::seta::tables::{
    pull_off_columns, write_seta_curve, write_seta_equilibria, write_seta_events, write_seta_rate_events,
    write_tip_curve, write_tips,
};
pub use pulls::seta::vtk::{SETA_STATE_FIELDS, SetaStateField, write_seta_states};
pub use pulls::solid::fields::write_solid_states;
pub use pulls::solid::picture::draw_solid;
pub use pulls::solid::summary::{SolidFound, SolidSummary, solid_end_reason, solid_end_word, solid_warnings};
pub use pulls::solid::sweep::{SolidResult, SolidRow, SolidTurn, draw_swept_solids, write_swept_solids};
pub use pulls::solid::tables::{solid_columns, write_solid_tables};
pub use records::model::{ground_warning, why_kept};
pub use records::observed::{ObservedSummary, write_observed};
pub use records::of_many::fit::{FitReport, FitSummary, write_fit};
pub use records::of_many::optimisation::{OptimisationSummary, Optimised, write_history};
pub use records::of_many::seta_law::{SetaLawFound, SetaLawSummary, seta_law_text, write_seta_law};
pub use records::of_many::sweep::{Sweep, SweepLine, SweepSummary, work_to, write_followed, write_sweep};
pub use records::of_many::tip::{TipFound, TipSummary, write_tip_law};
pub use records::of_many::tip_law::{read_tip_law, read_tip_law_of};
pub use records::of_many::uncertainty::{UncertainPeel, UncertaintySummary, write_samples, write_uncertainty};
pub use records::passed::{PassedAt, write_passed};
pub use records::path::{
    GripOfPoint, curve_csv, write_branch, write_curve, write_equilibria, write_limit_points, write_stations,
};
pub use records::peel::{PeelFound, PeelSummary, left_out};
pub use records::pulled::{Contact, Equilibria, PointAtRate, PulledAtRate, SlowPeak, StationAtRate};
pub use records::steps::{steps_columns, write_steps};
pub use records::summary::{Found, SCHEMA, Summary, VERSION, command_of_results, write_parameters};
pub use states::fields::{SPATIAL_STATE_FIELDS, STATE_FIELDS, StateField};
pub use states::table::write_states;
pub use states::vtk::write_vtk;
pub use swept::timed;
pub use swept::{PullRow, SweepRow, SweptKeys, as_given};
pub use writing::error::ReportError;
pub use writing::file::write_whole;
pub use writing::in_units::write_in_units;
pub use writing::names::unknown_error;
pub use writing::names::{
    end_reason, end_word, first_jump_word, form_word, jump_title, limit_point_kind_word, test_end_reason, test_end_word,
};
pub use writing::number::{Finite, to_json};
pub use writing::record::{Bounded, Cell, Content, Fields, Object, Record, columns_of, write_table};
pub use writing::reference::{Output, OutputKey, Reference, merged, paths, without_unit};
