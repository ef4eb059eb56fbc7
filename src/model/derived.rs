//! What follows from a model before anything is solved: the numbers by which one strip is compared with another.

use super::peel::{Adhesion, PeelModel};
use crate::adhesion::section::law::Law;
use crate::adhesion::spatial_section::section::SectionShape;
use crate::analytic::peeling::{kendall_force, sliding_force, stretched_force};
use crate::beam::material::stretch_law::StretchLaw;
use crate::beam::section::Section;

/// Quantities that follow from a model alone.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DerivedQuantities {
    /// w of the adhesion law in front of a beam of any height, J/m² = nN/nm: of the half space 15^(1/3) A_H/(16 π r0²), of a cohesive law the
    /// work that it was given
    pub work_of_adhesion: f64,
    /// The largest attraction σ of the law, GPa = nN/nm²; none of a law of the user's own
    pub strength: Option<f64>,
    /// Distance of a flat face at rest from the half space, nm
    pub equilibrium_gap: f64,
    /// Those of the section; none where that varies along the body or is an ellipse
    pub section: Option<DerivedOfSection>,
}

/// Quantities of a beam whose section is the same everywhere.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DerivedOfSection {
    /// w of this section, J/m²: what separating it takes, the attraction of the upper surface included where the model has that. Kendall's
    /// force and the groups are made of this one
    pub work_of_adhesion: f64,
    /// Kendall's force at the angle φ of the pull to the strip, nN: P²/(2 E h b²) + (P/b)(1 - cos φ) = w, or that of its law of stretch,
    /// [`stretched_force`]
    pub kendall_force: f64,
    /// The steady force of a film that slides along the substrate without friction, at the angle α of the pull, nN: P (1 - cos α) + P² sin² α/(2EA) =
    /// w b. What is bonded carries P cos α as well and is stretched by that before it peels; none in space
    pub sliding_force: Option<f64>,
    /// Kendall's force with the work in shear in place of that of opening, nN, where it has one of its own: a long strip peels between both, and one
    /// that is pulled along itself at this one
    pub kendall_force_in_shear: Option<f64>,
    /// EA (nN), GA_s (nN) and EI (nN nm²)
    pub stiffness: Section,
    /// Height of the axis above the adhering face at rest, nm: h/2
    pub neutral_axis: f64,
    /// ℓ, over which the adhesion falls off at the peeling front, nm: the lesser of (EI/k)^(1/4) and 3 (GA_s/k)^(1/2), k the stiffness of the
    /// adhesion at rest
    pub process_length: f64,
    /// The shear lag length (EA/(b k))^(1/2), nm, over which a force along the substrate goes over into it, k the stiffness of what holds the strip
    /// there; none where it slides freely
    pub shear_lag_length: Option<f64>,
    /// The elasto-adhesive length (EI/(w b))^(1/2), nm: a strip that comes off is bent to a radius of this over √2
    pub elasto_adhesive_length: f64,
    /// The dimensionless groups
    pub groups: DimensionlessGroups,
}

/// The dimensionless groups of a beam whose section is the same everywhere. ℓ is the length of the process zone.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DimensionlessGroups {
    /// L/h, the slenderness
    pub length_over_height: f64,
    /// L/ℓ: large where only a small part of the strip takes part in peeling
    pub length_over_process_length: f64,
    /// ℓ/h: below 1 sections deform where the strip peels, which the model leaves out
    pub process_length_over_height: f64,
    /// EI/(w b ℓ²): bending against adhesion within the process zone
    pub bending_over_adhesion: f64,
    /// EI/(w b L²), the same over the whole length: large where the strip comes off straight, as a rigid bar
    pub bending_over_adhesion_of_length: f64,
    /// EI/(GA_s ℓ²): bending against shear within the process zone; large where shear decides the peak
    pub bending_over_shear: f64,
    /// w/(E h): half the square of the strain of a strip that Kendall's force pulls along the substrate
    pub adhesion_over_stretching: f64,
    /// σ/E: strains of the material under the largest attraction
    pub strength_over_modulus: Option<f64>,
}

impl PeelModel {
    /// What follows from the model before anything is solved.
    pub fn derived(&self) -> DerivedQuantities {
        let law = self.line_law();
        let half_space = law.half_space;
        let (work_of_adhesion, strength) = match &law.law {
            Law::BodyForce | Law::SurfaceTraction => (half_space.work_of_adhesion(), Some(half_space.strength())),
            Law::Cohesive(_) => {
                let [work, strength] = self.adhesion.own_work_and_strength().unwrap_or_else(|| {
                    let Adhesion { work, strength, .. } = self.adhesion;
                    let [own_work, own_strength] = [half_space.work_of_adhesion(), half_space.strength()];
                    [work.unwrap_or(own_work), strength.unwrap_or(own_strength)]
                });
                (work, Some(strength))
            }
            Law::Own(_) => (-law.rest_energy(), None),
        };
        let oval = self.space.is_some_and(|space| space.section == SectionShape::Ellipse);
        let section = (self.is_uniform() && !oval).then(|| self.derived_of_section(strength));
        DerivedQuantities { work_of_adhesion, strength, equilibrium_gap: law.rest_gap(), section }
    }

