//! From TOML texts to a scene and back: finds every key, hands its value over, and says where a problem stands; and writes a scene as a
//! text that reads as the same scene, to the last bit.

use crate::body::{BODIES, body_of, set_body, set_space};
use crate::conflict::Conflict;
use crate::error::{Origin, SceneError, ValueError, nearest, one_line};
use crate::key::belongs::in_place_of;
use crate::key::kind::{Key, Kind};
use crate::key::table::{SETA, SETAE, SOLID, TIME};
use crate::keys::{KEYS, find_key, tables};
use crate::scene::{Described, Scene};
use crate::tables::setae::{array, seta};
use crate::tables::{rate, solid};
use crate::value::Value;
use crate::value::quantity::Comma;
use peelkit::model::{Adhesion, Space};
use std::collections::HashSet;
use std::fmt::Write;
use std::ops::Range;
use toml::de::{DeTable, DeValue};
use toml::{Spanned, Table};

impl Scene {
    /// Reads a scene. `name` is that of the file and stands in every message; `overrides` are keys with values that
    /// replace those of the text (`--set`): a TOML value, or a text without its quotes.
    ///
    /// An error names the first mistake, where it stands, and what would be right.
    ///
    /// ```
    /// use peelkit_scene::Scene;
    ///
    /// let text = r#"
    /// [strip]
    /// length = "0.1 um"
    /// height = "10 nm"
    /// youngs_modulus = "2 GPa"
    /// [adhesion]
    /// hamaker_constant = "1e-19 J"
    /// equilibrium_distance = "0.4 nm"
    /// "#;
    /// let scene = Scene::parse("strip.toml", text, &[("strip.height".into(), "5 nm".into())])?;
    /// assert_eq!((scene.model.length(), scene.model.free_end()), (100.0, (1.0, 5.0)));
    ///
    /// let error = Scene::parse("strip.toml", &text.replace("10 nm", "10"), &[]).unwrap_err();
    /// assert_eq!(error.to_string(), "strip.toml, line 4: `strip.height` is \"10\", a number without a unit");
    /// # Ok::<(), peelkit_scene::SceneError>(())
    /// ```
    pub fn parse(name: &str, text: &str, overrides: &[(String, String)]) -> Result<Self, SceneError> {
        let scene = Self::parse_any(name, text, overrides)?;
        let file = Origin::File { name, text };
        match scene.describes() {
            Described::Rate(..) => Err(rate::refused(&file, header_of(text, TIME.name))),
            Described::Solid(_) => Err(solid::refused(&file, header_of(text, SOLID.name))),
            Described::Array(_) => Err(array::refused(&file, header_of(text, SETAE.name))),
            Described::Seta(_) => Err(seta::refused(&file, header_of(text, SETA.name))),
            Described::Peel => Ok(scene),
        }
    }

    /// The same, of a scene that may have a seta or a solid, or be pulled at a rate, which [`Scene::parse`] refuses: who reads this has to look at
    /// [`Scene::describes`].
    pub fn parse_any(name: &str, text: &str, overrides: &[(String, String)]) -> Result<Self, SceneError> {
        let file = Origin::File { name, text };
        let document = DeTable::parse(text).map_err(|error| not_toml(&file, text, &error))?;
        let document = document.get_ref();
        let (scene, conflict) = read(name, text, document, overrides)?;
        match conflict {
            None => Ok(scene),
            Some(conflict) => Err(match guilty(name, text, document, overrides, &conflict) {
                Some((path, value)) => conflict.of_override(path, value),
                None => in_file(&file, text, document, &conflict),
            }),
        }
    }
}

impl Scene {
    /// As [`Scene::parse_any`], of a text that somebody else wrote: no file is read. A table of such a scene stands in its text; one that
    /// is the name of a file or of a folder is refused, wherever it stands.
    pub fn parse_without_files(name: &str, text: &str, overrides: &[(String, String)]) -> Result<Self, SceneError> {
        let file = Origin::File { name, text };
        let document = DeTable::parse(text).map_err(|error| not_toml(&file, text, &error))?;
        for key in KEYS.iter().filter(|key| key.reads_a_file() || names_a_folder(key)) {
            let table = document.get_ref().iter().find(|(table, _)| name_of(table) == key.table);
            let keys = table.and_then(|(_, table)| table.get_ref().as_table());
            let value = keys.and_then(|keys| keys.iter().find(|(name, _)| name_of(name) == key.name));
            let named = value.filter(|(_, value)| value.get_ref().as_str().is_some_and(|text| !text.contains('\n')));
            if let Some((_, value)) = named {
                return Err(file.error(value.span(), &format!("`{}`", key.path()), names_a_file(key)));
            }
            if let Some((path, value)) = overrides.iter().find(|(path, _)| path.trim() == key.path()) {
                let text = format!("{path}={value}");
                let origin = Origin::Override { text: &text };
                return Err(origin.error(0..path.len(), &format!("`{}`", key.path()), names_a_file(key)));
            }
        }
        Self::parse_any(name, text, overrides)
    }
}

