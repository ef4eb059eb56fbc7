//! `peel figures`: every figure, drawn anew.

use super::output::{list_files, progress_bar, say};
use super::stop::Stop;
use clap::Args;
use peelkit::report::draw_figures;
use std::path::PathBuf;

/// Regenerates every figure, and the data behind each
#[derive(Args)]
pub struct Figures {
    /// Folder for the figures, made where it is missing
    #[arg(long, value_name = "DIR", default_value = "figures")]
    out: PathBuf,
}

pub fn figures(args: &Figures) -> Result<(), Stop> {
    let bar = progress_bar(0);
    let files = draw_figures(&args.out, &|done, total| {
        bar.set_length(total as u64);
        bar.set_position(done as u64);
    });
    bar.finish_and_clear();
    say(&list_files(&files?))
}
