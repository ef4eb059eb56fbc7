//! The page that a browser plays.
//!
//! Expected: one well-formed file without a link to anything else, small, with frames that follow the path from rest to its end and
//! have the same number of points; stable and unstable ones among them.

use crate::strip::paper_strip;
use peelkit::study::{Accuracy, StopCriteria, peel};
use peelkit_report::write_animation;
use resvg::usvg::roxmltree::{Document, ParsingOptions};
use serde_json::Value;
use std::fs;

#[test]
fn the_page_is_well_formed_and_needs_nothing_else() {
    let dir = tempfile::tempdir().unwrap();
    let found = peel(&paper_strip(100.0, 1.0), &Accuracy::to(1e-4), &StopCriteria::after_points(5000));
    let path = write_animation(dir.path(), &found, "A strip & its <peel>").unwrap();
    assert_eq!(path, dir.path().join("animation.html"));
    let text = fs::read_to_string(path).unwrap();
    assert!(text.len() < 200_000, "{} bytes", text.len());
    for outside in ["http", "src=", "href", "url(", "import"] {
        assert!(!text.contains(outside), "{outside}");
    }
    let document =
        Document::parse_with_options(&text, ParsingOptions { allow_dtd: true, ..Default::default() }).unwrap();
    let by_id = |id: &str| document.descendants().find(|node| node.attribute("id") == Some(id)).unwrap();
    assert!(document.descendants().any(|node| node.has_tag_name("h1") && node.text() == Some("A strip & its <peel>")));
    for id in ["beam", "dot", "time", "play", "says"] {
        assert!(by_id(id).is_element());
    }
    let frames: Vec<Value> = serde_json::from_str(by_id("data").text().unwrap()).unwrap();
    assert!((20..=100).contains(&frames.len()), "{}", frames.len());
    let number = |frame: &Value, name: &str| frame[name].as_f64().unwrap();
    let (first, last) = (&frames[0], &frames[frames.len() - 1]);
    assert_eq!((number(first, "t"), number(first, "u"), number(last, "t")), (0.0, 0.0, 1.0));
    assert!(frames.windows(2).all(|pair| number(&pair[0], "t") <= number(&pair[1], "t")));
    let points = |frame: &Value| frame["o"].as_array().unwrap().len();
    assert!(frames.iter().all(|frame| points(frame) == points(first)) && points(first) > 100);
    assert_eq!(by_id("beam").attribute("points").unwrap().split(' ').count(), points(first));
    let stable = |wanted: bool| frames.iter().filter(|frame| frame["s"] == wanted).count();
    assert!(stable(true) > 10 && stable(false) > 3);
    // the snap-off is one of the frames
    let turn = found.snap_off.unwrap().displacement;
    assert!(frames.iter().any(|frame| (number(frame, "u") / turn - 1.0).abs() < 1e-5));
}

#[test]
fn a_path_without_points_has_no_page() {
    let dir = tempfile::tempdir().unwrap();
    let mut found = peel(&paper_strip(100.0, 1.0), &Accuracy::to(1e-3), &StopCriteria::after_points(5));
    found.points.clear();
    let error = write_animation(dir.path(), &found, "none").unwrap_err().to_string();
    assert!(error.contains("animation.html") && error.contains("0 points"), "{error}");
    assert!(fs::read_dir(dir.path()).unwrap().next().is_none());
}