/// Whether a key is the folder of the law of tips, or of a seta, or the scene of that.
fn names_a_folder(key: &Key) -> bool {
    (key.table, key.name) == (SETA.name, "tip_table") || is_law(key) || is_seta(key)
}

fn is_seta(key: &Key) -> bool {
    (key.table, key.name) == (SETAE.name, "seta")
}

fn is_law(key: &Key) -> bool {
    (key.table, key.name) == (SETAE.name, "law")
}

fn names_a_file(key: &Key) -> ValueError {
    if is_law(key) {
        return ValueError::new(
            "names a folder, and this scene is read without files",
            "Put the lines of its seta_law.toml into the scene, between \"\"\" and \"\"\".",
        );
    }
    if is_seta(key) {
        return ValueError::new(
            "names a file, and this scene is read without files",
            "Put the lines of that scene into this one, between \"\"\" and \"\"\", or remove `seta`.",
        );
    }
    match names_a_folder(key) {
        true => ValueError::new(
            "names a folder, and this scene is read without files",
            "Remove `tip_table`: the run computes the table.",
        ),
        false => ValueError::new(
            "names a file, and this scene is read without files",
            "Put the lines of the table into the scene, between \"\"\" and \"\"\".",
        ),
    }
}

/// Where the name of a table stands in a text, or its end.
fn header_of(text: &str, table: &str) -> Range<usize> {
    let document = DeTable::parse(text).ok();
    let found = document.as_ref().and_then(|all| all.get_ref().iter().find(|(name, _)| name_of(name) == table));
    found.map_or_else(|| end_of(text), |(name, _)| name.span())
}

/// The scene of the text and the overrides, and what of it does not fit the rest.
fn read(
    name: &str,
    text: &str,
    document: &DeTable,
    overrides: &[(String, String)],
) -> Result<(Scene, Option<Conflict>), SceneError> {
    let mut scene = Scene::empty(name);
    let mut given = fill(&mut scene, text, document)?;
    for (path, value) in overrides {
        let key = set(&mut scene, path, value)?;
        // what the text says of a seta gives way to what stands in its place by an override
        let is_replaced = |path: &String| {
            let name = path.strip_prefix(SETA.name).and_then(|rest| rest.strip_prefix('.'));
            key.table == SETA.name
                && name.and_then(|name| in_place_of(&scene, name)) == Some(key.name)
                && !overrides.iter().any(|(other, _)| other.trim() == path)
        };
        given.retain(|path| !is_replaced(path));
        given.insert(key.path());
    }
    supply_half_space(&mut scene, &mut given);
    let conflict = Conflict::find(&scene, &given);
    Ok((scene, conflict))
}

