//! What a sweep varies: `--vary` and what stands behind it, once or twice.
//!
//! With two parameters the options behind each `--vary` belong to it. clap's derive knows no such groups, but it knows the place of every
//! option on the command line.

use crate::terminal::stop::Stop;
use clap::{Arg, ArgAction, ArgMatches, Args, Command, Error, FromArgMatches, value_parser};

/// One key and the values that it takes, as they were typed.
#[derive(Clone, Debug, PartialEq)]
pub struct Parameter {
    pub path: String,
    pub values: TypedValues,
    /// Logarithmic spacing of a range, and axis of the picture.
    pub log: bool,
}

/// The values of a parameter as they were typed.
#[derive(Clone, Debug, PartialEq)]
pub enum TypedValues {
    Range { from: String, to: String, points: usize },
    List(Vec<String>),
}

/// All options that say what is varied, with their places on the command line.
#[derive(Clone, Debug, Default)]
pub struct Varied {
    vary: Vec<(usize, String)>,
    from: Vec<(usize, String)>,
    to: Vec<(usize, String)>,
    points: Vec<(usize, u32)>,
    values: Vec<(usize, String)>,
    log: Vec<(usize, bool)>,
}

/// Most parameters of a sweep.
const MOST: usize = 2;

impl Varied {
    /// The parameters, each with the options behind it; of a single one the options may stand before it.
    pub fn parameters(&self) -> Result<Vec<Parameter>, Stop> {
        if self.vary.len() > MOST {
            return Err(Stop::bad_input(
                format!("--vary is given {} times: a sweep varies one key or two", self.vary.len()),
                "Sweep two keys, and set the others with --set.",
            ));
        }
        (0..self.vary.len()).map(|index| self.parameter(index)).collect()
    }

    /// The keys, as they were typed.
    pub fn paths(&self) -> impl Iterator<Item = &str> {
        self.vary.iter().map(|(_, path)| path.as_str())
    }

    fn parameter(&self, index: usize) -> Result<Parameter, Stop> {
        let begins = if index == 0 { 0 } else { self.vary[index].0 };
        let ends = self.vary.get(index + 1).map_or(usize::MAX, |next| next.0);
        let path = self.vary[index].1.clone();
        let one = |name: &str, given: &[(usize, String)]| {
            let mine: Vec<&String> =
                given.iter().filter(|(at, _)| (begins..ends).contains(at)).map(|(_, text)| text).collect();
            match mine[..] {
                [] => Ok(None),
                [text] => Ok(Some(text.clone())),
                _ => Err(twice(name, &path)),
            }
        };
        let points: Vec<(usize, String)> = self.points.iter().map(|(at, points)| (*at, points.to_string())).collect();
        let (from, to) = (one("from", &self.from)?, one("to", &self.to)?);
        let (points, values) = (one("points", &points)?, one("values", &self.values)?);
        let values = match (from, to, points, values) {
            (None, None, None, Some(list)) => {
                if list.trim().is_empty() {
                    return Err(incomplete(&path, "has an empty list of --values"));
                }
                TypedValues::List(list.split(',').map(|text| text.trim().to_owned()).collect())
            }
            (Some(from), Some(to), Some(points), None) => {
                TypedValues::Range { from, to, points: points.parse().unwrap_or(1) }
            }
            (.., Some(_)) => return Err(incomplete(&path, "has --values and a range as well")),
            _ => return Err(incomplete(&path, "has no values, or a range without its --from, --to or --points")),
        };
        let log = self.log.iter().any(|(at, _)| (begins..ends).contains(at));
        Ok(Parameter { path, values, log })
    }
}

fn twice(name: &str, path: &str) -> Stop {
    Stop::bad_input(
        format!("--{name} is given twice for --vary {path}"),
        "With two keys, write behind each --vary the options that belong to it.",
    )
}

fn incomplete(path: &str, problem: &str) -> Stop {
    Stop::bad_input(
        format!("--vary {path} {problem}"),
        format!(
            "Write --vary {path} --from A --to B --points N, or --vary {path} --values A,B,C. With two keys, the options behind each --vary \
             belong to it."
        ),
    )
}

