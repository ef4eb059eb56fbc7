//! The long help: enough to work from without the README.

use peelkit_checks::suite::TOPICS;

pub const EXIT_STATUS: &str = "\
Exit status:
  0  done
  1  another error, such as a folder that cannot be written
  2  bad input: the message names the key, the line and what would be right. Also: the output folder is not empty
     and --force is not given
  3  the computation stopped short: what was reached is written all the same
  130  stopped at once by a second Ctrl-C";

const UNITS: &str = "\
A quantity is a text with its unit: \"100 nm\", \"0.1 um\", \"2 GPa\", \"2000 MPa\", \"1e-19 J\", \"100 zJ\", \"0.6 eV\".
The name of an output includes its unit: force_nN, displacement_nm, work_aJ (1 aJ = 1 nN nm). A positive force pulls
the grip away from the surface.";

const KEYS_ELSEWHERE: &str = "\
Keys of a scene: peel keys lists them with units, defaults and ranges, peel keys TABLE those of one table.";

pub const OUTPUTS: &str = "\
The output files appear in their folder all at once, when the command is done. The same command again replaces its
own files. Any other folder that is not empty is refused before anything is computed. With --force, files of the same
names are replaced and all others stay.";

pub const PIECES: &str = "\
The pieces of profile.pieces begin at the free end. Each piece needs length, width and height. Optional are roundness
(0: rectangle, 1: ellipse), bend (rotation of the underside along the piece: \"30 deg\"), course (\"linear\" or \"smooth\"
transition of width, roundness and direction) and height_course (\"smooth\": quintic transition; or \"linear\", where the
height has no kink). Width, height and roundness are one value, or a list of two: at the beginning and at the end.
";

/// Of `peel --help`.
pub fn overview() -> String {
    format!(
        "\
Examples:
  peel new                       writes strip.toml, a commented scene
  peel run strip.toml            computes the peeling: summary, curve, limit points and pictures in out/strip/
  peel run strip.toml --set strip.length=\"50 nm\" --set grip.rotation=fixed --json
  peel sweep strip.toml --vary strip.bending_stiffness_factor --from 1e-4 --to 1e4 --points 33 --log
  peel keys                      lists the keys of a scene with units, defaults and ranges
  peel new --list                names the kinds of scenes
  peel optimise strip.toml       finds the best of what a table [optimise] of the scene leaves free
  peel uncertainty strip.toml    samples what a table [uncertainty] of the scene calls uncertain
  peel serve strip.toml          a page with sliders, on this machine
  peel accuracy                  computing time against error: a table and a picture
  peel verify                    compares the program with published and independent values

{UNITS}

{KEYS_ELSEWHERE}

{EXIT_STATUS}"
    )
}

/// Of `peel run -h`.
pub const RUN: &str = "\
Example: peel run strip.toml --at u=\"10 nm\" --out short   (more: peel run --help, peel keys)";

