//! `peel keys`: the keys of a scene, one line each.

use crate::terminal::help;
use crate::terminal::output::say;
use crate::terminal::stop::Stop;
use clap::Args;
use peelkit_scene::{KEYS, Key, Kind, tables};

/// Lists the keys of a scene with unit, default and range
#[derive(Args)]
#[command(after_help = help::KEYS_EXAMPLES)]
pub struct Keys {
    /// A table of a scene, such as strip; top: the keys above the tables [default: all]
    #[arg(value_name = "TABLE")]
    table: Option<String>,
}

/// What the command calls the place above the tables.
const TOP: &str = "top";
/// Longer ranges stand below the table.
const LONGEST_RANGE: usize = 22;

pub fn keys(args: &Keys) -> Result<(), Stop> {
    let all: Vec<&str> = [TOP].into_iter().chain(tables()).collect();
    let shown = match &args.table {
        None => all,
        Some(table) => {
            let name = table.trim_matches(['[', ']']);
            if !all.contains(&name) {
                return Err(Stop::bad_input(
                    format!("{table} is not a table of a scene"),
                    format!("The tables are {}; {TOP} lists the keys above them.", tables().join(", ")),
                ));
            }
            vec![name]
        }
    };
    let one = shown.len() == 1;
    let mut text: String = shown.iter().map(|table| listed(table, one)).collect::<Vec<_>>().join("\n");
    if !one {
        text += "\n`peel keys TABLE` lists one table, with the words that a key takes. A quantity is a text with its unit: \"100 nm\".\n";
    }
    say(&text)
}

/// The keys of one table; with the words of their choices below where it stands alone.
fn listed(table: &str, alone: bool) -> String {
    let keys: Vec<&Key> = KEYS.iter().filter(|key| key.table == if table == TOP { "" } else { table }).collect();
    let rows: Vec<[String; 5]> = keys.iter().map(|key| row(key)).collect();
    let width =
        |column: usize, least: usize| rows.iter().map(|row| row[column].chars().count()).max().unwrap_or(0).max(least);
    let heading = if table == TOP { "above the tables".to_owned() } else { format!("[{table}]") };
    let widths = [width(0, heading.len()), width(1, 4), width(2, 8), width(3, 5)];
    let line = |cells: [&str; 5]| {
        let [name, unit, default, range, about] = cells;
        let [a, b, c, d] = widths;
        format!("{name:<a$}  {unit:<b$}  {default:<c$}  {range:<d$}  {about}").trim_end().to_owned() + "\n"
    };
    let mut text = line([&heading, "unit", "default", "range", "meaning"]);
    text += &rows.iter().map(|row| line(std::array::from_fn(|i| row[i].as_str()))).collect::<String>();
    if alone {
        text += &keys.iter().filter_map(|key| below(key)).collect::<String>();
        let has_pieces = keys.iter().any(|key| matches!(key.kind, Kind::Pieces(_)));
        text += &if has_pieces { format!("\n{}", help::PIECES) } else { String::new() };
    }
    text
}

fn row(key: &Key) -> [String; 5] {
    let range = match key.range_text() {
        range if range.chars().count() <= LONGEST_RANGE => range,
        _ => format!("{} words", key.choices().len()),
    };
    [key.name.to_owned(), key.usual_unit().to_owned(), key.default_text(), range, key.about.to_owned()]
}

/// What a line has no room for.
fn below(key: &Key) -> Option<String> {
    let shapes = key.shapes();
    if key.range_text().chars().count() > LONGEST_RANGE {
        return Some(format!("\n{}: {}\n", key.name, key.range_text()));
    }
    let other = key.alternative().map(|other| format!("\n{}: or {other} in its place\n", key.name));
    let is_shape = key.name == "shape" || shapes.is_empty() || key.name == "start" || key.name == "offset";
    other.or_else(|| (!is_shape).then(|| format!("\n{}: of the shape {}\n", key.name, shapes.join(", "))))
}
