//! How a seta branches where it does not double: lists by levels, or a tree that is given whole.

use crate::key::kind::Setting;
use crate::value::form::Form;
use crate::value::quantity::{Dimension, parse_quantity};
use crate::value::swc::read_swc;
use crate::value::{Fault, Value};
use peelkit::model::Range;
use std::sync::Arc;

/// Most branches behind one fork that can be meant.
const MOST: f64 = 64.0;

/// `branches`
pub(crate) static BRANCHES: Setting = Setting {
    takes: "a list of whole numbers, the branches behind each fork from the shaft on",
    brief: "a list",
    example: "[4, 3, 2]",
    form: || Form::list(Form::Whole(1.0, MOST)),
    read: |scene, value, _| {
        let whole = |value: &Value| match value {
            Value::Number(number) if (1.0..=MOST).contains(number) && number.fract() == 0.0 => Ok(*number as usize),
            other => Err(format!("{}, no whole number from 1 to {MOST}", other)),
        };
        scene.seta_table().seta.branches = list(value, whole)?;
        Ok(())
    },
    write: |scene, _| {
        let branches = &scene.seta.as_ref()?.seta.branches;
        let values = branches.iter().map(|&branches| Value::Number(branches as f64)).collect();
        (!branches.is_empty()).then_some(Value::List(values))
    },
};

/// `fork_heights`
pub(crate) static FORK_HEIGHTS: Setting = Setting {
    takes: "a list of lengths with their units, the heights of the forks above the tips from the shaft on",
    brief: "a list",
    example: "[\"28 um\", \"12 um\", \"5 um\"]",
    form: lengths,
    read: |scene, value, _| {
        scene.seta_table().seta.fork_heights = list(value, length)?;
        Ok(())
    },
    write: |scene, _| written(&scene.seta.as_ref()?.seta.fork_heights),
};

/// `diameters`
pub(crate) static DIAMETERS: Setting = Setting {
    takes: "a list of lengths with their units, the diameters of the shaft and of a branch behind each fork",
    brief: "a list",
    example: "[\"4 um\", \"2.2 um\", \"1.2 um\", \"0.6 um\"]",
    form: lengths,
    read: |scene, value, _| {
        scene.seta_table().seta.diameters = list(value, length)?;
        Ok(())
    },
    write: |scene, _| written(&scene.seta.as_ref()?.seta.diameters),
};

/// `tree`
pub(crate) static TREE: Setting = Setting {
    takes: "a tree in SWC of several lines, or the name of its file in quotes, beside the scene",
    brief: "SWC, file",
    example: "\"1 0 0 30 0 1 -1\\n2 0 0 9 0 1 1\\n3 0 -1 0 0 0.4 2\\n4 0 1 0 0 0.4 2\"",
    form: || Form::Text,
    read: |scene, value, _| {
        let Value::Text(text) = value else { return Err(Fault::whole(format!("is {value}, no text in quotes"))) };
        let (tree, text) = read_swc(&scene.name, text).map_err(Fault::whole)?;
        scene.seta_table().seta.tree = Some(Arc::new(tree));
        scene.table_texts.tree = text;
        Ok(())
    },
    write: |scene, _| {
        scene.seta.as_ref()?.seta.tree.as_ref()?;
        Some(Value::Text(scene.table_texts.tree.clone()))
    },
};

fn lengths() -> Form {
    Form::list(Form::Quantity(Dimension::Length, Range::Positive))
}

fn list<T>(value: &Value, one: impl Fn(&Value) -> Result<T, String>) -> Result<Vec<T>, Fault> {
    match value {
        Value::List(items) if !items.is_empty() => {
            let read = |(item, value)| one(value).map_err(|found| Fault::at(item, format!("has {found}")));
            items.iter().enumerate().map(read).collect()
        }
        Value::List(_) => Err(Fault::whole("is an empty list".to_owned())),
        other => Err(Fault::whole(format!("is {}, no list", other))),
    }
}

fn length(value: &Value) -> Result<f64, String> {
    let number = match value {
        Value::Text(text) => parse_quantity(text, Dimension::Length).ok(),
        _ => None,
    };
    number
        .filter(|number| *number > 0.0 && number.is_finite())
        .ok_or_else(|| format!("{}, no positive length with its unit", value))
}

fn written(lengths: &[f64]) -> Option<Value> {
    let text = |&length: &f64| Value::Text(format!("{length} nm"));
    (!lengths.is_empty()).then(|| Value::List(lengths.iter().map(text).collect()))
}