/// Of `peel run --help`.
pub fn run() -> String {
    format!(
        "\
Examples:
  peel run strip.toml --out thin --set strip.height=\"5 nm\"
  peel run strip.toml --set strip.length=\"50 nm\" --set grip.rotation=fixed --json
  peel run strip.toml --at u=\"10 nm\" --at P=\"0.04 nN\"
  peel run strip.toml --animate --sensitivities
  peel run strip.toml --branch
  peel run strip.toml --set grip.rotation=fixed --set grip.stiffness=\"0.05 N/m\" --observed

Files:
  summary.json       peaks, plateau, limit points, first jump, detachment, how the path ended, computational cost, the
                     scene, what follows from that alone (work of adhesion, Kendall's force, stiffnesses, dimensionless
                     groups), version and command. A peak is a located limit point or null; then largest_computed_force
                     has no bound
  curve.csv          one row for each point of the path; with --out-of-plane its stability out of the plane
  stations.csv       with --at, --event or --stop-at: one row for each equilibrium at a value that was asked for
  limit_points.csv   one row for each limit point of load or displacement, with error bounds
  parameters.toml    the scene as it was computed, with what --set has changed: peel run computes it to the same numbers
  curve.svg, .png    force against displacement
  shapes.svg, .png   the strip at marked points of the curve
  sensitivities.svg, .png   with --sensitivities: by which power of each parameter the results change
  branch.csv         with --branch: one row for each point of the branch out of the plane
  states.csv, states.pvd   with --states N: the fields along the beam (place, rotation, section forces, gap, loads) at
                     every limit point and at N points evenly along the path; states.pvd opens in ParaView
  observed.csv, .svg, .png   with --observed: the displacement-controlled test, one row for each point, pulling off and
                     returning; force against the displacement U of the machine
  animation.html     with --animate: the beam over the substrate beside the curve, one file that a browser plays
  events.csv, tips.csv, tip.csv, tips.svg, seta.svg   of a scene with a [seta]: its events, the state and load of each
                     tip, the law of a tip, a map of the loads, the seta at its peak
  run.partial        checkpoint of a run of more than 0.2 s: the points of its path, written every 0.2 s

The folder is named after the scene, what is asked besides, and the keys that --set changes, those of [bounds] left
out: commands that compute different things write to different folders. --out names another.

Interrupting a run: Ctrl-C stops the path at its next point and writes what was reached (exit status 3). A second
Ctrl-C stops the program at once (130).

Resuming a run: give the same command again. It also resumes a run that was killed, and one that bounds.time ended.
The points in run.partial are used again; the rest is computed. The files are then those of an uninterrupted run, bit
for bit, except for solve_s. The points of a path depend on the scene alone. So [bounds] may be changed, and
bounds.time starts anew. Limit points, error bounds and the test of --observed are computed again. A folder with an
unfinished run needs no --force. The checkpoint of another scene or version, and one in which a byte has
changed, is refused. --fresh discards the checkpoint. Runs that write no files (--json without --out) keep none.

How a path ends:
  detached     no point of the strip is nearer than the adhesion acts
  pivoting     the force has returned to zero, and the strip is still in edge contact
  pushing      behind a snap-off of a grip that rotates the force is below zero and does not return to zero
  turned-back  re-adhered: u has returned to 0
  back-in-plane
               of the branch of --branch: it has come back to the planar path
  sliding      with friction: the whole contact slides
  snapped      with friction: the strip snaps off
  bonded-part-unstable
               what is still bonded is unstable under the horizontal force: its sections tilt, it wrinkles, or its free
               end turns up; the reason has the force and the critical one
  upright-section
               far_face = false: a section stands at 90 degrees, where the energy W/cos θ has no lower bound, or is
               drawn there; under other laws it stands on a pressed edge, where the energy has a corner
  bound        a limit set under [bounds], or what path.until names, was reached
  refused      there is no stable state to start from, by a criterion that the reason names with its numbers
               (exit status 2)
  failed       the computation stopped short

{OUTPUTS}

{UNITS}

{KEYS_ELSEWHERE}

{EXIT_STATUS}"
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
  peel sweep strip.toml --vary strip.height --values 5,10,20nm --vary strip.youngs_modulus --values 1,2,4GPa
  peel sweep strip.toml --vary strip.height --from \"2 nm\" --to \"20 nm\" --points 1000 --part 3/8

Files:
  sweep.csv          one row for each value: peak force, plateau, snap-off, work, time, how the path ended. `value` is
                     in nm, GPa, aJ, s, rad, ..., or a plain number; the next column names the key and has the same
                     number in the unit in which it is given: an angle in degrees. Empty cells: it does not occur.
                     `work_to`: whether work_aJ goes to the first jump or to the end of a path without one
  sweep.svg, .png    these results against the varied value; of two keys, maps of peak force and work over their plane
  parameters.toml    the scene before the sweep, with what --set has changed, and the command
  sweep.partial      checkpoint while the sweep runs: each finished value, written at once
  sweep.part         with --part, in place of the pictures: what peel collect puts together

Interrupting a sweep: after Ctrl-C the values being computed are finished. The finished values are written to sweep.csv
and the pictures (exit status 3). A second Ctrl-C stops the program at once (130).

Resuming a sweep: give the same command again, also after the sweep was killed. The values in sweep.partial are used
again; the rest is computed. The results are the same except for solve_s. The range and the number of values may be
changed. A folder with an unfinished sweep needs no --force. The checkpoint of another scene, key, part or version,
and one in which a byte has changed, is refused. --fresh discards the checkpoint, of this sweep or another, and nothing
else. Sweeps that write no files (--json without --out) keep no checkpoint; neither do those with --follow or
--peak-only, which take milliseconds.

{OUTPUTS}

Two keys: with --vary twice, the options behind each belong to it, and every value of the second is taken with each of
the first: one row for each pair, with the columns value and value_2.

A part of a sweep: with --part I/N the values I, I + N, I + 2 N, ... are computed, on a machine of its own, say. The
folder is named after the part as well. peel collect puts the parts together to the files of the undivided sweep.

Continuation of one point: with --follow peak (or --peak-only) or --follow snap-off no whole path is computed for each
value. The limit point is solved for directly, from an extrapolation of the previous values. Here peak means the
initiation peak, the first local maximum of the force. Only the columns of that point are filled. The error bounds come
from meshes of 1.5 times as many elements at some of the values. At the first, the last and three intermediate
values the point is compared with the path from rest. If it vanishes, or is no longer the first of its kind, a remark
gives the value, and the path from rest is computed again.
With --json the object holds scene, title, vary, unit, rows (the columns of sweep.csv) and parameters.

{UNITS}

{KEYS_ELSEWHERE}

{EXIT_STATUS}"
    )
}

