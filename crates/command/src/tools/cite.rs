//! `peel cite`: how to cite the program, as CITATION.cff says.

use crate::terminal::output::say;
use crate::terminal::stop::Stop;
use clap::Args;

/// Says how to cite the program
#[derive(Args)]
pub struct Cite {}

const CITATION: &str = include_str!("../../CITATION.cff");

pub fn cite(_: &Cite) -> Result<(), Stop> {
    say(&text())
}

/// An entry for BibTeX, and the paper beside it.
fn text() -> String {
    let (program, paper) = CITATION.split_once("references:").unwrap_or((CITATION, ""));
    format!(
        "@software{{peelkit,\n  title = {{{}}},\n  author = {{{{{}}}}},\n  version = {{{}}}\n}}\n\n\
         The paper whose model it computes: {} {}, {}.\n",
        field(program, "title"),
        field(program, "name"),
        field(program, "version"),
        field(paper, "given-names"),
        field(paper, "family-names"),
        field(paper, "title"),
    )
}

/// The first value of this name.
fn field<'t>(text: &'t str, name: &str) -> &'t str {
    let of_line = |line: &'t str| line.trim_start_matches([' ', '-']).strip_prefix(name)?.strip_prefix(": ");
    text.lines().find_map(of_line).unwrap_or_default().trim_matches('"')
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn says_what_stands_in_the_file() {
        let version = env!("CARGO_PKG_VERSION");
        assert_eq!(
            text(),
            format!(
                "@software{{peelkit,\n  title = {{peelkit: how thin adhesive beams peel from a surface}},\n  \
                 author = {{{{The peelkit developers}}}},\n  version = {{{version}}}\n}}\n\n\
                 The paper whose model it computes: Roger A. Sauer, Advances in the computational modeling of the gecko \
                 adhesion mechanism.\n"
            )
        );
    }
}
