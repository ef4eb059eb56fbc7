//! The keys of the table: what each takes, and how it is read and written.

use super::{correlations, inputs, of};
use crate::form::Form;
use crate::key::kind::Setting;
use crate::near::nearest;
use crate::scene::Scene;
use crate::value::{Fault, Value, quoted};
use peelkit::study::PeelQuantity;
use peelkit::study::uncertainty::Indices;

/// Most samples.
const MOST_SAMPLES: f64 = 1e7;
/// Largest seed: whole numbers up to here are exact.
const LARGEST_SEED: f64 = 9_007_199_254_740_992.0;

/// `inputs`
pub(crate) static INPUTS: Setting = Setting {
    takes: "a list of tables, each with the `key` of a number of the scene, its `distribution` and what that needs: \"normal\" (mean, deviation), \
            \"lognormal\" (median, log_deviation of the logarithm), \"uniform\" (from, to) or \"triangular\" (from, mode, to); a mean, median \
            or mode that is left out is the value of the scene",
    brief: "list of tables",
    example: "[{ key = \"strip.height\", distribution = \"normal\", mean = \"10 nm\", deviation = \"0.5 nm\" }, { key = \"strip.width\", distribution = \
              \"lognormal\", median = \"1 nm\", log_deviation = 0.1 }]",
    form: || Form::list(Form::Table(inputs::ENTRIES)),
    read: |scene, value| {
        of(scene).inputs = inputs::read(list(value)?)?;
        Ok(())
    },
    write: |scene| Some(Value::List(scene.uncertainty.as_ref()?.inputs.iter().map(inputs::written).collect())),
};

/// `correlations`
pub(crate) static CORRELATIONS: Setting = Setting {
    takes: "a list of tables, each with two `keys` among those of the inputs and the `coefficient` of their correlation, between -1 and 1; of \
            inputs that are not normal it is that of the normal numbers behind them",
    brief: "list of tables",
    example: "[{ keys = [\"strip.height\", \"strip.width\"], coefficient = 0.5 }]",
    form: || Form::list(Form::Table(correlations::ENTRIES)),
    read: |scene, value| {
        of(scene).correlations = correlations::read(list(value)?)?;
        Ok(())
    },
    write: |scene| {
        let table = scene.uncertainty.as_ref()?;
        Some(Value::List(table.correlations.iter().map(correlations::written).collect()))
    },
};

/// `quantities`
pub(crate) static QUANTITIES: Setting = Setting {
    takes: "a list of numbers of a run, by their names in summary.json, such as \"peak.force_nN\" or \"first_jump.work_aJ\"",
    brief: "list of results",
    example: "[\"initiation_peak.force_nN\", \"first_jump.work_aJ\"]",
    form: || Form::list(Form::Word(PeelQuantity::all().map(PeelQuantity::name).collect())),
    read: |scene, value| {
        of(scene).quantities = quantities(list(value)?)?;
        Ok(())
    },
    write: |scene| {
        let names = scene.uncertainty.as_ref()?.quantities.iter().map(|of| Value::Text(of.name().to_owned()));
        Some(Value::List(names.collect()))
    },
};

/// `samples`
pub(crate) static SAMPLES: Setting = Setting {
    takes: "a whole number from 1 to 1e7",
    brief: "1 to 1e7, whole",
    example: "10000",
    form: || Form::Whole(1.0, MOST_SAMPLES),
    read: |scene, value| {
        of(scene).samples = whole(value, 1.0, MOST_SAMPLES)? as usize;
        Ok(())
    },
    write: |scene| Some(Value::Number(scene.uncertainty.as_ref()?.samples as f64)),
};

/// `seed`
pub(crate) static SEED: Setting = Setting {
    takes: "a whole number from 0 to 2^53",
    brief: "0 to 2^53, whole",
    example: "1",
    form: || Form::Whole(0.0, LARGEST_SEED),
    read: |scene, value| {
        of(scene).seed = whole(value, 0.0, LARGEST_SEED)? as u64;
        Ok(())
    },
    write: |scene| Some(Value::Number(scene.uncertainty.as_ref()?.seed as f64)),
};

/// `indices`
pub(crate) static INDICES: Setting = Setting {
    takes: "true or false",
    brief: "true, false",
    example: "false",
    form: || Form::Flag,
    read: |scene, value| match value {
        Value::Flag(flag) => {
            of(scene).indices = if *flag { Indices::Estimated } else { Indices::Omitted };
            Ok(())
        }
        value => Err(Fault::whole(format!("is {value}"))),
    },
    write: |scene: &Scene| Some(Value::Flag(scene.uncertainty.as_ref()?.indices == Indices::Estimated)),
};

fn list(value: &Value) -> Result<&[Value], Fault> {
    if let Value::List(items) = value { Ok(items) } else { Err(Fault::whole(format!("is {value}"))) }
}

fn whole(value: &Value, least: f64, most: f64) -> Result<f64, Fault> {
    match value {
        Value::Number(number) if number.fract() != 0.0 => Err(Fault::whole(format!("is {value}, which is not whole"))),
        Value::Number(number) if (least..=most).contains(number) => Ok(*number),
        Value::Number(_) => Err(Fault::whole(format!("is {value}, which is out of range"))),
        value => Err(Fault::whole(format!("is {value}"))),
    }
}

fn quantities(items: &[Value]) -> Result<Vec<PeelQuantity>, Fault> {
    let names: Vec<&str> = PeelQuantity::all().map(PeelQuantity::name).collect();
    let mut found = Vec::with_capacity(items.len());
    for (item, value) in items.iter().enumerate() {
        let Value::Text(name) = value else { return Err(Fault::at(item, format!("has {value} as a result"))) };
        let quantity = PeelQuantity::named(name).ok_or_else(|| {
            let guess = nearest(name, names.iter().copied())
                .map(|near| format!("; did you mean \"{near}\"?"))
                .unwrap_or_default();
            Fault::at(item, format!("has {}, which is none of {}{guess}", quoted(name), names.join(", ")))
        })?;
        if found.contains(&quantity) {
            return Err(Fault::at(item, format!("has {} twice", quoted(name))));
        }
        found.push(quantity);
    }
    if found.is_empty() { Err(Fault::whole("is empty: no result is asked for".into())) } else { Ok(found) }
}
