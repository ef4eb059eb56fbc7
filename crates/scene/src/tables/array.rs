//! An array of setae: what of it cannot be computed, and what is computed of it.

use crate::error::{Origin, SceneError, ValueError};
use crate::key::kind::Setting;
use crate::scene::Scene;
use crate::scene::array::{ArrayTable, BandLoad, FittedSeta};
use crate::value::form::Form;
use crate::value::seta_law::read_seta_law;
use crate::value::{Fault, Value};
use peelkit::analytic::{pretensioned_force, self_peeling_tension};
use peelkit::study::coarsening::{ExitPlane, SetaSheet};
use peelkit::toe::{
    ArrayDrive, ArrayError, Backing, BandSection, Lamella, Patch, PatchStep, RootLaw, Scatter, SetaArray, Toe,
};
use std::f64::consts::FRAC_PI_2;
use std::ops::Range;

/// The table of the setae.
pub(crate) const TABLE: &str = "setae";

/// `law`
pub(crate) static LAW: Setting = Setting {
    takes: "the name of a folder in quotes that `peel coarsen` of a seta has written, beside the scene, or the text of its seta_law.toml",
    brief: "a folder",
    example: "\"../out/seta-law\"",
    form: || Form::Text,
    read: |scene, value, _| {
        let Value::Text(text) = value else {
            return Err(Fault::whole(format!("is {value}, and takes the name of a folder in quotes")));
        };
        let (law, text) = read_seta_law(&scene.name, text).map_err(Fault::whole)?;
        scene.array_table().fitted = Some(FittedSeta { law, text });
        Ok(())
    },
    write: |scene, _| Some(Value::Text(scene.array.as_ref()?.fitted.as_ref()?.text.clone())),
};

/// That a scene is one of an array, where something else is asked for.
pub(crate) fn refused(file: &Origin, header: Range<usize>) -> SceneError {
    let problem = ValueError::new(
        "is a table of an array of setae, and here a single beam is peeled",
        "Give the scene to `peel run`, `sweep`, `optimise` or `uncertainty`.",
    );
    file.error(header, &format!("[{TABLE}]"), problem)
}

impl ArrayTable {
    /// The law of a seta.
    pub fn law(&self) -> RootLaw {
        if let Some(fitted) = &self.fitted {
            return RootLaw::Fitted(fitted.law.clone());
        }
        let Self { stiffness, reach, .. } = *self;
        let upright = (self.exit_angle - FRAC_PI_2).abs() < 1e-12;
        match (self.last_reach, self.tangential_stiffness) {
            (Some(last), _) => RootLaw::Softening { stiffness, first: reach, last },
            (None, None) if upright => RootLaw::Spring { stiffness, reach },
            (None, along) => {
                let (sin, cos) = self.exit_angle.sin_cos();
                let direction = if upright { [0.0, 1.0] } else { [cos, sin] };
                let exit = ExitPlane { direction, distance: reach };
                RootLaw::Held { stiffness: [[along.unwrap_or(0.0), 0.0], [0.0, stiffness]], exit }
            }
        }
    }

    /// The most that a seta holds where it is lifted straight, nN; of a law by numbers along its exit. None where a lift does not lead to the exit.
    pub fn strength(&self) -> Option<f64> {
        let Some(FittedSeta { law, .. }) = &self.fitted else { return Some(self.stiffness * self.reach) };
        let nearer = law.exit.direction[1];
        let at = [0.0, law.exit.distance / nearer];
        (nearer > 0.0).then(|| law.response(SetaSheet::Adhering, at).force[1])
    }

    fn scatter(&self) -> Scatter {
        Scatter { seed: self.seed as u64, ..self.scatter }
    }

    /// The width of a band, nm.
    pub fn width(&self) -> f64 {
        self.columns as f64 * self.pitch
    }

    /// The band of a lamella, or each one of a toe.
    pub fn band(&self) -> Option<Lamella> {
        let table = self.lamella?;
        Some(Lamella {
            rows: self.rows,
            columns: self.columns,
            pitch: self.pitch,
            section: BandSection::rectangular(self.width(), table.thickness, table.youngs_modulus),
            law: self.law(),
            scatter: self.scatter(),
            overhang: table.overhang,
            pulled_at: table.pulled_at.map(|row| row - 1),
        })
    }

    /// Γb, nN: the work of a row's setae over their pitch. None of a law whose exit is not above where it is at rest.
    pub fn peeling_energy(&self) -> Option<f64> {
        Some(self.law().work()? * self.columns as f64 / self.pitch)
    }

    /// The force of the band as a tape that peels steadily at an angle, with its tension, nN.
    pub fn steady_force(&self, angle: f64) -> Option<f64> {
        let (band, table) = (self.band()?, self.lamella?);
        pretensioned_force(self.peeling_energy()?, band.section.axial, table.pretension, angle)
    }
}

