//! `peel new`: a commented scene to start from.

use crate::terminal::help;
use crate::terminal::output::say;
use crate::terminal::stop::Stop;
use crate::tools::schema;
use clap::Args;
use std::fs::{self, OpenOptions};
use std::io::{ErrorKind, Write};
use std::path::{Path, PathBuf};

/// Writes a commented scene as a template
#[derive(Args)]
#[command(after_help = help::NEW_EXAMPLES)]
pub struct New {
    /// Name of the scene file [default: the name of the kind]; .toml is added if missing
    #[arg(value_name = "NAME")]
    name: Option<PathBuf>,

    /// Kind of scene; --list names them
    #[arg(long, visible_alias = "body", value_name = "KIND", default_value = "strip")]
    kind: String,

    /// Names the kinds of scenes, a line each
    #[arg(long, conflicts_with_all = ["name", "kind"])]
    list: bool,
}

/// A scene to start from.
struct Template {
    kind: &'static str,
    about: &'static str,
    text: &'static str,
}

/// Kind, meaning.
macro_rules! templates {
    ($($kind:literal $about:literal),* $(,)?) => {
        &[$(Template { kind: $kind, about: $about, text: include_str!(concat!("../../scenes/", $kind, ".toml")) }),*]
    };
}

/// Every kind, in the order of the list.
const TEMPLATES: &[Template] = templates![
    "strip" "a uniform strip on a flat substrate, with every key and its default",
    "spatula" "a gecko's spatula: a flat pad on a round, bent shaft",
    "profile" "a beam of any outline, given piece by piece",
    "seta" "a gecko's seta: a shaft that forks into 256 spatulae",
    "seta-tree" "a seta drawn joint by joint, of 13 tips",
    "seta-of-beams" "a fork with two spatulae that are beams, in one equilibrium",
    "patch" "3600 setae on a rigid backing, event by event",
    "lamella" "an elastic band on 60 rows of setae, lifted at its end",
    "toe" "a pad with 12 lamellae",
    "solid-strip" "a strip as a plane solid with enriched contact elements",
    "solid-spatula" "a spatula as a solid in space: some minutes",
    "strip-100nm" "the short strip of the examples",
    "strip-soft" "a very flexible strip, which re-adheres",
    "strip-rough" "a strip on wavy ground",
    "spatula-rough" "a spatula on wavy ground",
    "strip-friction" "a strip held by friction alone, pulled at 30 degrees",
    "strip-sideways" "a strip in space, pulled sideways",
    "strip-rolled" "a strip in space whose grip is rolled before the pull",
    "tape" "an adhesive tape of some millimetres, under a cohesive law",
    "foil" "a foil of aluminium that yields as it is bent at the front",
    "rubber" "a soft film of rubber under a cohesive law",
    "laminate" "a flexible circuit of three layers, as one beam",
    "double-cantilever" "an arm of a double cantilever beam (DCB) with an initial crack",
    "t-peel" "an arm of a T-peel of two films",
    "lap" "a lap joint, held along the substrate as well",
    "loop" "half of a loop tack test: bent, brought down and pulled up",
    "tape-at-a-rate" "a tape whose adhesive resists its opening, pulled at a rate",
    "strip-at-a-rate" "a viscous strip pulled at a rate, with inertia",
    "seta-at-a-rate" "a seta of viscous branches, 16 tips, pulled at a rate",
    "strip-auto" "a strip whose model is reduced to the terms that matter",
];

/// The kinds, a line each.
fn list() -> String {
    let widest = TEMPLATES.iter().map(|template| template.kind.len()).max().unwrap_or(0);
    let line = |Template { kind, about, .. }: &Template| format!("  {kind:<widest$}  {about}\n");
    let lines: String = TEMPLATES.iter().map(line).collect();
    format!("{lines}\n`peel new --kind KIND` writes KIND.toml, `peel new NAME --kind KIND` NAME.toml.\n")
}

fn template(kind: &str) -> Result<&'static Template, Stop> {
    TEMPLATES.iter().find(|template| template.kind == kind).ok_or_else(|| {
        let kinds: Vec<&str> = TEMPLATES.iter().map(|template| template.kind).collect();
        Stop::bad_input(format!("--kind {kind} is no kind of scene"), format!("The kinds are {}.", kinds.join(", ")))
    })
}

/// Writes what the first line of the scene names, which helps an editor with it.
fn write_schema(path: &Path) -> Result<String, Stop> {
    let shown = path.display();
    fs::write(path, schema::text()).map_err(|error| Stop::other(format!("cannot write {shown}: {error}")))?;
    Ok(format!("wrote {shown}, by which an editor completes and checks the scene\n"))
}

pub fn new(args: &New) -> Result<(), Stop> {
    if args.list {
        return say(&list());
    }
    let template = template(&args.kind)?;
    let mut path = args.name.clone().unwrap_or_else(|| template.kind.into());
    if path.extension().is_none_or(|extension| extension != "toml") {
        path.as_mut_os_string().push(".toml");
    }
    let shown = path.display();
    let cannot = |error| Stop::other(format!("cannot write {shown}: {error}"));
    let mut file = match OpenOptions::new().write(true).create_new(true).open(&path) {
        Err(error) if error.kind() == ErrorKind::AlreadyExists => {
            return Err(Stop::bad_input(
                format!("{shown} exists and is not replaced"),
                "Give another name: peel new NAME",
            ));
        }
        opened => opened.map_err(cannot)?,
    };
    let text = format!("#:schema {}\n{}", schema::NAME, template.text);
    if let Err(error) = file.write_all(text.as_bytes()) {
        // Half a scene is worse than none; the error is reported in either case.
        let _ = fs::remove_file(&path);
        return Err(cannot(error));
    }
    let beside = path.with_file_name(schema::NAME);
    let beside = if beside.exists() { String::new() } else { write_schema(&beside)? };
    say(&format!("wrote {shown}\n{beside}Next: peel run {shown}\n"))
}
