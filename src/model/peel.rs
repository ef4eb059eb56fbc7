//! A beam on a flat half space, lifted at its right end.

use super::body::Body;
use super::body::geometry::Geometry;
use super::body::strip::Strip;
use super::ground::{Friction, Ground};
use super::step::{Moved, Step};
use crate::adhesion::friction::dahl::FrictionLaw;
use crate::adhesion::levels::half_space::HalfSpace;
use crate::adhesion::section::law::{Attraction, Law};
use crate::adhesion::section::line_load::{LineLaw, LineLoad};
use crate::adhesion::section::sheared::ShearedLaw;
use crate::adhesion::spatial_section::section::SectionShape;
use crate::beam::bonded_beam::BondedBeam;
use crate::beam::grip_state::GripState;
use crate::beam::material::yielding::FilmLaw;
use crate::beam::section::{Material, Section};
use crate::beam::varying::BeamGeometry;
use crate::solve::problem::Direction;
use serde::{Deserialize, Serialize};
use std::f64::consts::FRAC_PI_2;
use std::sync::Arc;

/// The adhesion between the beam and the half space.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Adhesion {
    /// nN·nm = aJ
    pub hamaker_constant: f64,
    /// r0 of the pair potential, nm
    pub equilibrium_distance: f64,
    /// The adhesion model
    pub attraction: Attraction,
    /// Work of adhesion of a cohesive law, J/m²; none: that of the half space
    pub work: Option<f64>,
    /// Strength of a cohesive law, GPa; none: that of the half space
    pub strength: Option<f64>,
    /// Shear strength of a cohesive law, GPa; none: it holds nothing along the ground
    #[serde(default)]
    pub shear_strength: Option<f64>,
    /// Work that slip along the ground takes, J/m², beside a shear strength; none: that of opening
    #[serde(default)]
    pub shear_work: Option<f64>,
    /// η of Benzeggagh and Kenane, by which a work in shear mixes with that of opening, from 1 to 8; none: the linear criterion
    #[serde(default)]
    pub mixing_exponent: Option<f64>,
    /// Whether a face that has opened or slipped and comes back is held as before. A cohesive law that does not heal unloads to where it was
    /// closed, and what it has taken stays spent.
    #[serde(default = "heals")]
    pub healing: bool,
    /// Whether the contact moment acts beside the line force
    pub line_load: LineLoad,
    /// Whether the attraction of the upper surface is included (the r2 terms).
    pub far_face: bool,
}

/// What lets go heals, unless it is said that it does not.
const fn heals() -> bool {
    true
}

impl Default for Adhesion {
    /// That of the paper: A_H = 1e-19 J, r0 = 0.4 nm, as [`Adhesion::of_half_space`] has it.
    fn default() -> Self {
        Self::of_half_space(0.1, 0.4)
    }
}

impl Adhesion {
    /// Of the half space's body force, with line force and moment and both faces: A_H (aJ) and r0 (nm).
    pub fn of_half_space(hamaker_constant: f64, equilibrium_distance: f64) -> Self {
        Self {
            hamaker_constant,
            equilibrium_distance,
            attraction: Attraction::BodyForce,
            work: None,
            strength: None,
            shear_strength: None,
            shear_work: None,
            mixing_exponent: None,
            healing: true,
            line_load: LineLoad::Full,
            far_face: true,
        }
    }

    /// The line load per width on a section of this height, nm.
    pub(crate) fn line_law(&self, height: f64) -> LineLaw {
        let half_space = self.half_space();
        let law = self.attraction.law(&half_space, self.work, self.strength);
        LineLaw { half_space, height, law, line_load: self.line_load, far_face: self.far_face }
    }

    /// The same of a face that slides.
    #[must_use]
    pub fn sliding(&self) -> Self {
        Self { shear_strength: None, shear_work: None, mixing_exponent: None, ..*self }
    }

    /// The law with what holds along the ground, if it has a shear strength.
    pub(crate) fn sheared_law(&self) -> Option<ShearedLaw> {
        let law = self.attraction.law(&self.half_space(), self.work, self.strength);
        match (law, self.shear_strength) {
            (Law::Cohesive(cohesive), Some(strength)) => {
                Some(ShearedLaw::new(cohesive, strength, self.shear_work).with_exponent(self.mixing_exponent))
            }
            _ => None,
        }
    }

    /// The law of a face that is held along the ground, does not heal, or `yields` with its film, if it is cohesive.
    fn face_law(&self, yields: bool) -> Option<ShearedLaw> {
        let sliding = || match self.attraction.law(&self.half_space(), self.work, self.strength) {
            Law::Cohesive(cohesive) if !self.healing || yields => Some(ShearedLaw::sliding(cohesive)),
            _ => None,
        };
        self.sheared_law().or_else(sliding)
    }

