//! The adhesion of a section of a beam in space over a flat half space.

use super::error::SpatialSectionError;
use super::own_face::OwnFace;
use super::response::SpatialSectionResponse;
use super::{axis_gap, cohesive_face, ellipse, near_face, rectangle};
use crate::adhesion::section::calibrated::Cohesive;
use crate::adhesion::section::law::Law;
use crate::adhesion::section::line_load::{LineLaw, LineLoad};
use crate::number::Real;
use serde::{Deserialize, Serialize};

/// The outline of a section.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum SectionShape {
    /// b × h
    #[default]
    Rectangle,
    /// With the axes b and h; a disc where they are equal.
    Ellipse,
}

/// A section of a beam in space: outline, width b along d2, height h along d3 (of its law), adhesion law.
///
/// Its axis is at the height y over the half space; from side to side it rises by a = b d2·e_y, from bottom to top by
/// c = h d3·e_y, nm. In the plane, a = 0 and c = h cos θ, the energy is that of [`LineLaw`] times the width.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpatialSection {
    shape: SectionShape,
    width: f64,
    law: LineLaw,
    form: Form,
}

/// How the energy is computed.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Form {
    /// Body force over a rectangle
    Rectangle,
    /// Body force over an ellipse
    Ellipse,
    /// Body force of a rectangle's lower face
    NearFace,
    /// A cohesive law on a rectangle's lower face
    Cohesive(Cohesive),
    /// A law of the user's own on a rectangle
    Own(OwnFace),
    /// At the gap below the axis
    AxisGap,
}

impl SpatialSection {
    /// A section of this outline and width, nm, whose height, adhesion law, line load and faces are those of `law`.
    ///
    /// # Errors
    ///
    /// Where the load has no potential: line load "force-only", surface traction, a law of the user's own that says so.
    /// Where an ellipse has another law than the body force with both faces. Where width or height is not a length.
    pub fn new(shape: SectionShape, width: f64, law: LineLaw) -> Result<Self, SpatialSectionError> {
        for (what, value) in [("width", width), ("height", law.height)] {
            if !(value > 0.0 && value.is_finite()) {
                return Err(SpatialSectionError::NoLength { what, value });
            }
        }
        Ok(Self { shape, width, law, form: Form::of(shape, &law)? })
    }

    /// The outline
    pub(crate) fn shape(&self) -> SectionShape {
        self.shape
    }

    /// b, nm
    pub fn width(&self) -> f64 {
        self.width
    }

    /// The law in the plane, with the height h
    pub fn law(&self) -> &LineLaw {
        &self.law
    }

    /// The law of its bonded face, if that is cohesive.
    pub(crate) fn cohesive(&self) -> Option<&Cohesive> {
        match &self.form {
            Form::Cohesive(law) => Some(law),
            _ => None,
        }
    }

    /// Ψ with gradient and Hessian at the height y of the axis and the rises a and c of width and height, nm.
    ///
    /// The lowest point of the section lies above the half space: y > (|a| + |c|)/2, of an ellipse y > √(a² + c²)/2.
    /// Nothing checks that here.
    #[inline(always)]
    pub fn response<T: Real>(&self, y: T, a: T, c: T) -> SpatialSectionResponse<T> {
        self.response_of([T::splat(self.width), T::splat(self.law.height)], y, a, c)
    }

    /// The same for a section of another width and height, nm.
    #[inline(always)]
    pub(crate) fn response_of<T: Real>(&self, [width, height]: [T; 2], y: T, a: T, c: T) -> SpatialSectionResponse<T> {
        let half_space = &self.law.half_space;
        match &self.form {
            Form::Rectangle => rectangle::response(half_space, width * height, y, a, c),
            Form::Ellipse => ellipse::response(half_space, width * height, y, a, c),
            Form::NearFace => near_face::response(half_space, width * height, y, a, c),
            Form::Cohesive(law) => {
                each([width, height, y, a, c], |[width, _, y, a, c]| cohesive_face::response(law, width, y, a, c))
            }
            Form::Own(law) => {
                each([width, height, y, a, c], |[width, height, y, a, c]| law.response([width, height], y, a, c))
            }
            Form::AxisGap => axis_gap::response(&self.law, [width, height], y),
        }
    }

