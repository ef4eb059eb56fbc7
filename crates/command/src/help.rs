//! The long help: enough to work from without the README.

use peelkit_checks::suite::TOPICS;
use peelkit_scene::{KEYS, Key, Kind, Need, Value};

pub const EXIT_STATUS: &str = "\
Exit status:
  0  done
  1  something else went wrong, such as a folder that cannot be written
  2  bad input: the message names the key, the line and what would be right; or a folder for the outputs that is
     not empty, without --force
  3  the computation stopped short: what was reached is written all the same
  130  quit by a second Ctrl-C";

const UNITS: &str = "\
Quantities are texts with their unit: \"100 nm\", \"0.1 um\", \"2 GPa\", \"2000 MPa\", \"1e-19 J\", \"100 zJ\", \"0.6 eV\".
Outputs carry the unit in the name: force_nN, displacement_nm, work_aJ (1 aJ = 1 nN nm). A positive force pulls the
grip away from the surface.";

const OUTPUTS: &str = "\
The files of a command appear in their folder all at once, when it is done. A folder that is not empty is refused before
anything is computed, unless --force is given: then files of the same names are replaced, and all others stay.";

const PIECES: &str = "\
Each piece of profile.pieces, from the free end on, has length, width and height and, if wanted, roundness (0: a
rectangle, 1: an ellipse), bend (by how much the underside turns along it: \"30 deg\"), course of all but the height
(\"linear\" or \"smooth\") and height_course (\"smooth\", or \"linear\" where the height has no kink). Width, height and
roundness are one value, or two in a list: at its beginning and at its end.
";

/// Of `peel --help`.
pub fn overview() -> String {
    format!(
        "\
Examples:
  peel new                       writes strip.toml, a commented scene
  peel run strip.toml            peels it: summary, curve, limit points and pictures in out/strip/
  peel run strip.toml --set strip.length=\"50 nm\" --set grip.rotation=fixed --json
  peel sweep strip.toml --vary strip.bending_stiffness_factor --from 1e-4 --to 1e4 --points 33 --log
  peel accuracy                  what an error costs: a table and a picture
  peel verify                    holds the program against published and independent values

{UNITS}

{}
{EXIT_STATUS}",
        keys()
    )
}

/// Of `peel run --help`.
pub fn run() -> String {
    format!(
        "\
Examples:
  peel run strip.toml
  peel run strip.toml --out thin --set strip.height=\"5 nm\"
  peel run strip.toml --set grip.rotation=fixed --json
  peel run strip.toml --set grip.rotation=fixed --set grip.stiffness=\"0.05 N/m\" --observed

Files:
  summary.json       peaks, plateau, limit points, snap-off, how the path ended, effort, the scene as computed
  curve.csv          one row a point of the path
  limit_points.csv   one row a turning point of displacement or force, with error bounds
  curve.svg, .png    force against displacement; shapes.svg, .png  the strip at marked points
  observed.csv, .svg, .png   with --observed: one row a point of the test, there and back; force against the machine's U

  run.partial        while a run lasts longer than a second: the points of its path, kept every second

Ctrl-C ends the path at its next point, writes what was reached, and says so (exit status 3); a second Ctrl-C quits
at once (130). The same command then goes on where the path stopped, also after it was killed, and after a path that
bounds.time ended: it takes what run.partial holds of this scene and version, computes the rest, and writes the files
that a run without an interruption writes, to the last bit but for solve_s. The points of a path follow from the scene
alone, time only says where it is left: so bounds may change, and bounds.time begins anew. What another scene has kept
there is refused. A folder in which a run is unfinished is one to go on with, and needs no --force; --fresh discards
what is kept. Turning points and error bounds are computed again, as is the test of --observed. Runs that write no files
(--json without --out) keep nothing.

The path ends  detached (no point nearer than 10 r0), pivoting (the force is back at zero, an edge still holds),
turned-back (back at u = 0), with friction sliding (all of it slides) or snapped (it snaps off), bound (a bound of
[bounds] was reached) or failed.

{OUTPUTS}

{UNITS}

{}
{EXIT_STATUS}",
        keys()
    )
}

/// Of `peel sweep --help`.
pub fn sweep() -> String {
    format!(
        "\
Examples:
  peel sweep strip.toml --vary strip.bending_stiffness_factor --from 1e-4 --to 1e4 --points 33 --log
  peel sweep strip.toml --vary strip.height --from \"2 nm\" --to \"20 nm\" --points 10 --json
  peel sweep strip.toml --vary strip.bending_stiffness_factor --from 1e-4 --to 1e4 --points 1000 --log --peak-only

Files:
  sweep.csv          one row a value: peak force, plateau, snap-off, work, time, how the path ended; `value` is in
                     nm, GPa, aJ or s, or a plain number, as the key is; a cell is empty where a thing does not occur
  pictures beside it, SVG and PNG
  sweep.partial.jsonl  while the sweep runs: each finished value, kept at once

Ctrl-C lets the values under way finish, writes what is done to sweep.csv and the pictures, and says how many values
those are (exit status 3); a second Ctrl-C quits at once (130). The same command then goes on where it stopped, also
after it was killed: it takes what sweep.partial.jsonl holds of this scene, key and version and computes the rest,
with the same result but for solve_s. The range and the number of values may change. What another sweep has kept there
is refused. Sweeps that write no files (--json without --out) and those with --follow or --peak-only, which take
milliseconds, keep nothing and are not resumed.

{OUTPUTS}
A folder in which a sweep is unfinished is one to go on with, and needs no --force. --fresh discards the values that
sweep.partial.jsonl keeps, of this sweep or another, and nothing else.

With --follow peak (or --peak-only) or --follow snap-off no path is computed for each value: the point itself is solved
for, from an extrapolation of the values before. What peak means is then the initiation peak, the first local maximum of
the force, and only the columns of that point are filled. Each value has a bound on its error, from meshes half as fine
again at some of the values. At the first, the last and three values between the point is held against the path from
rest; where it vanishes, or is the first no longer, a remark says at which value, and the path from rest is asked again.
With --json the object holds scene, title, vary, unit, rows (the columns of sweep.csv) and parameters.

{UNITS}

{}
{EXIT_STATUS}",
        keys()
    )
}

/// Of `peel accuracy --help`.
pub fn accuracy() -> String {
    format!(
        "\
Without a scene the strip of 100 nm is taken. Each kind of run is repeated on more and more elements: orders 1 to 8; then, at
order 7, three fields a node instead of two, meshes that stay (graded, uniform) instead of moving with the front, steps that
are ten times shorter or longer. Beside them stand the runs in which all of that follows from accuracy.relative, from 1e-3 to
1e-10. A time is the least of several runs on one core; keep the machine quiet. It takes a minute.

Examples:
  peel accuracy
  peel accuracy strip.toml --set strip.length=\"1 um\" --out out/long

Files:
  accuracy.csv         one row a run: errors of peak, snap-off and curve, time, points, iterations, elements
  accuracy.svg, .png   time against error, the best of all runs marked

{OUTPUTS}

{EXIT_STATUS}"
    )
}

/// Of `peel figures --help`.
pub fn figures() -> String {
    format!(
        "\
The figures of the repository, from computed data only, with a caption of each in README.md. A folder that peel figures
has written before is written anew; any other that is not empty needs --force. It takes minutes.

Examples:
  peel figures
  peel figures --out mine

{OUTPUTS}

{EXIT_STATUS}"
    )
}

/// Of `peel verify --help`.
pub fn verify() -> String {
    let topics: String = TOPICS.iter().map(|topic| format!("  {:<12} {}\n", topic.name, topic.about)).collect();
    format!(
        "\
One line a check: pass or FAIL, topic and name, the value computed, the value expected, their difference, the tolerance,
and the source of the expected value. The tables that it needs are built in; verification/README.md tells how each was
computed without finite elements. Exit status 0 only if every check passes.

Examples:
  peel verify
  peel verify --only strip --json
  peel verify --hard

Topics:
{topics}
{EXIT_STATUS}"
    )
}

/// Every key with its default, or with an example where it has none.
fn keys() -> String {
    let mut text = "Keys of a scene, for --set and (the numbers) for --vary:\n".to_owned();
    for key in KEYS {
        let sample = format!("{} = {}", key.path(), sample(key));
        let room = 70;
        let note = match note(key) {
            note if note.is_empty() => String::new(),
            note if key.about.len() + note.len() < room => format!(" ({note})"),
            note => format!("\n{:50}({note})", ""),
        };
        text += &format!("  {sample:<47} {}{note}\n", key.about);
    }
    text + PIECES
}

fn sample(key: &Key) -> String {
    match key.default_value() {
        Some(Value::Number(number)) if !key.unit().is_empty() => format!("\"{number} {}\"", key.unit()),
        _ if matches!(key.kind, Kind::Pieces(_)) => format!("[{{ length = {:?}, ... }}]", "90 nm"),
        Some(Value::List(_)) => "[]".into(),
        Some(Value::Text(text)) if !text.is_empty() => format!("\"{text}\""),
        Some(value @ (Value::Number(_) | Value::Flag(_))) => value.to_string(),
        _ => key.example().to_owned(),
    }
}

fn note(key: &Key) -> String {
    match (&key.kind, key.need) {
        (_, Need::Required) if !key.shapes().is_empty() => format!("required for shape {}", key.shapes().join(", ")),
        (_, Need::Required) => key.alternative().map_or("required".into(), |other| format!("required, or {other}")),
        (Kind::Bound(..) | Kind::Steps(_), _) => "none unless given".into(),
        (Kind::Fixed(..) | Kind::Share(..), _) => "chosen by itself".into(),
        (Kind::Text(_), _) => "the name of the file unless given".into(),
        (Kind::LineLoad(_) | Kind::Hold(_) | Kind::Shape(_) | Kind::Start(_) | Kind::Terms(_), _) => key.takes(),
        _ => String::new(),
    }
}
