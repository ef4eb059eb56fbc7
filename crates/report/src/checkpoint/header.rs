//! What a checkpoint is of: the first of its frames. It is compared byte by byte, and where it is another one the first difference is reported.

use crate::records::summary::{VERSION, parameters};
use crate::writing::error::ReportError;
use crate::writing::record::Object;
use peelkit::units::PreferredUnits;
use peelkit_scene::Scene;
use serde::Serialize;
use serde_json::Value;
use std::collections::{BTreeMap, BTreeSet};
use std::io;
use std::path::Path;

/// In the order in which differences are reported.
#[derive(Serialize)]
struct Header<'h> {
    analysis: &'static str,
    version: &'static str,
    settings: BTreeMap<&'h str, &'h str>,
    scene: Object,
}

/// The text of a header: the program, what is computed, of which scene with its defaults, and the settings besides.
pub(super) fn text(analysis: &'static str, scene: &Scene, settings: &[(&str, &str)]) -> io::Result<Vec<u8>> {
    let settings = settings.iter().copied().collect();
    // in whatever units it is drawn
    let scene = &Scene { units: PreferredUnits::default(), ..scene.clone() };
    Ok(serde_json::to_vec(&Header { analysis, version: VERSION, settings, scene: parameters(scene) })?)
}

/// The version of the program that wrote a file in the form of peel 0.2 and before, lines of text or a line before bytes: its first line is an object of
/// JSON. Nothing where it is no such file, or does not say.
pub(super) fn older_version(bytes: &[u8]) -> Option<String> {
    let line = bytes.split(|&byte| byte == b'\n').next()?;
    let header: Value = serde_json::from_slice(line).ok()?;
    // a part of a divided sweep says it of the sweep
    let version = header.get("peelkit").or_else(|| header.get("sweep")?.get("peelkit"))?;
    version.as_str().map(str::to_owned)
}

/// How the file at `path`, which begins with `found`, is another one than that of the header `wanted`.
pub(super) fn other(path: &Path, found: &[u8], wanted: &[u8]) -> ReportError {
    let path = path.to_path_buf();
    let [found, wanted] = [found, wanted].map(|text| serde_json::from_slice(text).unwrap_or(Value::Null));
    let analysis = words(found.get("analysis"));
    let different = ["analysis", "version", "settings", "scene"].into_iter().find_map(|of| {
        let (name, there, here) = difference("", found.get(of), wanted.get(of))?;
        let of = match of {
            "analysis" => "kind",
            "settings" => &name,
            of => of,
        };
        let name = if name.is_empty() { of } else { &name };
        Some((of.to_owned(), format!("{name} is {there} there, and {here} here")))
    });
    match different {
        Some((of, difference)) => ReportError::OtherCheckpoint { path, analysis, of, difference },
        None => ReportError::NoCheckpoint { path, reason: "its header is written differently".to_owned() },
    }
}

/// The first difference between two texts: where it is, and what stands there in each.
fn difference(name: &str, found: Option<&Value>, wanted: Option<&Value>) -> Option<(String, String, String)> {
    match (found, wanted) {
        (found, wanted) if found == wanted => None,
        (Some(Value::Object(found)), Some(Value::Object(wanted))) => {
            let names: BTreeSet<&String> = found.keys().chain(wanted.keys()).collect();
            let inner = |own: &String| if name.is_empty() { own.clone() } else { format!("{name}.{own}") };
            names.into_iter().find_map(|own| difference(&inner(own), found.get(own), wanted.get(own)))
        }
        (Some(Value::Array(found)), Some(Value::Array(wanted))) if found.len() == wanted.len() => {
            let pairs = found.iter().zip(wanted).enumerate();
            pairs.into_iter().find_map(|(k, (a, b))| difference(&format!("{name}[{k}]"), Some(a), Some(b)))
        }
        _ => Some((name.to_owned(), words(found), words(wanted))),
    }
}

fn words(value: Option<&Value>) -> String {
    match value {
        None | Some(Value::Null) => "not given".to_owned(),
        Some(Value::Object(_)) => "given".to_owned(),
        Some(Value::Array(items)) => format!("a list of {}", items.len()),
        Some(Value::String(text)) => text.clone(),
        Some(other) => other.to_string(),
    }
}
