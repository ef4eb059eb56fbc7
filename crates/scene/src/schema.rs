//! A JSON schema of scenes, for editors: completion, the meaning and the unit of a key where the mouse rests on it, and a red line below what
//! is wrong.
//!
//! It is made from [`KEYS`], and refuses nothing that [`Scene::parse`](crate::Scene::parse) takes. It sees less: not whether one number fits
//! another, nor the powers of a product of units.

use crate::body::{BODIES, shape_has};
use crate::key::belongs::BY_LAYERS;
use crate::key::kind::{Key, Need};
use crate::key::table::{SETA, STRIP, SUBSTRATE};
use crate::keys::{KEYS, tables};
use crate::value::form::{Entry, Form};
use peelkit::adhesion::Substrate;
use peelkit::model::Range;
use serde_json::{Map, Value, json};

/// What a scene may be, as JSON Schema draft 7, which editors of TOML read.
pub fn schema() -> Value {
    let mut properties = Map::new();
    for key in keys_of("") {
        properties.insert(key.name.to_owned(), described(key));
    }
    for name in tables() {
        properties.insert(name.to_owned(), table(name));
    }
    let pairs = [
        ["strip", "spatula"],
        ["strip", "profile"],
        ["spatula", "profile"],
        [SETA.name, "strip"],
        [SETA.name, "profile"],
    ];
    let apart: Vec<Value> = pairs.iter().map(|pair| json!({ "not": { "required": pair } })).collect();
    let of_a_body = |body: &str| json!({ "required": [body, "adhesion"] });
    let one: Vec<Value> =
        BODIES.iter().copied().chain([SETA.name]).map(of_a_body).chain([json!({ "required": ["setae"] })]).collect();
    json!({
        "$schema": "http://json-schema.org/draft-07/schema#",
        "title": "a scene of peelkit",
        "description": "What peels, from what, and how it is pulled. A quantity is a text with its unit: \"100 nm\".",
        "type": "object",
        "properties": properties,
        "additionalProperties": false,
        "anyOf": one,
        "allOf": apart,
    })
}

fn keys_of(table: &str) -> impl Iterator<Item = &'static Key> {
    KEYS.iter().filter(move |key| key.table == table)
}

fn table(name: &str) -> Value {
    let properties: Map<String, Value> = keys_of(name).map(|key| (key.name.to_owned(), described(key))).collect();
    let mut schema = json!({
        "type": "object",
        "description": keys_of(name).next().map(|key| key.of.about),
        "properties": properties,
        "additionalProperties": false,
    });
    let needed = |key: &&Key| key.need == Need::Required;
    match name {
        name if name == SUBSTRATE.name => schema["allOf"] = shapes(),
        // a cohesive law with its work and its strength or its table needs nothing of the half space
        "adhesion" => {
            let half_space: Vec<&str> = keys_of(name).filter(needed).map(|key| key.name).collect();
            schema["anyOf"] = json!([{ "required": half_space }, { "required": ["law", "work", "strength"] }, { "required": ["law", "table"] }]);
        }
        // layers stand in place of what they give
        name if name == STRIP.name => {
            let given = |key: &&Key| BY_LAYERS.contains(&key.name);
            let names = |keys: Vec<&Key>| keys.iter().map(|key| key.name).collect::<Vec<_>>();
            let of_one = names(keys_of(name).filter(needed).filter(given).collect());
            let apart: Vec<Value> = BY_LAYERS.iter().map(|key| json!({ "not": { "required": [key] } })).collect();
            schema["required"] = json!(names(keys_of(name).filter(needed).filter(|key| !given(key)).collect()));
            schema["oneOf"] = json!([{ "required": of_one }, { "required": ["layers"], "allOf": apart }]);
        }
        _ => {
            let alone = keys_of(name).filter(needed).filter(|key| key.alternative().is_none());
            let required: Vec<&str> = alone.map(|key| key.name).collect();
            let either: Vec<Value> = keys_of(name)
                .filter(|key| key.alternative().is_some())
                .map(|key| json!({ "required": [key.name] }))
                .collect();
            if !required.is_empty() {
                schema["required"] = json!(required);
            }
            if !either.is_empty() {
                schema["oneOf"] = json!(either);
            }
        }
    }
    schema
}

