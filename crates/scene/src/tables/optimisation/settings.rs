//! The keys of the table: what each takes, and how it is read and written.

use super::read::{FREE_KEY, FREE_PROFILE, angle, keys, profile, whole, word, written_key, written_profile};
use super::{OptimisationTable, VolumeRule, of};
use crate::form::Form;
use crate::key::kind::Setting;
use crate::scene::Scene;
use crate::value::quantity::Dimension;
use crate::value::{Fault, Value};
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
    read: |scene, value| {
        let words: Vec<_> = PeelQuantity::all().map(|quantity| (quantity.name(), quantity)).collect();
        of(scene).objective = Some(word(value, &words)?);
        Ok(())
    },
    write: |scene| Some(Value::Text(table(scene)?.objective?.name().to_owned())),
};

/// `goal`
pub(crate) static GOAL: Setting = Setting {
    takes: "\"maximise\" or \"minimise\"",
    brief: "maximise, minimise",
    example: "\"minimise\"",
    form: || Form::word(GOALS),
    read: |scene, value| {
        of(scene).goal = word(value, GOALS)?;
        Ok(())
    },
    write: |scene| named(GOALS, &table(scene)?.goal),
};

/// `holding_angle`
pub(crate) static HOLDING_ANGLE: Setting = Setting {
    takes: "an angle with its unit in quotes (deg, rad), from 0 to 180 degrees; together with release_angle the objective is the ratio of \
            its values at the two angles of the pull",
    brief: "0 deg to 180 deg",
    example: "\"30 deg\"",
    form: || Form::Quantity(Dimension::Angle, Range::PULL_ANGLE),
    read: |scene, value| {
        of(scene).holding_angle = Some(angle(value)?);
        Ok(())
    },
    write: |scene| Some(angle_value(table(scene)?.holding_angle?)),
};

/// `release_angle`
pub(crate) static RELEASE_ANGLE: Setting = Setting {
    takes: "an angle with its unit in quotes (deg, rad), from 0 to 180 degrees; it needs holding_angle",
    brief: "0 deg to 180 deg",
    example: "\"120 deg\"",
    form: || Form::Quantity(Dimension::Angle, Range::PULL_ANGLE),
    read: |scene, value| {
        of(scene).release_angle = Some(angle(value)?);
        Ok(())
    },
    write: |scene| Some(angle_value(table(scene)?.release_angle?)),
};

fn angle_value(angle: f64) -> Value {
    Value::Text(format!("{angle} rad"))
}

/// `parameters`
pub(crate) static PARAMETERS: Setting = Setting {
    takes: "a list of tables, each with the `key` of a number of the scene and its bounds `from` and `to`",
    brief: "list of tables",
    example: "[{ key = \"strip.youngs_modulus\", from = \"0.1 GPa\", to = \"10 GPa\" }]",
    form: || Form::list(Form::Table(FREE_KEY)),
    read: |scene, value| {
        of(scene).parameters = keys(value)?;
        Ok(())
    },
    write: |scene| Some(Value::List(table(scene)?.parameters.iter().map(written_key).collect())),
};

/// `width`
pub(crate) static WIDTH: Setting = Setting {
    takes: "a table with the bounds `from` and `to` of the width along the body and, for smoothness, `slope`, the largest change of the \
            width from value to value over their distance",
    brief: "a table",
    example: "{ from = \"5 nm\", to = \"20 nm\", slope = 0.2 }",
    form: || Form::Table(FREE_PROFILE),
    read: |scene, value| {
        of(scene).width = Some(profile(value)?);
        Ok(())
    },
    write: |scene| table(scene)?.width.as_ref().map(written_profile),
};

/// `height`
pub(crate) static HEIGHT: Setting = Setting {
    takes: "a table with the bounds `from` and `to` of the height along the body, of which `from` is the least thickness, and, for \
            smoothness, `slope`, the largest change of the height from value to value over their distance",
    brief: "a table",
    example: "{ from = \"2 nm\", to = \"10 nm\", slope = 0.1 }",
    form: || Form::Table(FREE_PROFILE),
    read: |scene, value| {
        of(scene).height = Some(profile(value)?);
        Ok(())
    },
    write: |scene| table(scene)?.height.as_ref().map(written_profile),
};

