//! Scenes sampled over wide ranges of material and size: how often a path fails, and whether its bounds hold.

mod kind;
mod run;
mod scene;
mod survey;

pub use kind::SampleKind;
pub use run::{Outside, PeelSetting, Run, Sampled, WAYS, sampled, ways_of};
pub use scene::scene_text;
pub use survey::{SampleSurvey, SampledScenes, survey_sample};
