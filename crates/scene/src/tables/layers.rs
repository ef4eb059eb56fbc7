//! Layers of a strip.

use super::bounded::{each, entry};
use crate::body::strip;
use crate::key::kind::Setting;
use crate::value::form::{Entry, Form};
use crate::value::quantity::{Dimension, parse_quantity};
use crate::value::{Fault, Value, quoted};
use peelkit::model::{Laminate, Layer, Range};

/// Of a layer without its own.
const POISSONS_RATIO: f64 = 0.2;

/// The entries of a layer.
const LAYER: &[Entry] = &[
    Entry::needed("height", || Form::Quantity(Dimension::Length, Range::Positive)),
    Entry::needed("youngs_modulus", || Form::Quantity(Dimension::Pressure, Range::Positive)),
    Entry::optional("poissons_ratio", || Form::Number(Range::POISSONS_RATIO)),
];

/// `layers`
pub(crate) static LAYERS: Setting = Setting {
    takes: "a list of tables, one a layer from the adhering face up, each with its `height`, its `youngs_modulus`, and `poissons_ratio`, 0.2 unless \
            given; they stand in place of `height` and material of the strip",
    brief: "list of tables",
    example: "[{ height = \"30 um\", youngs_modulus = \"1 MPa\", poissons_ratio = 0.49 }, { height = \"50 um\", youngs_modulus = \"4 GPa\" }]",
    form: || Form::list(Form::Table(LAYER)),
    read: |scene, value, _| {
        let laminate = Laminate::new(&each(value, "layer", layer)?).map_err(|error| Fault::whole(error.to_string()))?;
        let strip = strip(scene);
        *strip = strip.of_layers(laminate);
        Ok(())
    },
    write: |scene, _| {
        let layers = scene.model.strip()?.layers?;
        Some(Value::List(layers.layers().iter().map(written).collect()))
    },
};

fn layer(value: &Value) -> Result<Layer, String> {
    let Value::Table(entries) = value else { return Err(format!("{value}, no table")) };
    let of = |name: &str, dimension: Dimension, example: &str| {
        let number = match entry(entries, LAYER, name)? {
            Some(Value::Text(text)) => parse_quantity(text, dimension).map_err(|_| quoted(text)),
            other => Err(other.map_or_else(String::new, ToString::to_string)),
        };
        number.map_err(|found| format!("`{name}` = {found}, no number with its unit in quotes, such as {example}"))
    };
    let poissons_ratio = match entry(entries, LAYER, "poissons_ratio")? {
        None => POISSONS_RATIO,
        Some(Value::Number(number)) => *number,
        Some(other) => return Err(format!("`poissons_ratio` = {other}, no number")),
    };
    Ok(Layer {
        height: of("height", Dimension::Length, "\"50 um\"")?,
        youngs_modulus: of("youngs_modulus", Dimension::Pressure, "\"4 GPa\"")?,
        poissons_ratio,
    })
}

fn written(layer: &Layer) -> Value {
    let Layer { height, youngs_modulus, poissons_ratio } = *layer;
    let text = |number: f64, unit: &str| Value::Text(format!("{number} {unit}"));
    let entries = [
        ("height", text(height, "nm")),
        ("youngs_modulus", text(youngs_modulus, "GPa")),
        ("poissons_ratio", Value::Number(poissons_ratio)),
    ];
    Value::Table(entries.into_iter().map(|(name, value)| (name.to_owned(), value)).collect())
}
