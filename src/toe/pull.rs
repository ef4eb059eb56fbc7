//! The pull of any array, with what a table or a picture shows of it.

use super::events::{ArrayEnd, ArrayEvent};
use super::lamella::{ArrayDrive, ArrayError, Lamella, sheets_after};
use super::law::RootLaw;
use super::patch::Patch;
use super::scatter::Scatter;
use super::toe_pad::Toe;
use nalgebra::Vector3;

/// What setae stand on, and how it is pulled.
#[derive(Clone, Debug, PartialEq)]
pub enum SetaArray {
    /// A rigid backing along its steps
    Patch(Patch),
    /// A band
    Lamella(Lamella, ArrayDrive),
    /// A pad on bands
    Toe(Toe, ArrayDrive),
}

/// What holds a row just before an event.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ArrayRow {
    /// How many setae adhere
    pub adhering: usize,
    /// Forces along and off the ground, nN
    pub force: [f64; 2],
}

/// The pull of an array.
#[derive(Clone, Debug, PartialEq)]
pub struct ArrayPull {
    /// In their order
    pub events: Vec<ArrayEvent>,
    /// The event with the largest load, before which rows and setae are shown; none where no seta lets go
    pub peak: Option<usize>,
    /// Largest load, between events as well; nN, or nN nm of a moment
    pub largest_load: f64,
    /// Where it ends
    pub end: ArrayEnd,
    /// Of the load, aJ
    pub work: f64,
    /// In all events, aJ
    pub released: f64,
    /// Largest difference of the work and of stored and released energy, over the work
    pub imbalance: f64,
    /// How many setae there are, and how many detach
    pub setae: usize,
    /// Of all setae
    pub detached: usize,
    /// Each row at the peak
    pub rows: Vec<ArrayRow>,
    /// Force of each seta off the ground at the peak, nN, row by row; none of a detached one
    pub forces: Vec<Option<f64>>,
    /// Setae in a row
    pub columns: usize,
}

impl SetaArray {
    /// Every event, until it is stopped.
    ///
    /// # Errors
    /// What cannot be followed.
    pub fn pull(&self, stopped: &dyn Fn() -> bool) -> Result<ArrayPull, ArrayError> {
        match self {
            Self::Patch(patch) => {
                let found = patch.follow_until(stopped)?;
                let peak = (!found.events.is_empty()).then_some(found.peak);
                let forces: Vec<Option<f64>> = match peak {
                    Some(peak) => {
                        let last = patch.law.sheets();
                        let loads = patch.loads(&found, peak).into_iter();
                        loads.map(|(sheet, load)| (usize::from(sheet) < last).then_some(load)).collect()
                    }
                    None => Vec::new(),
                };
                let row = |own: &[Option<f64>]| ArrayRow {
                    adhering: own.iter().flatten().count(),
                    force: [0.0, own.iter().flatten().sum()],
                };
                let rows = forces.chunks(patch.columns).map(row).collect();
                let mut pull = ArrayPull::of(found.events, peak, found.end, patch.rows * patch.columns);
                (pull.largest_load, pull.work, pull.released) = (found.largest_load, found.work, found.released);
                Ok(ArrayPull { rows, forces, columns: patch.columns, ..pull })
            }
            Self::Lamella(band, drive) => {
                let found = band.follow_until(*drive, [0.0; 3], usize::MAX, stopped)?;
                Ok(of_band(found, [band.rows, band.columns], (&band.law, &band.scatter), |row| band.node_of(row)))
            }
            Self::Toe(toe, drive) => {
                let found = toe.follow_until(*drive, [0.0; 3], usize::MAX, stopped)?;
                let band = &toe.lamella;
                Ok(of_band(found, toe.size(), (&band.law, &band.scatter), |row| toe.node_of(row)))
            }
        }
    }

    /// What of it cannot be followed.
    ///
    /// # Errors
    /// The first number that is none.
    pub fn check(&self) -> Result<(), ArrayError> {
        match self {
            Self::Patch(patch) => patch.check(),
            Self::Lamella(band, _) => band.check(),
            Self::Toe(toe, _) => toe.check(),
        }
    }
}

impl ArrayPull {
    fn of(events: Vec<ArrayEvent>, peak: Option<usize>, end: ArrayEnd, setae: usize) -> Self {
        let adhering = events.last().map_or(setae, |last| last.adhering);
        Self {
            largest_load: peak.and_then(|peak| events.get(peak)).map_or(0.0, |event| event.load),
            work: events.last().map_or(0.0, |last| last.work),
            released: events.iter().map(|event| event.released).sum(),
            imbalance: 0.0,
            detached: setae - adhering,
            rows: Vec::new(),
            forces: Vec::new(),
            columns: 1,
            events,
            peak,
            end,
            setae,
        }
    }

    /// At how many lifts events come: each is a jump of one seta or more.
    pub fn jumps(&self) -> usize {
        self.events.iter().filter(|event| event.starts_jump).count()
    }
}

/// Of a band or several, whose row stands at a node.
fn of_band(
    found: super::events::Followed,
    [rows, columns]: [usize; 2],
    (law, scatter): (&RootLaw, &Scatter),
    node_of: impl Fn(usize) -> usize,
) -> ArrayPull {
    let peak = (!found.events.is_empty()).then_some(found.peak);
    let on = sheets_after(rows, columns, &found.events[..found.peak]);
    let (mut of_rows, mut forces) = (Vec::new(), Vec::new());
    for row in (0..rows).filter(|_| peak.is_some()) {
        let place: Vector3<f64> = found.at_peak[node_of(row)];
        let mut own = ArrayRow { adhering: 0, force: [0.0; 2] };
        for column in 0..columns {
            let number = row * columns + column;
            let offset = scatter.of(number);
            let sheet = law.sheet(usize::from(on[number]), offset.strength);
            let force = sheet.map(|sheet| sheet.potential.response([place.x, place.y - offset.height]).force);
            if let Some(force) = force {
                own.adhering += 1;
                (0..2).for_each(|i| own.force[i] += force[i]);
            }
            forces.push(force.map(|force| force[1]));
        }
        of_rows.push(own);
    }
    let pull = ArrayPull::of(found.events, peak, found.end, rows * columns);
    ArrayPull { rows: of_rows, forces, columns, imbalance: found.imbalance, ..pull }
}