/// Fills the scene from the text; the keys that it gives.
fn fill(scene: &mut Scene, text: &str, document: &DeTable) -> Result<HashSet<String>, SceneError> {
    let name = scene.name.clone();
    let file = Origin::File { name: &name, text };
    let mut given = HashSet::new();
    // one without keys may stand alone; beside another one it is not meant
    let has_keys = |value: &Spanned<DeValue>| value.get_ref().as_table().is_some_and(|table| !table.is_empty());
    let bodies: Vec<_> = in_order(document).into_iter().filter(|(key, _)| BODIES.contains(&name_of(key))).collect();
    if let Some((table, _)) = bodies.iter().find(|(_, value)| has_keys(value)).or(bodies.first()) {
        set_body(scene, name_of(table));
    }
    take_kinds(scene, &file, document)?;
    place_in_space(scene, &file, document)?;
    if document.iter().any(|(table, _)| name_of(table) == SETA.name) {
        begin_seta(scene, bodies.is_empty());
    }
    // what can be asked for depends on whether there is a rate
    let (rate, others): (Vec<&str>, Vec<&str>) =
        document.iter().map(|(table, _)| name_of(table)).partition(|table| *table == TIME.name);
    for table in rate.into_iter().chain(others) {
        KEYS.iter().find(|key| key.table == table).into_iter().for_each(|key| (key.of.begin)(scene));
    }
    for (key, value) in in_order(document) {
        match value.get_ref() {
            DeValue::Table(table) if tables().contains(&name_of(key)) => {
                if table.is_empty() {
                    check_body(scene, &file, key)?;
                }
                for (inner, value) in in_order(table) {
                    let key = lookup(&file, name_of(key), inner)?;
                    if !key.belongs_to(scene) {
                        let subject = format!("`{}`", key.path());
                        return Err(file.error(inner.span(), &subject, key.foreign(scene)));
                    }
                    store(scene, &file, key, value)?;
                    given.insert(key.path());
                }
            }
            DeValue::Table(_) => return Err(unknown_table(&file, key)),
            found if tables().contains(&name_of(key)) => {
                let table = name_of(key);
                let problem = ValueError::new(
                    format!("is {}", convert(found, 0)),
                    format!("It is a table: write [{table}] on a line of its own and its keys below it."),
                );
                return Err(file.error(value.span(), &format!("`{table}`"), problem));
            }
            _ => {
                let (found, place) = (lookup(&file, "", key)?, key.span());
                if !found.belongs_to(scene) {
                    return Err(file.error(place, &format!("`{}`", found.path()), found.foreign(scene)));
                }
                store(scene, &file, found, value)?;
                given.insert(found.path());
            }
        }
    }
    Ok(given)
}

/// Makes the scene one with a seta, whose root is moved in space; its tips are spatulae where it names no body.
fn begin_seta(scene: &mut Scene, without_body: bool) {
    scene.seta_table();
    scene.model.space = Some(Space::default());
    if without_body {
        set_body(scene, "spatula");
    }
}

/// Refuses a body without keys beside another one, which would be ignored.
fn check_body(scene: &Scene, file: &Origin, table: &Spanned<toml::de::DeString>) -> Result<(), SceneError> {
    let (found, body) = (name_of(table), body_of(scene));
    if found == body || !BODIES.contains(&found) {
        return Ok(());
    }
    let problem = ValueError::new(
        format!("stands beside [{body}], and a scene peels one body"),
        format!(
            "Remove one of the tables. A scene has one of [{}]; a [seta] may stand beside a [spatula].",
            BODIES.join("], [")
        ),
    );
    Err(file.error(table.span(), &format!("[{found}]"), problem))
}

/// A cohesive law with a work of adhesion and a strength of its own takes nothing from the half space but where a face is closed. What is not
/// given of that: the pair distance is a share of the opening, and the Hamaker constant that of a half space with this work.
fn supply_half_space(scene: &mut Scene, given: &mut HashSet<String>) {
    let adhesion = &mut scene.model.adhesion;
    let Some(distance) = adhesion.distance_of_work_and_strength() else { return };
    let Some([work, _]) = adhesion.own_work_and_strength() else { return };
    if given.insert("adhesion.equilibrium_distance".to_owned()) {
        adhesion.equilibrium_distance = distance.clamp(f64::MIN_POSITIVE, f64::MAX);
    }
    if given.insert("adhesion.hamaker_constant".to_owned()) {
        let of_one = Adhesion { hamaker_constant: 1.0, ..*adhesion }.half_space().work_of_adhesion();
        adhesion.hamaker_constant = (work / of_one).clamp(f64::MIN_POSITIVE, f64::MAX);
    }
}

/// The override without which there would be no such conflict: the one that gives its key, or else the last one that it needs.
fn guilty<'a>(
    name: &str,
    text: &str,
    document: &DeTable,
    overrides: &'a [(String, String)],
    conflict: &Conflict,
) -> Option<(&'a str, &'a str)> {
    let gives = |(path, _): &&(String, String)| path.trim() == conflict.key;
    let needed = |&index: &usize| {
        let others = [&overrides[..index], &overrides[index + 1..]].concat();
        read(name, text, document, &others).is_ok_and(|(_, found)| found.is_none_or(|found| found.key != conflict.key))
    };
    let found = overrides.iter().rev().find(gives);
    let found = found.or_else(|| (0..overrides.len()).rev().find(needed).map(|index| &overrides[index]));
    found.map(|(path, value)| (path.as_str(), value.as_str()))
}