impl Args for Varied {
    fn augment_args(command: Command) -> Command {
        let option = |name: &'static str, value: &'static str, help: &'static str| {
            Arg::new(name).long(name).value_name(value).action(ArgAction::Append).help(help)
        };
        let points = option("points", "N", "Number of values, both ends included");
        let log = Arg::new("log").long("log").action(ArgAction::Append).num_args(0).default_missing_value("true");
        command
            .arg(option("vary", "KEY", "The key to vary (see peel keys); twice for a plane").required(true))
            .arg(option("from", "A", "First value, with its unit: \"100 nm\"").allow_hyphen_values(true))
            .arg(option("to", "B", "Last value, with its unit").allow_hyphen_values(true))
            .arg(points.value_parser(value_parser!(u32).range(1..=1_000_000)))
            .arg(option("values", "LIST", "Values in place of a range: 1,2,5nm").allow_hyphen_values(true))
            .arg(log.value_parser(value_parser!(bool)).help("Logarithmic spacing and axis").long_help(
                "Logarithmic spacing and axis: equal ratios instead of equal differences\n\nValues must be above zero.",
            ))
    }

    fn augment_args_for_update(command: Command) -> Command {
        Self::augment_args(command)
    }
}

impl FromArgMatches for Varied {
    fn from_arg_matches(matches: &ArgMatches) -> Result<Self, Error> {
        Ok(Self {
            vary: placed(matches, "vary"),
            from: placed(matches, "from"),
            to: placed(matches, "to"),
            points: placed(matches, "points"),
            values: placed(matches, "values"),
            log: placed(matches, "log"),
        })
    }

    fn update_from_arg_matches(&mut self, matches: &ArgMatches) -> Result<(), Error> {
        *self = Self::from_arg_matches(matches)?;
        Ok(())
    }
}

/// The values of an option with their places on the command line.
fn placed<T: Clone + Send + Sync + 'static>(matches: &ArgMatches, name: &str) -> Vec<(usize, T)> {
    let places = matches.indices_of(name).into_iter().flatten();
    places.zip(matches.get_many::<T>(name).into_iter().flatten().cloned()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parameters(words: &str) -> Result<Vec<Parameter>, Stop> {
        let command = Varied::augment_args(Command::new("sweep"));
        let words = shlex::split(&format!("sweep {words}")).unwrap();
        Varied::from_arg_matches(&command.get_matches_from(words)).unwrap().parameters()
    }

    fn list(path: &str, values: &[&str], log: bool) -> Parameter {
        let values = TypedValues::List(values.iter().map(|value| (*value).to_owned()).collect());
        Parameter { path: path.into(), values, log }
    }

    fn range(path: &str, from: &str, to: &str, points: usize, log: bool) -> Parameter {
        Parameter { path: path.into(), values: TypedValues::Range { from: from.into(), to: to.into(), points }, log }
    }

    #[test]
    fn of_one_key_the_options_stand_anywhere() {
        let expected = [range("a", "1 nm", "2 nm", 3, true)];
        for words in [
            "--vary a --from '1 nm' --to '2 nm' --points 3 --log",
            "--log --points 3 --from '1 nm' --to '2 nm' --vary a",
        ] {
            assert_eq!(parameters(words).unwrap(), expected);
        }
        assert_eq!(parameters("--vary a --values '1, 2,5 nm'").unwrap(), [list("a", &["1", "2", "5 nm"], false)]);
        assert_eq!(parameters("--vary a --values -1,2").unwrap(), [list("a", &["-1", "2"], false)]);
    }

    #[test]
    fn of_two_keys_the_options_belong_to_the_one_before_them() {
        let found = parameters("--vary a --from 1 --to 2 --points 3 --vary b --values 4,5 --log").unwrap();
        assert_eq!(found, [range("a", "1", "2", 3, false), list("b", &["4", "5"], true)]);
        let found = parameters("--vary a --log --values 1,2 --vary b --values 4,5").unwrap();
        assert_eq!(found, [list("a", &["1", "2"], true), list("b", &["4", "5"], false)]);
    }

    #[test]
    fn what_is_incomplete_or_given_twice_is_refused() {
        for words in [
            "--vary a",
            "--vary a --from 1 --to 2",
            "--vary a --from 1 --to 2 --points 3 --values 1",
            "--vary a --vary b --values 1 --values 2",
            "--vary a --values 1 --values 2",
            "--vary a --values ''",
            "--vary a --values 1 --vary b --values 2 --vary c --values 3",
        ] {
            assert!(parameters(words).is_err(), "{words}");
        }
    }
}
