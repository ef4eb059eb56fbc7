//! Shape functions of plane solid elements on the square -1 ≤ ξ, η ≤ 1, whose edge η = -1 of the lowest row is in contact.
//!
//! Each is a product f(ξ) g(η) of two [`Factor`]s. Elements differ in which products they take, and that only in the contact row where
//! they are enriched there (Sauer, Int. J. Numer. Meth. Engng 87, 2011): Q1C1 is bilinear everywhere, Q1Ck adds the integrated Legendre
//! polynomials of order 2 to k times (1 - η)/2, Q1CH has cubic Hermite functions times (1 - η)/2, whose second unknown is u,S.

use std::fmt;

/// The most unknowns along an edge: the order of a polynomial.
pub const MOST_SOLID_ORDER: usize = 8;

/// Which elements a solid is made of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SolidElement {
    /// Q1Ck: bilinear, with a contact edge of this order; Q1C1 is bilinear alone
    Enriched {
        /// k, 1 to 8
        order: usize,
    },
    /// Q1CH: bilinear, with a cubic Hermite contact edge
    HermiteEdge,
    /// H1(q): cubic Hermite along the strip in all rows, times a polynomial of order q through the thickness
    Hermite {
        /// q, 1 to 8
        through: usize,
    },
    /// Q(p,q): all products of polynomials of order p along the strip and q through the thickness
    Full {
        /// p, 1 to 8
        along: usize,
        /// q, 1 to 8
        through: usize,
    },
}

impl SolidElement {
    /// Whether its orders are from 1 to 8.
    pub(crate) fn is_offered(self) -> bool {
        let offered = |order: usize| (1..=MOST_SOLID_ORDER).contains(&order);
        match self {
            Self::HermiteEdge => true,
            Self::Enriched { order } => offered(order),
            Self::Hermite { through } => offered(through),
            Self::Full { along, through } => offered(along) && offered(through),
        }
    }

    /// The one that is called so: "Q1C1" to "Q1C8", "Q1CH", "H1(2)", "Q(4,4)". None where no element is, or where it is not offered.
    pub fn named(name: &str) -> Option<Self> {
        let number = |text: &str| text.trim().parse::<usize>().ok();
        let found = if name == "Q1CH" {
            Self::HermiteEdge
        } else if let Some(order) = name.strip_prefix("Q1C") {
            Self::Enriched { order: number(order)? }
        } else if let Some(rest) = name.strip_prefix("H1(") {
            Self::Hermite { through: number(rest.strip_suffix(')')?)? }
        } else {
            let (along, through) = name.strip_prefix("Q(")?.strip_suffix(')')?.split_once(',')?;
            Self::Full { along: number(along)?, through: number(through)? }
        };
        found.is_offered().then_some(found)
    }

    /// Whether it is bilinear off the contact row, so that incompatible modes do it good there.
    pub(crate) fn is_bilinear_inside(self) -> bool {
        matches!(self, Self::Enriched { .. } | Self::HermiteEdge)
    }

    /// Order of the polynomials along the strip, of the contact row or of the others.
    pub(crate) fn order_along(self, contact: bool) -> usize {
        match self {
            Self::Enriched { order } if contact => order,
            Self::HermiteEdge if contact => 3,
            Self::Enriched { .. } | Self::HermiteEdge => 1,
            Self::Hermite { .. } => 3,
            Self::Full { along, .. } => along,
        }
    }

    /// Order of the polynomials through the thickness.
    pub(crate) fn order_through(self) -> usize {
        match self {
            Self::Enriched { .. } | Self::HermiteEdge => 1,
            Self::Hermite { through } | Self::Full { through, .. } => through,
        }
    }

    /// Functions of a line across the strip, from the contact face up, in so many rows.
    pub(crate) fn line(self, rows: usize) -> Vec<LineFunction> {
        let mut functions = Vec::new();
        for row in 0..=rows {
            let bubbles = (2..=self.order_through()).filter(|_| row < rows);
            let all = std::iter::once(None).chain(bubbles.map(Some));
            for bubble in all {
                let of = |slope| LineFunction { row, bubble, slope };
                functions.push(of(false));
                let slope = match self {
                    Self::Hermite { .. } => true,
                    Self::HermiteEdge => row == 0,
                    Self::Enriched { .. } | Self::Full { .. } => false,
                };
                if slope {
                    functions.push(of(true));
                }
            }
        }
        functions
    }

    /// Functions of a column that vanish on its two lines and are shared by its rows.
    pub(crate) fn column(self, rows: usize) -> usize {
        match self {
            Self::Enriched { order } => order - 1,
            Self::HermiteEdge | Self::Hermite { .. } => 0,
            Self::Full { along, .. } => (rows + 1) * (along - 1),
        }
    }

