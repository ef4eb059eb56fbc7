//! The law of a seta, one level above that of a tip: few sheets, each a potential of the place of its root, left for the next one at a plane.
mod fit;
pub(crate) mod law;
mod path;

pub use fit::SetaLawOptions;
pub use law::{ExitPlane, LawSheet, RootResponse, SetaLaw, SetaLawErrors};
pub use path::{RootPath, RootPoint, SetaLawError};
