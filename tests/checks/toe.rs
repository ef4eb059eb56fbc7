//! Arrays of setae, by the suite.
//!
//! Reference: `verification/toe.csv`. Expected: each of its rows is computed at least once, within the error stated for it; what a band gives by
//! closed form and event by event is checked twice.

use peelkit_checks::suite;
use peelkit_checks::suite::reference;

#[test]
fn every_row_of_the_table_of_arrays() {
    let topic = suite::TOPICS.iter().find(|topic| topic.name == "toe").unwrap();
    let checks = topic.run();
    let rows = reference::read(include_str!("../../verification/toe.csv")).len();
    let twice = checks.iter().filter(|check| check.name.ends_with(", by events")).count();
    assert_eq!((checks.len(), rows, twice), (90, 81, 6));
    for check in &checks {
        assert!(check.passes() && check.tolerance <= 2e-3, "{check:?}");
    }
}
