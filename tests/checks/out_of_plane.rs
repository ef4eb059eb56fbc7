//! Where planar strips leave their plane, by the suite.

use peelkit_checks::suite;

#[test]
fn strips_leave_their_plane_where_the_spatial_equations_say() {
    let topic = suite::TOPICS.iter().find(|topic| topic.name == "out-of-plane").unwrap();
    let checks = topic.run();
    assert!(checks.len() == 9 * 2 * 2 * 2, "{}", checks.len());
    for check in &checks {
        assert!(check.passes(), "{check:?}");
    }
}
