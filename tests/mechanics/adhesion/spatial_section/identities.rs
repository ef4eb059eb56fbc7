//! What the ten numbers are to each other, and to those of other sections.

use super::{NAMES, cohesive, line_law, rectangle_laws, section, ten, told};
use crate::common::PAPER;
use peelkit::adhesion::{
    CohesiveShape, HalfSpace, Law, LineLaw, LineLoad, SectionShape, SpatialSection, SpatialSectionError,
    SpatialSectionResponse,
};
use peelkit::number::F64x4;

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
            // a cohesive law, and one of the user that hands on to it, acts on one face and knows a section that has turned over
            let bonded = matches!(section.law().law, Law::Cohesive(_) | Law::Own(_))
                && section.law().line_load == LineLoad::Full;
            for (p, q) in [(-1.0, 1.0), (1.0, -1.0), (-1.0, -1.0)].into_iter().filter(|(_, q)| *q > 0.0 || !bonded) {
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
