//! Addresses and what stands behind them.

use crate::asked::limits::Limits;
use crate::asked::refusal::Refusal;
use crate::asked::request::{FileRequest, PeelRequest, parse};
use crate::http::origin;
use crate::page::{FILES, PageFile, StartScene};
use crate::run::answer::answer;
use crate::run::files::file;
use crate::run::runs::Runs;
use axum::Router;
use axum::body::{Body, Bytes};
use axum::extract::{DefaultBodyLimit, FromRequest, Request, State};
use axum::http::{HeaderName, HeaderValue, StatusCode, header};
use axum::middleware::{Next, from_fn};
use axum::response::{IntoResponse, Response};
use axum::routing::{get, post};
use std::sync::Arc;

/// What the page may do in a browser: load what this server sends, and ask this server.
const POLICY: &str = "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' data: blob:; connect-src 'self'; \
                      base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

/// Of every answer.
const HEADERS: [(HeaderName, &str); 5] = [
    (header::CONTENT_SECURITY_POLICY, POLICY),
    (header::X_CONTENT_TYPE_OPTIONS, "nosniff"),
    (header::REFERRER_POLICY, "no-referrer"),
    (header::CACHE_CONTROL, "no-store"),
    (HeaderName::from_static("cross-origin-resource-policy"), "same-origin"),
];

/// What every address shares.
#[derive(Clone)]
struct Shared {
    runs: Runs,
    limits: Limits,
    scenes: Arc<Vec<StartScene>>,
}

/// The addresses of the page and of its server.
pub(crate) fn router(runs: Runs, limits: Limits, scenes: Vec<StartScene>) -> Router {
    let shared = Shared { runs, limits, scenes: Arc::new(scenes) };
    let mut router = Router::new()
        .route("/api/scenes", get(list_scenes))
        .route("/api/peel", post(run_peel))
        .route("/api/file", post(run_file));
    for page in FILES {
        router = router.route(page.path, get(|| async { page_file(page) }));
    }
    router
        .fallback(|| async { Refusal::NotFound })
        .layer(DefaultBodyLimit::max(limits.body))
        .layer(from_fn(guarded))
        .with_state(shared)
}

/// Refuses strangers, and gives every answer its headers.
async fn guarded(request: Request, next: Next) -> Response {
    let mut response = match origin::check(request.method(), request.uri(), request.headers()) {
        Ok(()) => next.run(request).await,
        Err(refusal) => refusal.into_response(),
    };
    let headers = response.headers_mut();
    for (name, value) in HEADERS {
        headers.insert(name, HeaderValue::from_static(value));
    }
    response
}

fn page_file(file: &'static PageFile) -> Response {
    typed(file.media, Body::from(file.text))
}

fn typed(media: &'static str, body: Body) -> Response {
    ([(header::CONTENT_TYPE, media)], body).into_response()
}

async fn list_scenes(State(shared): State<Shared>) -> Response {
    let list = serde_json::to_vec(shared.scenes.as_slice()).unwrap_or_default();
    typed("application/json", Body::from(list))
}

async fn run_peel(State(shared): State<Shared>, request: Request) -> Result<Response, Refusal> {
    let request: PeelRequest = parse(&arrived(&shared, request).await?)?;
    let json = shared.runs.run(move |end| answer(&request, end)).await??;
    Ok(typed("application/json", Body::from(json)))
}

async fn run_file(State(shared): State<Shared>, request: Request) -> Result<Response, Refusal> {
    let request: FileRequest = parse(&arrived(&shared, request).await?)?;
    let sent = shared.runs.run(move |end| file(&request, end)).await??;
    Ok(typed(sent.media, Body::from(sent.content)))
}

/// The body of a request, when it is there.
async fn arrived(Shared { limits, .. }: &Shared, request: Request) -> Result<Bytes, Refusal> {
    let announced = request.headers().get(header::CONTENT_LENGTH).and_then(|length| length.to_str().ok()?.parse().ok());
    if announced.is_some_and(|length: u64| length > limits.body as u64) {
        return Err(Refusal::TooLarge(limits.body));
    }
    match tokio::time::timeout(limits.arrival, Bytes::from_request(request, &())).await {
        Err(_) => Err(Refusal::TooSlow(limits.arrival)),
        Ok(Err(rejection)) if rejection.status() == StatusCode::PAYLOAD_TOO_LARGE => {
            Err(Refusal::TooLarge(limits.body))
        }
        Ok(Err(rejection)) => Err(Refusal::Request(rejection.body_text())),
        Ok(Ok(body)) => Ok(body),
    }
}
