//! What a user gets: tables, pictures, summaries, and checkpoints of what is not finished.

#![forbid(unsafe_code)]
#![warn(missing_docs)]

mod animation;
mod array;
pub mod chart;
mod checkpoint;
mod error;
mod file;
mod folder;
mod names;
mod number;
mod outputs;
pub mod overlay;
pub mod pictures;
mod rate;
mod record;
mod records;
mod reference;
mod seta;
mod solid;
mod states;
mod swept;
mod timing;
mod tip_law;
mod unknown_error;

pub use animation::frames::{Pose, poses};
pub use animation::write_animation;
pub use array::picture::draw_array;
pub use array::summary::{ArrayFound, ArraySummary, array_end_reason, array_end_word};
pub use array::sweep::{ArrayResult, SweptArray, draw_swept_arrays, write_swept_arrays};
pub use array::tables::{array_columns, write_array_tables};
pub use checkpoint::journal::{Journal, JournalKind};
pub use checkpoint::part::{DividedSweep, Part, PartAxis, PartHeader, PartialCollection, SweepPart};
pub use error::ReportError;
pub use file::write_whole;

pub use folder::{Existing, OutputFolder};
pub use names::{
    end_reason, end_word, first_jump_word, form_word, jump_title, limit_point_kind_word, test_end_reason, test_end_word,
};
pub use number::{Finite, to_json};
pub use outputs::outputs;
pub use pictures::fit::draw_fit;
pub use pictures::followed::draw_followed;
pub use pictures::marked::Marked;
pub use pictures::observed::draw_observed;
pub use pictures::optimisation::draw_optimum;
pub use pictures::peel::{curve_svg, draw_peel, draw_peel_with_branch};
pub use pictures::plane::draw_plane;
pub use pictures::sensitivities::draw_sensitivities;
pub use pictures::sweep::draw_sweep;
pub use pictures::tip::draw_tip_law;
pub use pictures::uncertainty::draw_uncertainty;
pub use rate::curve::{rate_columns, write_rate_curve};
pub use rate::picture::draw_rate;
pub use rate::pulled::{Contact, Equilibria, PointAtRate, PulledAtRate, SlowPeak, StationAtRate};
pub use rate::summary::{RateFound, RateSummary};
pub use rate::sweep::{RateResult, RateRow, draw_swept_rates, write_swept_rates};
pub use record::{Bounded, Cell, Content, Fields, Object, Record, columns_of, write_table};
pub use records::fit::{FitReport, FitSummary, write_fit};
pub use records::model::{ground_warning, why_kept};
pub use records::observed::{ObservedSummary, write_observed};
pub use records::optimisation::{OptimisationSummary, Optimised, write_history};
pub use records::passed::{PassedAt, write_passed};
pub use records::path::{
    GripOfPoint, curve_csv, write_branch, write_curve, write_equilibria, write_limit_points, write_stations,
};
pub use records::peel::{PeelFound, PeelSummary, left_out};
pub use records::seta_law::{SetaLawFound, SetaLawSummary, seta_law_text, write_seta_law};
pub use records::summary::{Found, SCHEMA, Summary, VERSION, command_of_results, write_parameters};
pub use records::sweep::{Sweep, SweepLine, SweepSummary, work_to, write_followed, write_sweep};
pub use records::tip::{TipFound, TipSummary, write_tip_law};
pub use records::uncertainty::{UncertainPeel, UncertaintySummary, write_samples, write_uncertainty};
pub use reference::{Output, OutputKey, Reference, merged, paths, without_unit};
pub use seta::animation::write_seta_animation;
pub use seta::motion::{SetaMotion, SetaPose};
pub use seta::names::{TipEvents, seta_end_reason, seta_end_word};
pub use seta::picture::draw_pull_off;
pub use seta::summary::{SetaFound, SetaSummary, tip_peak};
pub use seta::sweep::{SetaRow, draw_swept_setae, write_swept_setae};
pub use seta::tables::{
    pull_off_columns, write_seta_curve, write_seta_equilibria, write_seta_events, write_seta_rate_events,
    write_tip_curve, write_tips,
};
pub use seta::vtk::{SETA_STATE_FIELDS, SetaStateField, write_seta_states};
pub use solid::fields::write_solid_states;
pub use solid::picture::draw_solid;
pub use solid::summary::{SolidFound, SolidSummary, solid_end_reason, solid_end_word, solid_warnings};
pub use solid::sweep::{SolidResult, SolidRow, SolidTurn, draw_swept_solids, write_swept_solids};
pub use solid::tables::{solid_columns, write_solid_tables};
pub use states::fields::{SPATIAL_STATE_FIELDS, STATE_FIELDS, StateField};
pub use states::table::write_states;
pub use states::vtk::write_vtk;
pub use swept::{PullRow, SweepRow, SweptKeys, as_given};

pub use timing::timed;
pub use tip_law::{read_tip_law, read_tip_law_of};
pub use unknown_error::unknown_error;
