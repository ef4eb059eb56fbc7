//! The chapters of `docs/tutorials/programs/` show what their programs print and draw: the programs are compiled into these tests and run.
//!
//! `PEELKIT_WRITE=1 cargo test --test command examples` writes again what the chapters show, and their pictures.

use super::teaching::last_digit;
use super::{Block, blocks, hold, place, text, writing};
use std::error::Error;
use std::path::Path;

/// The programs, each as a module with its `draw`.
macro_rules! programs {
    ($($name:ident from $path:literal,)*) => {
        $(#[path = $path] #[allow(dead_code)] mod $name;)*
        const PROGRAMS: &[(&str, Draw)] = &[$((stringify!($name), $name::draw)),*];
    };
}

/// Draws the picture of a program in a folder, and gives what it prints.
type Draw = fn(&Path) -> Result<String, Box<dyn Error>>;

programs! {
    kendall_and_stiffness from "../../../examples/kendall_and_stiffness.rs",
    why_arc_length from "../../../examples/why_arc_length.rs",
    contact_moment from "../../../examples/contact_moment.rs",
    half_space_against_atoms from "../../../examples/half_space_against_atoms.rs",
    spatula_pull_off from "../../../examples/spatula_pull_off.rs",
    best_stiffness from "../../../examples/best_stiffness.rs",
    what_is_uncertain from "../../../examples/what_is_uncertain.rs",
}

/// Whether two words are the same, or numbers that differ by no more than their last digit.
fn is_same(shown: &str, printed: &str) -> bool {
    let number = |word: &str| word.trim_end_matches([',', ';', ':', '.']).parse::<f64>();
    match (number(shown), number(printed)) {
        (Ok(a), Ok(b)) => (a - b).abs() <= last_digit(shown.trim_end_matches([',', ';', ':', '.'])),
        _ => shown == printed,
    }
}

fn agree(shown: &str, printed: &str) -> bool {
    let (a, b): (Vec<_>, Vec<_>) = (shown.split_whitespace().collect(), printed.split_whitespace().collect());
    a.len() == b.len() && a.iter().zip(&b).all(|(a, b)| is_same(a, b))
}

/// The words of a picture: titles, labels, the texts of ticks.
fn words(svg: &str) -> Vec<&str> {
    let texts = svg.split("</text>").filter_map(|part| Some(part.rsplit_once('>')?.1.trim()));
    texts.filter(|text| !text.is_empty()).collect()
}

/// The block of a chapter that shows what its program prints.
fn shown(chapter: &str) -> Option<Block> {
    blocks(chapter).into_iter().find(|block| block.kind == "text")
}

#[test]
fn chapters_show_what_their_programs_print_and_draw() {
    let mut wrong = Vec::new();
    for &(name, draw) in PROGRAMS {
        let (stem, folder) = (name.replace('_', "-"), tempfile::tempdir().unwrap());
        let printed = draw(folder.path()).unwrap_or_else(|error| panic!("{name}: {error}"));
        let path = format!("docs/tutorials/programs/{stem}.md");
        let chapter = text(&path);
        let block = shown(&chapter).unwrap_or_else(|| panic!("{path} shows nothing that is printed"));
        let drawn = std::fs::read_to_string(folder.path().join(format!("{name}.svg"))).unwrap();
        assert!(!drawn.contains("NaN") && folder.path().join(format!("{name}.png")).is_file(), "{name}");
        let picture = format!("docs/tutorials/programs/{stem}.svg");
        if writing() {
            let lines: Vec<&str> = chapter.lines().collect();
            let fresh = printed.trim_end().lines();
            let all =
                lines[..block.lines.start].iter().copied().chain(fresh).chain(lines[block.lines.end..].iter().copied());
            hold(&path, &(all.collect::<Vec<_>>().join("\n") + "\n"));
            std::fs::write(place(&picture), &drawn).unwrap();
            continue;
        }
        if !agree(&block.text, &printed) {
            wrong.push(format!("{path}: the program prints\n{printed}"));
        }
        if words(&text(&picture)) != words(&drawn) {
            wrong.push(format!("{picture} is not what the program draws"));
        }
        for needed in [format!("examples/{name}.rs"), format!("--example {name}"), format!("({stem}.svg)")] {
            if !chapter.contains(&needed) {
                wrong.push(format!("{path} lacks {needed}"));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// What a reader needs to begin with.
#[test]
fn programs_say_what_they_show() {
    for (name, _) in PROGRAMS {
        let code = text(&format!("examples/{name}.rs"));
        let header: String = code.lines().take_while(|line| line.starts_with("//!")).collect();
        for part in ["What it shows:", "Equations:", "What to try:", &format!("--example {name}")] {
            assert!(header.contains(part), "examples/{name}.rs lacks {part}");
        }
        let lines = code.lines().map(str::trim).filter(|line| !line.starts_with("//") && !line.is_empty()).count();
        assert!(lines <= 80, "examples/{name}.rs: {lines} lines of code");
    }
}