    /// Whether the Hamaker constant changes nothing: under a cohesive law with a work of adhesion and a strength of its own.
    pub fn needs_no_hamaker_constant(&self) -> bool {
        self.own_work_and_strength().is_some()
    }

    /// Work of adhesion (nN/nm) and strength (nN/nm²) of a cohesive law that takes neither from the half space.
    pub fn own_work_and_strength(&self) -> Option<[f64; 2]> {
        match self.attraction.table() {
            Some(table) => Some([table.work(), table.strength()]),
            None => self.work.zip(self.strength).filter(|_| self.attraction.is_cohesive()).map(<[f64; 2]>::from),
        }
    }

    /// The pair distance r0 of a cohesive law with a work of adhesion and a strength of its own where none is given, nm: w/(10 σ), a tenth of the opening
    /// that takes the work at the strength. It changes neither forces nor openings, only where the beam lies at rest, at 0.64 r0. It is small beside the
    /// opening, so that what is nearer than 2 r0 has not come off yet, and not so small that the gap at rest is lost in the round-off of lengths of the
    /// beam.
    pub fn distance_of_work_and_strength(&self) -> Option<f64> {
        self.own_work_and_strength().map(|[work, strength]| 0.1 * work / strength)
    }

    /// The substrate.
    pub fn half_space(&self) -> HalfSpace {
        HalfSpace { hamaker_constant: self.hamaker_constant, equilibrium_distance: self.equilibrium_distance }
    }
}

/// What the grip does with one degree of freedom of the right end.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Hold {
    #[default]
    /// It is without a force or moment
    Free,
    /// It stays, or moves as the drive says
    Fixed,
}

/// The grip at S = L.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Grip {
    /// Of θ(L)
    pub rotation: Hold,
    /// Across the pull: free, so that the force points along the pull, or held, so that the grip moves along the pull. Where that is
    /// straight up, across it is horizontal.
    pub horizontal: Hold,
    /// k of a spring between the grip and the machine that moves it, nN/nm; none: the machine moves the grip itself
    pub stiffness: Option<f64>,
    /// Pretension, nN: the strip adheres stretched by this force, constrained normal to the pull direction from then on; none: no pretension
    pub pretension: Option<f64>,
}

impl Default for Grip {
    /// [`Grip::FREE`]
    fn default() -> Self {
        Self::FREE
    }
}

impl Grip {
    /// Free to turn and to move across the pull, without a spring.
    pub const FREE: Self = Self { rotation: Hold::Free, horizontal: Hold::Free, stiffness: None, pretension: None };
}

/// How the grip is moved.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Pull {
    /// α, of the pull to the substrate, rad: 0 along the substrate, away from the body; π/2 straight up; π backwards, over the body.
    /// The free end stays at x = 0, where it is held as far as the pull has a horizontal part; with friction, that alone holds it.
    pub angle: f64,
    /// How far the grip turns as it goes, rad/nm: in a grip that holds the rotation, that is θ_rest + `turn` u.
    pub turn: f64,
}

impl Default for Pull {
    /// [`Pull::UP`]
    fn default() -> Self {
        Self::UP
    }
}

impl Pull {
    /// Straight up.
    pub const UP: Self = Self { angle: FRAC_PI_2, turn: 0.0 };

    /// Its direction; straight up is that exactly.
    pub fn direction(self) -> Direction {
        if (self.angle - FRAC_PI_2).abs() < ROUNDED {
            return Direction::UP;
        }
        let (up, along) = self.angle.sin_cos();
        Direction { along, up }
    }
}

/// An angle that differs from a right one by less, rad, is that, rounded.
const ROUNDED: f64 = 1e-12;

/// A body, its adhesion, its grip and how that is moved: plain data, which [`PeelModel::check`] looks at before anything is computed.
///
/// It is written and read by serde, and the same to the last bit after that; a law of the user's own cannot be written.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct PeelModel {
    /// The beam
    pub body: Body,
    /// What attracts it to the ground
    pub adhesion: Adhesion,
    /// Which unknowns of its end are constrained
    pub grip: Grip,
    /// Where its end is moved
    pub pull: Pull,
    /// What the grip does before, one after the other.
    pub steps: Vec<Step>,
    /// What it adheres to
    pub ground: Ground,
    /// What resists sliding
    pub friction: Friction,
    /// Where it is peeled in space; none: in the plane
    #[serde(default)]
    pub space: Option<Space>,
}

/// Which unknowns a node has.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Form {
    /// y and θ; x is minimised out, the horizontal force is one number. Exact on a flat substrate without friction.
    #[default]
    TwoField,
    /// ξ = x - S, y and θ.
    ThreeField,
}

impl From<&Self> for PeelModel {
    fn from(model: &Self) -> Self {
        model.clone()
    }
}

