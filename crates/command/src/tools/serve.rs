//! `peel serve`: a page on the user's own machine.

use crate::studies::ready::ready;
use crate::terminal::help::EXIT_STATUS;
use crate::terminal::input::{parse_override, read_any_scene};
use crate::terminal::interrupt::Interrupt;
use crate::terminal::output::say;
use crate::terminal::stop::Stop;
use clap::Args;
use peelkit_serve::{Limits, Server, StartScene};
use std::net::{IpAddr, Ipv4Addr, SocketAddr};
use std::path::{Path, PathBuf};

/// Serves a page with sliders: the peel is computed again while one drags
#[derive(Args)]
#[command(after_help = SHORT_HELP, after_long_help = long_help())]
pub struct Serve {
    /// The scene that the page begins with: a TOML file
    #[arg(value_name = "SCENE")]
    scene: Option<PathBuf>,

    /// Sets a key of the scene: strip.length="50 nm"; may be repeated
    #[arg(long = "set", value_name = "KEY=VALUE", value_parser = parse_override, requires = "scene")]
    overrides: Vec<(String, String)>,

    /// Port of the page; 0 is one that is free
    #[arg(long, value_name = "PORT", default_value_t = 7878)]
    port: u16,

    /// Address to listen at; any other is open to others
    #[arg(long, value_name = "ADDRESS", default_value_t = IpAddr::V4(Ipv4Addr::LOCALHOST))]
    address: IpAddr,
}

pub fn serve(args: &Serve) -> Result<(), Stop> {
    let own = args.scene.as_deref().map(|path| own_scene(path, &args.overrides)).transpose()?;
    let server = Server::bind(args.address, args.port, own, Limits::default()).map_err(|error| {
        Stop::bad_input(
            format!("the page cannot listen at {}, port {}: {error}", args.address, args.port),
            "Give another port with --port, or --port 0 for one that is free.",
        )
    })?;
    let stopper = server.stopper();
    let _interrupt = Interrupt::listen(move || stopper.stop());
    say(&format!("{}Ctrl-C ends it.\n", whereabouts(server.address())))?;
    server.run().map_err(|error| Stop::other(format!("the page ended: {error}")))
}

/// Where the page is, and who can reach it.
fn whereabouts(address: SocketAddr) -> String {
    const OPEN: &str = "Warning: whoever reaches this address can let this machine compute; there is no password.\n";
    let ip = address.ip();
    if ip.is_loopback() {
        return format!("The page is at http://{address}/\n");
    }
    if ip.is_unspecified() {
        let port = address.port();
        return format!(
            "The page is at http://localhost:{port}/, and at every address of this machine in numbers, port {port}\n{OPEN}"
        );
    }
    format!("The page is at http://{address}/\n{OPEN}")
}

/// The scene of the user, its tables in its text.
fn own_scene(path: &Path, overrides: &[(String, String)]) -> Result<StartScene, Stop> {
    Ok(StartScene::of(&ready(|| read_any_scene(path, overrides))?))
}

// -- The help --

/// Of `peel serve -h`.
const SHORT_HELP: &str = "\
Example: peel serve strip.toml
More: peel serve --help, on what the page shows, who can reach it, its limits";

/// Of `peel serve --help`.
fn long_help() -> String {
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
