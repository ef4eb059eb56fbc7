//! The folder of a command's outputs where the user names none: commands that differ in what they compute have different ones.

use std::collections::hash_map::DefaultHasher;
use std::hash::{Hash, Hasher};
use std::path::{Path, PathBuf};

/// A longer name is cut, and ends with a number that stands for all of it.
const LONGEST: usize = 100;

/// `out/` and the name of the scene, with what the command adds to it and with the keys that it sets: `out/strip-strip.length-50nm`, in letters that no shell quotes. Keys of
/// `[bounds]` stay out: an unfinished run goes on in its folder with others.
pub fn default_folder(scene: &Path, parts: &[String], overrides: &[(String, String)]) -> PathBuf {
    let mut name = scene.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    let sets = overrides.iter().filter(|(key, _)| !key.starts_with("bounds."));
    // a command that is called as the scene, and says more, and the table of a key that is called as the command, are not said again
    let mut said = String::new();
    let parts = if parts.len() > 1 && parts[0] == name { &parts[1..] } else { parts };
    for part in parts.iter().cloned().chain(sets.map(|(key, value)| format!("{key}={value}"))) {
        let part = match part.split_once('.') {
            Some((table, rest)) if table == said && rest.contains('=') => rest.to_owned(),
            _ => part,
        };
        said = part.clone();
        name += "-";
        let written = part.chars().map(|c| if c == '=' { '-' } else { c });
        name.extend(written.filter(|&c| c.is_alphanumeric() || "._+-".contains(c)));
    }
    Path::new("out").join(cut(name))
}

fn cut(name: String) -> String {
    if name.chars().count() <= LONGEST {
        return name;
    }
    let mut hasher = DefaultHasher::new();
    name.hash(&mut hasher);
    let begins: String = name.chars().take(LONGEST).collect();
    format!("{begins}-{:08x}", hasher.finish() as u32)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn folder(parts: &[&str], overrides: &[(&str, &str)]) -> String {
        let parts: Vec<String> = parts.iter().map(|&part| part.to_owned()).collect();
        let overrides: Vec<_> = overrides.iter().map(|&(key, value)| (key.to_owned(), value.to_owned())).collect();
        default_folder(Path::new("scenes/strip.toml"), &parts, &overrides).display().to_string()
    }

    #[test]
    fn what_differs_has_another_name() {
        assert_eq!(folder(&[], &[]), "out/strip");
        assert_eq!(folder(&["sweep", "strip.length"], &[]), "out/strip-sweep-strip.length");
        let set = [("strip.length", "\"50 nm\""), ("drive.steps", "[\"press 1 nm\", \"hold\"]")];
        assert_eq!(folder(&["observed"], &set), "out/strip-observed-strip.length-50nm-drive.steps-press1nmhold");
        assert_eq!(folder(&[], &[("bounds.time", "3 s")]), "out/strip");
        let samples = [("uncertainty.samples", "1000")];
        assert_eq!(folder(&["uncertainty"], &samples), "out/strip-uncertainty-samples-1000", "no word twice");
        assert_eq!(
            default_folder(Path::new("fit.toml"), &["fit".into(), "meas".into()], &[]),
            Path::new("out/fit-meas")
        );
        assert_eq!(folder(&[], &[("strip.height", "5 nm")]), "out/strip-strip.height-5nm");
        assert_eq!(folder(&[], &[("title", "../../etc")]), "out/strip-title-....etc", "one folder below out/");
    }

    #[test]
    fn long_names_are_cut_and_stay_apart() {
        let long = |last: &str| folder(&[], &[("profile.table", &format!("{}{last}", "x".repeat(400)))]);
        assert!(long("a").len() < 120);
        assert_ne!(long("a"), long("b"));
    }
}
