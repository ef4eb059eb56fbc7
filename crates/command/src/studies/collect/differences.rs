//! In what two divided sweeps differ.

use crate::text_summary::number::spaced;
use peelkit_report::{DividedSweep, PartAxis};
use peelkit_scene::{KEYS, Key, Scene, find_key};

/// The first difference between two sweeps that are not the same, as the end of a message.
pub fn difference(a: &DividedSweep, b: &DividedSweep) -> String {
    if a.peelkit != b.peelkit {
        return format!("they were computed by peel {} and peel {}", a.peelkit, b.peelkit);
    }
    if a.of != b.of {
        return format!("one is divided into {} parts, the other into {}", a.of, b.of);
    }
    let keys = |sweep: &DividedSweep| sweep.vary.iter().map(|axis| axis.key.as_str()).collect::<Vec<_>>().join(" and ");
    if keys(a) != keys(b) {
        return format!("one varies {}, the other {}", keys(a), keys(b));
    }
    let of_axes = a.vary.iter().zip(&b.vary).find_map(|(a, b)| of_axis(a, b));
    of_axes.or_else(|| of_scenes(&a.scene, &b.scene)).unwrap_or_else(|| "their scenes are written differently".into())
}

fn of_axis(a: &PartAxis, b: &PartAxis) -> Option<String> {
    let (key, [m, n]) = (&a.key, [a.values.len(), b.values.len()]);
    if m != n {
        return Some(format!("{key} has {m} values in one and {n} in the other"));
    }
    if a.log != b.log {
        return Some(format!("{key} is varied with --log in one of them alone"));
    }
    let at = a.values.iter().zip(&b.values).position(|(a, b)| a.to_bits() != b.to_bits())?;
    let unit = find_key(key).map_or("", Key::unit);
    let [x, y] = [a, b].map(|axis| format!("{}{}", axis.values[at], spaced(unit)));
    Some(format!("value {} of {key} is {x} in one and {y} in the other", at + 1))
}

/// The first key that the scenes give differently.
fn of_scenes(a: &str, b: &str) -> Option<String> {
    let [a, b] = [a, b].map(|text| Scene::parse("part", text, &[]).ok());
    let (a, b) = a.zip(b)?;
    let value = |key: &Key, scene: &Scene| key.belongs_to(scene).then(|| key.value(scene)).flatten();
    let key = KEYS.iter().find(|key| value(key, &a) != value(key, &b))?;
    let shown = |scene: &Scene| {
        value(key, scene).map_or_else(|| "not given".to_owned(), |value| format!("{value}{}", spaced(key.unit())))
    };
    Some(format!("{} is {} in one and {} in the other", key.path(), shown(&a), shown(&b)))
}