impl Scene {
    /// The array of a table, with its load.
    pub fn seta_array(&self, table: &ArrayTable) -> Option<SetaArray> {
        let angle = self.model.pull.angle;
        let angle = if (angle - FRAC_PI_2).abs() < 1e-12 { FRAC_PI_2 } else { angle };
        if let Some(patch) = table.patch {
            return Some(SetaArray::Patch(Patch {
                rows: table.rows,
                columns: table.columns,
                pitch: table.pitch,
                backing: patch.dome_radius.map_or(Backing::Flat, |radius| Backing::Dome { radius }),
                law: table.law(),
                scatter: table.scatter(),
                press: patch.press,
                steps: vec![PatchStep { angle, distance: None }],
            }));
        }
        let (band, lamella) = (table.band()?, table.lamella?);
        let drive = match lamella.load {
            BandLoad::Force => ArrayDrive::Force { angle },
            BandLoad::Moment => ArrayDrive::Moment,
            BandLoad::Press => ArrayDrive::Press,
        };
        let Some(toe) = table.toe else { return Some(SetaArray::Lamella(band, drive)) };
        let pad = BandSection::rectangular(table.width(), toe.thickness, toe.youngs_modulus);
        let joined_at = toe.joined_at.map(|row| row - 1);
        Some(SetaArray::Toe(Toe { lamellae: toe.lamellae, pitch: toe.pitch, pad, lamella: band, joined_at }, drive))
    }
}

/// What of the array of a scene is wrong: by the key of the scene.
pub(crate) fn problem(scene: &Scene) -> Option<(String, ValueError)> {
    let table = scene.array.as_ref()?;
    let of = |key: &str, found: String, remedy: &str| Some((key.to_owned(), ValueError::new(found, remedy.to_owned())));
    let um = |length: f64| length * 1e-3;
    if table.patch.is_some() && (table.lamella.is_some() || table.toe.is_some()) {
        let found = "is the table of a rigid backing, beside that of a band";
        return of("patch.press", found.into(), "Remove [patch], or [lamella] and [toe].");
    }
    if table.patch.is_none() && table.lamella.is_none() {
        let found = "stand on nothing".to_owned();
        return of(
            "setae.rows",
            found,
            "Add the table [patch], of a rigid backing, or [lamella], of a band; beside that [toe], of a pad.",
        );
    }
    if table.pitch < table.diameter {
        let found = format!(
            "is {:.4} µm, and the shaft of a seta {:.4} µm thick: they do not stand beside one another",
            um(table.pitch),
            um(table.diameter)
        );
        return of("setae.pitch", found, "Give a larger pitch, or thinner setae.");
    }
    if let (Some(_), Some(_)) = (table.last_reach, table.tangential_stiffness) {
        let found = "is given, and setae that soften carry nothing along the ground".to_owned();
        return of("setae.tangential_stiffness", found, "Remove it, or `last_reach`.");
    }
    if let (Some(lamella), Some(energy), Some(band)) = (table.lamella, table.peeling_energy(), table.band()) {
        let most = self_peeling_tension(energy, band.section.axial);
        if lamella.pretension >= most {
            let found = format!(
                "is {:.6} µN, and the band peels by itself from √(2 EA Γb) = {:.6} µN on",
                um(lamella.pretension),
                um(most)
            );
            return of("lamella.pretension", found, "Give less.");
        }
    }
    let error = scene.seta_array(table)?.check().err()?;
    if table.fitted.is_some() && error == ArrayError::NotLinear {
        let found = format!("cannot be computed: {error}");
        return of(
            "setae.law",
            found,
            "Give a law by `peel coarsen` of the seta with --degree 2, or stand the setae on a [patch].",
        );
    }
    let (key, remedy) = match &error {
        ArrayError::Unattached { .. } if table.patch.is_some_and(|patch| patch.dome_radius.is_some()) => {
            ("patch.press", "Give more.")
        }
        ArrayError::Unattached { .. } => ("setae.height_scatter", "Give less, or press a patch."),
        ArrayError::NoSuchRow { .. }
            if table.toe.is_some_and(|toe| toe.joined_at.is_some_and(|row| row > table.rows)) =>
        {
            ("toe.joined_at", "Give a row that a lamella has.")
        }
        ArrayError::NoSuchRow { .. } => ("lamella.pulled_at", "Give a row that it has."),
        ArrayError::TooFew { .. } | ArrayError::TooMany { .. } => ("setae.rows", "Give another number."),
        ArrayError::StrengthScatter { .. } => ("setae.strength_scatter", "Give less."),
        _ => ("setae.reach", "Give other numbers."),
    };
    of(key, format!("cannot be computed: {error}"), remedy)
}

/// What is doubtful of the setae of a table, a sentence each.
pub fn array_warnings(table: &ArrayTable) -> Vec<String> {
    let bunching = || {
        let (length, modulus, energy) = (table.length?, table.youngs_modulus?, table.surface_energy?);
        let gap = table.pitch - table.diameter;
        let longest = peelkit::analytic::bunching_length(0.5 * table.diameter, gap, modulus, 0.3, energy);
        (length > longest).then(|| {
            format!(
                "setae are {:.2} µm long, and from {:.2} µm on neighbours stick together; here they do not touch. Give shorter or stiffer setae, or a larger pitch",
                length * 1e-3,
                longest * 1e-3
            )
        })
    };
    bunching().into_iter().collect()
}