/// `values`
pub(crate) static VALUES: Setting = Setting {
    takes: "a whole number from 5 to 40",
    brief: "5 to 40, whole",
    example: "10",
    form: || Form::Whole(*ProfileDesign::VALUES.start() as f64, *ProfileDesign::VALUES.end() as f64),
    read: |scene, value| {
        let range = ProfileDesign::VALUES;
        of(scene).values = whole(value, *range.start(), *range.end())?;
        Ok(())
    },
    write: |scene| Some(Value::Number(table(scene)?.values as f64)),
};

/// `volume`
pub(crate) static VOLUME: Setting = Setting {
    takes: "\"equal\" or \"at-most\", to that of the scene, or \"free\"; without it \"equal\" with a profile and \"free\" without",
    brief: "equal, at-most, free",
    example: "\"equal\"",
    form: || Form::word(VOLUMES),
    read: |scene, value| {
        of(scene).volume = Some(word(value, VOLUMES)?);
        Ok(())
    },
    write: |scene| named(VOLUMES, table(scene)?.volume.as_ref()?),
};

/// `method`
pub(crate) static METHOD: Setting = Setting {
    takes: "\"quasi-newton\" (without constraints), \"sequential-quadratic\" or \"derivative-free\"",
    brief: "quasi-newton, sequential-quadratic, derivative-free",
    example: "\"derivative-free\"",
    form: || Form::word(METHODS),
    read: |scene, value| {
        of(scene).method = Some(word(value, METHODS)?);
        Ok(())
    },
    write: |scene| named(METHODS, table(scene)?.method.as_ref()?),
};

/// `starts`
pub(crate) static STARTS: Setting = Setting {
    takes: "a whole number from 1 to 1000",
    brief: "1 to 1000, whole",
    example: "4",
    form: || Form::Whole(1.0, MOST_STARTS as f64),
    read: |scene, value| {
        of(scene).starts = whole(value, 1, MOST_STARTS)?;
        Ok(())
    },
    write: |scene| Some(Value::Number(table(scene)?.starts as f64)),
};

/// `evaluations`
pub(crate) static EVALUATIONS: Setting = Setting {
    takes: "a whole number from 1 to 1e5",
    brief: "1 to 1e5, whole",
    example: "50",
    form: || Form::Whole(1.0, MOST_EVALUATIONS as f64),
    read: |scene, value| {
        of(scene).evaluations = whole(value, 1, MOST_EVALUATIONS)?;
        Ok(())
    },
    write: |scene| Some(Value::Number(table(scene)?.evaluations as f64)),
};

/// `neighbours`
pub(crate) static NEIGHBOURS: Setting = Setting {
    takes: "a whole number from 0 to 1e5",
    brief: "0 to 1e5, whole",
    example: "20",
    form: || Form::Whole(0.0, MOST_EVALUATIONS as f64),
    read: |scene, value| {
        of(scene).neighbours = whole(value, 0, MOST_EVALUATIONS)?;
        Ok(())
    },
    write: |scene| Some(Value::Number(table(scene)?.neighbours as f64)),
};

/// `seed`
pub(crate) static SEED_OF_STARTS: Setting = Setting {
    takes: "a whole number from 0 to 2^53",
    brief: "0 to 2^53, whole",
    example: "1",
    form: || Form::Whole(0.0, LARGEST_SEED as f64),
    read: |scene, value| {
        of(scene).seed = whole(value, 0, LARGEST_SEED)? as u64;
        Ok(())
    },
    write: |scene| Some(Value::Number(table(scene)?.seed as f64)),
};

/// `check`
pub(crate) static CHECK: Setting = Setting {
    takes: "true or false",
    brief: "true, false",
    example: "true",
    form: || Form::Flag,
    read: |scene, value| match value {
        Value::Flag(flag) => {
            of(scene).check = *flag;
            Ok(())
        }
        value => Err(Fault::whole(format!("is {value}"))),
    },
    write: |scene| Some(Value::Flag(table(scene)?.check)),
};
