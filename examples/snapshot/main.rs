//! What a build of `peel` computes, kept in a file and compared with what another build computes.
//!
//!   cargo run --release --example snapshot -- write --peel OLD/peel --out before.json
//!   cargo run --release --example snapshot -- write --peel NEW/peel --out after.json
//!   cargo run --release --example snapshot -- compare before.json after.json
//!
//! `write` runs the scenes of a folder and randomly sampled ones, one after the other, and keeps their summaries without what depends on
//! the machine. `compare` leaves with status 1 unless every number is the same bit for bit, or within a relative difference (`--within`).
//! The sampled scenes end by a bound on points, not on time: a time bound would end them elsewhere on another machine.

mod compare;
mod differences;
mod job;
mod run;
mod sampled;

use clap::{CommandFactory, Parser, Subcommand};
use compare::compare;
use job::scenes_of;
use run::{Snapshot, run_all};
use sampled::sampled_scene;
use std::error::Error;
use std::path::PathBuf;
use std::process::ExitCode;

#[derive(Parser)]
#[command(about = "Keeps what a build of `peel` computes, and compares two builds")]
struct Args {
    #[command(subcommand)]
    task: Option<Task>,
}

#[derive(Subcommand)]
enum Task {
    /// Runs scenes and keeps their summaries
    Write {
        /// The command `peel` of the build
        #[arg(long)]
        peel: PathBuf,
        #[arg(long)]
        out: PathBuf,
        /// Folder of the scenes
        #[arg(long, default_value = "scenes")]
        scenes: PathBuf,
        /// How many scenes are sampled
        #[arg(long, default_value_t = 60)]
        sampled: u64,
        #[arg(long, default_value_t = 1)]
        seed: u64,
        /// Runs only what has this text in its name
        #[arg(long, default_value = "")]
        only: String,
        /// Prints the time of every run
        #[arg(long)]
        times: bool,
    },
    /// Compares two files
    Compare {
        before: PathBuf,
        after: PathBuf,
        /// Largest relative difference of a number that is let pass
        #[arg(long, default_value_t = 0.0)]
        within: f64,
        /// Lets changed texts and added or removed keys pass; counts of points, ends and limit points still have to be the same
        #[arg(long)]
        numbers_only: bool,
    },
}

fn main() -> Result<ExitCode, Box<dyn Error>> {
    let Some(task) = Args::parse().task else {
        Args::command().print_help()?;
        return Ok(ExitCode::SUCCESS);
    };
    match task {
        Task::Write { peel, out, scenes, sampled, seed, only, times } => {
            let mut jobs = scenes_of(&scenes)?;
            jobs.extend((0..sampled).map(|index| sampled_scene(seed, index)));
            jobs.retain(|job| job.label().contains(&only));
            let runs = run_all(&peel.canonicalize()?, &jobs, times)?;
            std::fs::write(&out, serde_json::to_string_pretty(&Snapshot { seed, runs })?)?;
            Ok(ExitCode::SUCCESS)
        }
        Task::Compare { before, after, within, numbers_only } => {
            let [before, after] = [before, after].map(|file| -> Result<Snapshot, Box<dyn Error>> {
                Ok(serde_json::from_str(&std::fs::read_to_string(file)?)?)
            });
            Ok(if compare(&before?, &after?, within, numbers_only) { ExitCode::SUCCESS } else { ExitCode::FAILURE })
        }
    }
}
