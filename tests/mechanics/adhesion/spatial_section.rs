//! The energy of a section of a beam in space, tilted along the beam and across it.
//!
//! Reference: verification/spatial_sections.csv, the energies as they are defined at 400 digits (mpmath); the laws in
//! the plane.
//!
//!            ______              y: height of the axis
//!       ____/     /  c           a = b d2·e_y: rise from side to side
//!      /   y     /               c = h d3·e_y: rise from bottom to top
//!     /     ____/
//!    /_____/   a
//!   -----------------
//!
//! Parameters: A_H = 1e-19 J, r0 = 0.4 nm; lowest corners from 0.2 to 100 nm, widths from 1 to 200 nm, tilts of 0,
//! 1e-12, .., 90 degrees both ways.
//!
//! Expected: value, gradient and Hessian to 1e-13 of their repulsive and attractive parts; level across, the law in the
//! plane; even in both tilts; each derivative that of the number it belongs to; no moment about its axis on a disc.
//!
//! Why: the forces and moments on a beam in space, and the tangent of Newton's method, are these ten numbers.

use crate::common::PAPER;
use peelkit::adhesion::{
    Cohesive, CohesiveShape, HalfSpace, Law, LineLaw, LineLoad, LineResponse, OwnLaw, SectionLaw, SectionShape,
    SpatialSection, SpatialSectionError, SpatialSectionResponse, TiltedSection,
};
use peelkit::number::F64x4;
use std::collections::BTreeMap;

const NAMES: [&str; 10] = ["", "_y", "_a", "_c", "_yy", "_ya", "_yc", "_aa", "_ac", "_cc"];

fn line_law(height: f64, law: Law, far_face: bool) -> LineLaw {
    LineLaw { half_space: PAPER, height, law, line_load: LineLoad::Full, far_face }
}

fn cohesive(shape: CohesiveShape) -> Law {
    Law::Cohesive(Cohesive::calibrated(shape, PAPER.strength(), PAPER.work_of_adhesion(), &PAPER))
}

fn section(shape: SectionShape, width: f64, law: LineLaw) -> SpatialSection {
    SpatialSection::new(shape, width, law).unwrap()
}

fn ten(at: SpatialSectionResponse) -> [f64; 10] {
    let mut out = [at.energy; 10];
    out[1..4].copy_from_slice(&at.gradient);
    out[4..].copy_from_slice(&at.hessian);
    out
}

/// A law of one's own: the body force's lower face and upper face, told from outside by the angle, as in the plane.
#[derive(Debug)]
struct Told(LineLaw);

impl SectionLaw for Told {
    fn name(&self) -> &'static str {
        "told"
    }

    fn response(&self, section: &TiltedSection) -> LineResponse<f64> {
        self.0.response_of(section.height, section.gap, section.sin, section.cos)
    }

    fn cutoff_distance(&self) -> f64 {
        self.0.cutoff_distance()
    }

    fn rest_gap(&self, _height: f64) -> f64 {
        self.0.rest_gap()
    }

    fn has_potential(&self) -> bool {
        self.0.has_potential()
    }
}

fn told(law: LineLaw) -> LineLaw {
    LineLaw { law: Law::Own(OwnLaw::kept(Told(law))), ..law }
}

/// Laws with a potential, on a rectangle of this height.
fn rectangle_laws(height: f64) -> Vec<LineLaw> {
    let mut laws = vec![line_law(height, Law::BodyForce, true), line_law(height, Law::BodyForce, false)];
    laws.extend(CohesiveShape::ALL.iter().map(|&shape| line_law(height, cohesive(shape), true)));
    laws.push(LineLaw { line_load: LineLoad::AxisGap, ..line_law(height, Law::BodyForce, true) });
    laws.push(LineLaw { line_load: LineLoad::AxisGap, ..line_law(height, Law::SurfaceTraction, false) });
    laws
}

