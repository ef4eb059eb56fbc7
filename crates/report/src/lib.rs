//! What a user gets: tables, pictures, summaries, and checkpoints of what is not finished.

#![forbid(unsafe_code)]
#![warn(missing_docs)]

mod animation;
pub mod chart;
mod checkpoint;
mod error;
mod file;
mod fit_report;
mod folder;
mod names;
mod number;
mod outputs;
pub mod overlay;
mod parameters_file;
pub mod pictures;
mod pull_row;
mod rate;
mod record;
mod records;
mod reference;
mod seta;
mod states;
mod sweep_row;
mod swept_keys;
mod table;
mod timing;
mod tip_law;

pub use animation::{Pose, poses, write_animation};
pub use checkpoint::{
    Damaged, DamagedPart, DividedSweep, Part, PartAxis, PartHeader, PartialCollection, PartialFile,
    PartialOptimisation, PartialRun, PartialSeta, PartialSweep, PartialUncertainty, SetaCheckpoint, Storable,
    SweepPart,
};
pub use error::ReportError;
pub use file::write_whole;
pub use fit_report::FitReport;
pub use folder::{Existing, OutputFolder};
pub use names::{
    end_reason, end_word, first_jump_word, form_word, jump_title, limit_point_kind_word, test_end_reason, test_end_word,
};
pub use number::{Finite, to_json};
pub use outputs::outputs;
pub use parameters_file::write_parameters;
pub use pictures::{
    curve_svg, draw_fit, draw_followed, draw_observed, draw_optimum, draw_peel, draw_peel_with_branch, draw_plane,
    draw_sensitivities, draw_sweep, draw_tip_law, draw_uncertainty,
};
pub use pull_row::PullRow;
pub use rate::{
    Contact, Equilibria, PointAtRate, PulledAtRate, RateFound, RateResult, RateRow, RateSummary, SlowPeak, draw_rate,
    draw_swept_rates, rate_columns, write_rate_curve, write_swept_rates,
};
pub use record::{Bounded, Cell, Content, Fields, Object, Record, columns_of};
pub use records::{
    FitSummary, Found, GripOfPoint, ObservedSummary, OptimisationSummary, Optimised, PeelFound, PeelSummary, SCHEMA,
    Summary, Sweep, SweepLine, SweepSummary, TipFound, TipSummary, UncertainPeel, UncertaintySummary, VERSION,
    curve_csv, ground_warning, left_out, why_kept, work_to, write_branch, write_curve, write_equilibria, write_fit,
    write_followed, write_history, write_limit_points, write_observed, write_samples, write_sweep, write_tip_law,
    write_uncertainty,
};
pub use reference::{Output, OutputKey, Reference, merged, paths, without_unit};
pub use seta::{
    SETA_STATE_FIELDS, SetaFound, SetaMotion, SetaPose, SetaRow, SetaStateField, SetaSummary, TipEvents, draw_pull_off,
    draw_swept_setae, pull_off_columns, seta_end_reason, seta_end_word, tip_peak, write_seta_animation,
    write_seta_curve, write_seta_equilibria, write_seta_events, write_seta_rate_events, write_seta_states,
    write_swept_setae, write_tip_curve, write_tips,
};
pub use states::{SPATIAL_STATE_FIELDS, STATE_FIELDS, StateField, write_states, write_vtk};
pub use sweep_row::SweepRow;
pub use swept_keys::{SweptKeys, as_given};
pub use table::write_table;
pub use timing::timed;
pub use tip_law::{read_tip_law, read_tip_law_of};