impl PeelModel {
    /// Pulled straight up, on flat ground without friction, with nothing done before.
    pub fn of(body: Body, adhesion: Adhesion, grip: Grip) -> Self {
        let (ground, friction) = (Ground::default(), Friction::NONE);
        Self { body, adhesion, grip, pull: Pull::UP, steps: Vec::new(), ground, friction, space: None }
    }

    /// The strip, where it is one.
    pub fn strip(&self) -> Option<&Strip> {
        if let Body::Strip(strip) = &self.body { Some(strip) } else { None }
    }

    /// Whether its sections carry a horizontal force: with a grip that is held across a pull straight up, or another pull, or
    /// on ground that is not flat, or when the grip moves along the substrate before.
    pub(crate) fn has_horizontal_force(&self) -> bool {
        let dragged = self.steps.iter().any(|step| step.moves(Moved::Place));
        dragged
            || self.grip.horizontal == Hold::Fixed
            || self.pull.direction() != Direction::UP
            || !self.ground.substrate.is_flat()
            || self.adhesion.shear_strength.is_some()
    }

    /// The form in which it can be solved where another is asked for: on ground that is not flat, where it does not slide freely or does not heal,
    /// where its stretch is not linear, and in space with x.
    pub(crate) fn form(&self, asked: Form) -> Form {
        let flat = self.ground.substrate.is_flat() && self.space.is_none();
        let free = self.tangential_stiffness().is_none() && self.adhesion.healing && !self.yields();
        let reducible = flat && free && self.material().stretch.is_linear();
        if reducible { asked } else { Form::ThreeField }
    }

    /// Whether its film yields.
    pub fn yields(&self) -> bool {
        self.material().yield_strength.is_some()
    }

    /// Whether its adhesive holds a beam in the plane along the ground.
    pub(crate) fn is_held(&self) -> bool {
        self.space.is_none() && self.adhesion.sheared_law().is_some()
    }

    /// How its sections yield, of a strip that does.
    pub(crate) fn film_law(&self) -> Option<FilmLaw> {
        self.material().film_law(&self.section())
    }

    /// The law of a face that is held along the ground, does not heal, or is that of a film that yields, if it is cohesive.
    pub(crate) fn face_law(&self) -> Option<ShearedLaw> {
        self.adhesion.face_law(self.yields())
    }

    /// Whether what acts on it is the gradient of an energy, but for friction.
    pub fn has_potential(&self) -> bool {
        self.line_law().has_potential() && self.adhesion.sheared_law().is_none_or(|law| law.has_potential())
    }

    /// How far a grip has come along the pull, nm, and its force along it, nN; none where the pull has a part along the substrate and the grip is free
    /// there.
    pub fn along_pull(&self, grip: &GripState) -> Option<[f64; 2]> {
        let direction = self.pull.direction();
        let (sin, cos) = self.space.map_or(0.0, |space| space.azimuth).sin_cos();
        let place = grip.in_space.unwrap_or_default();
        let forces = grip.forces.in_space.unwrap_or_default();
        let x = if direction.along == 0.0 { 0.0 } else { grip.x? };
        let level = |x: f64, z: f64| x * cos + z * sin;
        let displacement = direction.ahead(level(x, place.z), grip.y);
        Some([displacement, direction.ahead(level(grip.forces.horizontal, forces.lateral), grip.forces.vertical)])
    }

    /// The law of its friction, if there is any.
    pub fn friction_law(&self) -> Option<FrictionLaw> {
        self.friction.law(self.adhesion.half_space())
    }

    /// k, the stiffness along the ground of what lies on it, by friction or by the shear strength of a cohesive law, nN/nm³; none where it slides
    /// freely.
    pub(crate) fn tangential_stiffness(&self) -> Option<f64> {
        let sheared = || self.adhesion.sheared_law().map(|law| law.stiffness());
        self.friction_law().map(|law| law.stiffness()).or_else(sheared)
    }

    /// Length over which a strip that does not slide freely takes over a force along it, (EA/bk)^(1/2), of the free end, nm.
    pub(crate) fn shear_lag_length(&self) -> Option<f64> {
        self.tangential_stiffness().map(|k| (self.section().axial / (self.free_end().0 * k)).sqrt())
    }

    /// The same of a strip that friction holds, which may begin to slide anywhere.
    pub(crate) fn sticking_length(&self) -> Option<f64> {
        self.shear_lag_length().filter(|_| self.friction.strength.is_some())
    }

    /// The least length over which what happens at the front changes, nm.
    pub(crate) fn feature_length(&self) -> f64 {
        self.sticking_length().unwrap_or(f64::INFINITY).min(self.process_length())
    }

    /// The same of how far a face has opened and slipped.
    pub(crate) fn opening_length(&self) -> f64 {
        let lag = self.shear_lag_length().filter(|_| self.adhesion.shear_strength.is_some());
        lag.unwrap_or(f64::INFINITY).min(self.process_length())
    }

