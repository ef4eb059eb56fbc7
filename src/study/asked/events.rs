//! What is looked for on the way: stations, where a quantity has a value, and events of the user, where it passes one.

use crate::solve::points::passing::Passing;
use crate::study::states::fields::BeamState;
use crate::study::states::seta_state::SetaState;
use serde::{Deserialize, Serialize};
use std::fmt;
use std::sync::Arc;

/// A quantity that has a value at a station, or passes one in an event.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum StationQuantity {
    /// u of the grip, nm; of a seta how far the root has moved in its step
    Displacement,
    /// P, nN; of a seta that on the root along the direction of its step
    Force,
    /// S of the peeling front, nm
    Front,
    /// θ of the end that is pulled, rad
    EndRotation,
    /// Distance of the nearer edge of the section at the free end, S = 0, from the ground, nm
    FreeEndGap,
    /// t since a pull at a rate began, ns
    Time,
    /// Tips of a seta that adhere
    Attached,
}

impl StationQuantity {
    /// Every one with its name in a scene.
    pub const NAMED: [(&'static str, Self); 7] = [
        ("displacement", Self::Displacement),
        ("force", Self::Force),
        ("front", Self::Front),
        ("end_rotation", Self::EndRotation),
        ("free_end_gap", Self::FreeEndGap),
        ("time", Self::Time),
        ("attached", Self::Attached),
    ];

    /// Those of the equilibria of a beam.
    pub const OF_BEAM: &'static [Self] =
        &[Self::Displacement, Self::Force, Self::Front, Self::EndRotation, Self::FreeEndGap];
    /// Those of a strip as a plane solid.
    pub const OF_SOLID: &'static [Self] = Self::OF_BEAM;
    /// Those of a beam that is pulled at a rate.
    pub const OF_BEAM_IN_TIME: &'static [Self] =
        &[Self::Time, Self::Displacement, Self::Force, Self::Front, Self::FreeEndGap];
    /// Those of a seta.
    pub const OF_SETA: &'static [Self] = &[Self::Displacement, Self::Force, Self::Attached];
    /// Those of a seta that is pulled at a rate.
    pub const OF_SETA_IN_TIME: &'static [Self] = &[Self::Time, Self::Displacement, Self::Force, Self::Attached];

    /// Its name in a scene.
    pub fn name(self) -> &'static str {
        Self::NAMED.iter().find(|named| named.1 == self).map_or("", |named| named.0)
    }

    /// Whether a state has it between two whole numbers: what goes by whole numbers has no stations.
    pub fn is_continuous(self) -> bool {
        self != Self::Attached
    }
}

/// A value of a quantity at which a path is asked for.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct StationAt {
    /// The quantity
    pub quantity: StationQuantity,
    /// Its value, in the unit of the quantity
    pub value: f64,
}

/// A number of an equilibrium, by its fields.
pub(crate) type OfFields<F> = Arc<dyn Fn(&F) -> f64 + Send + Sync>;

/// What passes a value in an event.
#[derive(Clone)]
pub enum EventQuantity {
    /// A quantity with a name
    Named(StationQuantity),
    /// A number of the fields of a beam
    OfBeam(OfFields<BeamState>),
    /// A number of a seta
    OfSeta(OfFields<SetaState>),
}

impl EventQuantity {
    /// The quantity with a name, where it is one.
    pub fn named(&self) -> Option<StationQuantity> {
        if let Self::Named(quantity) = self { Some(*quantity) } else { None }
    }

    /// Its value in an equilibrium of a seta; 0 of what a seta does not have.
    pub(in crate::study) fn of_seta(&self, state: &SetaState) -> f64 {
        match self {
            Self::Named(StationQuantity::Displacement) => state.point.displacement,
            Self::Named(StationQuantity::Force) => state.point.force_along,
            Self::Named(StationQuantity::Attached) => state.point.attached as f64,
            Self::OfSeta(of) => of(state),
            Self::Named(_) | Self::OfBeam(_) => 0.0,
        }
    }

    /// Its name in a scene; `own` where it is a function of the caller.
    pub fn name(&self) -> &'static str {
        self.named().map_or("own", StationQuantity::name)
    }
}

impl fmt::Debug for EventQuantity {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl PartialEq for EventQuantity {
    /// Two functions are the same where they are one.
    fn eq(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Named(a), Self::Named(b)) => a == b,
            (Self::OfBeam(a), Self::OfBeam(b)) => Arc::ptr_eq(a, b),
            (Self::OfSeta(a), Self::OfSeta(b)) => Arc::ptr_eq(a, b),
            _ => false,
        }
    }
}

/// What comes of an event.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum EventAction {
    /// It is recorded.
    #[default]
    Record,
    /// It is recorded, and nothing is followed beyond it.
    Stop,
}

impl EventAction {
    /// Every one with its name in a scene.
    pub const NAMED: [(&'static str, Self); 2] = [("record", Self::Record), ("stop", Self::Stop)];

    /// Its name in a scene.
    pub fn name(self) -> &'static str {
        Self::NAMED.iter().find(|named| named.1 == self).map_or("", |named| named.0)
    }
}

/// An event of the user: where a quantity passes a value.
///
/// A station is one without a name, which counts both ways and is recorded.
#[derive(Clone, Debug, PartialEq)]
pub struct EventAt {
    /// What the user calls it
    pub name: String,
    /// What passes a value
    pub quantity: EventQuantity,
    /// The value, in the unit of the quantity
    pub value: f64,
    /// Which way
    pub passing: Passing,
    /// What comes of it
    pub action: EventAction,
}

impl From<StationAt> for EventAt {
    fn from(StationAt { quantity, value }: StationAt) -> Self {
        let quantity = EventQuantity::Named(quantity);
        Self { name: String::new(), quantity, value, passing: Passing::Either, action: EventAction::Record }
    }
}

impl EventAt {
    /// Where a number of the fields of a beam is zero: recorded, both ways.
    pub fn of_beam(name: &str, number: impl Fn(&BeamState) -> f64 + Send + Sync + 'static) -> Self {
        Self::of(name, EventQuantity::OfBeam(Arc::new(number)))
    }

    /// Where a number of a seta is zero: recorded, both ways.
    pub fn of_seta(name: &str, number: impl Fn(&SetaState) -> f64 + Send + Sync + 'static) -> Self {
        Self::of(name, EventQuantity::OfSeta(Arc::new(number)))
    }

    fn of(name: &str, quantity: EventQuantity) -> Self {
        Self { name: name.to_owned(), quantity, value: 0.0, passing: Passing::Either, action: EventAction::Record }
    }

    /// Whether the quantity passes the value, in a way that counts, where it goes from one number to another. Whole numbers pass it upwards where they
    /// come to be above it, and downwards where they come to be below.
    pub(in crate::study) fn passes(&self, before: f64, behind: f64) -> bool {
        let rises = self.passing == Passing::Rising && self.quantity == EventQuantity::Named(StationQuantity::Attached);
        let is_above = |number: f64| if rises { number > self.value } else { number >= self.value };
        is_above(before) != is_above(behind) && self.passing.counts(before, behind)
    }

    /// The same, and nothing is followed beyond it.
    pub fn stopping(self) -> Self {
        Self { action: EventAction::Stop, ..self }
    }
}
