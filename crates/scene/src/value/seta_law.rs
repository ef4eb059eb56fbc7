//! The law of a seta as a text, which `peel coarsen` of a seta writes and `setae.law` reads.

use super::table::beside;
use crate::error::one_line;
use peelkit::study::coarsening::{ExitPlane, LawSheet, SetaLaw, SetaLawErrors};
use std::fs;
use std::io::ErrorKind;
use toml::{Table, Value as Toml};

/// The file of the law in its folder.
pub const SETA_LAW: &str = "seta_law.toml";
/// What its last line begins with: a check sum of all before it follows.
pub const CHECK: &str = "check = ";
/// A law has less than a thousandth of that.
const MOST_BYTES: u64 = 1_000_000;

/// Reads the law of a seta, and the lines of the seta that it is of.
///
/// ```
/// let error = peelkit_scene::parse_seta_law("degree = 2\n").unwrap_err();
/// assert_eq!(error, "has no check sum in its last line: it is not whole, or not the law of a seta");
/// ```
pub fn parse_seta_law(text: &str) -> Result<(SetaLaw, Vec<String>), String> {
    let whole = text.trim_end();
    let last = whole.rfind('\n').map_or(0, |end| end + 1);
    let (before, check) = whole.split_at(last);
    let check = check.strip_prefix(CHECK).map(|check| check.trim_matches('"'));
    let check = check.ok_or("has no check sum in its last line: it is not whole, or not the law of a seta")?;
    let found = format!("{:08x}", crc32fast::hash(before.as_bytes()));
    if check != found {
        return Err(format!("has been changed: its check sum is {found}, and its last line says {check}"));
    }
    let table: Table = before.parse().map_err(|error: toml::de::Error| format!("is no TOML: {}", error.message()))?;
    let number = |name: &str| table.get(name).and_then(number_of).ok_or_else(|| format!("lacks the number {name}"));
    let degree = number("degree")?;
    let degree = if [2.0, 3.0, 4.0].contains(&degree) { degree as usize } else { 0 };
    let sheets = table.get("sheets").and_then(Toml::as_array).filter(|sheets| !sheets.is_empty());
    let sheets = sheets.ok_or("lacks the list sheets: it is of an earlier peel, and `peel coarsen` makes it anew")?;
    let sheets = sheets.iter().enumerate().map(|(number, sheet)| sheet_of(number, sheet.as_table(), degree));
    let sheets = sheets.collect::<Result<Vec<LawSheet>, String>>()?;
    let lines = table.get("of").and_then(Toml::as_array).map(|lines| lines.iter().filter_map(Toml::as_str));
    let lines = lines.ok_or("lacks the list of")?.map(str::to_owned).collect();
    let law = SetaLaw {
        degree,
        scale: number("scale_nm")?,
        sheets,
        largest_force: number("largest_force_nN")?,
        errors: SetaLawErrors {
            force: number("force_error")?,
            force_left_out: number("force_error_left_out")?,
            exit: number("exit_error")?,
            exit_left_out: number("exit_error_left_out")?,
            peak: number("peak_error")?,
            peak_left_out: number("peak_error_left_out")?,
            work: number("work_error")?,
            work_left_out: number("work_error_left_out")?,
        },
    };
    Ok((law, lines))
}

/// A sheet of a law whose first one has a degree.
fn sheet_of(number: usize, table: Option<&Table>, degree: usize) -> Result<LawSheet, String> {
    let table = table.ok_or_else(|| format!("has no table as sheet {number}"))?;
    let find = |name: &str| table.get(name).ok_or_else(|| format!("lacks {name} on sheet {number}"));
    let list = |name: &str| {
        let all = find(name)?.as_array().and_then(|items| items.iter().map(number_of).collect::<Option<Vec<f64>>>());
        all.ok_or_else(|| format!("has no numbers as {name} on sheet {number}"))
    };
    let single =
        |name: &str| number_of(find(name)?).ok_or_else(|| format!("has no number as {name} on sheet {number}"));
    let coefficients = list("coefficients_aJ")?;
    let degree = if number == 0 { degree } else { 2 };
    let wanted = (degree + 1) * (degree + 2) / 2;
    if degree == 0 || coefficients.len() != wanted {
        let found = coefficients.len();
        return Err(format!(
            "has {found} coefficients of degree {degree} on sheet {number}, and {wanted} belong to it"
        ));
    }
    let direction = list("exit_direction")?.try_into();
    let direction = direction.map_err(|_| format!("has no exit_direction of two numbers on sheet {number}"))?;
    let exit = ExitPlane { direction, distance: single("exit_nm")? };
    Ok(LawSheet { tips: single("tips")? as usize, coefficients, exit })
}