/// Which keys each shape of the substrate has, and which of them it needs.
fn shapes() -> Value {
    let is = |name: &str| json!({ "properties": { "shape": { "const": name } }, "required": ["shape"] });
    let keys = |substrate: &Substrate| {
        let own: Vec<&str> =
            keys_of(SUBSTRATE.name).map(|key| key.name).filter(|name| shape_has(substrate, name)).collect();
        let needed = |name: &&&str| keys_of(SUBSTRATE.name).any(|key| key.name == **name && key.need == Need::Required);
        let required: Vec<&str> = own.iter().filter(needed).copied().collect();
        json!({ "propertyNames": { "enum": own }, "required": required })
    };
    let named =
        Substrate::all().into_iter().map(|(name, substrate)| json!({ "if": is(name), "then": keys(&substrate) }));
    let none = json!({ "if": { "not": { "required": ["shape"] } }, "then": keys(&Substrate::default()) });
    named.chain([none]).collect()
}

/// A key with its meaning, its unit and its default.
fn described(key: &Key) -> Value {
    let mut schema = of(&key.form());
    let unit = if key.usual_unit().is_empty() { String::new() } else { format!(" Unit: {}.", key.usual_unit()) };
    schema["description"] = json!(format!("{}.{unit} Default: {}.", key.about, key.default_text()));
    schema
}

fn of(form: &Form) -> Value {
    match form {
        Form::Text => json!({ "type": "string" }),
        Form::Word(words) => json!({ "enum": words }),
        Form::Flag => json!({ "type": "boolean" }),
        Form::Whole(least, most) => json!({ "type": "integer", "minimum": least, "maximum": most }),
        Form::Number(range) => number(*range),
        Form::Quantity(dimension, range) => {
            let example = format!("\"1 {}\"", dimension.usual_unit());
            json!({ "type": "string", "pattern": quantity(&dimension.pattern(), *range), "examples": [example] })
        }
        Form::OfItsKey => json!({ "type": ["number", "string"] }),
        Form::AtBothEnds(one) => {
            let one = of(one);
            json!({ "anyOf": [one, { "type": "array", "items": one, "minItems": 2, "maxItems": 2 }] })
        }
        Form::Either(one, other) => json!({ "anyOf": [of(one), of(other)] }),
        Form::List(one) => json!({ "type": "array", "items": of(one) }),
        Form::Table(entries) => entries_of(entries),
        Form::Step(words) => json!({ "type": "string", "pattern": format!("^\\s*(?:{})\\b", words.join("|")) }),
        Form::Values => json!({ "type": "object", "additionalProperties": { "type": ["string", "number", "object"] } }),
        Form::OfKey => {
            let keys: Vec<String> = KEYS.iter().filter(|key| key.is_numeric()).map(Key::path).collect();
            json!({ "type": "string", "pattern": format!("^\\s*(?:{})\\b", keys.join("|").replace('.', "\\.")), "examples": keys })
        }
    }
}

fn entries_of(entries: &[Entry]) -> Value {
    let properties: Map<String, Value> =
        entries.iter().map(|entry| (entry.name.to_owned(), of(&(entry.form)()))).collect();
    let required: Vec<&str> = entries.iter().filter(|entry| entry.needed).map(|entry| entry.name).collect();
    json!({ "type": "object", "properties": properties, "additionalProperties": false, "required": required })
}

fn number(range: Range) -> Value {
    match range {
        Range::Positive => json!({ "type": "number", "minimum": Range::LEAST, "maximum": Range::LARGEST }),
        Range::Between(low, high) => json!({ "type": "number", "exclusiveMinimum": low, "exclusiveMaximum": high }),
        Range::From(low, high) => json!({ "type": "number", "minimum": low, "maximum": high }),
    }
}

/// A number and a unit; of the range its sign alone.
fn quantity(unit: &str, range: Range) -> String {
    let digits = match range {
        Range::Positive => "\\+?[0.]*[1-9][0-9.]*",
        Range::Between(low, _) | Range::From(low, _) if low >= 0.0 => "\\+?[0-9.]+",
        _ => "[+-]?[0-9.]+",
    };
    format!("^\\s*{digits}(?:[eE][+-]?[0-9]+)?\\s*{unit}\\s*$")
}