/// The message about a conflict, at the key in the file or where it would stand.
fn in_file(file: &Origin, text: &str, document: &DeTable, conflict: &Conflict) -> SceneError {
    let table = conflict.key.split_once('.').map_or("", |(table, _)| table);
    let header = in_order(document).into_iter().find(|(name, _)| name_of(name) == table);
    match (&conflict.missing, header) {
        (None, _) => {
            let span = place_of(document, &conflict.key).unwrap_or_else(|| end_of(text));
            file.error(span, &format!("`{}`", conflict.key), conflict.problem.clone())
        }
        (Some(missing), Some((header, _))) => {
            file.error(header.span(), &format!("[{table}]"), missing.in_table.clone())
        }
        (Some(missing), None) => file.error(end_of(text), "the scene", missing.table.clone()),
    }
}

/// Gives the substrate the shape and the adhesion the law that the text names, which say what their other keys mean.
fn take_kinds(scene: &mut Scene, file: &Origin, document: &DeTable) -> Result<(), SceneError> {
    let decides = |key: &&Key| matches!(key.kind, Kind::Shape(_)) || key.path() == "adhesion.law";
    for key in KEYS.iter().filter(decides) {
        let table = document.iter().find(|(name, _)| name_of(name) == key.table);
        let Some(DeValue::Table(table)) = table.map(|(_, table)| table.get_ref()) else { continue };
        if let Some((_, value)) = table.iter().find(|(name, _)| name_of(name) == key.name) {
            store(scene, file, key, value)?;
        }
    }
    Ok(())
}

/// Puts the scene in space where the text says so, or where it says nothing of that and gives a key of space.
fn place_in_space(scene: &mut Scene, file: &Origin, document: &DeTable) -> Result<(), SceneError> {
    let Some(key) = KEYS.iter().find(|key| matches!(key.kind, Kind::InSpace)) else { return Ok(()) };
    if let Some((_, value)) = document.iter().find(|(name, _)| name_of(name) == key.name) {
        return store(scene, file, key, value);
    }
    let is_of_space =
        |table: &str, name: &str| KEYS.iter().any(|key| key.is_of_space() && key.table == table && key.name == name);
    let implied = document.iter().any(|(table, value)| {
        let keys = value.get_ref().as_table();
        keys.is_some_and(|keys| keys.iter().any(|(name, _)| is_of_space(name_of(table), name_of(name))))
    });
    set_space(scene, implied);
    Ok(())
}

/// Applies one `--set`.
fn set(scene: &mut Scene, path: &str, value: &str) -> Result<&'static Key, SceneError> {
    let text = format!("{path}={value}");
    let origin = Origin::Override { text: &text };
    let key =
        find_key(path).map_err(|problem| origin.error(0..path.len(), &format!("`{}`", one_line(path)), problem))?;
    if key.is_of_space() {
        set_space(scene, true);
    }
    (key.of.begin)(scene);
    if !key.belongs_to(scene) {
        return Err(origin.error(0..path.len(), &format!("`{}`", key.path()), key.foreign(scene)));
    }
    let parsed = DeValue::parse(value.trim()).ok().map(|value| convert(value.get_ref(), NESTED));
    let parsed = match parsed {
        Some(parsed @ Value::Text(_)) => parsed,
        Some(parsed) if !key.is_text() => parsed,
        _ => Value::Text(value.trim().to_owned()),
    };
    key.store(scene, &parsed)
        .map_err(|problem| origin.error(path.len() + 1..text.len(), &format!("`{}`", key.path()), problem))?;
    Ok(key)
}

fn store(scene: &mut Scene, file: &Origin, key: &Key, value: &Spanned<DeValue>) -> Result<(), SceneError> {
    let stored = key.store(scene, &convert(value.get_ref(), NESTED));
    stored.map_err(|problem| {
        let item = value.get_ref().as_array().zip(problem.item).and_then(|(items, item)| items.get(item));
        file.error(item.unwrap_or(value).span(), &format!("`{}`", key.path()), problem)
    })
}

