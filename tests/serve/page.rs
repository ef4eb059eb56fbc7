//! The page stands in the binary, loads nothing from elsewhere, and says so to the browser.

use crate::client::Running;
use peelkit_scene::Scene;
use peelkit_serve::READY;

const FILES: [&str; 12] = [
    "/",
    "/style.css",
    "/main.js",
    "/server.js",
    "/controls.js",
    "/curve.js",
    "/beam.js",
    "/sweep.js",
    "/units.js",
    "/results.js",
    "/link.js",
    "/chart.js",
];

#[test]
fn every_file_is_there_and_forbids_what_comes_from_elsewhere() {
    let server = Running::usual();
    for path in FILES {
        let reply = server.get(path);
        assert_eq!(reply.status, 200, "{path}");
        assert!(
            reply.head.contains("content-security-policy: default-src 'none'; script-src 'self'"),
            "{}",
            reply.head
        );
        assert!(reply.head.contains("x-content-type-options: nosniff"), "{}", reply.head);
        assert!(!reply.head.contains("set-cookie"), "{}", reply.head);
    }
}

/// The chart library names its home in a remark, SVG has a name space; nothing else names another address.
#[test]
fn no_file_of_ours_names_another_address() {
    let server = Running::usual();
    for path in FILES.iter().filter(|path| **path != "/chart.js") {
        let body = server.get(path).body.replace("http://www.w3.org/2000/svg", "");
        assert!(!body.contains("://"), "{path}");
    }
}

#[test]
fn what_is_not_there_is_said_in_a_sentence() {
    let server = Running::usual();
    let reply = server.get("/etc/passwd");
    assert_eq!((reply.status, reply.json()["error"].as_str()), (404, Some("there is nothing at this address")));
}

#[test]
fn the_scenes_that_the_page_offers_are_scenes_that_read_no_file() {
    for (name, _, text) in READY {
        Scene::parse_without_files(name, text, &[]).unwrap();
    }
    let server = Running::usual();
    let list = server.get("/api/scenes").json();
    assert_eq!(list.as_array().unwrap().len(), READY.len());
}
