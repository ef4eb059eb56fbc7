//! The tables of `verification/`, built into the program so that a check needs no file and no Python.

use peelkit::adhesion::LineLoad;
use peelkit::beam::StretchLaw;
use peelkit::model::{Attraction, Friction, Hold, PeelModel, Step, StripModel};
use std::collections::HashMap;

/// A row of a table, by the names of the columns.
#[derive(Clone, Debug)]
pub struct Row {
    cells: HashMap<String, String>,
}

impl Row {
    /// The text of a cell; None where it is empty or the column does not exist.
    pub fn text(&self, column: &str) -> Option<&str> {
        self.cells.get(column).map(String::as_str).filter(|text| !text.is_empty())
    }

    /// The number in a cell; None where it is empty, no number, or the column does not exist.
    pub fn number(&self, column: &str) -> Option<f64> {
        self.text(column)?.parse().ok()
    }

    /// The strip of a row: the paper's, with what the row says otherwise. None where a column holds something out of range.
    pub fn strip(&self) -> Option<StripModel> {
        let mut model =
            StripModel::of_the_paper(self.number("length_nm")?, self.number("bending_stiffness_factor").unwrap_or(1.0));
        let StripModel { strip, adhesion, grip, pull } = &mut model;
        let numbers = [
            ("height_nm", &mut strip.height, 1.0),
            ("width_nm", &mut strip.width, 1.0),
            ("youngs_modulus_GPa", &mut strip.material.youngs_modulus, 1.0),
            ("poissons_ratio", &mut strip.material.poissons_ratio, 1.0),
            ("shear_correction", &mut strip.material.shear_correction, 1.0),
            ("hamaker_constant_J", &mut adhesion.hamaker_constant, 1e18),
            ("equilibrium_distance_nm", &mut adhesion.equilibrium_distance, 1.0),
            ("pull_angle_deg", &mut pull.angle, 1f64.to_radians()),
            ("grip_turn_deg_per_nm", &mut pull.turn, 1f64.to_radians()),
        ];
        for (column, place, unit) in numbers {
            if let Some(text) = self.text(column) {
                *place = unit * text.parse::<f64>().ok()?;
            }
        }
        grip.pretension = self.number("pretension_nN");
        adhesion.shear_strength = self.number("shear_strength_GPa").filter(|&strength| strength > 0.0);
        adhesion.shear_work = self.number("shear_work_J_per_m2");
        adhesion.mixing_exponent = self.number("mixing_exponent");
        let holds = [("free", Hold::Free), ("fixed", Hold::Fixed)];
        let loads = [("full", LineLoad::Full), ("force-only", LineLoad::ForceOnly), ("axis-gap", LineLoad::AxisGap)];
        if let Some(word) = self.text("law") {
            adhesion.attraction = Attraction::named(word)?;
        }
        self.pick("stretch", &StretchLaw::NAMED, &mut strip.material.stretch)?;
        self.pick("grip_rotation", &holds, &mut grip.rotation)?;
        self.pick("grip_horizontal", &holds, &mut grip.horizontal)?;
        self.pick("grip_across", &holds, &mut grip.horizontal)?;
        self.pick("line_load", &loads, &mut adhesion.line_load)?;
        self.pick("far_face", &[("true", true), ("false", false)], &mut adhesion.far_face)?;
        Some(model)
    }

    /// The same with friction, and with what its grip does before the pull.
    pub fn model(&self) -> Option<PeelModel> {
        let coefficient = self.number("friction_coefficient").unwrap_or(0.0);
        let friction = Friction { strength: self.number("tau0_GPa"), coefficient, presliding: None };
        let turned = self.number("grip_turned_deg").filter(|&degrees| degrees != 0.0);
        let steps = turned.map(|degrees| Step::Turn(degrees.to_radians())).into_iter().collect();
        Some(PeelModel { steps, friction, ..PeelModel::from(self.strip()?) })
    }

    /// Puts what the word in a column stands for into its place, if there is one; None where it stands for nothing.
    fn pick<T: Copy>(&self, column: &str, choices: &[(&str, T)], place: &mut T) -> Option<()> {
        if let Some(word) = self.text(column) {
            *place = choices.iter().find(|(name, _)| *name == word)?.1;
        }
        Some(())
    }
}

/// Reads a table: lines that begin with `#` are remarks, the first other line names the columns.
pub fn read(table: &str) -> Vec<Row> {
    let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_reader(table.as_bytes());
    reader.deserialize().filter_map(Result::ok).map(|cells| Row { cells }).collect()
}

/// A number of verification/published.csv; NaN, which fails, where it is not there.
pub fn published(quantity: &str) -> f64 {
    let rows = read(include_str!("../../verification/published.csv"));
    let row = rows.iter().find(|row| row.text("quantity") == Some(quantity));
    row.and_then(|row| row.number("value")).unwrap_or(f64::NAN)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reads_remarks_names_and_gaps() {
        let rows = read("# remark\na,b,c\n1,,x\n2,3e-4,\n");
        assert_eq!(rows.len(), 2);
        assert_eq!(rows[0].number("a"), Some(1.0));
        assert_eq!((rows[0].number("b"), rows[0].text("c"), rows[0].number("c")), (None, Some("x"), None));
        assert_eq!(rows[1].number("b"), Some(3e-4));
        assert_eq!(rows[1].text("d"), None);
    }

    #[test]
    fn a_row_is_the_papers_strip_with_what_it_says_otherwise() {
        let rows = read(
            "length_nm,bending_stiffness_factor,line_load,grip_across,pull_angle_deg,hamaker_constant_J\n\
             200,0.1,axis-gap,fixed,90,2e-19\n100,1,,,,\n100,1,full,held,,\n",
        );
        let strip = rows[0].strip().unwrap();
        assert_eq!((strip.strip.length, strip.strip.material.bending_stiffness_factor), (200.0, 0.1));
        assert_eq!((strip.adhesion.line_load, strip.grip.horizontal), (LineLoad::AxisGap, Hold::Fixed));
        assert_eq!(strip.pull.direction(), peelkit::model::Pull::UP.direction());
        approx::assert_relative_eq!(strip.adhesion.hamaker_constant, 0.2, max_relative = 1e-15);
        assert_eq!(rows[1].strip(), Some(StripModel::of_the_paper(100.0, 1.0)));
        assert_eq!(rows[2].strip(), None);
    }
}
