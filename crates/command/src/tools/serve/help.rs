//! The help of `peel serve`.

use crate::terminal::help::EXIT_STATUS;

/// Of `peel serve -h`.
pub const SHORT: &str = "\
Example: peel serve strip.toml
More: peel serve --help, on what the page shows, who can reach it, its limits";

/// Of `peel serve --help`.
pub fn long() -> String {
    format!(
        "\
Examples:
  peel serve
  peel serve strip.toml
  peel serve strip.toml --set grip.rotation=fixed --port 8000

The page has sliders for the keys of the scene, the curve with its limit points, error bounds and Kendall's force, the
beam at any point of the curve, the jumps of a displacement-controlled test, and the peak against any key. A scene with
[seta] shows the pull-off of its seta, one with [time] the pull at its rate beside the equilibria.
Curves can be kept for comparison. A link holds the scene; scene, table, picture and summary can be downloaded.
Everything is in the program: the page loads nothing from elsewhere.

Who can reach it: this machine alone, unless --address names another address. Requests that a page of another site
sends, and requests for a host with a name other than localhost, are refused. A scene that the page sends reads no file.

Limits: as many runs at once as there are cores, 32 more may wait, and a path ends after 20 s. A further run is refused
with a reason. A run whose page has gone is stopped.

Ctrl-C ends the program.

{EXIT_STATUS}"
    )
}
