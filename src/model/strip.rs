//! A uniform strip on a flat half space, lifted at its right end.

use super::chain::{three_field, two_field};
use crate::adhesion::{HalfSpace, LineLaw, LineLoad};
use crate::beam::{ReducedBeam, ReissnerBeam, RestCurve, Section, rectangle_second_moment};
use crate::solve::{Chain, Focus, MOST_FIELDS, Mesh, Problem};

/// Geometry and material of a uniform strip of rectangular section.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Strip {
    /// nm
    pub length: f64,
    /// nm
    pub height: f64,
    /// nm
    pub width: f64,
    /// GPa = nN/nm²
    pub youngs_modulus: f64,
    pub poissons_ratio: f64,
    pub shear_correction: f64,
    /// Multiplies EI alone.
    pub bending_stiffness_factor: f64,
}

/// The adhesion between the strip and the half space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Adhesion {
    /// nN·nm = aJ
    pub hamaker_constant: f64,
    /// r0 of the pair potential, nm
    pub equilibrium_distance: f64,
    pub line_load: LineLoad,
    /// Whether the top face counts (the r2 terms).
    pub far_face: bool,
}

/// What the grip does with one degree of freedom of the right end.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Hold {
    Free,
    Fixed,
}

/// The grip at S = L. Its vertical displacement is what is driven.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Grip {
    pub rotation: Hold,
    pub horizontal: Hold,
    /// k of a spring between the grip and the machine that moves it, nN/nm; none: the machine moves the grip itself
    pub stiffness: Option<f64>,
}

/// A strip, its adhesion and its grip.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StripModel {
    pub strip: Strip,
    pub adhesion: Adhesion,
    pub grip: Grip,
}

/// Which unknowns a node has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// y and θ; x is minimised out, the horizontal force is one number. Exact on a flat substrate without friction.
    TwoField,
    /// x, y and θ.
    ThreeField,
}

impl StripModel {
    /// The strip of Figs. 9 and 10 of the paper, of the given length in nm, in a free grip, with EI times `bending`.
    pub fn of_the_paper(length: f64, bending: f64) -> Self {
        Self {
            strip: Strip {
                length,
                height: 10.0,
                width: 1.0,
                youngs_modulus: 2.0,
                poissons_ratio: 0.2,
                shear_correction: 5.0 / 6.0,
                bending_stiffness_factor: bending,
            },
            adhesion: Adhesion {
                hamaker_constant: 0.1,
                equilibrium_distance: 0.4,
                line_load: LineLoad::Full,
                far_face: true,
            },
            grip: Grip { rotation: Hold::Free, horizontal: Hold::Free, stiffness: None },
        }
    }

    /// EA, GA_s and EI.
    pub fn section(&self) -> Section {
        let s = &self.strip;
        let area = s.height * s.width;
        Section {
            axial: s.youngs_modulus * area,
            shear: s.shear_correction * s.youngs_modulus / (2.0 * (1.0 + s.poissons_ratio)) * area,
            bending: s.youngs_modulus * rectangle_second_moment(s.height, s.width) * s.bending_stiffness_factor,
        }
    }

    /// The line load per width.
    pub fn line_law(&self) -> LineLaw {
        LineLaw {
            half_space: HalfSpace {
                hamaker_constant: self.adhesion.hamaker_constant,
                equilibrium_distance: self.adhesion.equilibrium_distance,
            },
            height: self.strip.height,
            line_load: self.adhesion.line_load,
            far_face: self.adhesion.far_face,
        }
    }

    /// Decay length (EI/k)^(1/4) of a bending beam on the adhesion's stiffness k at rest, nm.
    pub fn bending_length(&self) -> f64 {
        (self.section().bending / self.rest_stiffness()).powf(0.25)
    }

    /// k, the adhesion's stiffness at rest, nN/nm².
    fn rest_stiffness(&self) -> f64 {
        let law = self.line_law();
        law.response(law.rest_gap(), 0.0, 1.0).gap_gap * self.strip.width
    }

    /// Decay length (GA_s/k)^(1/2) of a shear beam on the adhesion's stiffness k at rest, nm.
    pub fn shear_length(&self) -> f64 {
        (self.section().shear / self.rest_stiffness()).sqrt()
    }

    /// Length of the process zone, nm: that of a bending beam, or a few times that of a shear beam where that is shorter.
    pub fn process_length(&self) -> f64 {
        self.bending_length().min(3.0 * self.shear_length())
    }

    /// What the solver is given, with elements of order 1 to 8. The displacement is that of the grip, whatever spring moves it.
    pub fn problem(&self, form: Form, order: usize) -> Problem {
        let (section, law, width) = (self.section(), self.line_law(), self.strip.width);
        let r0 = self.adhesion.equilibrium_distance;
        let process_length = 0.7 * self.process_length();
        // the free end may come to stand on its edge, a wedge whose attraction is concentrated on a part of r0
        let edge = (0.36 * process_length).min(0.25 * r0);
        let mut foci = vec![Focus { center: 0.0, length: edge, weight: 0.8 }];
        if self.grip.rotation == Hold::Fixed {
            foci.push(Focus { center: self.strip.length, length: process_length, weight: 0.2 });
        }
        let rotation_scale = (r0 / process_length).min(1.0);
        let sliding_held = self.grip.horizontal == Hold::Fixed;
        let turning_held = self.grip.rotation == Hold::Fixed;
        let (chain, lead): (Box<dyn Chain>, usize) = match (form, sliding_held) {
            (Form::TwoField, false) => (two_field(ReducedBeam::<false> { section, law, width }, order), 0),
            (Form::TwoField, true) => (two_field(ReducedBeam::<true> { section, law, width }, order), 0),
            // held at x(0) = 0, which with a sliding grip carries no force
            (Form::ThreeField, _) => {
                (three_field(ReissnerBeam { section, law, width }, order, [Some(0.0), None, None]), 1)
            }
        };
        let mut held = [false; MOST_FIELDS];
        let mut scale = [r0; MOST_FIELDS];
        held[lead + 1] = turning_held;
        scale[lead + 1] = rotation_scale;
        if form == Form::ThreeField {
            held[0] = sliding_held;
        }
        Problem {
            chain,
            length: self.strip.length,
            rest: RestCurve::straight(0.0, law.rest_gap(), 0.0),
            driven: lead,
            rotation: lead + 1,
            held,
            compliance: 0.0,
            scale,
            force_scale: (width * law.rest_energy()).abs(),
            round_off: 0.0,
            rest_adhesion: width * law.rest_energy(),
            mesh: Mesh::Moving,
            fixed_foci: foci,
            process_length,
            height: self.strip.height,
            sees_tilt: law.line_load != LineLoad::AxisGap,
            conservative: law.has_potential(),
        }
    }
}