    /// Angle φ of the pull to the strip, rad: that to the substrate in the plane; in space cos φ = cos α cos β, of the
    /// elevation α and the azimuth β.
    pub fn angle_to_strip(&self) -> f64 {
        let angle = self.pull.angle;
        self.space.map_or(angle, |space| (angle.cos() * space.azimuth.cos()).acos())
    }

    fn derived_of_section(&self, strength: Option<f64>) -> DerivedOfSection {
        let (stiffness, width, height) = self.section_at(0.0);
        let (modulus, length, process_length) = (self.material().youngs_modulus, self.length(), self.process_length());
        let work = -self.line_law().rest_energy();
        let Section { shear, bending, .. } = stiffness;
        let over_adhesion = bending / (work * width);
        let thickness = height * self.thickness_over_height();
        let (law, axial) = (self.material().stretch, stiffness.axial);
        let slides = self.space.is_none() && self.adhesion.shear_strength.is_none();
        let bonded = |work: f64| match law {
            StretchLaw::Linear => kendall_force(work, modulus, height, width, self.angle_to_strip()),
            _ => stretched_force(law, work * width, axial, self.pull.angle, false),
        };
        let in_shear = self.adhesion.sheared_law().filter(|law| !law.has_potential());
        DerivedOfSection {
            work_of_adhesion: work,
            kendall_force: bonded(work),
            kendall_force_in_shear: in_shear.map(|law| bonded(law.shear_work())),
            sliding_force: slides.then(|| match law {
                StretchLaw::Linear => sliding_force(-work * width, axial, self.pull.angle),
                _ => stretched_force(law, work * width, axial, self.pull.angle, true),
            }),
            stiffness,
            neutral_axis: 0.5 * height,
            process_length,
            shear_lag_length: self.shear_lag_length(),
            elasto_adhesive_length: over_adhesion.sqrt(),
            groups: DimensionlessGroups {
                length_over_height: length / thickness,
                length_over_process_length: length / process_length,
                process_length_over_height: process_length / thickness,
                bending_over_adhesion: over_adhesion / process_length.powi(2),
                bending_over_adhesion_of_length: over_adhesion / length.powi(2),
                bending_over_shear: bending / (shear * process_length.powi(2)),
                adhesion_over_stretching: work / (modulus * height),
                strength_over_modulus: strength.map(|strength| strength / modulus),
            },
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::{Adhesion, Body, Grip, Spatula, StripModel};
    use approx::assert_relative_eq;

    #[test]
    fn the_paper_strip() {
        let derived = PeelModel::from(&StripModel::of_the_paper(100.0, 1.0)).derived();
        assert_relative_eq!(derived.work_of_adhesion, 0.030665, max_relative = 1e-4);
        assert_relative_eq!(derived.strength.unwrap(), 0.1236, max_relative = 1e-3);
        let section = derived.section.unwrap();
        assert_relative_eq!(section.stiffness.axial, 20.0, max_relative = 1e-14);
        assert_relative_eq!(section.stiffness.shear, 5.0 / 6.0 * 2.0 / 2.4 * 10.0, max_relative = 1e-14);
        assert_relative_eq!(section.stiffness.bending, 2.0e3 / 12.0, max_relative = 1e-14);
        // P + P²/(2EA) = w b
        let (p, w) = (section.kendall_force, section.work_of_adhesion);
        assert_relative_eq!(p + p * p / 40.0, w, max_relative = 1e-13);
        assert_relative_eq!(section.sliding_force.unwrap(), p, max_relative = 1e-13);
        // the attraction of the upper surface counts
        assert!(w < derived.work_of_adhesion && w > 0.999 * derived.work_of_adhesion);
        let groups = section.groups;
        assert_eq!(groups.length_over_height, 10.0);
        let all = groups.length_over_process_length * groups.process_length_over_height;
        assert_relative_eq!(all, groups.length_over_height, max_relative = 1e-14);
        assert_relative_eq!(
            groups.bending_over_adhesion_of_length,
            (section.elasto_adhesive_length / 100.0).powi(2),
            max_relative = 1e-14
        );
    }

    #[test]
    fn what_varies_along_a_body_has_no_single_value() {
        let derived = PeelModel::of(Body::Spatula(Spatula::default()), Adhesion::default(), Grip::FREE).derived();
        assert_eq!(derived.section, None);
        assert_relative_eq!(derived.work_of_adhesion, 0.030665, max_relative = 1e-4);
    }
}