    /// The same of what repels alone, under a cohesive law; nothing under another one.
    #[inline(always)]
    pub(crate) fn pressed_of<T: Real>(&self, width: T, y: T, a: T, c: T) -> SpatialSectionResponse<T> {
        each([width, T::splat(0.0), y, a, c], |[width, _, y, a, c]| match &self.form {
            Form::Cohesive(law) => cohesive_face::pressed(law, width, y, a, c),
            _ => SpatialSectionResponse { energy: 0.0, gradient: [0.0; 3], hessian: [0.0; 6] },
        })
    }

    /// Ψ alone, nN.
    #[inline(always)]
    pub fn energy<T: Real>(&self, y: T, a: T, c: T) -> T {
        let (half_space, area) = (&self.law.half_space, T::splat(self.width * self.law.height));
        match &self.form {
            Form::Rectangle => rectangle::energy(half_space, area, y, a, c),
            Form::Ellipse => ellipse::energy(half_space, area, y, a, c),
            Form::NearFace => near_face::response(half_space, area, y, a, c).energy,
            Form::Cohesive(_) | Form::Own(_) | Form::AxisGap => self.response(y, a, c).energy,
        }
    }
}

impl Form {
    fn of(shape: SectionShape, law: &LineLaw) -> Result<Self, SpatialSectionError> {
        if !law.has_potential() {
            return Err(SpatialSectionError::NoPotential { law: name(law) });
        }
        let form = match (law.line_load, law.law, law.far_face) {
            (LineLoad::AxisGap, ..) => Self::AxisGap,
            (_, Law::BodyForce, true) if shape == SectionShape::Ellipse => return Ok(Self::Ellipse),
            (_, Law::BodyForce, true) => Self::Rectangle,
            (_, Law::BodyForce, false) => Self::NearFace,
            (_, Law::Cohesive(cohesive), _) => Self::Cohesive(cohesive),
            (_, Law::Own(own), _) => Self::Own(OwnFace::new(own, law.height)),
            (_, Law::SurfaceTraction, _) => return Err(SpatialSectionError::NoPotential { law: name(law) }),
        };
        match shape {
            SectionShape::Rectangle => Ok(form),
            SectionShape::Ellipse => Err(SpatialSectionError::RequiresRectangle { law: name(law) }),
        }
    }
}

/// At one section or at several side by side, which are computed one by one.
#[inline(always)]
fn each<T: Real>(at: [T; 5], one: impl Fn([f64; 5]) -> SpatialSectionResponse) -> SpatialSectionResponse<T> {
    let [energy, by_y, by_a, by_c, yy, ya, yc, aa, ac, cc] = T::each_of(at, |at| {
        let SpatialSectionResponse { energy, gradient: [by_y, by_a, by_c], hessian: [yy, ya, yc, aa, ac, cc] } =
            one(at);
        [energy, by_y, by_a, by_c, yy, ya, yc, aa, ac, cc]
    });
    SpatialSectionResponse { energy, gradient: [by_y, by_a, by_c], hessian: [yy, ya, yc, aa, ac, cc] }
}

/// What of a law decides.
fn name(law: &LineLaw) -> String {
    match (law.line_load, &law.law) {
        (LineLoad::ForceOnly, _) => "the line load \"force-only\"".into(),
        (LineLoad::AxisGap, _) => "the line load \"axis-gap\"".into(),
        (_, Law::BodyForce) => "the body force without the upper surface".into(),
        (_, Law::SurfaceTraction) => "the surface traction".into(),
        (_, Law::Cohesive(cohesive)) => format!("the cohesive law \"{}\"", cohesive.shape.name()),
        (_, Law::Own(own)) => format!("the law \"{}\"", own.law().name()),
    }
}
