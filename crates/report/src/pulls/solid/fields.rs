//! The strip at chosen points of its path, as a grid that ParaView opens: the places of the material with displacement and stress.

use crate::states::grid::{Grid, PointData, collection};
use crate::writing::error::ReportError;
use crate::writing::file::write_whole;
use peelkit::study::{SolidPeel, SolidPoint};
use std::path::{Path, PathBuf};

/// Each element is drawn in so many parts along it: its contact edge is curved.
const PARTS: usize = 3;

/// S and heights at which fields are shown: all lines of the mesh, and between those across the strip some more.
pub(super) fn shown(peel: &SolidPeel) -> [Vec<f64>; 2] {
    let (across, along) = peel.body.mesh_lines();
    let part = |pair: &[f64], k: usize| pair[0] + (pair[1] - pair[0]) * k as f64 / PARTS as f64;
    let places = across.windows(2).flat_map(|pair| (0..PARTS).map(move |k| part(pair, k)));
    [places.chain(across.last().copied()).collect(), along.to_vec()]
}

/// The points that are shown: at the peak, and where half of the body is off, if the path comes so far.
pub(super) fn chosen(peel: &SolidPeel) -> Vec<(&'static str, &SolidPoint)> {
    let peak = peel.peak().and_then(|at| peel.points.get(at.after));
    let half = peel.points.iter().find(|at| at.front >= 0.5 * peel.body.adhering_length());
    let last = peel.points.last();
    let first = peak.map_or_else(|| ("at the end", last), |peak| ("at the peak", Some(peak)));
    let second = half.map_or_else(|| ("at the end", last), |half| ("half off", Some(half)));
    let mut chosen: Vec<_> = [first, second].into_iter().filter_map(|(what, at)| Some((what, at?))).collect();
    // in the order of the path
    chosen.sort_by(|a, b| a.1.front.total_cmp(&b.1.front));
    chosen.dedup_by(|a, b| std::ptr::eq(a.1, b.1));
    chosen
}

/// Writes solid.pvd, the list of the states, and states/solid-000.vtu and so on, which it names: at so many points evenly along the path, with
/// displacement and Cauchy's stress as point data, u and P as field data.
///
/// Fails with [`ReportError::Write`] where a file cannot be written or a number is not finite.
pub fn write_solid_states(dir: &Path, peel: &SolidPeel, count: usize) -> Result<Vec<PathBuf>, ReportError> {
    let name = |number: usize| format!("states/solid-{number:03}.vtu");
    let last = peel.points.len().saturating_sub(1);
    let mut chosen: Vec<usize> = (0..count).map(|k| k * last / count.saturating_sub(1).max(1)).collect();
    chosen.extend(peel.peak().map(|peak| peak.after));
    chosen.sort_unstable();
    chosen.dedup();
    let list = dir.join("solid.pvd");
    write_whole(&list, collection((0..chosen.len()).map(name)).as_bytes())?;
    let mut files = vec![list];
    for (number, &index) in chosen.iter().enumerate() {
        let Some(at) = peel.points.get(index) else { continue };
        let path = dir.join(name(number));
        let of_state = [("displacement_nm", at.displacement), ("force_nN", at.force), ("path_position", index as f64)];
        let text = grid(peel, at).of_state(&of_state);
        let text = text.map_err(|source| ReportError::Write { path: path.clone(), source })?;
        write_whole(&path, text.as_bytes())?;
        files.push(path);
    }
    Ok(files)
}

fn grid(peel: &SolidPeel, at: &SolidPoint) -> Grid {
    let [places, heights] = shown(peel);
    let all: Vec<[f64; 2]> = places.iter().flat_map(|&s| heights.iter().map(move |&height| [s, height])).collect();
    let rows = heights.len();
    let corner = |column: usize, row: usize| column * rows + row;
    let cells = (1..places.len()).flat_map(|column| {
        (1..rows).map(move |row| {
            vec![corner(column - 1, row - 1), corner(column, row - 1), corner(column, row), corner(column - 1, row)]
        })
    });
    let moved = |&of: &[f64; 2]| {
        let [x, y] = peel.body.displacement_at(at.values(), of);
        [x, y, 0.0]
    };
    let stresses: Vec<[f64; 3]> = all.iter().map(|&of| peel.body.stress_at(at.values(), of)).collect();
    let stress = |name, component: usize| PointData {
        name,
        components: 1,
        values: stresses.iter().map(|stress| stress[component]).collect(),
    };
    let points = all.iter().map(|&of| peel.body.place_at(at.values(), of)).map(|[x, y]| [x, y, 0.0]).collect();
    let displacement =
        PointData { name: "displacement_nm", components: 3, values: all.iter().flat_map(moved).collect() };
    let data = vec![displacement, stress("stress_xx_GPa", 0), stress("stress_yy_GPa", 1), stress("stress_xy_GPa", 2)];
    Grid { points, cells: cells.collect(), data }
}