/// Rows of the table: columns by name, and the form.
fn table() -> Vec<(String, BTreeMap<&'static str, f64>)> {
    let text = include_str!("../../../verification/spatial_sections.csv");
    let mut lines = text.lines().filter(|line| !line.starts_with('#'));
    let names: Vec<&str> = lines.next().unwrap().split(',').skip(1).collect();
    let row = |line: &'static str| {
        let (form, numbers) = line.split_once(',').unwrap();
        let numbers = numbers.split(',').map(|number| number.parse().unwrap());
        (form.to_string(), names.iter().copied().zip(numbers).collect())
    };
    lines.map(row).collect()
}

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

/// Of what shape and law is, at states from level to steep.
fn states() -> impl Iterator<Item = [f64; 3]> {
    let tilts = [0.0, 1e-6, 0.02, 0.3, 0.8];
    let pairs = tilts.into_iter().flat_map(move |roll| tilts.map(|pitch| (roll, pitch)));
    pairs.flat_map(|(roll, pitch)| {
        let (a, c) = (6.0 * f64::sin(roll) * f64::cos(pitch), 2.0 * f64::cos(roll) * f64::cos(pitch));
        [0.22, 0.3, 0.7, 4.0].map(|gap| [gap + 0.5 * (a + c), a, c])
    })
}

/// Those among them that lie above the half space: independent of its tilts a section is there as if it were level.
fn states_of(section: &SpatialSection) -> impl Iterator<Item = [f64; 3]> {
    let lowest = if section.law().line_load == LineLoad::AxisGap { 1.2 } else { 0.0 };
    states().filter(move |state| state[0] > lowest)
}

fn sections() -> Vec<SpatialSection> {
    let mut laws = rectangle_laws(2.0);
    laws.push(told(line_law(2.0, Law::BodyForce, true)));
    laws.push(told(line_law(2.0, cohesive(CohesiveShape::Trapezoidal), true)));
    let mut sections: Vec<_> = laws.into_iter().map(|law| section(SectionShape::Rectangle, 6.0, law)).collect();
    sections.push(section(SectionShape::Ellipse, 6.0, line_law(2.0, Law::BodyForce, true)));
    sections
}

#[test]
fn even_in_both_tilts() {
    for section in sections() {
        for [y, a, c] in states_of(&section) {
            let here = ten(section.response(y, a, c));
            for (p, q) in [(-1.0, 1.0), (1.0, -1.0), (-1.0, -1.0)] {
                let there = ten(section.response(y, p * a, q * c));
                let signs = [1.0, 1.0, p, q, 1.0, p, q, 1.0, p * q, 1.0];
                for k in 0..10 {
                    let off = (signs[k] * there[k] - here[k]).abs();
                    let scale = here[k].abs().max(here[4].abs()).max(1e-6);
                    // by the angle, the second derivative by c has a round-off of 1e-16 over the square of its sine,
                    // here 1e-4
                    let by_angle = k == 9 && matches!(section.law().law, Law::Own(_));
                    let allowed = if by_angle { 1e-7 } else { 1e-13 };
                    assert!(
                        off <= allowed * scale,
                        "Ψ{} of {section:?} at {y}, {a}, {c}: {off:e} of {:e}",
                        NAMES[k],
                        here[k]
                    );
                }
            }
        }
    }
}

/// By central differences of fourth order, of the energy and of the gradient.
#[test]
fn derivatives_are_slopes() {
    for section in sections() {
        for state in states_of(&section) {
            let here = section.response(state[0], state[1], state[2]);
            let hessian = [[0, 1, 2], [1, 3, 4], [2, 4, 5]].map(|row| row.map(|k| here.hessian[k]));
            for i in 0..3 {
                // there is no angle at which a section rises by more than its height
                if i == 2 && matches!(section.law().law, Law::Own(_)) && state[2] > 1.999 {
                    continue;
                }
                let slope = |of: &dyn Fn(SpatialSectionResponse) -> f64| {
                    let d = 1e-4;
                    let at = |steps: f64| {
                        let mut moved = state;
                        moved[i] += steps * d;
                        of(section.response(moved[0], moved[1], moved[2]))
                    };
                    (8.0 * (at(1.0) - at(-1.0)) - (at(2.0) - at(-2.0))) / (12.0 * d)
                };
                let close = |what: String, computed: f64, difference: f64, size: f64| {
                    let off = (computed - difference).abs();
                    assert!(
                        off <= 1e-6 * size,
                        "{what} of {section:?} at {state:?}: {computed:e}, {difference:e}, {:e} of {size:e}",
                        off / size
                    );
                };
                let largest = here.hessian.iter().chain(&here.gradient).fold(1e-6, |most: f64, x| most.max(x.abs()));
                close(format!("gradient {i}"), here.gradient[i], slope(&|at| at.energy), largest);
                for j in 0..3 {
                    close(format!("Hessian {i} {j}"), hessian[i][j], slope(&|at| at.gradient[j]), 10.0 * largest);
                }
            }
        }
    }
}

