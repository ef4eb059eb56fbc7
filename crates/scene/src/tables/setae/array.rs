//! An array of setae: what of it cannot be computed, and what is computed of it.

use crate::error::{Origin, SceneError, ValueError};
use crate::key::kind::{Key, Setting};
use crate::scene::array::{ArrayTable, BandLoad, FittedSeta, SetaOfLaw};
use crate::scene::{Described, Scene};
use crate::value::form::Form;
use crate::value::seta_law::{LawRead, other_seta, parse_seta_law, read_seta_law, read_seta_scene};
use crate::value::{Fault, Value};
use peelkit::analytic::{pretensioned_force, self_peeling_tension};
use peelkit::study::coarsening::{ExitPlane, SetaLawErrors, SetaLawOptions};
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
        let fitted = match read_seta_law(&scene.name, text).map_err(Fault::whole)? {
            LawRead::Known(law, text) => FittedSeta::Known { law: *law, text },
            LawRead::Missing(why) => FittedSeta::Missing { folder: text.clone(), why },
        };
        scene.array_table().fitted = Some(fitted);
        Ok(())
    },
    write: |scene, _| match scene.array.as_ref()?.fitted.as_ref()? {
        FittedSeta::Known { text, .. } => Some(Value::Text(text.clone())),
        FittedSeta::Missing { folder, .. } => Some(Value::Text(folder.clone())),
    },
};

/// `seta`
pub(crate) static SETA: Setting = Setting {
    takes: "the name of a file in quotes, the scene of the seta that `law` is of, beside the scene, or its text",
    brief: "a scene",
    example: "\"seta.toml\"",
    form: || Form::Text,
    read: |scene, value, keys| {
        let Value::Text(text) = value else {
            return Err(Fault::whole(format!("is {value}, and takes the name of a file in quotes")));
        };
        let seta = seta_of_law(&scene.name, text, keys).map_err(Fault::whole)?;
        scene.array_table().seta = Some(seta);
        Ok(())
    },
    write: |scene, _| Some(Value::Text(scene.array.as_ref()?.seta.as_ref()?.text.clone())),
};

/// The seta that a value gives by its scene, a text of several lines or a file beside the scene.
fn seta_of_law(scene: &str, value: &str, keys: &[Key]) -> Result<SetaOfLaw, String> {
    if value.trim().is_empty() {
        return Err("is empty".to_owned());
    }
    let refused = |shown: &str, error: &SceneError| format!("names {shown}, and there {error}. {}", error.remedy());
    // an array in it would be read for ever where it names itself
    let of_array = |text: &str| text.parse::<toml::Table>().is_ok_and(|table| table.contains_key(TABLE));
    let of_one = |shown: &str| format!("names {shown}, which is not the scene of a seta");
    let (seta, shown) = if value.contains('\n') {
        let shown = "a scene in this one";
        if of_array(value) {
            return Err(of_one(shown));
        }
        let seta = Scene::parse_without_files("the scene of `seta`", value, &[]);
        (seta.map_err(|error| refused(shown, &error))?, shown.to_owned())
    } else {
        let (text, shown) = read_seta_scene(scene, value)?;
        if of_array(&text) {
            return Err(of_one(&shown));
        }
        (Scene::parse_any(&shown, &text, &[]).map_err(|error| refused(&shown, &error))?, shown)
    };
    match seta.describes() {
        Described::Seta(_) => Ok(SetaOfLaw { lines: seta_lines(&seta, keys), text: seta.to_toml() }),
        _ => Err(of_one(&shown)),
    }
}

/// The tables of a scene that make a seta.
const OF_A_SETA: [&str; 3] = ["seta", "spatula", "adhesion"];

/// What a scene says of its seta and its tips, a line for each of these keys: the law of another seta has others.
pub fn seta_lines(scene: &Scene, keys: &[Key]) -> Vec<String> {
    let own = keys.iter().filter(|key| OF_A_SETA.contains(&key.table) && key.belongs_to(scene));
    let line = |key: &Key| {
        let value = match key.held(keys, scene)? {
            Value::Number(number) => format!("{number:?}"),
            other => other.to_string(),
        };
        Some(format!("{} = {value}", key.label()))
    };
    own.filter_map(line).collect()
}

