//! What may be asked of a run besides.

use crate::outcome::Refusal;

/// What is asked of a run besides, named as the options of `peel run`. Nothing by default.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Asked {
    /// A displacement-controlled test
    pub observed: bool,
    /// The stability of the planar path against leaving its plane
    pub out_of_plane: bool,
    /// The branch that leaves the plane, with that stability
    pub branch: bool,
    /// By which power of each parameter the results change
    pub sensitivities: bool,
    /// The fields along the beam at every limit point, and at so many points evenly along the path
    pub states: Option<u32>,
    /// What a browser plays
    pub animate: bool,
}

impl Asked {
    pub(super) fn looks_out_of_plane(self) -> bool {
        self.out_of_plane || self.branch
    }
}

/// Refuses the first of these options that is asked for: it has no meaning for what the scene describes, with the reason, and what to do instead.
pub(super) fn refuse(options: &[(bool, &str, &str)], scene_of: &str, instead: &str) -> Result<(), Refusal> {
    match options.iter().find(|(is_asked, ..)| *is_asked) {
        Some((_, option, why)) => Err(Refusal::asked(
            format!("{option} has no meaning for {scene_of}: {why}"),
            format!("Omit {option}{instead}"),
        )),
        None => Ok(()),
    }
}