/// The entries of a table in the order of the text.
fn in_order<'a, 'i>(table: &'a DeTable<'i>) -> Vec<(&'a Spanned<toml::de::DeString<'i>>, &'a Spanned<DeValue<'i>>)> {
    let mut entries: Vec<_> = table.iter().collect();
    entries.sort_by_key(|(key, _)| key.span().start);
    entries
}

fn name_of<'a>(key: &'a Spanned<toml::de::DeString>) -> &'a str {
    key.get_ref()
}

/// How deep a value is that a key takes: a list of tables of lists.
const NESTED: usize = 3;

/// The value, with nothing deeper than `levels`.
fn convert(value: &DeValue, levels: usize) -> Value {
    match value {
        DeValue::String(text) => Value::Text(text.to_string()),
        DeValue::Integer(integer) => match i64::from_str_radix(integer.as_str(), integer.radix()) {
            Ok(integer) => Value::Number(integer as f64),
            Err(_) => Value::Other("a whole number with too many digits"),
        },
        DeValue::Float(float) => match float.as_str().parse() {
            Ok(float) => Value::Number(float),
            Err(_) => Value::Other("a number that cannot be read"),
        },
        DeValue::Boolean(flag) => Value::Flag(*flag),
        DeValue::Datetime(_) => Value::Other("a date or time"),
        DeValue::Array(_) if levels == 0 => Value::Other("a list"),
        DeValue::Table(_) if levels == 0 => Value::Other("a table"),
        DeValue::Array(items) => Value::List(items.iter().map(|item| convert(item.get_ref(), levels - 1)).collect()),
        DeValue::Table(table) => {
            let entry = |(name, value): (&Spanned<_>, &Spanned<DeValue>)| {
                (name_of(name).to_owned(), convert(value.get_ref(), levels - 1))
            };
            Value::Table(in_order(table).into_iter().map(entry).collect())
        }
    }
}

/// The key of this name in this table, or the message that there is none.
fn lookup(file: &Origin, table: &str, found: &Spanned<toml::de::DeString>) -> Result<&'static Key, SceneError> {
    let name = name_of(found);
    if let Some(key) = KEYS.iter().find(|key| key.table == table && key.name == name) {
        return Ok(key);
    }
    let here: Vec<&str> = KEYS.iter().filter(|key| key.table == table).map(|key| key.name).collect();
    let place = |table: &str| match table {
        "" => "at the top of the file, above the tables".to_owned(),
        table => format!("in the table [{table}]"),
    };
    let remedy = if let Some(elsewhere) = KEYS.iter().find(|key| key.name == name) {
        format!("`{name}` stands {}.", place(elsewhere.table))
    } else if let Some(near) = nearest(name, here.iter().copied()) {
        format!("Did you mean `{near}`?")
    } else if let Some(near) = nearest(name, KEYS.iter().map(|key| key.name)) {
        let tables = KEYS.iter().filter(|key| key.name == near).map(|key| place(key.table));
        format!("Did you mean `{near}`, which stands {}?", tables.collect::<String>())
    } else {
        format!("The keys {} are {}.", place(table), here.join(", "))
    };
    let shown = one_line(name);
    let subject = if table.is_empty() { format!("`{shown}`") } else { format!("`{table}.{shown}`") };
    Err(file.error(found.span(), &subject, ValueError::new("is not a key of a scene", remedy)))
}

fn unknown_table(file: &Origin, found: &Spanned<toml::de::DeString>) -> SceneError {
    let remedy = match nearest(name_of(found), tables()) {
        Some(near) => format!("Did you mean [{near}]?"),
        None => format!("The tables are [{}].", tables().join("], [")),
    };
    let problem = ValueError::new("is not a table of a scene", remedy);
    file.error(found.span(), &format!("[{}]", one_line(name_of(found))), problem)
}

/// Where the value of the key of this path stands in a text, if it does.
fn place_of(document: &DeTable, path: &str) -> Option<Range<usize>> {
    let Some((in_table, key)) = path.split_once('.') else {
        return document.iter().find(|(name, _)| name_of(name) == path).map(|(key, _)| key.span());
    };
    let (_, table) = document.iter().find(|(name, _)| name_of(name) == in_table)?;
    let DeValue::Table(table) = table.get_ref() else { return None };
    table.iter().find(|(name, _)| name_of(name) == key).map(|(_, value)| value.span())
}

