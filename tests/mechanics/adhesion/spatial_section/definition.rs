//! The ten numbers against their definition, another program, and the law in the plane.

use super::{NAMES, cohesive, line_law, rectangle_laws, section, table, ten, told};
use crate::common::PAPER;
use peelkit::adhesion::{CohesiveShape, Law, LineLoad, SectionShape};
use std::collections::BTreeMap;

#[test]
fn all_ten_are_those_of_the_definition() {
    let rows = table();
    let mut worst: BTreeMap<String, (f64, f64)> = BTreeMap::new();
    for (form, row) in &rows {
        let (shape, law, far_face) = match form.as_str() {
            "rectangle" => (SectionShape::Rectangle, Law::BodyForce, true),
            "near-face" => (SectionShape::Rectangle, Law::BodyForce, false),
            "ellipse" => (SectionShape::Ellipse, Law::BodyForce, true),
            "exponential" => (SectionShape::Rectangle, cohesive(CohesiveShape::Exponential), true),
            other => panic!("{other}"),
        };
        let section = section(shape, row["b"], line_law(row["h"], law, far_face));
        let (y, a, c) = (row["y"], row["a"], row["c"]);
        let computed = ten(section.response(y, a, c));
        let rise = if form == "ellipse" { a.hypot(c) } else { a.abs() + c.abs() };
        // the input's own round-off: the lowest point is a difference
        let condition = (y / (y - 0.5 * rise)).max(1.0);
        for (name, computed) in NAMES.into_iter().zip(computed) {
            let (expected, size) = (row[format!("psi{name}").as_str()], row[format!("size{name}").as_str()]);
            let off = (computed - expected).abs();
            assert!(
                off <= 1e-13 * size,
                "Ψ{name} of {form} {row:?}: {computed:e}, expected {expected:e}, {:e} of its size",
                off / size
            );
            let (most, over) = worst.entry(form.clone()).or_default();
            let share = if size > 0.0 { off / size } else { 0.0 };
            (*most, *over) = (most.max(share), over.max(share / condition));
        }
        let alone = section.energy(y, a, c);
        assert!((alone - row["psi"]).abs() <= 1e-13 * row["size"], "Ψ alone of {form} {row:?}: {alone:e}");
    }
    assert_eq!(rows.len(), 440);
    println!("worst errors over size, and over size and condition: {worst:?}");
}

/// Of another program, in which four terms of 400 digits are subtracted: moderate, steep, and level along the beam.
#[test]
fn values_of_another_program() {
    #[rustfmt::skip]
    let states: [([f64; 5], &[f64]); 3] = [
        ([8.0, 4.0, 9.0, 40.0, 10.0], &[
            -0.0135156539862028, 0.0119976265136771, -0.00345403696482849, -0.00462422257964902,
            -0.00254279702108364, -0.00255715197943661, -0.0032422104857981,
        ]),
        ([30.0, 39.0, 2.0, 40.0, 10.0], &[
            -0.000237917046881944, 4.741850506592e-05, -1.80578018752807e-05, -2.2748691399389e-06,
        ]),
        ([100.3, 200.0, 0.0, 200.0, 10.0], &[-0.267130812866672, 1.22887844553744, -0.613103575306091, 0.0]),
    ];
    for ([y, a, c, b, h], expected) in states {
        let at = section(SectionShape::Rectangle, b, line_law(h, Law::BodyForce, true)).response(y, a, c);
        let computed = [at.energy].into_iter().chain(at.gradient).chain(at.hessian[3..].iter().copied());
        for (computed, expected) in computed.zip(expected) {
            let off = (computed - expected).abs();
            assert!(off <= 2e-13 * expected.abs(), "at {y}, {a}, {c}: {computed:e}, expected {expected:e}");
        }
    }
}

/// In the plane a = 0, c = h cos θ: Ψ_θ = -h sin θ Ψ_c, Ψ_θθ = h² sin² θ Ψ_cc - c Ψ_c.
#[test]
fn level_across_it_is_the_law_in_the_plane() {
    let mut worst = 0.0f64;
    for height in [1.0, 8.0] {
        let laws = rectangle_laws(height);
        let own = laws.iter().filter(|law| law.line_load == LineLoad::Full).map(|law| told(*law)).collect::<Vec<_>>();
        for law in laws.into_iter().chain(own) {
            let section = section(SectionShape::Rectangle, 3.0, law);
            for degrees in [0.0f64, 1e-7, 0.01, 3.0, 30.0, 70.0, 88.0, 110.0, 175.0, -20.0] {
                let (sin, cos) = degrees.to_radians().sin_cos();
                let arm = height * sin;
                for gap in [0.2, 0.2578125, 0.4, 1.5, 20.0] {
                    let fall = if law.line_load == LineLoad::AxisGap { 0.0 } else { 0.5 * height * (1.0 - cos.abs()) };
                    let lowest = gap + fall;
                    let plane = law.response(gap, sin, cos);
                    let [energy, y, a, c, yy, ya, yc, aa, ac, cc] =
                        ten(section.response(gap + 0.5 * height, 0.0, height * cos)).map(|value| value / 3.0);
                    // repulsion and attraction without their signs, and what a derivative multiplies them by
                    let of = |r: f64| {
                        let q = 0.4 / r;
                        PAPER.potential_scale() * (q.powi(8) / 45.0 + q.powi(2) / 3.0)
                    };
                    let steep = if law.has_pole() { cos.abs().recip() } else { 1.0 };
                    let size = (of(lowest) * steep * height.min(lowest / cos.abs()).min(lowest) / lowest)
                        .max(0.1 * PAPER.work_of_adhesion());
                    let (g, r) =
                        (10.0 / lowest.min(0.3), (1.0 + 10.0 * height * sin.abs() / lowest.min(0.3)) * steep * steep);
                    let pairs = [
                        ("Ψ", energy, plane.energy, 1.0),
                        ("Ψ_y", y, plane.by_gap, g),
                        ("Ψ_θ", -arm * c, plane.by_rotation, r),
                        ("Ψ_yy", yy, plane.gap_gap, g * g),
                        ("Ψ_yθ", -arm * yc, plane.gap_rotation, g * r),
                        ("Ψ_θθ", arm * arm * cc - height * cos * c, plane.rotation_rotation, r * r + height * g),
                        ("Ψ_a", a, 0.0, g),
                        ("Ψ_ya", ya, 0.0, g * g),
                        ("Ψ_ac", ac, 0.0, g * g),
                    ];
                    for (name, computed, expected, factor) in pairs {
                        let off = (computed - expected).abs() / (size * factor);
                        worst = worst.max(off);
                        assert!(
                            off <= 1e-13,
                            "{name} of {law:?} at {gap} nm, {degrees} degrees: {computed:e}, {expected:e}, {off:e}"
                        );
                    }
                    if law.line_load != LineLoad::AxisGap {
                        // a linear rise adds nothing to a mean but at second order: Ψ_aa = Ψ_yy/12
                        let off = (12.0 * aa - yy).abs() / (size * g * g);
                        assert!(
                            off <= 1e-12,
                            "Ψ_aa of {law:?} at {gap} nm, {degrees} degrees: {aa:e}, {yy:e}/12, {off:e}"
                        );
                    }
                }
            }
        }
    }
    println!("worst error over size: {worst:e}");
}
