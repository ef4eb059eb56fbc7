//! Ground that is not flat, by the suite.

use peelkit_checks::suite;

/// Checks of spatulae: nine a row.
const SPATULAE: usize = 9 * 6;

#[test]
fn strips_lie_and_peel_as_the_strong_form_says() {
    let topic = suite::TOPICS.iter().find(|topic| topic.name == "ground").unwrap();
    let checks = topic.run();
    let strips = checks.iter().filter(|check| check.source.contains("rough.py")).count();
    assert!((strips, checks.len()) == (48, 48 + SPATULAE), "{} {strips}", checks.len());
    for check in &checks {
        assert!(check.passes(), "{check:?}");
    }
}
