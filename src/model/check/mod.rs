//! Whether a model can be computed. Whatever builds one, a scene or a program, is held to this and to nothing else.
//!
//! First every number by itself ([`MODEL_NUMBERS`]), then whether they fit one another. Tables, pieces and heights are checked when
//! they are built ([`super::TableError`], [`super::PiecesError`], [`crate::adhesion::HeightsError`]), a rod when it is
//! ([`super::RodError`]).

mod consistency;
pub(super) mod drive;
pub(crate) mod error;
pub(crate) mod numbers;
use super::peel::PeelModel;
use super::problem::build::Discretisation;
use error::{Measured, ModelError, Range};
use numbers::MODEL_NUMBERS;

impl PeelModel {
    /// Whether it can be computed: every number finite and in its range, and all of them fit for one another. The analyses of
    /// [`crate::study`] ask this first.
    ///
    /// # Errors
    /// What is wrong first, by the key of a scene, with what was found and what would be right.
    ///
    /// ```
    /// use peelkit::model::{PeelModel, StripModel};
    ///
    /// let mut model = PeelModel::from(StripModel::of_the_paper(100.0, 1.0));
    /// assert!(model.check().is_ok());
    /// model.adhesion.equilibrium_distance = -0.4;
    /// let error = model.check().unwrap_err();
    /// assert_eq!(error.key(), "adhesion.equilibrium_distance");
    /// assert_eq!(error.to_string(), "`adhesion.equilibrium_distance` is -0.4 nm, which is out of range");
    /// assert_eq!(error.remedy(), "Give a number above zero, in nm.");
    /// ```
    pub fn check(&self) -> Result<(), ModelError> {
        MODEL_NUMBERS.iter().try_for_each(|number| number.check(self))?;
        drive::check_steps(&self.steps)?;
        consistency::check(self)
    }

    /// Itself, if it can be computed.
    ///
    /// # Errors
    /// As [`PeelModel::check`].
    pub fn checked(self) -> Result<Self, ModelError> {
        self.check().map(|()| self)
    }
}

impl Discretisation {
    /// Highest order of the elements.
    pub const MOST_ORDER: usize = 8;

    /// Whether there are elements of its order.
    ///
    /// # Errors
    /// By the key `accuracy.order`.
    pub fn check(&self) -> Result<(), ModelError> {
        let found = Measured { value: self.order as f64, unit: "" };
        let range = Range::From(1.0, Self::MOST_ORDER as f64);
        range.check(found).map_err(|kind| ModelError::new("accuracy.order", kind))
    }
}
