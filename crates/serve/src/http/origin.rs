//! Who may ask: the page of this server, and nobody whom another page has sent.

use crate::asked::refusal::Refusal;
use axum::http::{HeaderMap, Method, Uri, header};
use std::net::IpAddr;

/// Refuses a request for a host that is called by a name (another site may let its name point here), and one that the page of another origin
/// sends.
pub(crate) fn check(method: &Method, uri: &Uri, headers: &HeaderMap) -> Result<(), Refusal> {
    let text = |name: header::HeaderName| headers.get(name).and_then(|value| value.to_str().ok());
    if headers.get_all(header::HOST).iter().count() > 1 {
        return Err(Refusal::Request("it has two lines Host".to_owned()));
    }
    let host = text(header::HOST).unwrap_or_default();
    // a whole address in the first line names a host as well
    if let Some(named) = uri.authority().map(|authority| authority.as_str()).filter(|named| *named != host) {
        return Err(Refusal::OtherHost(shown(named)));
    }
    if !is_number_or_localhost(host) {
        return Err(Refusal::OtherHost(shown(host)));
    }
    if let Some(origin) = headers.get(header::ORIGIN) {
        let origin = origin.to_str().unwrap_or_default();
        if origin.split_once("://").map(|(_, authority)| authority) != Some(host) {
            return Err(Refusal::OtherSite(shown(origin)));
        }
    }
    let site = headers.get("sec-fetch-site").and_then(|site| site.to_str().ok());
    if method == Method::POST && !matches!(site, None | Some("same-origin" | "none")) {
        return Err(Refusal::OtherSite(site.map(shown).unwrap_or_default()));
    }
    let is_json = text(header::CONTENT_TYPE).is_some_and(|media| media.split(';').next() == Some("application/json"));
    if method == Method::POST && !is_json {
        return Err(Refusal::NotJson);
    }
    Ok(())
}

/// Whether a host with or without a port is `localhost` or an address in numbers.
fn is_number_or_localhost(host: &str) -> bool {
    let name = match host.rsplit_once(':') {
        Some((name, port)) if port.bytes().all(|digit| digit.is_ascii_digit()) && !name.ends_with(':') => name,
        _ => host,
    };
    let bare = name.strip_prefix('[').and_then(|name| name.strip_suffix(']')).unwrap_or(name);
    bare.eq_ignore_ascii_case("localhost") || bare.parse::<IpAddr>().is_ok()
}

/// The beginning of what a stranger wrote.
fn shown(text: &str) -> String {
    text.chars().filter(|letter| !letter.is_control()).take(60).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_is_no_host() {
        for host in ["localhost", "LOCALHOST:80", "127.0.0.1:7878", "[::1]:7878", "192.168.0.2", "[::1]"] {
            assert!(is_number_or_localhost(host), "{host}");
        }
        for host in
            ["", "evil.example", "evil.example:7878", "127.0.0.1.evil.example", "localhost.evil.example:1", ":1"]
        {
            assert!(!is_number_or_localhost(host), "{host}");
        }
    }
}
