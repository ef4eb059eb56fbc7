//! Whoever sends nonsense, too much, too slowly or too often gets a refusal with a reason, and the server goes on.

use crate::client::{Running, STRIP, read};
use peelkit_serve::Limits;
use rand::{Rng, RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use serde_json::json;
use std::io::Write;
use std::time::{Duration, Instant};

/// A scene whose path has many points: a long strip to ten digits.
fn long_run() -> serde_json::Value {
    json!({"name": "s", "scene": STRIP, "set": [["strip.length", "20 um"], ["accuracy.relative", "1e-10"]], "parts": ["curve"]})
}

#[test]
fn garbled_requests_are_refused() {
    let server = Running::usual();
    let whole = server.request("/api/peel", &json!({"name": "s", "scene": STRIP, "parts": ["curve"]}).to_string(), "");
    let mut random = ChaCha8Rng::seed_from_u64(7);
    for _ in 0..100 {
        let mut bytes = whole.clone();
        for _ in 0..random.random_range(1..30) {
            let place = random.random_range(0..bytes.len());
            bytes[place] = random.random();
        }
        bytes.truncate(random.random_range(1..=bytes.len()));
        let mut stream = server.connect();
        let _ = stream.write_all(&bytes);
        let _ = stream.shutdown(std::net::Shutdown::Write);
        let reply = read(&mut stream);
        assert!(matches!(reply.status, 0 | 200 | 400..=422), "{}: {}", reply.status, reply.body);
    }
    let mut noise = vec![0; 100_000];
    random.fill_bytes(&mut noise);
    server.raw(&noise);
    assert!(server.is_alive());
}

#[test]
fn what_is_no_request_of_the_page_is_told_so() {
    let server = Running::usual();
    for body in [
        "",
        "{}",
        "[]",
        "null",
        "{\"name\": 1}",
        "{\"name\": \"s\", \"scene\": \"\", \"parts\": [\"all\"]}",
        &"[".repeat(100_000),
    ] {
        let reply = server.raw(&server.request("/api/peel", body, ""));
        assert_eq!(reply.status, 400);
        assert!(reply.json()["error"].as_str().unwrap().starts_with("the request is none that the page sends: "));
    }
    assert!(server.is_alive());
}

#[test]
fn a_huge_request_is_refused_with_the_limit() {
    let server = Running::usual();
    let body = json!({"name": "s", "scene": "#".repeat(3 << 20)}).to_string();
    let reply = server.raw(&server.request("/api/peel", &body, ""));
    assert!(matches!(reply.status, 0 | 413), "{}", reply.status);
    // its length alone is enough
    let head = format!(
        "POST /api/peel HTTP/1.1\r\nHost: {}\r\nContent-Type: application/json\r\nConnection: close\r\nContent-Length: 99999999999\r\n\r\n",
        server.address
    );
    let reply = server.raw(head.as_bytes());
    assert_eq!(reply.status, 413);
    assert_eq!(reply.json()["error"], "the request is larger than 1048576 bytes");
    assert!(server.is_alive());
}

/// A head of a mebibyte, and one of a thousand lines.
#[test]
fn a_huge_head_is_refused() {
    let server = Running::usual();
    let host = format!("GET / HTTP/1.1\r\nHost: {}\r\n", server.address);
    for lines in [format!("X: {}\r\n", "x".repeat(1 << 20)), "X: x\r\n".repeat(1000)] {
        let mut stream = server.connect();
        // what is beyond the limit is not read
        let sent = format!("{host}{lines}\r\n");
        let _ = stream.write_all(&sent.as_bytes()[..sent.len().min(100_000)]);
        let reply = read(&mut stream);
        assert!(matches!(reply.status, 0 | 431), "{}: {}", reply.status, reply.head);
    }
    // one that has been read whole when it is refused
    let reply = server.raw(format!("{host}{}\r\n", "X: x\r\n".repeat(150)).as_bytes());
    assert_eq!(reply.status, 431);
    assert!(server.is_alive());
}

/// Heads that never end: each makes room for the next, and a page that comes after them is answered.
#[test]
fn a_thousand_connections_that_never_finish_leave_room_for_a_page() {
    let server = Running::new(Limits { connections: 64, ..Limits::default() });
    let mut open = Vec::new();
    for number in 0..1000 {
        let mut stream = server.connect();
        let _ = stream.write_all(if number % 2 == 0 { b"GET / HTTP/1.1\r\nHost: lo" } else { b"" });
        open.push(stream);
        // a test has no more open files than other programs
        if open.len() > 200 {
            open.remove(0);
        }
    }
    assert!(server.is_alive());
    drop(open);
    assert!(server.is_alive());
}

#[test]
fn a_body_that_never_comes_is_given_up() {
    let server = Running::new(Limits { arrival: Duration::from_millis(200), ..Limits::default() });
    let mut request = server.request("/api/peel", &json!({"name": "s", "scene": STRIP}).to_string(), "");
    request.truncate(request.len() - 5);
    let reply = server.raw(&request);
    assert_eq!((reply.status, reply.json()["error"].as_str()), (408, Some("the request did not arrive within 0.2 s")));
}

/// Three run or wait, the others are refused; those that were taken are answered.
#[test]
fn of_a_hundred_runs_at_once_some_are_refused_and_the_others_answered() {
    let server = Running::new(Limits { runs: 1, waiting: 2, ..Limits::default() });
    let body = json!({"name": "s", "scene": STRIP, "parts": ["curve"]}).to_string();
    let request = server.request("/api/peel", &body, "");
    let mut streams: Vec<_> = (0..100).map(|_| server.connect()).collect();
    for stream in &mut streams {
        stream.write_all(&request).unwrap();
    }
    let replies: Vec<_> = streams.iter_mut().map(read).collect();
    let count = |status: u16| replies.iter().filter(|reply| reply.status == status).count();
    assert!(count(200) >= 1 && count(503) >= 1 && count(200) + count(503) == 100);
    let refused = replies.iter().find(|reply| reply.status == 503).unwrap();
    assert_eq!(refused.json()["error"], "2 runs wait already for one to end");
    assert!(refused.head.contains("retry-after: 1"));
    assert!(server.is_alive());
}

#[test]
fn a_run_ends_with_its_time_and_keeps_what_it_has() {
    let server = Running::new(Limits { time: Duration::from_millis(30), ..Limits::default() });
    let reply = server.post("/api/peel", &long_run());
    assert_eq!(reply.status, 200, "{}", reply.body);
    let summary = &reply.json()["summary"];
    assert!(matches!(summary["end"].as_str(), Some("bound" | "failed")), "{summary}");
    assert!(server.is_alive());
}

/// One run at a time, of an hour: the next is answered because the first is stopped when its page goes.
#[test]
fn a_run_whose_page_has_gone_is_stopped() {
    let server = Running::new(Limits { runs: 1, time: Duration::from_secs(3600), ..Limits::default() });
    let slow = json!({"name": "s", "scene": STRIP, "set": [["strip.length", "1 mm"], ["accuracy.relative", "1e-11"], ["bounds.time", "1 h"], ["bounds.points", "1000000000"]]});
    let mut gone = server.connect();
    gone.write_all(&server.request("/api/peel", &slow.to_string(), "")).unwrap();
    std::thread::sleep(Duration::from_millis(300));
    drop(gone);
    let since = Instant::now();
    assert!(server.is_alive(), "after {:?}", since.elapsed());
}