/// A wide face by a thousand parts, each by the law in the plane at its own height: the rule is not told of the laws'
/// corners.
#[test]
fn wide_faces_are_sums_over_their_parts() {
    let mut laws: Vec<_> = CohesiveShape::ALL.iter().map(|&shape| line_law(10.0, cohesive(shape), true)).collect();
    laws.extend([true, false].map(|far_face| told(line_law(10.0, Law::BodyForce, far_face))));
    laws.extend([true, false].map(|far_face| line_law(10.0, Law::BodyForce, far_face)));
    for law in laws {
        let section = section(SectionShape::Rectangle, 200.0, law);
        for (a, c) in [(0.1, 10.0), (3.0, 9.9), (120.0, 7.5), (-180.0, 4.0)] {
            let y: f64 = 0.23 + 0.5 * (f64::abs(a) + c);
            let (cos, sin) = (0.1 * c, (1.0 - 0.01 * c * c).sqrt());
            // parts that grow from the low side, ten times as many as they need
            let parts = 20_000;
            let place = |k: usize| (k as f64 / parts as f64).powi(3);
            let mut sums = [0.0; 4];
            let mut sizes = [0.0; 4];
            for k in 0..parts {
                let (from, to) = (place(k), place(k + 1));
                let (half, middle) = (0.5 * (to - from), 0.5 * (from + to));
                for side in [-1.0, 1.0] {
                    let s = middle + side * half / 3f64.sqrt() - 0.5;
                    let at = law.response(y + s * a.abs() - 5.0, sin, cos);
                    let terms = [at.energy, at.by_gap, s * at.by_gap * a.signum(), -at.by_rotation / (10.0 * sin)];
                    for i in 0..4 {
                        if i < 3 || sin > 0.0 {
                            sums[i] += 200.0 * half * terms[i];
                            sizes[i] += 200.0 * half * terms[i].abs();
                        }
                    }
                }
            }
            let computed = ten(section.response(y, a, c));
            for i in 0..4 {
                if i == 3 && sin == 0.0 {
                    continue;
                }
                let off = (computed[i] - sums[i]).abs() / sizes[i];
                assert!(off < 1e-9, "Ψ{} of {law:?} at {a}, {c}: {:e}, {:e}, {off:e}", NAMES[i], computed[i], sums[i]);
            }
        }
    }
}

/// The moment about d1 is h Ψ_c d2·e_y - b Ψ_a d3·e_y. A disc feels none, an ellipse and a rectangle do.
#[test]
fn a_disc_does_not_roll() {
    for (roll, pitch) in [(0.3f64, 0.0f64), (1.2, 0.4), (1e-5, 1.0)] {
        let (across, along) = (roll.sin() * pitch.cos(), roll.cos() * pitch.cos());
        let moment = |shape, width: f64, height: f64| {
            let section = section(shape, width, line_law(height, Law::BodyForce, true));
            let (a, c) = (width * across, height * along);
            let at = section.response(0.4 + 0.5 * (a.abs() + c.abs()), a, c);
            let parts = [height * at.gradient[2] * across, width * at.gradient[1] * along];
            (parts[0] - parts[1], parts[0].abs() + parts[1].abs())
        };
        let (disc, size) = moment(SectionShape::Ellipse, 10.0, 10.0);
        assert!(disc.abs() <= 1e-15 * size, "{disc:e} of {size:e}");
        for (shape, width) in [(SectionShape::Ellipse, 14.0), (SectionShape::Rectangle, 10.0)] {
            let (other, size) = moment(shape, width, 10.0);
            assert!(other.abs() > 1e-2 * size, "{shape:?}: {other:e} of {size:e}");
        }
    }
}