/// What is wrong with the law of the setae beside the seta that it is to be of: by the key of the scene.
fn problem_of_law(table: &ArrayTable) -> Option<(String, ValueError)> {
    let of = |key: &str, found: String, remedy: &str| Some((key.to_owned(), ValueError::new(found, remedy.to_owned())));
    match (&table.fitted, &table.seta) {
        (None, Some(_)) => of(
            "setae.seta",
            "is given, and setae follow numbers, not the law of a seta".to_owned(),
            "Give `law`, the name of the folder of its law, which is made where it is missing, or remove `seta`.",
        ),
        (Some(FittedSeta::Missing { why, .. }), None) => of(
            "setae.law",
            why.clone(),
            "Make it by `peel coarsen SETA.toml --out FOLDER`, or name the scene of the seta by `seta = \"SETA.toml\"`: a run then makes it.",
        ),
        (Some(FittedSeta::Known { text, .. }), Some(seta)) => {
            let (_, lines) = parse_seta_law(text).ok()?;
            let other = other_seta(&lines, &seta.lines)?;
            of(
                "setae.law",
                format!("is the law of another seta: {other}"),
                "Name another folder, in which the law is made anew, or remove `seta`.",
            )
        }
        _ => None,
    }
}

/// That a scene is one of an array, where something else is asked for.
pub(crate) fn refused(file: &Origin, header: Range<usize>) -> SceneError {
    let problem = ValueError::new(
        "is a table of an array of setae, and here a single beam is peeled",
        "Give the scene to `peel run`, `sweep`, `optimise` or `uncertainty`.",
    );
    file.error(header, &format!("[{TABLE}]"), problem)
}

impl ArrayTable {
    /// The law of a seta; none where it is not made yet.
    pub fn law(&self) -> Option<RootLaw> {
        match &self.fitted {
            Some(FittedSeta::Known { law, .. }) => Some(RootLaw::Fitted(law.clone())),
            Some(FittedSeta::Missing { .. }) => None,
            None => Some(self.law_of_numbers()),
        }
    }

    fn law_of_numbers(&self) -> RootLaw {
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
        if self.fitted.is_none() {
            return Some(self.stiffness * self.reach);
        }
        Some(self.law()?.lifted()?.force)
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
            law: self.law()?,
            scatter: self.scatter(),
            overhang: table.overhang,
            pulled_at: table.pulled_at.map(|row| row - 1),
        })
    }

    /// Γb, nN: the work of a row's setae over their pitch. None of a law whose exit is not above where it is at rest.
    pub fn peeling_energy(&self) -> Option<f64> {
        Some(self.law()?.lifted()?.work * self.columns as f64 / self.pitch)
    }

    /// The force of the band as a tape that peels steadily at an angle, with its tension, nN.
    pub fn steady_force(&self, angle: f64) -> Option<f64> {
        let (band, table) = (self.band()?, self.lamella?);
        pretensioned_force(self.peeling_energy()?, band.section.axial, table.pretension, angle)
    }
}

impl Scene {
    /// The array of a table, with its load; none where its setae stand on nothing, or their law is not made yet.
    pub fn seta_array(&self, table: &ArrayTable) -> Option<SetaArray> {
        let angle = self.model.pull.angle;
        let angle = if (angle - FRAC_PI_2).abs() < 1e-12 { FRAC_PI_2 } else { angle };
        if let Some(patch) = table.patch {
            return Some(SetaArray::Patch(Patch {
                rows: table.rows,
                columns: table.columns,
                pitch: table.pitch,
                backing: patch.dome_radius.map_or(Backing::Flat, |radius| Backing::Dome { radius }),
                law: table.law()?,
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
    if let Some(problem) = problem_of_law(table) {
        return Some(problem);
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
    let law = || {
        let Some(FittedSeta::Known { law, .. }) = &table.fitted else { return None };
        let SetaLawErrors { peak, work, .. } = law.errors;
        (peak.max(work) > SetaLawOptions::default().tolerance).then(|| {
            format!(
                "the law of the setae has its peaks within {:.1} % of those of the resolved seta, and its works within {:.1} %. Make it with more sheets or of a higher degree",
                100.0 * peak,
                100.0 * work
            )
        })
    };
    bunching().into_iter().chain(law()).collect()
}
