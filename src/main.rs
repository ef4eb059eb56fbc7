//! The command `peel`.

mod cli;

fn main() -> std::process::ExitCode {
    cli::main()
}