    /// Its geometry and material.
    fn geometry(&self) -> &dyn Geometry {
        self.body.geometry()
    }

    /// Whether it is straight in its stress-free configuration, and its section the same everywhere.
    pub fn is_uniform(&self) -> bool {
        self.geometry().is_uniform()
    }

    /// How the body varies along its length, where it does.
    pub(super) fn contour(&self) -> Option<Arc<dyn BeamGeometry>> {
        (!self.is_uniform()).then(|| self.geometry().shared())
    }

    /// Where elements have to end, nm.
    pub fn breaks(&self) -> Vec<f64> {
        self.geometry().breaks()
    }

    /// Whether it is a strip of layers.
    pub fn has_layers(&self) -> bool {
        self.strip().is_some_and(|strip| strip.layers.is_some())
    }

    /// Thickness over the height h of the sections: 1, but of layers, whose h is twice the distance of the adhering face from the axis.
    pub fn thickness_over_height(&self) -> f64 {
        self.geometry().thickness_over_height()
    }

    /// What the body is made of.
    pub fn material(&self) -> Material {
        self.geometry().material()
    }

    /// L, nm
    pub fn length(&self) -> f64 {
        self.geometry().length()
    }

    /// Width and height of the free end, nm.
    pub fn free_end(&self) -> (f64, f64) {
        let (_, width, height) = self.section_at(0.0);
        (width, height)
    }

    /// EA, GA_s and EI at S, nm, with the adhering width and the height there, nm.
    pub fn section_at(&self, place: f64) -> (Section, f64, f64) {
        let outline = self.geometry().at(place);
        let (width, height) = (outline.width, outline.height[0]);
        (self.material().section(width, height, outline.roundness), self.geometry().adhering(place, width), height)
    }

    /// EA, GA_s and EI of the free end.
    pub fn section(&self) -> Section {
        self.section_at(0.0).0
    }

    /// The line load per width on the free end.
    pub fn line_law(&self) -> LineLaw {
        self.adhesion.line_law(self.free_end().1)
    }

    /// Its bonded section at S (nm) on flat ground, for when that loses its stability.
    pub fn bonded_beam(&self, place: f64) -> BondedBeam {
        let (section, width, height) = self.section_at(place);
        BondedBeam::of(section, self.material().stretch, &self.adhesion.line_law(height), width)
    }

    /// Decay length (EI/k)^(1/4) of the free end as a bending beam on the adhesion's stiffness k at rest, nm.
    pub(crate) fn bending_length(&self) -> f64 {
        (self.section().bending / self.rest_stiffness()).powf(0.25)
    }

    /// k, the adhesion's stiffness at rest at the free end, nN/nm².
    fn rest_stiffness(&self) -> f64 {
        self.line_law().rest_stiffness() * self.free_end().0
    }

    /// Decay length (GA_s/k)^(1/2) of the free end as a shear beam on the adhesion's stiffness k at rest, nm.
    pub(crate) fn shear_length(&self) -> f64 {
        (self.section().shear / self.rest_stiffness()).sqrt()
    }

    /// Length of the process zone, nm: that of a bending beam, or a few times that of a shear beam where that is shorter.
    pub fn process_length(&self) -> f64 {
        self.bending_length().min(3.0 * self.shear_length())
    }

    /// How far the grip goes until it has moved a section by the scale of its gap, or has turned it over the length of the process zone by as much, nm.
    pub(crate) fn first_way(&self) -> f64 {
        let (gap, process) = (self.line_law().gap_scale(), self.process_length());
        gap.min(process).min((gap / process).min(1.0) / self.pull.turn.abs())
    }

    /// How much longer a strip is under its pretension, nm.
    pub(super) fn prestretch(&self) -> f64 {
        let strain = |tension: f64| self.material().stretch.strain(tension / self.section().axial);
        self.grip.pretension.map_or(0.0, |tension| strain(tension) * self.length())
    }
}

/// What a model in space has besides one in the plane. Displacements and angles count from rest.
///
/// The ground is without friction: what neither it nor the grip holds is held at the left end, which is x and z of the axis, its yaw unless
/// the grip holds that of its own end or its place sideways, and its roll where the section is a disc and the grip lets it roll.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Space {
    /// Direction of the pull along the substrate, rad: 0 along the body, away from it; π/2 sideways, along z
    pub azimuth: f64,
    /// Of the place normal to the vertical plane of the pull
    pub lateral: Hold,
    /// Of the roll about the axis of the right end
    pub roll: Hold,
    /// Of the yaw of the right end
    pub yaw: Hold,
    /// Outline of the section of a strip; other bodies are as round as their outline says and adhere as rectangles.
    pub section: SectionShape,
}
