//! Numbers that may be written: JSON and a table have no NaN and no infinity, and silence about one would be a lie.

use serde::{Serialize, Serializer, ser::Error};
use std::io;

/// The library counts times in ns.
pub(crate) const S_PER_NS: f64 = 1e-9;

/// A number that is refused in writing when it is not finite.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Finite(pub f64);

impl Serialize for Finite {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        if self.0.is_finite() {
            serializer.serialize_f64(self.0)
        } else {
            Err(S::Error::custom(format!("{} is not a finite number", self.0)))
        }
    }
}

/// A JSON object, laid out for reading; an error names the key that could not be written.
pub fn to_json<T: Serialize>(value: &T) -> io::Result<String> {
    let mut text = Vec::new();
    let mut serializer = serde_json::Serializer::pretty(&mut text);
    serde_path_to_error::serialize(value, &mut serializer)
        .map_err(|error| io::Error::new(io::ErrorKind::InvalidData, error.to_string()))?;
    text.push(b'\n');
    String::from_utf8(text).map_err(|error| io::Error::new(io::ErrorKind::InvalidData, error))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[derive(Serialize)]
    struct Outer {
        peak: Inner,
    }
    #[derive(Serialize)]
    struct Inner {
        force: Finite,
    }

    #[test]
    fn refuses_nan_and_infinity_and_names_the_key() {
        let json = |force| to_json(&Outer { peak: Inner { force: Finite(force) } });
        assert_eq!(json(0.1 + 0.2).unwrap(), "{\n  \"peak\": {\n    \"force\": 0.30000000000000004\n  }\n}\n");
        for bad in [f64::NAN, f64::INFINITY] {
            let error = json(bad).unwrap_err().to_string();
            assert!(error.contains("peak.force"), "{error}");
        }
    }
}
