//! How two runs of the same scene differ.

use crate::run::Run;
use serde_json::Value;

/// How two summaries differ.
#[derive(Default)]
pub struct Differences {
    pub numbers: usize,
    /// Largest relative difference, and where.
    pub largest: Option<(f64, String)>,
    /// Whether every number with an error bound moved by less than a tenth of the sum of both bounds.
    pub beyond_bounds: Vec<String>,
    /// Counts of points and the like.
    pub counts: Vec<String>,
    pub texts: Vec<String>,
    pub keys: Vec<String>,
    /// What is there in one alone, or of another kind.
    pub shapes: Vec<String>,
}

impl Differences {
    pub fn between(before: &Run, after: &Run) -> Self {
        let mut found = Self::default();
        if before.status != after.status {
            found.shapes.push(format!("status {:?} -> {:?}", before.status, after.status));
        }
        if before.message != after.message {
            found.texts.push("message".into());
        }
        if before.scene != after.scene {
            found.shapes.push("the scene itself".into());
        }
        found.walk(&before.summary, &after.summary, String::new());
        found
    }

    fn walk(&mut self, before: &Value, after: &Value, path: String) {
        match (before, after) {
            (Value::Object(old), Value::Object(new)) => {
                for (name, value) in old {
                    let path = if path.is_empty() { name.clone() } else { format!("{path}.{name}") };
                    match new.get(name) {
                        None => self.keys.push(format!("-{path}")),
                        Some(other) => {
                            self.against_bounds(name, [old, new], [value, other], &path);
                            self.walk(value, other, path);
                        }
                    }
                }
                let added = new.keys().filter(|name| !old.contains_key(*name));
                self.keys.extend(added.map(|name| format!("+{path}.{name}")));
            }
            (Value::Array(old), Value::Array(new)) => {
                if old.len() != new.len() {
                    self.shapes.push(format!("{path}: {} -> {}", old.len(), new.len()));
                }
                for (index, (value, other)) in old.iter().zip(new).enumerate() {
                    self.walk(value, other, format!("{path}[{index}]"));
                }
            }
            (Value::Number(old), Value::Number(new)) if old.is_u64() && new.is_u64() => {
                self.numbers += 1;
                if old != new {
                    self.counts.push(format!("{path}: {old} -> {new}"));
                }
            }
            (Value::Number(old), Value::Number(new)) => self.numbers(old.as_f64(), new.as_f64(), path),
            (Value::String(old), Value::String(new)) => {
                // how a path ended, and what kind a point is of
                let matters = path == "end" || path.ends_with(".end") || path.ends_with(".kind");
                match (old == new, matters) {
                    (true, _) => {}
                    (false, true) => self.shapes.push(format!("{path}: {old} -> {new}")),
                    (false, false) => self.texts.push(path),
                }
            }
            (old, new) if old != new => self.shapes.push(format!("{path}: {} -> {}", short(old), short(new))),
            _ => {}
        }
    }

    fn numbers(&mut self, before: Option<f64>, after: Option<f64>, path: String) {
        let (Some(before), Some(after)) = (before, after) else { return };
        self.numbers += 1;
        if before.to_bits() == after.to_bits() {
            return;
        }
        let relative = (after - before).abs() / before.abs().max(after.abs()).max(f64::MIN_POSITIVE);
        if self.largest.as_ref().is_none_or(|(largest, _)| relative > *largest) {
            self.largest = Some((relative, path));
        }
    }

    /// A number whose error bound stands beside it: `force_nN` and `error_nN`, `pull_off_force_nN` and `pull_off_error_nN`.
    fn against_bounds(
        &mut self,
        name: &str,
        objects: [&serde_json::Map<String, Value>; 2],
        values: [&Value; 2],
        path: &str,
    ) {
        let ([Some(before), Some(after)], Some((stem, unit))) = (values.map(Value::as_f64), name.rsplit_once('_'))
        else {
            return;
        };
        if name.starts_with("error_") || stem.ends_with("_error") {
            return;
        }
        let own = [format!("{stem}_error_{unit}"), format!("{}_error_{unit}", stem.trim_end_matches("_force"))];
        let shared = format!("error_{unit}");
        let bound = |object: &serde_json::Map<String, Value>| {
            own.iter().chain([&shared]).find_map(|key| object.get(key)).and_then(Value::as_f64)
        };
        if let [Some(one), Some(other)] = objects.map(bound)
            && (after - before).abs() > 0.1 * (one + other)
        {
            self.beyond_bounds.push(path.to_owned());
        }
    }

    pub fn is_none(&self) -> bool {
        self.largest.is_none() && self.passes(0.0, false)
    }

    pub fn passes(&self, within: f64, numbers_only: bool) -> bool {
        self.largest.as_ref().is_none_or(|(largest, _)| *largest <= within)
            && self.counts.is_empty()
            && self.shapes.is_empty()
            && (numbers_only || self.texts.is_empty() && self.keys.is_empty())
    }
}

fn short(value: &Value) -> String {
    match value {
        Value::Object(_) => "{...}".into(),
        Value::Array(_) => "[...]".into(),
        other => other.to_string(),
    }
}
