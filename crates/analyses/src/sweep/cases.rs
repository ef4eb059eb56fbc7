//! The cases of a sweep: the scene with each value, or each pair of values, in its place.

use crate::outcome::Refusal;
use peelkit_report::{Part, SweptKeys};
use peelkit_scene::{Key, Scene, ValueError};

/// Most cases of a sweep.
const MOST: usize = 1_000_000;

/// A key and its values, in the unit of the library.
pub struct Axis {
    /// The key
    pub key: &'static Key,
    /// Its values
    pub values: Vec<f64>,
    /// Whether the axis of the picture is logarithmic
    pub log: bool,
    /// What a message calls the values
    pub origin: String,
}

/// One case: its values, in the units of the library, and its scene.
#[derive(Clone, Debug)]
pub struct Case {
    /// Of the first key
    pub value: f64,
    /// Of the second key, where two are varied
    pub second: Option<f64>,
    /// With these values
    pub scene: Scene,
}

/// What is varied, and the cases: of two keys every value of the second with each of the first; of a divided sweep those of one part.
pub struct Cases {
    /// What is varied
    pub keys: SweptKeys<'static>,
    /// Whether the axis of each key is logarithmic; of a single key the second is not.
    pub log: [bool; 2],
    /// In the order of the values, those of the second key first
    pub all: Vec<Case>,
}

impl Cases {
    /// The cases along these axes, all of them or those of one part.
    ///
    /// Fails where two axes are the same, where there are too many cases, and where a value is refused beside another one.
    pub fn along(scene: &Scene, axes: &[Axis], part: Option<Part>) -> Result<Self, Refusal> {
        let [first, rest @ ..] = axes else {
            return Err(Refusal::Other("a sweep varies no key".to_owned()));
        };
        let second = rest.first();
        let keys = SweptKeys { first: first.key, second: second.map(|axis| axis.key) };
        if let Some(other) = keys.second.filter(|other| other.path() == keys.first.path()) {
            return Err(Refusal::asked(
                format!("--vary {} is given twice", other.path()),
                "Give two different keys, or all its values behind one --vary.",
            ));
        }
        let seconds = second.map_or_else(|| vec![None], |axis| axis.values.iter().copied().map(Some).collect());
        let count = first.values.len().saturating_mul(seconds.len());
        if count > MOST {
            return Err(Refusal::asked(
                format!("a sweep over {} has {count} pairs of values, more than {MOST}", keys.names()),
                "Give fewer --points.",
            ));
        }
        let pairs = first.values.iter().flat_map(|&value| seconds.iter().map(move |&second| (value, second)));
        let mine = pairs.enumerate().filter(|&(index, _)| part.is_none_or(|part| part.has(index)));
        let case =
            |(_, (value, second))| Ok(Case { value, second, scene: with_values(scene, axes, [Some(value), second])? });
        let all = mine.map(case).collect::<Result<_, Refusal>>()?;
        Ok(Self { keys, log: [first.log, second.is_some_and(|axis| axis.log)], all })
    }
}

/// The scene with one value, or two, in their places.
fn with_values(scene: &Scene, axes: &[Axis], values: [Option<f64>; 2]) -> Result<Scene, Refusal> {
    let mut scene = scene.clone();
    for (axis, value) in axes.iter().zip(values) {
        let stop = |problem: ValueError| Refusal::value(&axis.origin, &problem);
        axis.key.store_number(&mut scene, value.unwrap_or(f64::NAN)).map_err(stop)?;
        // of two keys the first value may be right only with the second
        if axes.last().is_none_or(|last| last.key.path() == axis.key.path()) {
            scene.check().map_err(|error| stop(error.into()))?;
        }
    }
    Ok(scene)
}
