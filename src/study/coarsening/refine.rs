//! A table of one branch that is refined until it is as accurate as was asked, by equilibria solved between its nodes.
//!
//! In each round the spatula is solved in the middle of every cell of each coordinate; a cell whose error there is above a share of what is
//! wanted is halved. The moment is a derivative by θ, and has an error at the nodes as well: halved are then the cells of θ beside them, and those of s
//! only where the error is larger between the nodes. So it is with the force along the substrate and v. The last round solves the spatula in the middles of the
//! cells in all coordinates at once.
//!
//! An error is the distance of what was solved from the table: with ΔF of the forces and ΔU of the displacement at the same s, and the
//! stiffness K of the table,
//!
//!   e = |ΔF - K_u ΔU| / (1 + |K_uu|/K0).
//!
//! Where the branch is soft that is the error of the force at the same displacement; where it is steep, as next to its limit, it is K0 times that of the displacement at
//! the same force. K0 is ten times the largest force over the length of the branch in u.

use super::columns::Columns;
use super::options::{HeldError, TipPlace};
use super::sheet::{Sheet, SheetNode, SheetTable};
use serde::{Deserialize, Serialize};

/// What errors are measured by: the largest force, nN, the largest moment, nN·nm, and K0, nN/nm.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct TipScales {
    /// The largest normal force of the attached branch, nN
    pub force: f64,
    /// The largest moment of it without its sign, nN·nm
    pub moment: f64,
    /// K0, nN/nm
    pub stiffness: f64,
}

/// How wrong a table is between its nodes: twice the largest error that was measured.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct SheetErrors {
    /// Of the normal force and of that along the substrate, nN, and of the moment, nN·nm
    pub force: [f64; 3],
    /// Of u at the limit point, nm
    pub limit: f64,
    /// Of u at the limit point by the mesh of the spatula, nm
    pub mesh: f64,
    /// At how many places it was measured
    pub checked: usize,
    /// The largest of the errors over what they are measured by
    pub relative: f64,
}

/// Cells of each coordinate to begin with.
const PATH: usize = 12;
const LATERAL: usize = 4;
const ROTATION: usize = 4;
/// A cell is halved where its error in one coordinate is above this share of what is wanted.
const SHARE: f64 = 0.5;
/// The error bound over the largest error that was measured.
const BOUND: f64 = 2.0;
/// Most rounds.
const MOST_ROUNDS: usize = 12;
/// K0 over the largest force and the length of the branch.
const STIFF: f64 = 10.0;

/// What is asked of a branch.
#[derive(Clone, Copy)]
pub(super) struct Wanted {
    /// Relative error
    pub tolerance: f64,
    /// Most columns; the branch is then as accurate as it is.
    pub most_columns: usize,
    /// Most nodes along it; with more of them there is none.
    pub most_nodes: usize,
}

/// A refined branch.
pub(super) struct Refined {
    pub sheet: Sheet,
    pub errors: SheetErrors,
    pub scales: TipScales,
}

/// Even cells of a range; one node where it has no length.
fn nodes([from, to]: [f64; 2], cells: usize) -> Vec<f64> {
    if from == to {
        return vec![from];
    }
    (0..=cells).map(|k| from + (to - from) * k as f64 / cells as f64).collect()
}

/// The middles of the cells of a coordinate.
fn middles(nodes: &[f64]) -> Vec<f64> {
    nodes.windows(2).map(|pair| 0.5 * (pair[0] + pair[1])).collect()
}

/// The middles of the cells that have this node.
fn beside(nodes: &[f64], node: f64) -> Vec<f64> {
    nodes.windows(2).filter(|pair| pair.contains(&node)).map(|pair| 0.5 * (pair[0] + pair[1])).collect()
}

/// The middles of cells, or the one node of a coordinate that has no cells.
fn centres(nodes: &[f64]) -> Vec<f64> {
    if nodes.len() == 1 { nodes.to_vec() } else { middles(nodes) }
}

fn pairs(lateral: &[f64], rotation: &[f64]) -> Vec<(f64, f64)> {
    lateral.iter().flat_map(|&v| rotation.iter().map(move |&t| (v, t))).collect()
}

