//! Links of the documents lead to files that are there, and to headings in them; every chapter is in the list of chapters; what is
//! cited is this version.

use super::{chapters, documents, place, text};
use std::path::Path;

/// What a forge makes of a heading: `## Against scipy's solve_bvp` is `against-scipys-solve_bvp`.
fn anchor(heading: &str) -> String {
    let kept = heading.to_lowercase().chars().filter(|c| c.is_alphanumeric() || " -_".contains(*c)).collect::<String>();
    kept.trim().replace(' ', "-")
}

fn has_heading(document: &str, wanted: &str) -> bool {
    document
        .lines()
        .filter_map(|line| line.strip_prefix('#'))
        .any(|line| anchor(line.trim_start_matches('#')) == wanted)
}

#[test]
fn links_lead_somewhere() {
    let mut broken = Vec::new();
    for path in documents() {
        let document = text(&path);
        let folder = Path::new(&path).parent().unwrap();
        for link in document.split("](").skip(1).filter_map(|rest| rest.split(')').next()) {
            if link.starts_with("http") {
                continue;
            }
            let (file, heading) = link.split_once('#').unwrap_or((link, ""));
            let target = if file.is_empty() { path.clone() } else { folder.join(file).to_str().unwrap().to_owned() };
            let there = place(&target).exists();
            if !there || !heading.is_empty() && !has_heading(&text(&target), heading) {
                broken.push(format!("{path}: {link}"));
            }
        }
    }
    assert!(broken.is_empty(), "{}", broken.join("\n"));
}

#[test]
fn every_chapter_is_in_the_summary() {
    let summary = text("docs/SUMMARY.md");
    let missing: Vec<String> = chapters()
        .into_iter()
        .map(|path| path["docs/".len()..].to_owned())
        .filter(|name| name != "SUMMARY.md" && !summary.contains(&format!("({name})")))
        .collect();
    assert!(missing.is_empty(), "{missing:?}");
}

/// The most lines of the README, of a page that answers one question, and of one that explains.
#[test]
fn pages_are_short() {
    let most = |path: &str| match path {
        "README.md" => 120,
        _ if path.starts_with("docs/how-to/") => 60,
        _ if path.starts_with("docs/explanation/") => 150,
        _ => usize::MAX,
    };
    let lines = |path: &String| text(path).lines().count();
    let long: Vec<_> = documents().into_iter().filter(|path| lines(path) > most(path)).collect();
    assert!(long.is_empty(), "{long:?}");
}

#[test]
fn what_is_cited_is_this_version() {
    let version = format!("\nversion: {}\n", env!("CARGO_PKG_VERSION"));
    assert!(text("CITATION.cff").contains(&version));
}
