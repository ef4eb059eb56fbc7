//! The law of a seta, laid out for a person.

use super::number::in_columns;
use peelkit_report::SetaLawFound;

/// Its exit, its stiffness and its errors.
pub fn seta_law(title: &str, found: &SetaLawFound) -> String {
    let (law, [soft, stiff]) = (&found.law, found.stiffness());
    let [along, off] = law.exit.direction;
    let percent = |share: f64| format!("{:.2} %", 100.0 * share);
    let mut lines = vec![
        ("law of a seta", format!("a potential of degree {}, up to the first loss of a tip", law.degree)),
        ("exit", format!("{:.4} nm along {:.3} deg to the ground", law.exit.distance, off.atan2(along).to_degrees())),
        ("stiffness", format!("{soft:.5} and {stiff:.5} N/m, across and along the stiff direction")),
        ("largest force", format!("{:.4} nN", law.largest_force)),
    ];
    for (degree, errors) in (2..).zip(&found.by_degree) {
        let said = errors.as_ref().map_or_else(
            || "not determined by these paths".to_owned(),
            |errors| {
                format!(
                    "force within {}, {} on a path left out; exit within {}, {}",
                    percent(errors.force),
                    percent(errors.force_left_out),
                    percent(errors.exit),
                    percent(errors.exit_left_out)
                )
            },
        );
        lines.push((["degree 2", "degree 3", "degree 4"][degree - 2], said));
    }
    let equilibria: usize = found.paths.iter().map(|(_, path)| path.points.len()).sum();
    lines.push((
        "computed from",
        format!("{} pulls, {equilibria} equilibria, {:.2} s", found.paths.len(), found.seconds),
    ));
    in_columns(title, &lines)
}
