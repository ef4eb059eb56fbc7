//! `peel serve`: a page on the user's own machine.

mod help;

use crate::input::{parse_override, read_scene};
use crate::interrupt::Interrupt;
use crate::output::say;
use crate::stop::Stop;
use clap::Args;
use peelkit_serve::{Limits, Server, StartScene};
use std::net::{IpAddr, Ipv4Addr};
use std::path::{Path, PathBuf};

/// Serves a page with sliders: the peel is computed again while one drags
#[derive(Args)]
#[command(after_help = help::SHORT, after_long_help = help::long())]
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

    /// Address that the page listens at; any but the default is open to others
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
    let warning = match args.address.is_loopback() {
        true => "",
        false => "Warning: whoever reaches this address can let this machine compute; there is no password.\n",
    };
    say(&format!("The page is at http://{}/\n{warning}Ctrl-C ends it.\n", server.address()))?;
    server.run().map_err(|error| Stop::other(format!("the page ended: {error}")))
}

/// The scene of the user, its tables in its text.
fn own_scene(path: &Path, overrides: &[(String, String)]) -> Result<StartScene, Stop> {
    Ok(StartScene::of(&read_scene(path, overrides)?))
}
