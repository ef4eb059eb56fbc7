//! A tree of branches in SWC, the format of reconstructions from micrographs: a joint a line, with what it hangs on.

use super::table::{read, shown};
use peelkit::model::{SetaJoint, SetaTree, SetaTreeError};
use std::collections::HashMap;

/// The columns of a line.
const COLUMNS: [&str; 7] = ["id", "type", "x", "y", "z", "radius", "parent"];
/// SWC counts in micrometres.
const NM_PER_UM: f64 = 1e3;
/// The parent of a root.
const NONE: i64 = -1;

/// What is wrong with a tree in SWC.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum SwcError {
    /// A line with other columns.
    #[error("has in line {line} {found} numbers; a line of SWC has seven: id, type, x, y, z, radius and parent")]
    Columns {
        /// From 1, with the remarks
        line: usize,
        /// How many it has
        found: usize,
    },
    /// A number that is wrong.
    #[error("has in line {line} {column} = {found}, which {wrong}")]
    Cell {
        /// From 1, with the remarks
        line: usize,
        /// Of the seven
        column: &'static str,
        /// Its text
        found: String,
        /// What is wrong with it
        wrong: &'static str,
    },
    /// A joint that does not fit the others.
    #[error("has in line {line} a joint that does not fit: {wrong}")]
    Joint {
        /// From 1, with the remarks
        line: usize,
        /// Why
        wrong: SetaTreeError,
    },
    /// The joints are no tree.
    #[error("is no tree of a seta: {0}")]
    Tree(SetaTreeError),
}

/// Reads a tree in SWC: lines of id, type, x, y, z, radius and parent, lengths in micrometres, y along the normal of the ground. The root has the parent
/// -1; the radius of a joint is that of the branch which leads to it. The type says nothing. A line that begins with `#` is a remark.
///
/// ```
/// let tree = peelkit_scene::parse_swc("1 0 0 9 0 0.5 -1\n2 0 0 3 0 0.5 1\n3 0 -1 0 0 0.2 2\n4 0 1 0 0 0.2 2\n")?;
/// assert_eq!((tree.joints().len(), tree.tips().len()), (4, 2));
/// # Ok::<(), peelkit_scene::SwcError>(())
/// ```
pub fn parse_swc(text: &str) -> Result<SetaTree, SwcError> {
    let (mut lines, mut joints, mut parents) = (Vec::new(), Vec::new(), Vec::new());
    let mut numbers = HashMap::new();
    let is_row = |line: &&str| !line.is_empty() && !line.starts_with('#');
    for (line, row) in (1..).zip(text.lines().map(str::trim)).filter(|(_, row)| is_row(row)) {
        let cells: Vec<&str> = row.split_whitespace().collect();
        let Ok(cells) = <[&str; 7]>::try_from(cells.as_slice()) else {
            return Err(SwcError::Columns { line, found: cells.len() });
        };
        let wrong =
            |column: usize, wrong| SwcError::Cell { line, column: COLUMNS[column], found: shown(cells[column]), wrong };
        let whole = |column: usize| cells[column].parse::<i64>().map_err(|_| wrong(column, "is no whole number"));
        let length = |column: usize| match cells[column].parse::<f64>() {
            Ok(length) if length.is_finite() => Ok(NM_PER_UM * length),
            _ => Err(wrong(column, "is no number")),
        };
        if numbers.insert(whole(0)?, joints.len()).is_some() {
            return Err(wrong(0, "an earlier line has as well"));
        }
        joints.push(SetaJoint {
            place: [length(2)?, length(3)?, length(4)?],
            diameter: 2.0 * length(5)?,
            parent: None,
        });
        parents.push((whole(6)?, wrong(6, "is the id of no line")));
        lines.push(line);
    }
    for (joint, (parent, missing)) in joints.iter_mut().zip(parents).filter(|(_, (parent, _))| *parent != NONE) {
        joint.parent = Some(*numbers.get(&parent).ok_or(missing)?);
    }
    SetaTree::new(&joints).map_err(|wrong| match wrong.joint() {
        Some(joint) => SwcError::Joint { line: lines[joint], wrong },
        None => SwcError::Tree(wrong),
    })
}

/// Reads a tree, and gives the text that it is read from.
pub(crate) fn read_swc(name: &str, text: &str) -> Result<(SetaTree, String), String> {
    read(name, text, parse_swc)
}

#[cfg(test)]
mod tests {
    use super::*;

    const TREE: &str = "# a remark\n 1 0 0 9 0 0.5 -1\n\n7 2 0 3 0 0.5 1\n4 0 1 0 0 0.2 7\n3 0 -1 0.1 0 0.2 7\n";

    #[test]
    fn lengths_are_micrometres_and_ids_are_names() {
        let tree = parse_swc(TREE).unwrap();
        let places: Vec<[f64; 2]> = tree.joints().iter().map(|joint| [joint.place[0], joint.place[1]]).collect();
        assert_eq!(places, [[0.0, 8950.0], [0.0, 2950.0], [1000.0, -50.0], [-1000.0, 50.0]]);
        assert_eq!(tree.joints()[3].diameter, 400.0);
    }

    #[test]
    fn what_is_wrong_is_told_with_its_line() {
        for (from, to, said) in [
            ("4 0 1 0 0 0.2 7", "4 0 1 0 0 0.2", "has in line 5 6 numbers; a line of SWC has seven"),
            ("4 0 1 0 0 0.2 7", "4 0 1 x 0 0.2 7", "has in line 5 y = x, which is no number"),
            ("4 0 1 0 0 0.2 7", "4 0 1 inf 0 0.2 7", "has in line 5 y = inf, which is no number"),
            ("4 0 1 0 0 0.2 7", "4.5 0 1 0 0 0.2 7", "has in line 5 id = 4.5, which is no whole number"),
            ("4 0 1 0 0 0.2 7", "7 0 1 0 0 0.2 7", "has in line 5 id = 7, which an earlier line has as well"),
            ("4 0 1 0 0 0.2 7", "4 0 1 0 0 0.2 8", "has in line 5 parent = 8, which is the id of no line"),
            (
                "4 0 1 0 0 0.2 7",
                "4 0 1 0 0 0 7",
                "has in line 5 a joint that does not fit: the diameter of its branch is 0 nm",
            ),
            ("4 0 1 0 0 0.2 7", "4 0 1 0 0 0.2 -1", "has in line 5 a joint that does not fit: it is a second root"),
            ("1 0 0 9 0 0.5 -1", "1 0 0 9 0 0.5 7", "is no tree of a seta: no joint is a root"),
        ] {
            let error = parse_swc(&TREE.replace(from, to)).unwrap_err().to_string();
            assert!(error.starts_with(said), "{error}");
        }
        assert_eq!(parse_swc("").unwrap_err(), SwcError::Tree(SetaTreeError::NoRoot));
    }
}