/// Of `peel uncertainty -h`.
pub const UNCERTAINTY: &str = "\
Example: peel uncertainty strip.toml, with a table [uncertainty] in the scene
More: peel uncertainty --help, on that table, files, resuming";

/// Of `peel uncertainty --help`.
pub fn uncertainty() -> String {
    format!(
        "\
The scene names what is uncertain:

  [uncertainty]
  inputs = [
    {{ key = \"strip.youngs_modulus\", distribution = \"lognormal\", median = \"2 GPa\", log_deviation = 0.1 }},
    {{ key = \"strip.height\", distribution = \"normal\", deviation = \"0.5 nm\" }},
    {{ key = \"adhesion.hamaker_constant\", distribution = \"uniform\", from = \"0.8e-19 J\", to = \"1.2e-19 J\" }},
    {{ key = \"adhesion.equilibrium_distance\", distribution = \"triangular\", from = \"0.35 nm\", to = \"0.45 nm\" }},
  ]
  quantities = [\"initiation_peak.force_nN\", \"first_jump.work_aJ\"]
  samples = 10000

A mean, median or mode that is left out is the value of the scene. `correlations` lists inputs that vary together.
Where only the initiation peak is asked for, the path is followed to it and no farther. `peel run` ignores the table.

Examples:
  peel uncertainty strip.toml
  peel uncertainty strip.toml --set uncertainty.samples=1000 --set uncertainty.seed=1 --json
  peel uncertainty strip.toml --set uncertainty.indices=false

Files:
  summary.json       for each result mean, standard deviation and quantiles with their sampling errors, sensitivity
                     indices, what derivatives give beside that, and what each input does alone
  statistics.csv     one row for each result
  indices.csv        one row for each result and input: first-order and total index of Sobol
  samples.csv        one row for each sample: inputs, results, why it was cut short
  RESULT.svg, .png   histogram, indices, and the result with one input changed, for each result
  parameters.toml    the scene with what --set has changed: peel uncertainty gives the same numbers
  uncertainty.partial  checkpoint while it runs: each finished sample, written at once

Interrupting: after Ctrl-C the samples being computed are finished, and what follows from all finished samples is
written (exit status 3). A second Ctrl-C stops the program at once (130).

Resuming: give the same command again. The samples in the checkpoint are used again; the rest is computed. `samples`
may be changed meanwhile. --fresh discards the checkpoint. With --json and without --out nothing is kept.

A sample whose path was not computed to its end is counted and reported (exit status 3); results that it has count.

{OUTPUTS}

{EXIT_STATUS}"
    )
}

/// Of `peel accuracy --help`.
pub fn accuracy() -> String {
    format!(
        "\
Without a scene the strip of 100 nm is used. Each discretisation is run on more and more elements: orders 1 to 8; then,
at order 7, three fields per node instead of two, a fixed mesh (graded or uniform) instead of one that moves with the
front, and steps ten times shorter or longer. They are compared with the runs whose discretisation follows from
accuracy.relative, from 1e-3 to 1e-10. A time is the shortest of several runs on one core: run nothing else meanwhile.
It takes a minute.

Examples:
  peel accuracy
  peel accuracy strip.toml --set strip.length=\"1 um\" --out out/long

Files:
  accuracy.csv         one row for each run: errors of peak, snap-off and curve, time, points, iterations, elements
  accuracy.svg, .png   time against error; the best of all runs are marked

{OUTPUTS}

{EXIT_STATUS}"
    )
}

/// Of `peel figures --help`.
pub fn figures() -> String {
    format!(
        "\
Draws the figures of the repository, from computed data only. README.md in their folder has the captions. A folder that
peel figures has written before is overwritten; any other folder that is not empty needs --force. It takes minutes.

Examples:
  peel figures
  peel figures --out mine
  peel figures --out some --part 1/3

{OUTPUTS}

{EXIT_STATUS}"
    )
}

/// Of `peel keys --help`.
pub const KEYS_EXAMPLES: &str = "\
Examples:
  peel keys                every key of a scene
  peel keys adhesion       those of the table [adhesion]
  peel keys top            those above the tables";

/// Of `peel plot --help`.
pub const PLOT: &str = "\
Examples:
  peel plot out/thin out/thick
  peel plot out/strip --data measured.csv --out compared
  peel plot out/a/sweep.csv out/b/sweep.csv --log-x";

/// Of `peel new --help`.
pub const NEW_EXAMPLES: &str = "\
Examples:
  peel new                     writes strip.toml, and peel.schema.json for an editor
  peel new mine                writes mine.toml
  peel new --kind spatula      writes spatula.toml
  peel new --list              names the kinds of scenes";

pub const SCHEMA_EXAMPLES: &str = "\
Examples:
  peel schema                  writes peel.schema.json
  peel schema -                prints it

A scene of peel new names it in its first line, #:schema peel.schema.json. An editor with support
for TOML, such as VS Code with Even Better TOML, then completes keys and words, shows what a key
means, and marks what is wrong.";

pub const COMPLETIONS_EXAMPLES: &str = "\
Examples:
  peel completions bash > ~/.local/share/bash-completion/completions/peel
  peel completions zsh > ~/.zfunc/_peel
  peel completions fish > ~/.config/fish/completions/peel.fish
  peel completions powershell >> $PROFILE";

pub const MAN_EXAMPLES: &str = "\
Examples:
  peel man                          writes man/peel.1, man/peel-run.1 and the others
  peel man ~/.local/share/man/man1  where man peel finds them";

/// Of `peel verify --help`.
pub fn verify() -> String {
    let topics: String = TOPICS.iter().map(|topic| format!("  {:<12} {}\n", topic.name, topic.about)).collect();
    format!(
        "\
Prints one line for each check: pass or FAIL, topic and name, the computed value, the expected value, their difference,
the tolerance, and the source of the expected value. The tables of expected values are built in; verification/README.md
describes how each was computed without finite elements. The exit status is 0 only if every check passes.

Examples:
  peel verify
  peel verify --only strip --json
  peel verify --hard
  peel verify --part 1/3
  peel verify --sampled 100 --kind strip
  peel verify --sampled 100 --kind law --ways 2
  peel verify --scenes 72,196 --kind law --ways 1
  peel verify --kind strip --scene 4

Topics:
{topics}
{EXIT_STATUS}"
    )
}
