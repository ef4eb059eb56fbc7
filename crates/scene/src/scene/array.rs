//! An array of setae as data: the table `setae`, and what they stand on, `patch`, `lamella` or `toe`.

use peelkit::study::coarsening::SetaLaw;
use peelkit::toe::Scatter;

/// What a load on a band is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum BandLoad {
    /// A force at the angle of `drive`
    #[default]
    Force,
    /// A moment that turns the end off the ground
    Moment,
    /// A moment that presses the end
    Press,
}

pub(crate) const LOADS: &[(&str, BandLoad)] =
    &[("force", BandLoad::Force), ("moment", BandLoad::Moment), ("press", BandLoad::Press)];

/// Setae and what they stand on, as a scene gives it. Lengths in nm, forces in nN.
#[derive(Clone, Debug, PartialEq)]
pub struct ArrayTable {
    /// How many rows
    pub rows: usize,
    /// Setae in a row
    pub columns: usize,
    /// From seta to seta
    pub pitch: f64,
    /// Of the shaft of a seta
    pub diameter: f64,
    /// Of a seta along the normal, nN/nm
    pub stiffness: f64,
    /// The same along the ground; none: it carries nothing there
    pub tangential_stiffness: Option<f64>,
    /// How far it holds
    pub reach: f64,
    /// As far as what it softens; none: it is brittle
    pub last_reach: Option<f64>,
    /// Along what its reach is measured, rad from the ground
    pub exit_angle: f64,
    /// The law of a resolved seta; none: the numbers above
    pub fitted: Option<FittedSeta>,
    /// The seta whose law that has to be
    pub seta: Option<SetaOfLaw>,
    /// F_n = F_s tan α is the most that a seta holds; for the critical angle of a lamella alone
    pub cone_angle: Option<f64>,
    /// How setae differ
    pub scatter: Scatter,
    /// The same as a number
    pub seed: f64,
    /// Of a seta, for the warning about bunching
    pub length: Option<f64>,
    /// GPa
    pub youngs_modulus: Option<f64>,
    /// nN/nm
    pub surface_energy: Option<f64>,
    /// A rigid backing
    pub patch: Option<PatchTable>,
    /// A band; of a toe each of them
    pub lamella: Option<LamellaTable>,
    /// A pad
    pub toe: Option<ToeTable>,
}

/// The law of a resolved seta.
#[derive(Clone, Debug, PartialEq)]
pub enum FittedSeta {
    /// One that was read
    Known {
        /// Its potential and its exit
        law: SetaLaw,
        /// The text that it was read from
        text: String,
    },
    /// One that is not made yet
    Missing {
        /// Its folder, as the scene names it
        folder: String,
        /// What is not there, in words
        why: String,
    },
}

/// One seta, whose law an array takes.
#[derive(Clone, Debug, PartialEq)]
pub struct SetaOfLaw {
    /// Its scene
    pub text: String,
    /// What that says of the seta and its tips, a line a key
    pub lines: Vec<String>,
}

/// A rigid backing.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PatchTable {
    /// How far it is pressed first
    pub press: f64,
    /// Radius of the dome that carries the setae; none: it is flat
    pub dome_radius: Option<f64>,
}

/// A band.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LamellaTable {
    /// Of the band
    pub thickness: f64,
    /// GPa
    pub youngs_modulus: f64,
    /// In front of the first row
    pub overhang: f64,
    /// Row at which it is pulled, from 1 on; none: its end
    pub pulled_at: Option<usize>,
    /// What grows there
    pub load: BandLoad,
    /// Tension in which it adheres, for the steady force
    pub pretension: f64,
}

/// A pad.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ToeTable {
    /// How many
    pub lamellae: usize,
    /// From one to the next
    pub pitch: f64,
    /// Of the pad
    pub thickness: f64,
    /// GPa
    pub youngs_modulus: f64,
    /// Row at which a lamella is joined to the pad, from 1 on; none: it is rigid
    pub joined_at: Option<usize>,
}

impl Default for ArrayTable {
    /// The setae of a tokay gecko, as sliding tips hold them.
    fn default() -> Self {
        Self {
            rows: 60,
            columns: 360,
            pitch: 8330.0,
            diameter: 4200.0,
            stiffness: 0.0884,
            tangential_stiffness: None,
            reach: 5140.0,
            last_reach: None,
            exit_angle: 90.0 * 1f64.to_radians(),
            fitted: None,
            seta: None,
            cone_angle: None,
            scatter: Scatter::default(),
            seed: 0.0,
            length: None,
            youngs_modulus: None,
            surface_energy: None,
            patch: None,
            lamella: None,
            toe: None,
        }
    }
}

impl Default for LamellaTable {
    fn default() -> Self {
        Self {
            thickness: 30_000.0,
            youngs_modulus: 1.5,
            overhang: 0.0,
            pulled_at: None,
            load: BandLoad::default(),
            pretension: 0.0,
        }
    }
}

impl Default for ToeTable {
    fn default() -> Self {
        Self { lamellae: 12, pitch: 500_000.0, thickness: 81_000.0, youngs_modulus: 1.5, joined_at: None }
    }
}

impl ArrayTable {
    /// With all that setae may stand on, as a list of keys shows it.
    pub(crate) fn of_all() -> Self {
        let (patch, lamella, toe) =
            (Some(PatchTable::default()), Some(LamellaTable::default()), Some(ToeTable::default()));
        Self { patch, lamella, toe, ..Self::default() }
    }

    /// The rigid backing, which it is given where it has none.
    pub(crate) fn patch_table(&mut self) -> &mut PatchTable {
        self.patch.get_or_insert_default()
    }

    /// The band, likewise.
    pub(crate) fn lamella_table(&mut self) -> &mut LamellaTable {
        self.lamella.get_or_insert_default()
    }

    /// The pad, likewise.
    pub(crate) fn toe_table(&mut self) -> &mut ToeTable {
        self.toe.get_or_insert_default()
    }
}