/// Level both ways an ellipse is b wide in the middle and none at its bottom: the integral of its chords.
#[test]
fn an_ellipse_is_its_chords() {
    let section = section(SectionShape::Ellipse, 14.0, line_law(6.0, Law::BodyForce, true));
    for gap in [0.3, 1.0, 10.0] {
        let y = gap + 3.0;
        // the trapezoidal rule over the angle at the centre
        let count = 4000;
        let sum: f64 = (0..count)
            .map(|k| (f64::from(k) + 0.5) * std::f64::consts::PI / f64::from(count))
            .map(|angle| PAPER.traction(y - 3.0 * angle.cos()) * angle.sin().powi(2))
            .sum();
        let expected = sum * std::f64::consts::PI / f64::from(count) * 14.0 * 3.0;
        let computed = section.energy(y, 0.0, 6.0);
        assert!((computed - expected).abs() <= 1e-12 * expected.abs(), "{gap} nm: {computed:e}, {expected:e}");
    }
}

#[test]
fn several_side_by_side_are_each_of_them() {
    for section in sections() {
        let all: Vec<_> = states().collect();
        for four in all.chunks_exact(4) {
            let column = |i: usize| F64x4([four[0][i], four[1][i], four[2][i], four[3][i]]);
            let together = section.response(column(0), column(1), column(2));
            for l in 0..4 {
                let one = section.response(four[l][0], four[l][1], four[l][2]);
                assert_eq!(together.energy.0[l], one.energy);
                for k in 0..6 {
                    assert_eq!(together.hessian[k].0[l], one.hessian[k], "{section:?}");
                }
            }
        }
    }
}

#[test]
fn loads_without_a_potential_are_refused() {
    let rectangle = |law| SpatialSection::new(SectionShape::Rectangle, 4.0, law);
    let full = line_law(10.0, Law::BodyForce, true);
    let traction = line_law(10.0, Law::SurfaceTraction, true);
    for (law, name) in [
        (LineLaw { line_load: LineLoad::ForceOnly, ..full }, "the line load \"force-only\""),
        (
            LineLaw { line_load: LineLoad::ForceOnly, ..line_law(10.0, cohesive(CohesiveShape::Dugdale), true) },
            "the line load \"force-only\"",
        ),
        (traction, "the surface traction"),
        (told(traction), "the law \"told\""),
    ] {
        assert_eq!(rectangle(law), Err(SpatialSectionError::NoPotential { law: name.into() }));
    }
    for (law, name) in [
        (line_law(10.0, Law::BodyForce, false), "the body force without the upper surface"),
        (line_law(10.0, cohesive(CohesiveShape::Dugdale), true), "the cohesive law \"dugdale\""),
        (LineLaw { line_load: LineLoad::AxisGap, ..full }, "the line load \"axis-gap\""),
    ] {
        let refused = SpatialSection::new(SectionShape::Ellipse, 4.0, law);
        assert_eq!(refused, Err(SpatialSectionError::RequiresRectangle { law: name.into() }));
    }
    for (width, height, what) in [(0.0, 1.0, "width"), (f64::NAN, 1.0, "width"), (1.0, -2.0, "height")] {
        let refused = SpatialSection::new(SectionShape::Rectangle, width, LineLaw { height, ..full });
        assert!(matches!(refused, Err(SpatialSectionError::NoLength { what: found, .. }) if found == what));
    }
    // the half space alone sets the units
    let other = HalfSpace { hamaker_constant: 0.2, equilibrium_distance: 0.4 };
    let twice = rectangle(LineLaw { half_space: other, ..full }).unwrap().energy(6.0, 1.0, 9.0);
    assert_eq!(twice, 2.0 * rectangle(full).unwrap().energy(6.0, 1.0, 9.0));
}
