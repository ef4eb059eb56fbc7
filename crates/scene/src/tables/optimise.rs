//! The table `optimise`: what each of its keys takes, and how it is read and written.

use super::bounded::{BETWEEN, bounded, entry, written};
use crate::error::nearest;
use crate::key::kind::{Key, Setting};
use crate::scene::Scene;
use crate::scene::studies::{FreeKey, FreeProfile, OptimisationTable, VolumeRule};
use crate::value::form::{Entry, Form};
use crate::value::quantity::{Dimension, parse_quantity};
use crate::value::{Fault, Value, quoted};
use peelkit::model::Range;
use peelkit::study::PeelQuantity;
use peelkit::study::optimisation::{Goal, ProfileDesign, SearchMethod};

const GOALS: &[(&str, Goal)] = &[("maximise", Goal::Maximise), ("minimise", Goal::Minimise)];
const VOLUMES: &[(&str, VolumeRule)] =
    &[("equal", VolumeRule::Equal), ("at-most", VolumeRule::AtMost), ("free", VolumeRule::Free)];
const METHODS: &[(&str, SearchMethod)] = &[
    ("quasi-newton", SearchMethod::QuasiNewton),
    ("sequential-quadratic", SearchMethod::SequentialQuadratic),
    ("derivative-free", SearchMethod::DerivativeFree),
];
const MOST_STARTS: usize = 1000;
const MOST_EVALUATIONS: usize = 100_000;
const LARGEST_SEED: usize = 9_007_199_254_740_992;

fn table(scene: &Scene) -> Option<&OptimisationTable> {
    scene.optimisation.as_ref()
}

