//! Other pages that the browser has open may not use the server: neither by a request across origins, nor by a name that they let point
//! here (DNS rebinding).

use crate::client::{Running, STRIP};
use serde_json::json;

fn body() -> String {
    json!({"name": "s", "scene": STRIP}).to_string()
}

#[test]
fn a_page_of_another_origin_is_refused_with_a_reason() {
    let server = Running::usual();
    for header in [
        "Origin: http://evil.example\r\n",
        "Origin: null\r\n",
        "Sec-Fetch-Site: cross-site\r\n",
        "Sec-Fetch-Site: same-site\r\n",
    ] {
        let reply = server.raw(&server.request("/api/peel", &body(), header));
        assert_eq!(reply.status, 403, "{header}");
        assert!(reply.json()["error"].as_str().unwrap().starts_with("the request was sent by a page of another site"));
        assert!(!reply.head.contains("access-control-allow-origin"), "{}", reply.head);
    }
    let own = format!("Origin: http://{}\r\nSec-Fetch-Site: same-origin\r\n", server.address);
    assert_eq!(server.raw(&server.request("/api/peel", &body(), &own)).status, 200);
}

#[test]
fn a_host_with_a_name_is_refused() {
    let server = Running::usual();
    for (host, status) in [("evil.example", 403), ("localhost:1", 200), ("[::1]", 200), ("", 403)] {
        let reply = server.raw(format!("GET / HTTP/1.1\r\nHost: {host}\r\nConnection: close\r\n\r\n").as_bytes());
        assert_eq!(reply.status, status, "{host}");
    }
    assert_eq!(server.raw(b"GET / HTTP/1.0\r\n\r\n").status, 403);
}

/// What names two hosts is not believed to be for this one.
#[test]
fn a_request_of_two_hosts_is_refused() {
    let server = Running::usual();
    let own = &server.address;
    for (head, status) in [
        (format!("GET / HTTP/1.1\r\nHost: {own}\r\nHost: evil.example"), 400),
        (format!("GET http://evil.example/ HTTP/1.1\r\nHost: {own}"), 403),
        (format!("GET http://{own}/ HTTP/1.1\r\nHost: {own}"), 200),
    ] {
        let reply = server.raw(format!("{head}\r\nConnection: close\r\n\r\n").as_bytes());
        assert_eq!(reply.status, status, "{head}");
    }
}

/// A form of another page can send text, and no JSON without asking first.
#[test]
fn a_form_is_refused() {
    let server = Running::usual();
    let request = String::from_utf8(server.request("/api/peel", &body(), "")).unwrap();
    let form = request.replace("application/json", "text/plain");
    assert_eq!(server.raw(form.as_bytes()).status, 415);
}
