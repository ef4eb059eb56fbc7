//! Blocks of the kind `console` show a command and what it prints. They are held against what it prints, words as they are and numbers
//! of at least six digits to 1e-4; error bounds and other counts may differ. Times are those of a machine, and Newton iterations those of a processor:
//! 277 where it fuses multiplication and addition, 271 where it does not, of the strip of 100 nm. So … stands in their place.

use super::{blocks, documents, hold, place, text, writing};
use std::process::Command;

/// What the command prints, without times and without the names of the files that it writes.
fn printed(command: &str) -> String {
    let folder = tempfile::tempdir().unwrap();
    std::os::unix::fs::symlink(place("scenes").canonicalize().unwrap(), folder.path().join("scenes")).unwrap();
    let words = shlex::split(command).unwrap();
    let output =
        Command::new(env!("CARGO_BIN_EXE_peel")).args(&words[1..]).current_dir(folder.path()).output().unwrap();
    let text = format!("{}{}", String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr));
    let lines = text.lines().filter(|line| !line.starts_with("wrote "));
    let mut is_table = false;
    let lines = lines.map(|line| {
        is_table = line.ends_with(" ms  end") || is_table && !line.is_empty();
        without_iterations(without_times(line.trim_end(), is_table))
    });
    lines.collect::<Vec<_>>().join("\n").trim_end().to_owned()
}

/// The line with … in place of the number before `ms`, or before the last word of a row of a sweep.
fn without_times(line: &str, is_row: bool) -> String {
    let behind = if is_row { line.rsplit_once("  ").map(|(_, end)| format!("  {end}")) } else { Some(" ms".into()) };
    let parts = behind.as_ref().and_then(|behind| line.rsplit_once(behind.as_str()));
    let Some((before, after)) = parts else { return line.to_owned() };
    let start = before.rfind(' ').map_or(0, |space| space + 1);
    if before[start..].parse::<f64>().is_err() {
        return line.to_owned();
    }
    let width = before[start..].chars().count();
    let time = if is_row { format!("{:>width$}", "…") } else { "…".into() };
    format!("{}{time}{}{after}", &before[..start], behind.unwrap_or_default())
}

/// The line with … in place of the number of Newton iterations, which is that of a processor.
fn without_iterations(line: String) -> String {
    let Some((before, after)) = line.split_once(" Newton iterations") else { return line };
    let start = before.rfind(' ').map_or(0, |space| space + 1);
    format!("{}… Newton iterations{after}", &before[..start])
}

/// A word as it is compared: a number of few digits is a count, a time or a bound.
#[derive(Debug, PartialEq)]
enum Token<'a> {
    Word(&'a str),
    Number(f64),
    Rough,
}

fn tokens(text: &str) -> Vec<Token<'_>> {
    let token = |word| {
        let number = word_of_number(word);
        match number.parse::<f64>() {
            Ok(value) if number.chars().filter(char::is_ascii_digit).count() >= 6 => Token::Number(value),
            Ok(_) => Token::Rough,
            Err(_) => Token::Word(word),
        }
    };
    text.split_whitespace().map(token).collect()
}

fn word_of_number(word: &str) -> &str {
    word.trim_end_matches([',', ';', ':', ')', '*', '%'])
}

fn same(found: &Token, wanted: &Token) -> bool {
    match (found, wanted) {
        (Token::Word(found), Token::Word(wanted)) => found == wanted,
        (Token::Number(found), Token::Number(wanted)) => (found - wanted).abs() <= 1e-4 * wanted.abs(),
        (Token::Word(_), _) | (_, Token::Word(_)) => false,
        // how many digits are shown depends on the bound
        _ => true,
    }
}

#[test]
fn commands_print_what_the_documents_show() {
    let mut wrong = Vec::new();
    for path in documents() {
        let document = text(&path);
        let mut lines: Vec<String> = document.lines().map(str::to_owned).collect();
        for block in blocks(&document).iter().rev().filter(|block| block.kind == "console") {
            let (command, shown) = block.text.split_once('\n').unwrap_or((&block.text, ""));
            let command = command.strip_prefix("$ ").unwrap_or_else(|| panic!("{path}: no command: {command}"));
            let printed = printed(command);
            let (found, wanted) = (tokens(shown), tokens(&printed));
            let agree = found.len() == wanted.len() && found.iter().zip(&wanted).all(|(a, b)| same(a, b));
            if !agree {
                wrong.push(format!("{path}: {command} prints\n{printed}"));
                let fresh = std::iter::once(format!("$ {command}")).chain(printed.lines().map(str::to_owned));
                lines.splice(block.lines.clone(), fresh);
            }
        }
        if writing() {
            hold(&path, &(lines.join("\n") + "\n"));
        }
    }
    assert!(wrong.is_empty() || writing(), "{}", wrong.join("\n\n"));
}