fn named<T: PartialEq>(words: &[(&'static str, T)], value: &T) -> Option<Value> {
    words.iter().find(|(_, choice)| choice == value).map(|(word, _)| Value::Text((*word).to_owned()))
}

/// `objective`
pub(crate) static OBJECTIVE: Setting = Setting {
    takes: "a number of a run, by its name in summary.json, such as \"initiation_peak.force_nN\" or \"first_jump.work_aJ\"",
    brief: "a result",
    example: "\"initiation_peak.force_nN\"",
    form: || Form::Word(PeelQuantity::all().map(PeelQuantity::name).collect()),
    read: |scene, value, _| {
        let words: Vec<_> = PeelQuantity::all().map(|quantity| (quantity.name(), quantity)).collect();
        scene.optimisation_table().objective = Some(word(value, &words)?);
        Ok(())
    },
    write: |scene, _| Some(Value::Text(table(scene)?.objective?.name().to_owned())),
};

/// `goal`
pub(crate) static GOAL: Setting = Setting {
    takes: "\"maximise\" or \"minimise\"",
    brief: "maximise, minimise",
    example: "\"minimise\"",
    form: || Form::word(GOALS),
    read: |scene, value, _| {
        scene.optimisation_table().goal = word(value, GOALS)?;
        Ok(())
    },
    write: |scene, _| named(GOALS, &table(scene)?.goal),
};

/// `holding_angle`
pub(crate) static HOLDING_ANGLE: Setting = Setting {
    takes: "an angle with its unit in quotes (deg, rad), from 0 to 180 degrees; together with release_angle the objective is the ratio of \
            its values at the two angles of the pull",
    brief: "0 deg to 180 deg",
    example: "\"30 deg\"",
    form: || Form::Quantity(Dimension::Angle, Range::PULL_ANGLE),
    read: |scene, value, _| {
        scene.optimisation_table().holding_angle = Some(angle(value)?);
        Ok(())
    },
    write: |scene, _| Some(angle_value(table(scene)?.holding_angle?)),
};

/// `release_angle`
pub(crate) static RELEASE_ANGLE: Setting = Setting {
    takes: "an angle with its unit in quotes (deg, rad), from 0 to 180 degrees; it needs holding_angle",
    brief: "0 deg to 180 deg",
    example: "\"120 deg\"",
    form: || Form::Quantity(Dimension::Angle, Range::PULL_ANGLE),
    read: |scene, value, _| {
        scene.optimisation_table().release_angle = Some(angle(value)?);
        Ok(())
    },
    write: |scene, _| Some(angle_value(table(scene)?.release_angle?)),
};

fn angle_value(angle: f64) -> Value {
    Value::Text(format!("{angle} rad"))
}

/// `parameters`
pub(crate) static PARAMETERS: Setting = Setting {
    takes: "a list of tables, each with the `key` of a number of the scene and its bounds `from` and `to`",
    brief: "list of tables",
    example: "[{ key = \"strip.youngs_modulus\", from = \"0.1 GPa\", to = \"10 GPa\" }]",
    form: || Form::list(Form::Table(BETWEEN)),
    read: |scene, value, keys| {
        scene.optimisation_table().parameters = free_keys(value, keys)?;
        Ok(())
    },
    write: |scene, keys| {
        Some(Value::List(
            table(scene)?
                .parameters
                .iter()
                .map(|free| written(&free.path, Some(free.from), Some(free.to), keys))
                .collect(),
        ))
    },
};

/// `width`
pub(crate) static WIDTH: Setting = Setting {
    takes: "a table with the bounds `from` and `to` of the width along the body and, for smoothness, `slope`, the largest change of the \
            width from value to value over their distance",
    brief: "a table",
    example: "{ from = \"5 nm\", to = \"20 nm\", slope = 0.2 }",
    form: || Form::Table(FREE_PROFILE),
    read: |scene, value, _| {
        scene.optimisation_table().width = Some(profile(value)?);
        Ok(())
    },
    write: |scene, _| table(scene)?.width.as_ref().map(written_profile),
};

/// `height`
pub(crate) static HEIGHT: Setting = Setting {
    takes: "a table with the bounds `from` and `to` of the height along the body, of which `from` is the least thickness, and, for \
            smoothness, `slope`, the largest change of the height from value to value over their distance",
    brief: "a table",
    example: "{ from = \"2 nm\", to = \"10 nm\", slope = 0.1 }",
    form: || Form::Table(FREE_PROFILE),
    read: |scene, value, _| {
        scene.optimisation_table().height = Some(profile(value)?);
        Ok(())
    },
    write: |scene, _| table(scene)?.height.as_ref().map(written_profile),
};

/// `values`
pub(crate) static VALUES: Setting = Setting {
    takes: "a whole number from 5 to 40",
    brief: "5 to 40, whole",
    example: "10",
    form: || Form::Whole(*ProfileDesign::VALUES.start() as f64, *ProfileDesign::VALUES.end() as f64),
    read: |scene, value, _| {
        let range = ProfileDesign::VALUES;
        scene.optimisation_table().values = whole(value, *range.start(), *range.end())?;
        Ok(())
    },
    write: |scene, _| Some(Value::Number(table(scene)?.values as f64)),
};

/// `volume`
pub(crate) static VOLUME: Setting = Setting {
    takes: "\"equal\" or \"at-most\", to that of the scene, or \"free\"; without it \"equal\" with a profile and \"free\" without",
    brief: "equal, at-most, free",
    example: "\"equal\"",
    form: || Form::word(VOLUMES),
    read: |scene, value, _| {
        scene.optimisation_table().volume = Some(word(value, VOLUMES)?);
        Ok(())
    },
    write: |scene, _| named(VOLUMES, table(scene)?.volume.as_ref()?),
};

/// `method`
pub(crate) static METHOD: Setting = Setting {
    takes: "\"quasi-newton\" (without constraints), \"sequential-quadratic\" or \"derivative-free\"",
    brief: "quasi-newton, sequential-quadratic, derivative-free",
    example: "\"derivative-free\"",
    form: || Form::word(METHODS),
    read: |scene, value, _| {
        scene.optimisation_table().method = Some(word(value, METHODS)?);
        Ok(())
    },
    write: |scene, _| named(METHODS, table(scene)?.method.as_ref()?),
};

/// `starts`
pub(crate) static STARTS: Setting = Setting {
    takes: "a whole number from 1 to 1000",
    brief: "1 to 1000, whole",
    example: "4",
    form: || Form::Whole(1.0, MOST_STARTS as f64),
    read: |scene, value, _| {
        scene.optimisation_table().starts = whole(value, 1, MOST_STARTS)?;
        Ok(())
    },
    write: |scene, _| Some(Value::Number(table(scene)?.starts as f64)),
};

/// `evaluations`
pub(crate) static EVALUATIONS: Setting = Setting {
    takes: "a whole number from 1 to 1e5",
    brief: "1 to 1e5, whole",
    example: "50",
    form: || Form::Whole(1.0, MOST_EVALUATIONS as f64),
    read: |scene, value, _| {
        scene.optimisation_table().evaluations = whole(value, 1, MOST_EVALUATIONS)?;
        Ok(())
    },
    write: |scene, _| Some(Value::Number(table(scene)?.evaluations as f64)),
};

/// `neighbours`
pub(crate) static NEIGHBOURS: Setting = Setting {
    takes: "a whole number from 0 to 1e5",
    brief: "0 to 1e5, whole",
    example: "20",
    form: || Form::Whole(0.0, MOST_EVALUATIONS as f64),
    read: |scene, value, _| {
        scene.optimisation_table().neighbours = whole(value, 0, MOST_EVALUATIONS)?;
        Ok(())
    },
    write: |scene, _| Some(Value::Number(table(scene)?.neighbours as f64)),
};

/// `seed`
pub(crate) static SEED_OF_STARTS: Setting = Setting {
    takes: "a whole number from 0 to 2^53",
    brief: "0 to 2^53, whole",
    example: "1",
    form: || Form::Whole(0.0, LARGEST_SEED as f64),
    read: |scene, value, _| {
        scene.optimisation_table().seed = whole(value, 0, LARGEST_SEED)? as u64;
        Ok(())
    },
    write: |scene, _| Some(Value::Number(table(scene)?.seed as f64)),
};

/// `check`
pub(crate) static CHECK: Setting = Setting {
    takes: "true or false",
    brief: "true, false",
    example: "true",
    form: || Form::Flag,
    read: |scene, value, _| match value {
        Value::Flag(flag) => {
            scene.optimisation_table().check = *flag;
            Ok(())
        }
        value => Err(Fault::whole(format!("is {value}"))),
    },
    write: |scene, _| Some(Value::Flag(table(scene)?.check)),
};

/// The entries of a profile.
const FREE_PROFILE: &[Entry] = &[
    Entry::needed("from", || Form::Quantity(Dimension::Length, Range::Positive)),
    Entry::needed("to", || Form::Quantity(Dimension::Length, Range::Positive)),
    Entry::optional("slope", || Form::Number(Range::Positive)),
];

/// One of several words.
fn word<T: Copy>(value: &Value, words: &[(&'static str, T)]) -> Result<T, Fault> {
    let Value::Text(text) = value else { return Err(Fault::whole(format!("is {value}"))) };
    let found = words.iter().find(|(word, _)| word == text);
    let names: Vec<&str> = words.iter().map(|(word, _)| *word).collect();
    found.map(|(_, choice)| *choice).ok_or_else(|| {
        let guess = nearest(text, names.iter().copied());
        let guess = guess.map(|near| format!("; did you mean \"{near}\"?")).unwrap_or_default();
        Fault::whole(format!("is {}, which is none of {}{guess}", quoted(text), names.join(", ")))
    })
}

/// A whole number in a range.
fn whole(value: &Value, least: usize, most: usize) -> Result<usize, Fault> {
    match value {
        Value::Number(number) if number.fract() != 0.0 => Err(Fault::whole(format!("is {value}, which is not whole"))),
        Value::Number(number) if (least as f64..=most as f64).contains(number) => Ok(*number as usize),
        Value::Number(_) => Err(Fault::whole(format!("is {value}, which is out of range"))),
        value => Err(Fault::whole(format!("is {value}"))),
    }
}

/// An angle with its unit, rad.
fn angle(value: &Value) -> Result<f64, Fault> {
    measure(value, Dimension::Angle).map_err(|found| Fault::whole(format!("is {found}")))
}

fn measure(value: &Value, dimension: Dimension) -> Result<f64, String> {
    let Value::Text(text) = value else { return Err(format!("{value}, which is no text with a unit")) };
    parse_quantity(text, dimension)
        .map_err(|_| format!("{value}, which is no {dimension} with its unit ({})", dimension.units().join(", ")))
}

/// The free keys of a list.
fn free_keys(value: &Value, keys: &[Key]) -> Result<Vec<FreeKey>, Fault> {
    let Value::List(items) = value else { return Err(Fault::whole(format!("is {value}"))) };
    let one = |(item, value): (usize, &Value)| {
        let number = item + 1;
        let read = match value {
            Value::Table(entries) => {
                free_key(entries, keys).map_err(|found| format!("has in parameter {number} {found}"))
            }
            value => Err(format!("has as parameter {number} {value}, no table of its keys")),
        };
        read.map_err(|found| Fault::at(item, found))
    };
    items.iter().enumerate().map(one).collect()
}

fn free_key(entries: &[(String, Value)], keys: &[Key]) -> Result<FreeKey, String> {
    match bounded(entries, BETWEEN, keys)? {
        (key, Some(from), Some(to)) => Ok(FreeKey { path: key.path(), from, to }),
        (_, None, _) => Err("no `from`".into()),
        (_, _, None) => Err("no `to`".into()),
    }
}

/// The bounds of a profile.
fn profile(value: &Value) -> Result<FreeProfile, Fault> {
    let Value::Table(entries) = value else { return Err(Fault::whole(format!("is {value}"))) };
    let given = |name: &str| entry(entries, FREE_PROFILE, name);
    let length = |name: &str| {
        let value = given(name)?.ok_or_else(|| format!("no `{name}`"))?;
        measure(value, Dimension::Length).map_err(|found| format!("`{name}` = {found}"))
    };
    let slope = || match given("slope")? {
        None => Ok(None),
        Some(Value::Number(slope)) if *slope > 0.0 => Ok(Some(*slope)),
        Some(value) => Err(format!("`slope` = {value}, which is no number above zero")),
    };
    let read = || Ok(FreeProfile { from: length("from")?, to: length("to")?, slope: slope()? });
    read().map_err(|found: String| Fault::whole(format!("has {found}")))
}

/// A profile as a scene writes it.
fn written_profile(of: &FreeProfile) -> Value {
    let length = |number: f64| Value::Text(format!("{number} nm"));
    let mut entries = vec![("from".to_owned(), length(of.from)), ("to".to_owned(), length(of.to))];
    entries.extend(of.slope.map(|slope| ("slope".to_owned(), Value::Number(slope))));
    Value::Table(entries)
}