    /// The shape functions of an element of this row, those inside it first; with incompatible modes where `modes` says so.
    pub(crate) fn shapes(self, row: usize, rows: usize, modes: bool) -> Vec<Shape> {
        let (mut inner, mut outer) = (Vec::new(), Vec::new());
        for (index, function) in self.line(rows).into_iter().enumerate() {
            let through = match function.bubble {
                Some(order) if function.row == row => Factor::Bubble(order),
                None if function.row == row => Factor::First,
                None if function.row == row + 1 => Factor::Second,
                Some(_) | None => continue,
            };
            let cubic = self.is_cubic(function.row);
            let (left, right) = match (cubic, function.slope) {
                (true, true) => (Factor::SlopeFirst, Factor::SlopeSecond),
                (true, false) => (Factor::HermiteFirst, Factor::HermiteSecond),
                (false, _) => (Factor::First, Factor::Second),
            };
            outer.push(Shape { along: left, through, place: ShapePlace::Left(index) });
            outer.push(Shape { along: right, through, place: ShapePlace::Right(index) });
        }
        match self {
            Self::Enriched { order } if row == 0 => {
                outer.extend((2..=order).map(|m| Shape {
                    along: Factor::Bubble(m),
                    through: Factor::First,
                    place: ShapePlace::Column(m - 2),
                }));
            }
            Self::Full { along, through } => {
                for m in 2..=along {
                    let of = |through, row: usize| Shape {
                        along: Factor::Bubble(m),
                        through,
                        place: ShapePlace::Column(row * (along - 1) + m - 2),
                    };
                    outer.extend([of(Factor::First, row), of(Factor::Second, row + 1)]);
                    inner.extend((2..=through).map(|n| (Factor::Bubble(m), Factor::Bubble(n))));
                }
            }
            Self::Enriched { .. } | Self::HermiteEdge | Self::Hermite { .. } => {}
        }
        if modes {
            inner.extend([(Factor::Bubble(2), Factor::One), (Factor::One, Factor::Bubble(2))]);
        }
        let inside = |(index, (along, through))| Shape { along, through, place: ShapePlace::Inner(index) };
        inner.into_iter().enumerate().map(inside).chain(outer).collect()
    }

    /// Whether the functions of a line in this row of vertices are cubic along the strip.
    fn is_cubic(self, row: usize) -> bool {
        match self {
            Self::Hermite { .. } => true,
            Self::HermiteEdge => row == 0,
            Self::Enriched { .. } | Self::Full { .. } => false,
        }
    }
}

impl fmt::Display for SolidElement {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Self::Enriched { order } => write!(f, "Q1C{order}"),
            Self::HermiteEdge => f.write_str("Q1CH"),
            Self::Hermite { through } => write!(f, "H1({through})"),
            Self::Full { along, through } => write!(f, "Q({along},{through})"),
        }
    }
}

/// A function of a line across the strip: of a vertex between two rows, or a polynomial that vanishes at both vertices of its row.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct LineFunction {
    /// Of the vertex below a row, or of the row
    pub row: usize,
    /// Its order, where it is no vertex
    pub bubble: Option<usize>,
    /// Whether its unknown is u,S in place of u
    pub slope: bool,
}

/// Where the unknowns of a shape function stand.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum ShapePlace {
    /// On the left line of the column
    Left(usize),
    /// On its right line
    Right(usize),
    /// In the column, shared by its rows
    Column(usize),
    /// In the element alone
    Inner(usize),
}

/// A shape function.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Shape {
    /// f(ξ)
    pub along: Factor,
    /// g(η)
    pub through: Factor,
    /// Where its unknowns stand
    pub place: ShapePlace,
}

impl Shape {
    /// Whether its unknown is u,S: it is then multiplied with half the length of the element.
    pub(crate) fn is_slope(&self) -> bool {
        matches!(self.along, Factor::SlopeFirst | Factor::SlopeSecond)
    }

    /// Whether it is an incompatible mode.
    pub(crate) fn is_mode(&self) -> bool {
        self.along == Factor::One || self.through == Factor::One
    }

    /// Its factor for an element of this length.
    pub(crate) fn scale(&self, length: f64) -> f64 {
        if self.is_slope() { 0.5 * length } else { 1.0 }
    }
}

/// A function of one coordinate on [-1, 1].
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Factor {
    /// 1, of an incompatible mode
    One,
    /// (1 - t)/2
    First,
    /// (1 + t)/2
    Second,
    /// (2 - 3t + t³)/4
    HermiteFirst,
    /// (2 + 3t - t³)/4
    HermiteSecond,
    /// (1 - t - t² + t³)/4, of the slope at -1
    SlopeFirst,
    /// (-1 - t + t² + t³)/4, of the slope at 1
    SlopeSecond,
    /// ∫ of the Legendre polynomial of one order less, from -1 on, over the root of its norm
    Bubble(usize),
}

