//! Where a strip is cut into columns and rows.

/// Where elements are finer than elsewhere.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Grading {
    /// Nowhere
    #[default]
    None,
    /// At the two corners of the gripped end: the last column, the lowest row and the highest are cut again, each cut at `ratio` of the way to
    /// the corner of the one before
    Grip {
        /// How many cuts
        levels: usize,
        /// Of one cut to the next, above 0 and below 1
        ratio: f64,
    },
}

impl Grading {
    /// As most strips in a rigid grip need it: three cuts, each at a quarter. More of them may leave elements so slender that Newton's method stalls.
    pub const OF_GRIP: Self = Self::Grip { levels: 3, ratio: 0.25 };
}

/// The mesh of a strip: rectangles in columns and rows.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct StripMesh {
    /// S of the lines across the strip, ascending from 0 to L, nm
    pub lines: Vec<f64>,
    /// Heights of the lines along it over the contact face, ascending from 0 to h, nm
    pub heights: Vec<f64>,
}

impl StripMesh {
    /// Of a length and height (nm), with columns of about the length `along` (nm) and so many rows before it is graded.
    pub(crate) fn new(length: f64, height: f64, along: f64, through: usize, grading: Grading) -> Self {
        let columns = (length / along).round().max(1.0) as usize;
        let even = |whole: f64, parts: usize| -> Vec<f64> {
            (0..=parts).map(|k| if k == parts { whole } else { whole * k as f64 / parts as f64 }).collect()
        };
        let (mut lines, mut heights) = (even(length, columns), even(height, through));
        if let Grading::Grip { levels, ratio } = grading {
            if through == 1 {
                heights.insert(1, 0.5 * height);
            }
            let (last, row) = (length - lines[columns - 1], heights[1]);
            let cuts = |size: f64| (1..=levels).map(move |level| size * ratio.powi(level as i32));
            lines.extend(cuts(last).map(|cut| length - cut));
            heights.extend(cuts(row).flat_map(|cut| [cut, height - cut]));
            lines.sort_by(f64::total_cmp);
            heights.sort_by(f64::total_cmp);
        }
        Self { lines, heights }
    }

    /// The same with every column and every row cut in two.
    pub(crate) fn halved(&self) -> Self {
        Self { lines: halved(&self.lines), heights: halved(&self.heights) }
    }

    /// Number of columns.
    pub(crate) fn columns(&self) -> usize {
        self.lines.len() - 1
    }

    /// Number of rows.
    pub(crate) fn rows(&self) -> usize {
        self.heights.len() - 1
    }

    /// h, nm
    pub(crate) fn height(&self) -> f64 {
        self.heights[self.rows()]
    }

    /// Length of a column, nm.
    pub(crate) fn length_of(&self, column: usize) -> f64 {
        self.lines[column + 1] - self.lines[column]
    }

    /// Height of a row, nm.
    pub(crate) fn height_of(&self, row: usize) -> f64 {
        self.heights[row + 1] - self.heights[row]
    }

    /// The column or row of a place between ascending cuts, and the coordinate in it from -1 to 1.
    pub(crate) fn located(cuts: &[f64], place: f64) -> (usize, f64) {
        let index = cuts.partition_point(|&cut| cut <= place).clamp(1, cuts.len() - 1) - 1;
        let width = cuts[index + 1] - cuts[index];
        (index, (2.0 * (place - cuts[index]) / width - 1.0).clamp(-1.0, 1.0))
    }
}

/// Ascending cuts with one more in the middle of each pair.
pub(super) fn halved(cuts: &[f64]) -> Vec<f64> {
    let pairs = cuts.windows(2).flat_map(|pair| [pair[0], 0.5 * (pair[0] + pair[1])]);
    pairs.chain(cuts.last().copied()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_graded_mesh_is_cut_towards_the_corners_of_the_grip() {
        let mesh = StripMesh::new(100.0, 10.0, 4.0, 5, Grading::Grip { levels: 2, ratio: 0.25 });
        assert_eq!((mesh.columns(), mesh.rows()), (27, 9));
        assert_eq!(mesh.lines[24..], [96.0, 99.0, 99.75, 100.0]);
        assert_eq!(mesh.heights, [0.0, 0.125, 0.5, 2.0, 4.0, 6.0, 8.0, 9.5, 9.875, 10.0]);
        let even = StripMesh::new(100.0, 10.0, 4.0, 5, Grading::None);
        assert_eq!((even.columns(), even.rows()), (25, 5));
        assert_eq!(StripMesh::located(&even.heights, 5.5), (2, 0.5));
        assert_eq!(StripMesh::located(&even.heights, 10.0), (4, 1.0));
    }
}
