//! What the command is built from: every crate with its licence, as `docs/notes/dependencies.md` lists them, each licence one that
//! `deny.toml` allows; one version for all that is published; and packages that hold every file that their source includes.
//!
//! The crates are those that cargo itself names for a build of `peel` on Linux, without what tests and builds alone need.

use super::{hold, place, row, text, with_part};
use serde_json::Value;
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::process::Command;

fn metadata() -> Value {
    let output = Command::new(env!("CARGO"))
        .args(["metadata", "--format-version", "1", "--locked", "--filter-platform", "x86_64-unknown-linux-gnu"])
        .current_dir(place(""))
        .output()
        .unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    serde_json::from_slice(&output.stdout).unwrap()
}

/// The identifiers of the packages that a build of the command links, its own among them.
fn linked(metadata: &Value) -> BTreeSet<&str> {
    let nodes: BTreeMap<&str, &Value> = metadata["resolve"]["nodes"]
        .as_array()
        .unwrap()
        .iter()
        .map(|node| (node["id"].as_str().unwrap(), node))
        .collect();
    let is_command = |package: &&Value| package["name"] == "peelkit-cli";
    let command = metadata["packages"].as_array().unwrap().iter().find(is_command).unwrap();
    let mut found = BTreeSet::new();
    let mut left = vec![command["id"].as_str().unwrap()];
    while let Some(id) = left.pop() {
        if !found.insert(id) {
            continue;
        }
        for dependency in nodes[id]["deps"].as_array().unwrap() {
            // a kind of null is an ordinary dependency
            if dependency["dep_kinds"].as_array().unwrap().iter().any(|kind| kind["kind"].is_null()) {
                left.push(dependency["pkg"].as_str().unwrap());
            }
        }
    }
    found
}

/// What `deny.toml` says: the licences that are allowed, and those of crates that name none.
struct Licences {
    allowed: Vec<String>,
    clarified: BTreeMap<String, String>,
}

impl Licences {
    fn read() -> Self {
        let deny: toml::Table = text("deny.toml").parse().unwrap();
        let texts = |value: &toml::Value| value.as_str().unwrap().to_owned();
        Self {
            allowed: deny["licenses"]["allow"].as_array().unwrap().iter().map(texts).collect(),
            clarified: deny["licenses"]["clarify"]
                .as_array()
                .unwrap()
                .iter()
                .map(|of| (texts(&of["crate"]), texts(&of["expression"])))
                .collect(),
        }
    }

    /// The licence of a package as an expression; older manifests write "/" for "or".
    fn of(&self, package: &Value) -> Option<String> {
        let name = package["name"].as_str().unwrap();
        let given = package["license"].as_str().map(|text| text.replace(" / ", "/").replace('/', " OR "));
        given.or_else(|| self.clarified.get(name).cloned())
    }

    fn allow(&self, expression: &str) -> bool {
        let parsed = spdx::Expression::parse(expression).unwrap();
        parsed.evaluate(|needed| self.allowed.iter().any(|id| needed.license.to_string() == *id))
    }
}

#[test]
fn every_dependency_is_listed_with_a_licence_that_is_allowed() {
    let metadata = metadata();
    let linked = linked(&metadata);
    let licences = Licences::read();
    let mut by_licence: BTreeMap<String, Vec<String>> = BTreeMap::new();
    for package in metadata["packages"].as_array().unwrap() {
        let name = package["name"].as_str().unwrap();
        if name.starts_with("peelkit") || !linked.contains(package["id"].as_str().unwrap()) {
            continue;
        }
        let licence = licences.of(package).unwrap_or_else(|| panic!("{name} names no licence"));
        assert!(licences.allow(&licence), "{name}: {licence} is not allowed by deny.toml");
        by_licence.entry(licence).or_default().push(name.to_owned());
    }
    let mut table = row(&["licence", "crates"]) + &row(&["---", "---"]);
    for (licence, mut names) in by_licence {
        names.sort();
        names.dedup();
        table += &row(&[&licence, &names.join(", ")]);
    }
    let page = "docs/notes/dependencies.md";
    hold(page, &with_part(&text(page), "licences", &table));
}

#[test]
fn what_is_published_has_one_version() {
    let metadata = metadata();
    let ours = |package: &&Value| package["name"].as_str().is_some_and(|name| name.starts_with("peelkit"));
    let published = |package: &&Value| !package["publish"].as_array().is_some_and(Vec::is_empty);
    let mut names = Vec::new();
    for package in metadata["packages"].as_array().unwrap().iter().filter(ours).filter(published) {
        let name = package["name"].as_str().unwrap();
        assert_eq!(package["version"], env!("CARGO_PKG_VERSION"), "{name}");
        for dependency in package["dependencies"].as_array().unwrap().iter().filter(ours) {
            let of = format!("^{}", env!("CARGO_PKG_VERSION"));
            assert_eq!(dependency["req"], of, "{name} on {}", dependency["name"]);
        }
        names.push(name);
    }
    assert!(names.len() >= 5, "{names:?}");
}

/// A file that the source of a crate includes must be in its package: within the folder of the crate, as the path is written, and
/// not below `..` from there.
#[test]
fn no_crate_includes_a_file_from_outside() {
    let mut included = 0;
    for (manifest, sources) in
        [("", "src"), ("crates/scene", "crates/scene/src"), ("crates/report", "crates/report/src")]
            .into_iter()
            .chain([("crates/checks", "crates/checks/src"), ("crates/command", "crates/command/src")])
            .chain([("crates/serve", "crates/serve/src"), ("crates/analyses", "crates/analyses/src")])
    {
        let depth = place(manifest).components().count();
        for path in sources_in(&place(sources)) {
            // documents are included where the tests compile them, and nowhere else
            let source = std::fs::read_to_string(&path).unwrap().replace("#[doc = include_str!", "");
            for (_, rest) in source.match_indices("include_").map(|(at, _)| source.split_at(at)) {
                let Some((_, file)) = rest.lines().next().and_then(|line| line.split_once('"')) else { continue };
                let up = file.matches("../").count();
                let inside = path.parent().unwrap().components().count() - depth;
                assert!(up <= inside, "{}: {}", path.display(), rest.lines().next().unwrap());
                included += 1;
            }
        }
    }
    assert!(included > 20, "{included}");
}

/// The Rust files of a folder and of those in it.
fn sources_in(folder: &Path) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    let found = entries.flat_map(|path| if path.is_dir() { sources_in(&path) } else { vec![path] });
    found.filter(|path| path.extension().is_some_and(|ending| ending == "rs")).collect()
}
