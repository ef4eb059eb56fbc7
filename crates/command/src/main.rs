//! The command `peel`, one file a subcommand.

#![forbid(unsafe_code)]

mod studies;
mod terminal;
mod text_summary;
mod tools;

use clap::{CommandFactory, Parser, Subcommand};
use std::io::IsTerminal;
use std::process::ExitCode;
use studies::{accuracy, coarsen, collect, fit, optimise, run, sweep, uncertainty};
use terminal::help;
use tools::{cite, figures, keys, new, plot, schema, serve, shell, verify};

/// Computes how thin adhesive beams peel from a surface.
#[derive(Parser)]
#[command(name = "peel", version, after_help = help::EXIT_STATUS, after_long_help = help::overview())]
struct Cli {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    Run(run::Run),
    Sweep(sweep::args::Sweep),
    Collect(collect::Collect),
    Optimise(optimise::Optimise),
    Fit(fit::Fit),
    Uncertainty(uncertainty::Uncertainty),
    Coarsen(coarsen::Coarsen),
    Accuracy(accuracy::Accuracy),
    Verify(verify::Verify),
    New(new::New),
    Keys(keys::Keys),
    Plot(plot::Plot),
    Serve(serve::Serve),
    Figures(figures::Figures),
    Schema(schema::Schema),
    Completions(shell::Completions),
    Man(shell::Man),
    Cite(cite::Cite),
}

/// Reads the command line, does what it says, and turns what went wrong into a message and an exit status.
fn main() -> ExitCode {
    let wrap = std::io::stderr().is_terminal();
    // Long messages stay on one line where another program may search them. It fails only if it was set before.
    let _ = miette::set_hook(Box::new(move |_| {
        Box::new(miette::MietteHandlerOpts::new().wrap_lines(wrap).context_lines(1).build())
    }));
    let done = match Cli::parse().command {
        Command::Run(args) => run::run(&args),
        Command::Sweep(args) => sweep::sweep(&args),
        Command::Collect(args) => collect::collect(&args),
        Command::Optimise(args) => optimise::optimise(&args),
        Command::Fit(args) => fit::fit(&args),
        Command::Uncertainty(args) => uncertainty::uncertainty(&args),
        Command::Coarsen(args) => coarsen::coarsen(&args),
        Command::Accuracy(args) => accuracy::accuracy(&args),
        Command::Verify(args) => verify::verify(&args),
        Command::New(args) => new::new(&args),
        Command::Keys(args) => keys::keys(&args),
        Command::Plot(args) => plot::plot(&args),
        Command::Serve(args) => serve::serve(&args),
        Command::Figures(args) => figures::figures(&args),
        Command::Schema(args) => schema::schema(&args),
        Command::Completions(args) => shell::completions(&args, Cli::command()),
        Command::Man(args) => shell::man(&args, Cli::command()),
        Command::Cite(args) => cite::cite(&args),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(stop) => stop.report(),
    }
}
