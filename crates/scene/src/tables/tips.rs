//! What the tips of a seta follow: the keys of it, and which of them go together.

use super::seta::{SetaTable, of};
use crate::error::ValueError;
use crate::form::Form;
use crate::key::kind::Setting;
use crate::value::{Fault, Value, quoted};

/// What the tips of a seta follow.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum SetaTipLaw {
    /// The curve of their spatula, pulled along the normal: a function of the height alone
    #[default]
    Curve,
    /// The table of their spatula: a function of height and rotation
    Table,
}

const LAWS: [(&str, SetaTipLaw); 2] = [("curve", SetaTipLaw::Curve), ("table", SetaTipLaw::Table)];

fn text(value: &Value) -> Result<&str, Fault> {
    match value {
        Value::Text(text) => Ok(text),
        other => Err(Fault::whole(format!("is {other}, and takes a text in quotes"))),
    }
}

/// `tip_law`
pub(crate) static TIP_LAW: Setting = Setting {
    takes: "\"curve\", the normal pull of their spatula, or \"table\", its force and moment at any height and rotation",
    brief: "curve, table",
    example: "\"table\"",
    form: || Form::word(&LAWS),
    read: |scene, value| {
        let word = text(value)?;
        let found = LAWS.iter().find(|(name, _)| *name == word);
        of(scene).tip_law = found.ok_or_else(|| Fault::whole(format!("is {}, no law of tips", quoted(word))))?.1;
        Ok(())
    },
    write: |scene| {
        let law = scene.seta.as_ref()?.tip_law;
        let (word, _) = LAWS.iter().find(|(_, own)| *own == law)?;
        Some(Value::Text((*word).to_owned()))
    },
};

/// `tip_table`
pub(crate) static TIP_TABLE: Setting = Setting {
    takes: "the name of a folder in quotes that `peel coarsen` has written, beside the scene; without it the run computes the table",
    brief: "a folder",
    example: "\"out/spatula-tip\"",
    form: || Form::Text,
    read: |scene, value| {
        let folder = text(value)?;
        if folder.trim().is_empty() {
            return Err(Fault::whole("is empty, and takes the name of a folder".to_owned()));
        }
        of(scene).tip_table = Some(folder.to_owned());
        Ok(())
    },
    write: |scene| Some(Value::Text(scene.seta.as_ref()?.tip_table.clone()?)),
};

/// What of it does not fit the rest: by the key of the table.
pub(crate) fn problem(table: &SetaTable) -> Option<(&'static str, ValueError)> {
    let default = SetaTable::default();
    match table.tip_law {
        SetaTipLaw::Curve if table.tip_table.is_some() => Some((
            "tip_table",
            ValueError::new(
                "names a table, and the tips follow the curve of their normal pull",
                "Give seta.tip_law = \"table\", or remove `tip_table`.",
            ),
        )),
        SetaTipLaw::Curve if table.tip_tolerance != default.tip_tolerance => Some((
            "tip_tolerance",
            ValueError::new(
                "is that of a table, and the tips follow the curve of their normal pull",
                "Give seta.tip_law = \"table\", or remove `tip_tolerance`.",
            ),
        )),
        SetaTipLaw::Curve if table.resolve_within.is_some() => Some((
            "resolve_within",
            ValueError::new(
                "says which tips are no longer taken from a table, and the tips follow the curve of their normal pull",
                "Give seta.tip_law = \"table\", or remove `resolve_within`.",
            ),
        )),
        SetaTipLaw::Table if table.contact_height != default.contact_height => Some((
            "contact_height",
            ValueError::new(
                "is given, and tips that follow their table adhere again where the attraction pulls them down",
                "Remove `contact_height`, or give seta.tip_law = \"curve\".",
            ),
        )),
        _ => None,
    }
}
