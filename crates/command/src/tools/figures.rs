//! `peel figures`: every figure, drawn anew.

use crate::terminal::help;
use crate::terminal::output::{OutArgs, list_files, progress_bar, say};
use crate::terminal::stop::Stop;
use clap::Args;
use peelkit_checks::{draw_figures, holds_figures};
use peelkit_report::{Existing, OutputFolder, Part};
use std::path::Path;

/// Draws every figure again, with its data
#[derive(Args)]
#[command(after_long_help = help::figures(), mut_arg("out", |out| out.help("Folder for the figures [default: figures]")))]
pub struct Figures {
    #[command(flatten)]
    out: OutArgs,

    /// Draws one part of N: 1/3; the figures are dealt out in turn
    #[arg(long, value_name = "I/N", requires = "out")]
    part: Option<Part>,
}

pub fn figures(args: &Figures) -> Result<(), Stop> {
    let folder = args.out.out.as_deref().unwrap_or(Path::new("figures"));
    // a part of them is not what the folder of all of them is to hold
    let folder = match args.part.is_none() && holds_figures(folder) {
        true => OutputFolder::claim(folder, Existing::Replace, None)?,
        false => args.out.claim(folder, None)?,
    };
    let bar = progress_bar(0);
    let progress = |done, total| {
        bar.set_length(total as u64);
        bar.set_position(done as u64);
    };
    let files = folder.write(|dir| draw_figures(dir, args.part, &progress));
    bar.finish_and_clear();
    say(&list_files(&files))?;
    files?;
    Ok(())
}
