//! The surface of a beam in space: its outline from section to section, and the two end faces.

use super::fields::{SPATIAL_STATE_FIELDS, VECTORS};
use super::grid::{Grid, PointData};
use peelkit::adhesion::SectionShape;
use peelkit::beam::SpatialSectionPlace;
use peelkit::study::SpatialSectionFields;
use std::f64::consts::TAU;

/// Corners of the polygon that is drawn for an ellipse.
const CORNERS: usize = 24;
/// Fields that the surface carries, beside the loads, which are vectors.
const SCALARS: [&str; 10] = [
    "S_nm",
    "N_nN",
    "Q2_nN",
    "Q3_nN",
    "T_nN_nm",
    "M2_nN_nm",
    "M3_nN_nm",
    "gap_nm",
    "adhesion_energy_aJ_per_nm",
    "stored_energy_aJ_per_nm",
];

/// The outline of a section, x, y, z in nm, anticlockwise as seen against d1: of a rectangle its corners, of an ellipse points on it.
pub fn outline(shape: SectionShape, section: &SpatialSectionPlace) -> Vec<[f64; 3]> {
    let at = |across: f64, up: f64| -> [f64; 3] {
        let [_, d2, d3] = section.directors;
        std::array::from_fn(|i| section.place[i] + across * section.width * d2[i] + up * section.height * d3[i])
    };
    match shape {
        SectionShape::Rectangle => {
            [[-0.5, -0.5], [0.5, -0.5], [0.5, 0.5], [-0.5, 0.5]].map(|[across, up]| at(across, up)).to_vec()
        }
        SectionShape::Ellipse => {
            let corner = |k: usize| (TAU * k as f64 / CORNERS as f64).sin_cos();
            (0..CORNERS).map(corner).map(|(sin, cos)| at(0.5 * cos, 0.5 * sin)).collect()
        }
    }
}

/// The surface as a grid: quadrilaterals along the beam, triangles about the axis on the end faces.
pub(super) fn grid(shape: SectionShape, sections: &[SpatialSectionFields]) -> Grid {
    let rings: Vec<Vec<[f64; 3]>> = sections.iter().map(|at| outline(shape, &at.state.section)).collect();
    let around = rings.first().map_or(0, Vec::len);
    let mut points = rings.concat();
    let mut places: Vec<usize> = (0..sections.len()).flat_map(|section| std::iter::repeat_n(section, around)).collect();
    let next = |k: usize| (k + 1) % around;
    let mut cells = Vec::new();
    for ring in 0..sections.len().saturating_sub(1) {
        let (here, there) = (ring * around, (ring + 1) * around);
        cells.extend((0..around).map(|k| vec![here + k, here + next(k), there + next(k), there + k]));
    }
    let faces = [(0, false), (sections.len().saturating_sub(1), true)];
    for (section, last) in faces.into_iter().filter(|_| !sections.is_empty()) {
        let (middle, from) = (points.len(), section * around);
        points.push(sections[section].state.section.place);
        places.push(section);
        let pair = |k: usize| if last { [from + k, from + next(k)] } else { [from + next(k), from + k] };
        cells.extend((0..around).map(pair).map(|[a, b]| vec![middle, a, b]));
    }
    Grid { points, cells, data: data(sections, &places) }
}

/// What the points carry: that of their sections.
fn data(sections: &[SpatialSectionFields], places: &[usize]) -> Vec<PointData> {
    let chosen = SPATIAL_STATE_FIELDS.iter().filter(|field| SCALARS.contains(&field.name));
    let scalars = chosen.map(|field| PointData {
        name: field.name,
        components: 1,
        values: places.iter().map(|&section| (field.value)(&sections[section])).collect(),
    });
    let loads = VECTORS.iter().filter(|(name, _)| name.starts_with("line_")).map(|&(name, parts)| {
        let parts = parts.map(|part| SPATIAL_STATE_FIELDS.iter().find(|field| field.name == part));
        let of = |&section: &usize| parts.map(|field| field.map_or(0.0, |field| (field.value)(&sections[section])));
        PointData { name, components: 3, values: places.iter().flat_map(of).collect() }
    });
    scalars.chain(loads).collect()
}
