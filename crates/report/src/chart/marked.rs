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

/// Marks what was found in every panel that shows it: squares, in the legend once, an event with its name where it first lies.
pub(crate) fn mark_found(panels: &mut [Panel], marked: &[Marked]) {
    for panel in panels {
        let mut labelled: Vec<&str> = Vec::new();
        let (mut station, mut event) = (Some("station"), Some("event"));
        let shown: Vec<&Marked> = marked.iter().filter(|marked| panel.shows(marked.at)).collect();
        for Marked { name, at } in shown {
            let is_station = name.is_empty();
            let (legend, colour) =
                if is_station { (station.take(), colour::ORANGE) } else { (event.take(), colour::GREEN) };
            let is_new = !is_station && labelled.len() < LABELLED && !labelled.contains(&name.as_str());
            labelled.extend(is_new.then_some(name.as_str()));
            let note = is_new.then(|| Note { badge: None, text: vec![name.clone()] });
            panel.marks.push(Mark { at: *at, symbol: Symbol::Square, colour, name: legend.map(str::to_owned), note });
        }
    }
}
