//! The lamella of the reference, and its table.

use peelkit::toe::{BandSection, Lamella, RootLaw, Scatter};
use std::collections::HashMap;

pub const UM: f64 = 1000.0;
pub const UN: f64 = 1000.0;
/// nm
pub const REACH: f64 = 5142.67;
/// nN/nm
pub const STIFFNESS: f64 = 0.45445 / 5.14267;
/// nm
pub const PITCH: f64 = 25_000.0 / 3.0;
pub const COLUMNS: usize = 360;

/// verification/toe.csv, by case and quantity.
pub fn table() -> HashMap<(String, String), f64> {
    let text = std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/../../verification/toe.csv")).unwrap();
    let rows = text.lines().filter(|line| !line.starts_with('#')).skip(1);
    rows.map(|line| {
        let cells: Vec<&str> = line.split(',').collect();
        ((cells[0].to_owned(), cells[1].to_owned()), cells[2].parse().unwrap())
    })
    .collect()
}

pub fn spring() -> RootLaw {
    RootLaw::Spring { stiffness: STIFFNESS, reach: REACH }
}

/// 3 mm wide, 30 µm thick, of 1.5 GPa, on rows of 360 setae.
pub fn lamella(rows: usize) -> Lamella {
    Lamella {
        rows,
        columns: COLUMNS,
        pitch: PITCH,
        section: BandSection::rectangular(3000.0 * UM, 30.0 * UM, 1.5),
        law: spring(),
        scatter: Scatter::default(),
        overhang: 0.0,
        pulled_at: None,
    }
}