/// The branch on a grid that is refined to what is wanted. `scales` are those of another branch; none: its own.
pub(super) fn refined(
    columns: &mut Columns,
    grid: &mut Grid,
    Wanted { tolerance, most_columns, most_nodes }: Wanted,
    scales: Option<TipScales>,
) -> Result<Refined, HeldError> {
    let wanted = tolerance / BOUND;
    let mut round = 0;
    loop {
        round += 1;
        if grid.path.len() > most_nodes {
            return Err(HeldError::Rough { nodes: grid.path.len(), most: most_nodes });
        }
        let sheet = grid.sheet(columns)?;
        let scales = scales.unwrap_or_else(|| scales_of(sheet.table()));
        let last = round == MOST_ROUNDS || columns.len() >= most_columns;
        let marked = if last { Marked::default() } else { grid.marked(&sheet, columns, &scales, SHARE * wanted)? };
        if !marked.is_empty() {
            grid.halve(&marked);
            continue;
        }
        let (errors, worst) = grid.certified(&sheet, columns, &scales)?;
        if errors.relative <= tolerance || last {
            return Ok(Refined { sheet, errors, scales });
        }
        grid.halve(&worst);
    }
}

/// The coordinates of a table under way.
pub(super) struct Grid {
    path: Vec<f64>,
    lateral: Vec<f64>,
    rotation: Vec<f64>,
}

/// Middles of the cells that are to be halved.
#[derive(Default)]
struct Marked {
    path: Vec<f64>,
    lateral: Vec<f64>,
    rotation: Vec<f64>,
}

impl Marked {
    fn is_empty(&self) -> bool {
        self.path.is_empty() && self.lateral.is_empty() && self.rotation.is_empty()
    }
}

impl Grid {
    /// A coarse one over these ranges.
    pub(crate) fn new(lateral: [f64; 2], rotation: [f64; 2]) -> Self {
        Self { path: nodes([0.0, 1.0], PATH), lateral: nodes(lateral, LATERAL), rotation: nodes(rotation, ROTATION) }
    }

    fn sheet(&self, columns: &mut Columns) -> Result<Sheet, HeldError> {
        let places = pairs(&self.lateral, &self.rotation);
        columns.compute(&places, &self.path)?;
        let node = |place: (f64, f64), s: f64| columns.node(place, s).copied().unwrap_or_default();
        let table = SheetTable {
            path: self.path.clone(),
            lateral: self.lateral.clone(),
            rotation: self.rotation.clone(),
            nodes: places.iter().flat_map(|&place| self.path.iter().map(move |&s| node(place, s))).collect(),
        };
        Sheet::new(table).ok_or(HeldError::NoTable)
    }

    /// Halves the cells with these middles.
    fn halve(&mut self, marked: &Marked) {
        let Marked { path, lateral, rotation } = marked;
        for (nodes, more) in [(&mut self.path, path), (&mut self.lateral, lateral), (&mut self.rotation, rotation)] {
            nodes.extend(more);
            nodes.sort_by(f64::total_cmp);
            nodes.dedup();
        }
    }

    /// The cells with an error above `share` in the middle of one coordinate, or at a node across the branch.
    fn marked(
        &self,
        sheet: &Sheet,
        columns: &mut Columns,
        scales: &TipScales,
        share: f64,
    ) -> Result<Marked, HeldError> {
        let mut marked = Marked::default();
        let own = pairs(&self.lateral, &self.rotation);
        let middle = middles(&self.path);
        columns.compute(&own, &middle)?;
        let each = |columns: &Columns, places: &[(f64, f64)], path: &[f64]| {
            let all = places.iter().flat_map(|&place| path.iter().map(move |&s| (place, s)));
            all.map(|(place, s)| relative(sheet, columns, place, s, scales))
                .fold([0.0; 3], |most: [f64; 3], one| std::array::from_fn(|i| most[i].max(one[i])))
        };
        let worst = |columns: &Columns, places: &[(f64, f64)], path: &[f64]| largest(each(columns, places, path));
        // at its nodes a table has the normal force that was solved, and the derivatives by v and θ of what lies beside them
        let at_nodes: Vec<f64> = self.path.iter().map(|&s| worst(columns, &own, &[s])).collect();
        for &(v, t) in &own {
            let [_, along, moment] = each(columns, &[(v, t)], &self.path);
            if along > share {
                marked.lateral.extend(beside(&self.lateral, v));
            }
            if moment > share {
                marked.rotation.extend(beside(&self.rotation, t));
            }
        }
        let of_path = |k: usize, s: f64| worst(columns, &own, &[s]) > share.max(at_nodes[k]).max(at_nodes[k + 1]);
        marked.path = middle.iter().enumerate().filter(|&(k, &s)| of_path(k, s)).map(|(_, &s)| s).collect();
        for v in middles(&self.lateral) {
            let places = pairs(&[v], &self.rotation);
            columns.compute(&places, &self.path)?;
            marked.lateral.extend((worst(columns, &places, &self.path) > share).then_some(v));
        }
        for t in middles(&self.rotation) {
            let places = pairs(&self.lateral, &[t]);
            columns.compute(&places, &self.path)?;
            marked.rotation.extend((worst(columns, &places, &self.path) > share).then_some(t));
        }
        Ok(marked)
    }