fn number_of(value: &Toml) -> Option<f64> {
    value.as_float().or_else(|| value.as_integer().map(|whole| whole as f64)).filter(|number| number.is_finite())
}

/// What a value gives as the law of a seta.
pub(crate) enum LawRead {
    /// A law, and the text that it was read from
    Known(Box<SetaLaw>, String),
    /// A folder without one, and what is not there
    Missing(String),
}

/// The law that a value gives, a text of several lines or a folder beside the scene.
pub(crate) fn read_seta_law(scene: &str, value: &str) -> Result<LawRead, String> {
    if value.contains('\n') {
        let (law, _) = parse_seta_law(value)?;
        return Ok(LawRead::Known(Box::new(law), value.to_owned()));
    }
    if value.trim().is_empty() {
        return Err("is empty".to_owned());
    }
    let path = beside(scene, value).join(SETA_LAW);
    let shown = path.display();
    let unread = |error| format!("names {shown}, which cannot be read: {error}");
    match fs::metadata(&path) {
        Err(error) if error.kind() == ErrorKind::NotFound => return Ok(LawRead::Missing(unread(error))),
        Err(error) => return Err(unread(error)),
        Ok(found) if found.len() > MOST_BYTES => {
            return Err(format!("names {shown}, which has {} bytes and is no law of a seta", found.len()));
        }
        Ok(_) => {}
    }
    let text = fs::read_to_string(&path).map_err(unread)?;
    let (law, _) = parse_seta_law(&text).map_err(|why| format!("names {shown}, which {why}"))?;
    Ok(LawRead::Known(Box::new(law), text))
}

/// The text of the scene of a seta that a value names, and its place.
pub(crate) fn read_seta_scene(scene: &str, value: &str) -> Result<(String, String), String> {
    let path = beside(scene, value);
    let shown = path.display();
    let unread = |error| format!("names {shown}, which cannot be read: {error}");
    let found = fs::metadata(&path).map_err(unread)?;
    if !found.is_file() || found.len() > MOST_BYTES {
        return Err(format!("names {shown}, which is no file of at most {MOST_BYTES} bytes"));
    }
    Ok((fs::read_to_string(&path).map_err(unread)?, shown.to_string()))
}

/// What of a seta differs between the lines of its law and those that are wanted, in words; nothing where they agree.
pub(crate) fn other_seta(law: &[String], wanted: &[String]) -> Option<String> {
    fn split(line: &str) -> (&str, &str) {
        line.split_once(" = ").unwrap_or((line, ""))
    }
    let value = |lines: &[String], key: &str| {
        let own = lines.iter().map(|line| split(line)).find(|(name, _)| *name == key);
        own.map_or("not given".to_owned(), |(_, value)| one_line(value))
    };
    let differing = wanted.iter().filter(|line| !law.contains(line));
    let removed = law.iter().filter(|line| wanted.iter().all(|other| split(other).0 != split(line).0));
    let keys: Vec<&str> = differing.chain(removed).map(|line| split(line).0).collect();
    let (first, rest) = keys.split_first()?;
    let more = if rest.is_empty() { String::new() } else { format!("; different too: {}", rest.join(", ")) };
    let (there, here) = (value(law, first), value(wanted, first));
    Some(format!("{first} is {there} there, and {here} in the scene that `seta` names{more}"))
}
