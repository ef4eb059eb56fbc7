//! Stations and events of the user beside a path: in a displacement-controlled test, in the pull-off of a seta, and in a pull at a rate.

use crate::chart::marked::Marked;
use crate::records::pulled::{Contact, PulledAtRate};
use crate::writing::error::ReportError;
use crate::writing::number::S_PER_NS;
use crate::writing::record::{Fields, Record, write_table};
use crate::writing::reference::Output;
use peelkit::study::{EventAt, Observed, SetaPullOff, SolidPeel};
use std::path::{Path, PathBuf};

/// A station, or where an event of the user lies.
#[derive(Clone, Debug, PartialEq)]
pub struct PassedAt {
    /// Which one of those that were looked for
    pub event: usize,
    /// Of an event; empty of a station
    pub name: String,
    quantity: &'static str,
    value: f64,
    /// Of a seta, from 1
    pub step: Option<usize>,
    /// ns
    pub time: Option<f64>,
    /// U of the machine, nm
    pub machine: Option<f64>,
    /// nm
    pub displacement: f64,
    /// nN
    pub force: f64,
    /// Bound of the error of the force, nN
    pub force_error: Option<f64>,
    /// The same of the displacement, nm
    pub displacement_error: Option<f64>,
    work: Option<f64>,
    front: Option<f64>,
    free_end_gap: Option<f64>,
    /// Of a seta
    pub attached: Option<usize>,
    /// Whether the quantity jumps past the value
    pub jumped: bool,
    after: Option<usize>,
}

impl PassedAt {
    fn at(looked_for: &[EventAt], event: usize) -> Self {
        let at = &looked_for[event];
        Self {
            event,
            name: at.name.clone(),
            quantity: at.quantity.name(),
            value: at.value,
            step: None,
            time: None,
            machine: None,
            displacement: 0.0,
            force: 0.0,
            force_error: None,
            displacement_error: None,
            work: None,
            front: None,
            free_end_gap: None,
            attached: None,
            jumped: false,
            after: None,
        }
    }

    /// Those of a test in which these were looked for.
    pub fn of_test(test: &Observed, looked_for: &[EventAt]) -> Vec<Self> {
        let of = |station: &peelkit::study::TestStation| {
            let (point, errors) = (&station.point, station.errors);
            Self {
                machine: Some(point.machine),
                displacement: point.displacement,
                force: point.force,
                force_error: errors.map(|errors| errors.force),
                displacement_error: errors.map(|errors| errors.displacement),
                work: Some(point.work),
                front: Some(point.front),
                free_end_gap: Some(station.free_end_gap),
                jumped: point.jumped,
                ..Self::at(looked_for, station.event)
            }
        };
        test.stations.iter().map(of).collect()
    }

    /// Those of a pull-off in which these were looked for.
    pub fn of_pull_off(pull_off: &SetaPullOff, looked_for: &[EventAt]) -> Vec<Self> {
        let of = |station: &peelkit::study::SetaStation| {
            let (point, location) = (&station.point, station.location);
            Self {
                step: Some(point.step + 1),
                displacement: point.displacement,
                force: point.force_along,
                force_error: location.map(|location| location.force),
                displacement_error: location.map(|location| location.displacement),
                work: Some(point.work),
                attached: Some(point.attached),
                jumped: station.jumped,
                after: Some(station.after),
                ..Self::at(looked_for, station.event)
            }
        };
        pull_off.stations.iter().map(of).collect()
    }

    /// Those of the peel of a solid in which these were looked for.
    pub fn of_solid(peel: &SolidPeel, looked_for: &[EventAt]) -> Vec<Self> {
        let of = |station: &peelkit::study::SolidStation| {
            let point = &station.point;
            Self {
                displacement: point.displacement,
                force: point.force,
                force_error: station.force_error,
                work: point.work,
                front: Some(peel.body.adhering_length() - point.front),
                after: Some(station.after),
                ..Self::at(looked_for, station.event)
            }
        };
        peel.stations.iter().map(of).collect()
    }

    /// Those of a pull at a rate in which these were looked for.
    pub fn of_rate(pulled: &PulledAtRate, looked_for: &[EventAt]) -> Vec<Self> {
        let of = |station: &crate::records::pulled::StationAtRate| {
            let point = &station.point;
            let front = if let Contact::Front(front) = point.contact { Some(front) } else { None };
            Self {
                time: Some(point.time),
                displacement: point.displacement,
                force: point.force,
                work: Some(point.balance.work),
                front,
                free_end_gap: station.free_end_gap,
                attached: point.attached(),
                jumped: station.jumped,
                after: Some(station.after),
                ..Self::at(looked_for, station.event)
            }
        };
        pulled.stations.iter().map(of).collect()
    }

    /// Where it stands in the picture of a force over the displacement.
    pub(crate) fn marked(&self) -> Marked {
        Marked { name: self.name.clone(), at: (self.machine.unwrap_or(self.displacement), self.force) }
    }
}

impl Record for PassedAt {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("event", "the name of an event of the user; empty of a station", |at| at.name.clone());
        of.field("quantity", "`displacement`, `force`, `front`, `end_rotation`, `free_end_gap`, `time` or `attached`", |at| at.quantity);
        of.field("value", "its value that was asked for: nm, of a force nN, of a rotation rad, of a time ns, of `attached` tips", |at| at.value);
        of.field("step", "of a seta the number of the step of the loading, from 1", |at| at.step);
        of.field("time_s", "of a pull at a rate: since it began", |at| at.time.map(|time| S_PER_NS * time));
        of.field("machine_displacement_nm", "of a displacement-controlled test: U of the machine", |at| at.machine);
        of.field("displacement_nm", "u of the grip; of a seta how far the root has moved in the step; of a pull at a rate that of what moves the grip", |at| at.displacement);
        of.field("force_nN", "P; of a seta the force on the root along the step", |at| at.force);
        of.field("error_nm", "bound of the error of the displacement; of a seta by how much the equilibrium may be missed, with mesh and law of the tips as they are. Empty behind a jump, of a pull at a rate and of a solid", |at| at.displacement_error);
        of.field("error_nN", "the same of the force; of a solid at this displacement, by a finer mesh", |at| at.force_error);
        of.field("work_aJ", "work from the beginning to there; empty for a load without a potential", |at| at.work);
        of.field("front_nm", "of a beam the length that adheres, by its energy; of a solid by the logarithm of the gap", |at| at.front);
        of.field("free_end_gap_nm", "of a beam the distance of the nearer edge of the section at the free end, S = 0, from the ground", |at| at.free_end_gap);
        of.field("tips_attached", "of a seta the number of tips that adhere", |at| at.attached);
        of.field("jumped", "whether the quantity jumps past the value; the row is then what is behind the jump", |at| at.jumped);
        of.field("after_point", "it lies behind this row of curve.csv, counted from 0", |at| at.after);
    }
}

/// The table.
pub(crate) fn outputs() -> Vec<Output> {
    vec![Output::table("stations.csv of a seta, a solid or at a rate", PassedAt::keys())]
}

/// Writes stations.csv of a seta, of a solid, or of a pull at a rate: one row a station, or where an event of the user lies, in their order.
///
/// Fails with [`ReportError::Write`] where the file cannot be written or a number is not finite.
pub fn write_passed(dir: &Path, passed: &[PassedAt]) -> Result<PathBuf, ReportError> {
    write_table(dir, "stations.csv", passed.iter().cloned())
}
