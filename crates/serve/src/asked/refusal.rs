//! Why a request has no answer: a status for programs, and sentences for who reads the page.

use axum::http::{HeaderValue, StatusCode, header};
use axum::response::{IntoResponse, Response};
use peelkit_report::ReportError;
use peelkit_scene::SceneError;
use serde::Serialize;
use std::time::Duration;

/// Why a request has no answer.
#[derive(Debug, thiserror::Error)]
pub(crate) enum Refusal {
    /// The scene cannot be read or computed.
    #[error("{found}")]
    Scene { found: String, remedy: String },
    /// The request is none that the page sends.
    #[error("the request is none that the page sends: {0}")]
    Request(String),
    /// It has more bytes than this.
    #[error("the request is larger than {0} bytes")]
    TooLarge(usize),
    /// It did not arrive within this time.
    #[error("the request did not arrive within {} s", .0.as_secs_f64())]
    TooSlow(Duration),
    /// It is no JSON by its own account.
    #[error("the request is not of the content type application/json")]
    NotJson,
    /// It asks for a host of this name.
    #[error("the host `{0}` is not this one")]
    OtherHost(String),
    /// A page of this origin has sent it.
    #[error("the request was sent by a page of another site: {0}")]
    OtherSite(String),
    /// So many runs wait already.
    #[error("{0} runs wait already for one to end")]
    Busy(usize),
    /// The server is ending.
    #[error("the server is ending")]
    Ending,
    /// The run ended without a result.
    #[error("the run ended without a result: {0}")]
    Broken(String),
    /// There is no such page.
    #[error("there is nothing at this address")]
    NotFound,
}

#[derive(Serialize)]
struct Body<'b> {
    error: &'b str,
    remedy: &'b str,
}

impl Refusal {
    fn status(&self) -> StatusCode {
        match self {
            Self::Scene { .. } => StatusCode::UNPROCESSABLE_ENTITY,
            Self::Request(_) => StatusCode::BAD_REQUEST,
            Self::TooLarge(_) => StatusCode::PAYLOAD_TOO_LARGE,
            Self::TooSlow(_) => StatusCode::REQUEST_TIMEOUT,
            Self::NotJson => StatusCode::UNSUPPORTED_MEDIA_TYPE,
            Self::OtherHost(_) | Self::OtherSite(_) => StatusCode::FORBIDDEN,
            Self::Busy(_) | Self::Ending => StatusCode::SERVICE_UNAVAILABLE,
            Self::Broken(_) => StatusCode::INTERNAL_SERVER_ERROR,
            Self::NotFound => StatusCode::NOT_FOUND,
        }
    }

    /// What would be right.
    fn remedy(&self) -> &str {
        match self {
            Self::Scene { remedy, .. } => remedy,
            Self::Request(_) | Self::NotJson => "Load the page again: it may be that of another version.",
            Self::TooLarge(_) => "Give a shorter scene.",
            Self::TooSlow(_) => "Send it again.",
            Self::OtherHost(_) => "Open the page at localhost, or at the address of the machine in numbers.",
            Self::OtherSite(_) => "Open the page at the address that peel serve prints.",
            Self::Busy(_) => "Wait a moment, or close other windows with this page.",
            Self::Ending => "Start peel serve again.",
            Self::Broken(_) => "Change the scene a little; the server goes on.",
            Self::NotFound => "The page is at /.",
        }
    }
}

impl IntoResponse for Refusal {
    fn into_response(self) -> Response {
        let body = serde_json::to_vec(&Body { error: &self.to_string(), remedy: self.remedy() }).unwrap_or_default();
        let mut response = (self.status(), [(header::CONTENT_TYPE, "application/json")], body).into_response();
        if matches!(self, Self::Busy(_)) {
            response.headers_mut().insert(header::RETRY_AFTER, HeaderValue::from_static("1"));
        }
        response
    }
}

impl From<SceneError> for Refusal {
    fn from(error: SceneError) -> Self {
        let (message, remedy) = (error.to_string(), error.remedy().to_owned());
        // a control of the page has no line of a file
        let found = if message.starts_with("--set ") { error.problem() } else { message };
        Self::Scene { found, remedy }
    }
}

impl From<peelkit_analyses::Refusal> for Refusal {
    fn from(refusal: peelkit_analyses::Refusal) -> Self {
        use peelkit_analyses::Refusal as Of;
        match refusal {
            Of::Asked { found, remedy } | Of::Scene { found, remedy } => Self::Scene { found, remedy },
            Of::CutShort(why) => Self::Scene {
                found: format!("the computation stopped short: {why}"),
                remedy: "Change the scene a little.".into(),
            },
            Of::Report(error) => error.into(),
            Of::Other(why) => Self::Broken(why),
        }
    }
}

impl From<ReportError> for Refusal {
    fn from(error: ReportError) -> Self {
        match error {
            ReportError::Draw { reason, .. } => {
                Self::Scene { found: format!("there is nothing to draw: {reason}"), remedy: "Change the scene.".into() }
            }
            other => Self::Broken(other.to_string()),
        }
    }
}

impl From<std::io::Error> for Refusal {
    /// Of a number that cannot be written.
    fn from(error: std::io::Error) -> Self {
        Self::Broken(error.to_string())
    }
}
