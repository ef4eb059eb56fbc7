//! Stations, and events of the user, in the picture of a curve.

use crate::chart::panel::{Mark, Note, Panel};
use crate::chart::style::colour;
use crate::chart::symbol::Symbol;
use peelkit::study::{Events, Stations};

/// Most events that are labelled in a panel; all are marked.
const LABELLED: usize = 6;

/// A station, or where an event of the user lies, in the picture of a curve.
#[derive(Clone, Debug, PartialEq)]
pub struct Marked {
    /// Of an event; empty of a station
    pub name: String,
    /// In the units of the axes
    pub at: (f64, f64),
}

impl Marked {
    /// Those of a path, on its force over its displacement.
    pub fn of_path(stations: &[Stations], events: &[Events]) -> Vec<Self> {
        let of_station = stations.iter().flat_map(|of| of.found.iter().map(|at| (String::new(), at)));
        let of_event = events.iter().flat_map(|of| of.found.iter().map(|at| (of.at.name.clone(), at)));
        of_station.chain(of_event).map(|(name, at)| Self { name, at: (at.displacement, at.force) }).collect()
    }
}

/// Marks what was found in every panel that shows it: squares, in the legend once, an event with its name.
pub(crate) fn mark_found(panels: &mut [Panel], marked: &[Marked]) {
    for panel in panels {
        let mut labelled = 0;
        let (mut station, mut event) = (Some("station"), Some("event"));
        for Marked { name, at } in marked.iter().filter(|marked| panel.shows(marked.at)).cloned().collect::<Vec<_>>() {
            let is_event = !name.is_empty();
            let (legend, colour) =
                if is_event { (event.take(), colour::GREEN) } else { (station.take(), colour::ORANGE) };
            let note = (is_event && labelled < LABELLED).then(|| Note { badge: None, text: vec![name] });
            labelled += usize::from(note.is_some());
            panel.marks.push(Mark { at, symbol: Symbol::Square, colour, name: legend.map(str::to_owned), note });
        }
    }
}