/// Behind the last character of a text.
fn end_of(text: &str) -> Range<usize> {
    let end = text.trim_end().len();
    end..end
}

fn not_toml(file: &Origin, text: &str, error: &toml::de::Error) -> SceneError {
    let span = error.span().unwrap_or_else(|| end_of(text));
    let reason = error.message().lines().collect::<Vec<_>>().join("; ");
    let general = "A scene is a TOML file: [table] on a line of its own, below it key = value; \
                   texts and quantities are in quotes: length = \"100 nm\". `peel new` writes a template.";
    let comma = value_on_line(text, span.start).and_then(Comma::find);
    let remedy = match comma {
        Some(comma) => format!("A number has a decimal point: {}. {general}", one_line(&comma.decimal)),
        None => general.to_owned(),
    };
    file.error(span.clone(), &key_on_line(text, span.start), ValueError::new(format!("is not TOML: {reason}"), remedy))
}

/// The key that stands on the line of this place in a text that is not TOML, or "this".
fn key_on_line(text: &str, at: usize) -> String {
    let key = entry_on_line(text, at).map_or("", |(key, _)| key.trim());
    let is_key = !key.is_empty() && key.chars().all(|c| c.is_alphanumeric() || "._-".contains(c));
    if is_key { format!("`{}`", one_line(key)) } else { "this".to_owned() }
}

/// What stands behind the key on the line of this place.
fn value_on_line(text: &str, at: usize) -> Option<&str> {
    entry_on_line(text, at).map(|(_, value)| value.trim())
}

/// What stands before and behind the sign of equality on the line of this place.
fn entry_on_line(text: &str, at: usize) -> Option<(&str, &str)> {
    let start = text.as_bytes()[..at.min(text.len())].iter().rposition(|&byte| byte == b'\n').map_or(0, |end| end + 1);
    text.get(start..)?.lines().next()?.split_once('=')
}

impl Scene {
    /// The scene as a text with every key that it has a value for, defaults and overrides among them: one line a key, tables in place of the
    /// files that it names. [`Scene::parse`] makes the same scene of it, but for its `name`.
    ///
    /// ```
    /// use peelkit_scene::Scene;
    ///
    /// let text = r#"
    /// strip = { length = "0.1 um", height = "10 nm", youngs_modulus = "2 GPa" }
    /// adhesion = { hamaker_constant = "1e-19 J", equilibrium_distance = "0.4 nm" }
    /// "#;
    /// let scene = Scene::parse("strip.toml", text, &[])?;
    /// assert!(scene.to_toml().contains("length = \"100 nm\""));
    /// assert_eq!(Scene::parse("strip.toml", &scene.to_toml(), &[])?, scene);
    /// # Ok::<(), peelkit_scene::SceneError>(())
    /// ```
    pub fn to_toml(&self) -> String {
        let mut text = String::new();
        let mut table = "";
        for key in KEYS.iter().filter(|key| key.belongs_to(self)) {
            let Some(value) = key.value(self) else { continue };
            if key.table != table {
                table = key.table;
                let _ = write!(text, "\n[{table}]\n");
            }
            let _ = writeln!(text, "{} = {}", key.name, key.written(&value));
        }
        text
    }
}

impl Key {
    /// A value as it stands behind the name of the key.
    fn written(&self, value: &Value) -> toml::Value {
        match value {
            Value::Number(number) if self.is_written_whole(*number) => toml::Value::Integer(*number as i64),
            Value::Number(number) if self.has_unit() => toml::Value::String(format!("{number} {}", self.unit())),
            value => in_toml(value),
        }
    }

    fn has_unit(&self) -> bool {
        matches!(self.kind, Kind::Measure(..) | Kind::Quantity(..) | Kind::Bound(..))
    }
}

fn in_toml(value: &Value) -> toml::Value {
    match value {
        Value::Text(text) => toml::Value::String(text.clone()),
        Value::Number(number) => toml::Value::Float(*number),
        Value::Flag(flag) => toml::Value::Boolean(*flag),
        Value::List(items) => toml::Value::Array(items.iter().map(in_toml).collect()),
        Value::Table(entries) => {
            toml::Value::Table(entries.iter().map(|(name, value)| (name.clone(), in_toml(value))).collect::<Table>())
        }
        // no key of a scene has one
        Value::Other(what) => toml::Value::String((*what).to_owned()),
    }
}
