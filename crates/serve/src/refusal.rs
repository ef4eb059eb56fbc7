//! Why a request has no answer: a status for programs, and sentences for who reads the page.

use axum::http::{HeaderValue, StatusCode, header};
use axum::response::{IntoResponse, Response};
use peelkit_report::ReportError;
use peelkit_scene::SceneError;
use serde::Serialize;
use std::time::Duration;

/// Why a request has no answer.
#[derive(Debug)]
pub(crate) enum Refusal {
    /// The scene cannot be read or computed.
    Scene { found: String, remedy: String },
    /// The request is none that the page sends.
    Request(String),
    /// It has more bytes than this.
    TooLarge(usize),
    /// It did not arrive within this time.
    TooSlow(Duration),
    /// It is no JSON by its own account.
    NotJson,
    /// It comes from a page of another origin, or asks for a host that this is not.
    Foreign(String),
    /// So many runs wait already.
    Busy(usize),
    /// The server is ending.
    Ending,
    /// The run ended without a result.
    Broken(String),
    /// There is no such page.
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
            Self::Foreign(_) => StatusCode::FORBIDDEN,
            Self::Busy(_) | Self::Ending => StatusCode::SERVICE_UNAVAILABLE,
            Self::Broken(_) => StatusCode::INTERNAL_SERVER_ERROR,
            Self::NotFound => StatusCode::NOT_FOUND,
        }
    }

    /// What was found.
    fn found(&self) -> String {
        match self {
            Self::Scene { found, .. } => found.clone(),
            Self::Request(found) => format!("the request is none that the page sends: {found}"),
            Self::TooLarge(most) => format!("the request is larger than {most} bytes"),
            Self::TooSlow(time) => format!("the request did not arrive within {} s", time.as_secs_f64()),
            Self::NotJson => "the request is not of the content type application/json".into(),
            Self::Foreign(found) => found.clone(),
            Self::Busy(waiting) => format!("{waiting} runs wait already for one to end"),
            Self::Ending => "the server is ending".into(),
            Self::Broken(found) => format!("the run ended without a result: {found}"),
            Self::NotFound => "there is nothing at this address".into(),
        }
    }

    /// What would be right.
    fn remedy(&self) -> &str {
        match self {
            Self::Scene { remedy, .. } => remedy,
            Self::Request(_) | Self::NotJson => "Load the page again: it may be that of another version.",
            Self::TooLarge(_) => "Give a shorter scene.",
            Self::TooSlow(_) => "Send it again.",
            Self::Foreign(_) => "Open the page at the address that peel serve prints.",
            Self::Busy(_) => "Wait a moment, or close other windows with this page.",
            Self::Ending => "Start peel serve again.",
            Self::Broken(_) => "Change the scene a little; the server goes on.",
            Self::NotFound => "The page is at /.",
        }
    }
}

impl IntoResponse for Refusal {
    fn into_response(self) -> Response {
        let body = serde_json::to_vec(&Body { error: &self.found(), remedy: self.remedy() }).unwrap_or_default();
        let mut response =
            (self.status(), [(header::CONTENT_TYPE, "application/json")], body).into_response();
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
        let found = if message.starts_with("--set ") { error.statement().to_owned() } else { message };
        Self::Scene { found, remedy }
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
