//! What every subcommand does alike: it reads what is given, says how far it is, hears Ctrl-C, writes a folder, and ends with a message.

pub(crate) mod command_line;
pub(crate) mod folder_name;
pub(crate) mod help;
pub(crate) mod input;
pub(crate) mod interrupt;
pub(crate) mod output;
pub(crate) mod progress;
pub(crate) mod run_progress;
pub(crate) mod stop;