    /// The errors in the middles of all cells, and the middles of that with the largest.
    fn certified(
        &self,
        sheet: &Sheet,
        columns: &mut Columns,
        scales: &TipScales,
    ) -> Result<(SheetErrors, Marked), HeldError> {
        let places = pairs(&centres(&self.lateral), &centres(&self.rotation));
        let mut path = centres(&self.path);
        path.push(1.0);
        columns.compute(&places, &path)?;
        let mut errors = SheetErrors { mesh: BOUND * columns.mesh_error(), ..SheetErrors::default() };
        let mut worst = Marked::default();
        for &(lateral, rotation) in &places {
            for &s in &path {
                let Some(node) = columns.node((lateral, rotation), s) else { continue };
                let (off, shift) = missed(sheet, node, lateral, rotation, s, scales);
                (0..3).for_each(|i| errors.force[i] = errors.force[i].max(BOUND * off[i]));
                if s == 1.0 {
                    errors.limit = errors.limit.max(BOUND * shift.abs());
                }
                errors.checked += 1;
                let own = BOUND * largest(over(off, scales));
                if own > errors.relative {
                    errors.relative = own;
                    let cells = |nodes: &[f64], middle: f64| if nodes.len() > 1 { vec![middle] } else { Vec::new() };
                    worst = Marked {
                        path: if s < 1.0 { vec![s] } else { Vec::new() },
                        lateral: cells(&self.lateral, lateral),
                        rotation: cells(&self.rotation, rotation),
                    };
                }
            }
        }
        Ok((errors, worst))
    }
}

/// Errors of forces and moment at a node that was solved, and by how much the table's u is off.
fn missed(sheet: &Sheet, node: &SheetNode, lateral: f64, rotation: f64, s: f64, scales: &TipScales) -> ([f64; 3], f64) {
    let place = TipPlace { normal: node.normal, lateral, rotation };
    let table = sheet.interpolated_at(s, place);
    let shift = sheet.displacement_at(s, place) - node.normal;
    let own = table.stiffness[0][0];
    let off = std::array::from_fn(|i| {
        let miss = (table.force[i] - node.force[i]) / own - table.stiffness[i][0] / own * shift;
        (miss / (1.0 / own.abs() + 1.0 / scales.stiffness)).abs()
    });
    (off, shift)
}

/// The errors over what they are measured by.
fn over([normal, along, moment]: [f64; 3], scales: &TipScales) -> [f64; 3] {
    [normal / scales.force, along / scales.force, moment / scales.moment]
}

fn largest(errors: [f64; 3]) -> f64 {
    errors.into_iter().fold(0.0, f64::max)
}

fn relative(sheet: &Sheet, columns: &Columns, (v, t): (f64, f64), s: f64, scales: &TipScales) -> [f64; 3] {
    columns.node((v, t), s).map_or([0.0; 3], |node| over(missed(sheet, node, v, t, s, scales).0, scales))
}

/// The scales of a branch.
fn scales_of(table: &SheetTable) -> TipScales {
    let most = |of: fn(&SheetNode) -> f64| table.nodes.iter().map(of).fold(0.0, f64::max);
    let force = most(|node| node.force[0]);
    let length = (0..table.lateral.len())
        .flat_map(|v| (0..table.rotation.len()).map(move |t| (v, t)))
        .map(|(v, t)| {
            let column = table.column(v, t);
            (column[column.len() - 1].normal - column[0].normal).abs()
        })
        .fold(0.0, f64::max);
    TipScales { force, moment: most(|node| node.force[2].abs()), stiffness: STIFF * force / length }
}
