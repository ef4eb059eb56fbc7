//! The help of `peel optimise`.

use crate::terminal::help::{EXIT_STATUS, OUTPUTS};

/// Of `peel optimise -h`.
pub const SHORT: &str = "\
Example: peel optimise strip.toml, with a table [optimise] in the scene
More: peel optimise --help, on that table, files, resuming; peel keys optimise, its keys";

/// Of `peel optimise --help`.
pub fn long() -> String {
    format!(
        "\
The scene names what is free, what is to be large or small, and what has to hold:

  [optimise]
  objective = \"initiation_peak.force_nN\"      a result, by its name in the summary of peel run
  goal = \"maximise\"
  width = {{ from = \"5 nm\", to = \"20 nm\", slope = 0.2 }}
  height = {{ from = \"2 nm\", to = \"10 nm\" }}
  values = 20                                 along the body, with a monotone cubic between them
  volume = \"equal\"                            to that of the scene; \"at-most\", \"free\"
  parameters = [{{ key = \"strip.youngs_modulus\", from = \"0.1 GPa\", to = \"10 GPa\" }}]

With holding_angle and release_angle the objective is the ratio of its values in pulls at these two angles. Searches
with exact derivatives begin at the scene and at random designs. A design that cannot be computed is a bad one and does
not end them. `peel run` ignores the table.

Examples:
  peel optimise strip.toml
  peel optimise strip.toml --set drive.angle=\"30 deg\" --set optimise.starts=4
  peel run out/strip-optimise/optimum.toml

Files:
  summary.json       objective before and after with error bounds, variables, searches, certificate: projected gradient,
                     active constraints with their multipliers, random feasible neighbours
  history.csv        one row for each design of each search
  optimum.toml       the best design as a scene
  optimum.svg, .png  shape and peel before and after, and the searches
  parameters.toml    the scene with what --set has changed: peel optimise gives the same numbers
  optimise.partial   checkpoint while it runs: each evaluated design, written at once

Interrupting: after Ctrl-C the designs being evaluated are finished, and the best so far is written (exit status 3). A
second Ctrl-C stops the program at once (130).

Resuming: give the same command again. It makes the same choices and takes what is known from the checkpoint. --fresh
discards the checkpoint. With --json and without --out nothing is kept.

{OUTPUTS}

{EXIT_STATUS}"
    )
}
