//! A scene written as a text that reads as the same scene, to the last bit.

use super::key::Key;
use super::key::kind::Kind;
use super::keys::KEYS;
use super::scene::Scene;
use super::value::Value;
use std::fmt::Write;
use toml::Table;

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
