//! The command line as it was typed, for the outputs.

use std::path::Path;

/// The command and its arguments, quoted as a shell needs them; the command without its folder.
pub fn command_line() -> String {
    joined(&words())
}

/// Its words; the first is the command without its folder.
pub fn words() -> Vec<String> {
    let mut words: Vec<String> = std::env::args_os().map(|word| word.to_string_lossy().into_owned()).collect();
    if let Some(first) = words.first_mut() {
        let name = Path::new(&*first).file_stem().map(|name| name.to_string_lossy().into_owned());
        *first = name.unwrap_or_else(|| "peel".to_owned());
    }
    words
}

/// Words with spaces between, those in quotes that a shell would take apart.
pub fn joined(words: &[String]) -> String {
    // fails for a word with a zero byte, which no command line has
    let quoted = |word: &String| shlex::try_quote(word).map_or_else(|_| word.clone(), |word| word.into_owned());
    words.iter().map(quoted).collect::<Vec<_>>().join(" ")
}

#[cfg(test)]
mod tests {
    use super::joined;

    #[test]
    fn what_a_shell_reads_again_is_the_same() {
        let words = ["peel", "run", "a b.toml", "--set", "strip.length=50 nm", "it's"].map(str::to_owned);
        assert_eq!(shlex::split(&joined(&words)).unwrap(), words);
    }
}