impl Factor {
    /// Its value and its slope.
    pub(crate) fn at(self, t: f64) -> [f64; 2] {
        match self {
            Self::One => [1.0, 0.0],
            Self::First => [0.5 * (1.0 - t), -0.5],
            Self::Second => [0.5 * (1.0 + t), 0.5],
            Self::HermiteFirst => [0.25 * (1.0 - t) * (1.0 - t) * (2.0 + t), 0.75 * (t * t - 1.0)],
            Self::HermiteSecond => [0.25 * (1.0 + t) * (1.0 + t) * (2.0 - t), 0.75 * (1.0 - t * t)],
            Self::SlopeFirst => [0.25 * (1.0 - t) * (1.0 - t) * (1.0 + t), 0.25 * (t - 1.0) * (3.0 * t + 1.0)],
            Self::SlopeSecond => [0.25 * (1.0 + t) * (1.0 + t) * (t - 1.0), 0.25 * (t + 1.0) * (3.0 * t - 1.0)],
            Self::Bubble(order) => {
                let legendre = legendre(order, t);
                let norm = bubble_norm(order);
                let value = (legendre[order] - legendre[order - 2]) / (2 * order - 1) as f64;
                [value / norm, legendre[order - 1] / norm]
            }
        }
    }
}

/// The root of ∫ P² of the slope of a bubble of this order, without its norm.
fn bubble_norm(order: usize) -> f64 {
    (2.0 / (2 * order - 1) as f64).sqrt()
}

/// Legendre polynomials of order 0 to `most` at t.
fn legendre(most: usize, t: f64) -> [f64; MOST_SOLID_ORDER + 1] {
    let mut found = [0.0; MOST_SOLID_ORDER + 1];
    found[0] = 1.0;
    if most > 0 {
        found[1] = t;
    }
    for n in 2..=most {
        let k = n as f64;
        found[n] = ((2.0 * k - 1.0) * t * found[n - 1] - (k - 1.0) * found[n - 2]) / k;
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_abs_diff_eq;

    const FACTORS: [Factor; 11] = [
        Factor::One,
        Factor::First,
        Factor::Second,
        Factor::HermiteFirst,
        Factor::HermiteSecond,
        Factor::SlopeFirst,
        Factor::SlopeSecond,
        Factor::Bubble(2),
        Factor::Bubble(3),
        Factor::Bubble(5),
        Factor::Bubble(8),
    ];

    #[test]
    fn slopes_are_those_of_the_values() {
        for factor in FACTORS {
            for t in [-0.9, -0.3, 0.1, 0.7] {
                let difference = (factor.at(t + 1e-6)[0] - factor.at(t - 1e-6)[0]) / 2e-6;
                assert_abs_diff_eq!(factor.at(t)[1], difference, epsilon = 1e-8);
            }
        }
    }

    /// Hermite functions carry value and slope at the two ends, one each; bubbles vanish there.
    #[test]
    fn functions_are_of_their_ends() {
        let cubic = [Factor::HermiteFirst, Factor::SlopeFirst, Factor::HermiteSecond, Factor::SlopeSecond];
        for (k, factor) in cubic.into_iter().enumerate() {
            let ends = [factor.at(-1.0), factor.at(1.0)].concat();
            (0..4).for_each(|m| assert_abs_diff_eq!(ends[m], f64::from(u8::from(m == k)), epsilon = 1e-15));
        }
        for order in 2..=MOST_SOLID_ORDER {
            for end in [-1.0, 1.0] {
                assert_abs_diff_eq!(Factor::Bubble(order).at(end)[0], 0.0, epsilon = 1e-15);
            }
        }
    }

    #[test]
    fn names_are_read_as_they_are_written() {
        let all = [
            SolidElement::Enriched { order: 1 },
            SolidElement::Enriched { order: 4 },
            SolidElement::HermiteEdge,
            SolidElement::Hermite { through: 2 },
            SolidElement::Full { along: 4, through: 5 },
        ];
        for element in all {
            assert_eq!(SolidElement::named(&element.to_string()), Some(element));
        }
        for name in ["Q1C0", "Q1C9", "Q1", "H1(0)", "Q(4)", "Q(4,9)", "brick"] {
            assert_eq!(SolidElement::named(name), None, "{name}");
        }
    }

    /// Shapes of vertices and Hermite values sum to one: a translation is in every element.
    #[test]
    fn a_translation_is_in_every_element() {
        for name in ["Q1C1", "Q1C4", "Q1CH", "H1(3)", "Q(3,2)"] {
            let element = SolidElement::named(name).unwrap();
            for row in 0..3 {
                let shapes = element.shapes(row, 3, element.is_bilinear_inside() && row > 0);
                let line = element.line(3);
                let is_value = |index: usize| line[index].bubble.is_none() && !line[index].slope;
                let value = |shape: &&Shape| match shape.place {
                    ShapePlace::Left(index) | ShapePlace::Right(index) => is_value(index),
                    ShapePlace::Column(_) | ShapePlace::Inner(_) => false,
                };
                let sum: f64 = shapes.iter().filter(value).map(|s| s.along.at(0.3)[0] * s.through.at(-0.4)[0]).sum();
                assert_abs_diff_eq!(sum, 1.0, epsilon = 1e-15);
            }
        }
    }
}
