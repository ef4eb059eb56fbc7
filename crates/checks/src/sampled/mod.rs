//! Scenes sampled over wide ranges of material and size: how often a path fails, and whether its bounds hold.

mod run;
mod scene;
mod survey;

pub use run::{Outside, PeelSetting, Run, Sampled, WAYS, sampled};
pub use scene::{SampleKind, scene_text};
pub use survey::{SampleSurvey, SampledScenes, survey_sample};
