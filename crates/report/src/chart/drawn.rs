//! What drawing comes to.

use plotters::drawing::DrawingAreaErrorKind;
use std::fmt;

/// Why a drawing failed.
#[derive(Debug)]
pub struct DrawError(pub String);

impl<E: std::error::Error + Send + Sync> From<DrawingAreaErrorKind<E>> for DrawError {
    fn from(error: DrawingAreaErrorKind<E>) -> Self {
        DrawError(error.to_string())
    }
}

impl fmt::Display for DrawError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

/// What was drawn, or why it could not be.
pub type Drawn<T = ()> = Result<T, DrawError>;
