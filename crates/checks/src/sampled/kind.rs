//! What is sampled: one line of `SampleKind::NAMES`, one variant and one generator in `scene.rs` a kind.

/// What is sampled.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SampleKind {
    /// Strips of any material, size and grip, pulled straight up.
    Strip,
    /// The same, pulled at 10 to 170 degrees.
    Angle,
    /// Spatulae.
    Spatula,
    /// Strips under every law and every line load but the half space's body force with all of them.
    Law,
    /// Strips in space, pulled in any direction over the substrate, in grips that hold this or that.
    Space,
    /// Longer and wider strips in space in a free grip, pulled to one side.
    Oblique,
    /// Strips that friction holds.
    Friction,
    /// Strips on wavy ground.
    Rough,
    /// Strips that are pulled at a rate, elastic or viscous.
    Rate,
    /// Setae.
    Seta,
    /// Adhesive tapes and films, from micrometres to decimetres, under a cohesive law.
    Tape,
    /// The same, which their adhesive holds along the substrate as well.
    Held,
    /// Strips in a displacement-controlled test, pulled straight up or at 20 to 160 degrees.
    Observed,
}

impl SampleKind {
    /// All of them, in the order in which help lists them, with what the command calls each.
    const NAMES: [(Self, &str); 13] = [
        (Self::Strip, "strip"),
        (Self::Angle, "angle"),
        (Self::Spatula, "spatula"),
        (Self::Law, "law"),
        (Self::Space, "space"),
        (Self::Oblique, "oblique"),
        (Self::Friction, "friction"),
        (Self::Rough, "rough"),
        (Self::Rate, "rate"),
        (Self::Seta, "seta"),
        (Self::Tape, "tape"),
        (Self::Held, "held"),
        (Self::Observed, "observed"),
    ];

    /// All of them, in the order in which help lists them.
    pub fn all() -> impl Iterator<Item = Self> {
        Self::NAMES.into_iter().map(|(kind, _)| kind)
    }

    /// What the command calls it.
    pub fn name(self) -> &'static str {
        Self::NAMES.into_iter().find(|(kind, _)| *kind == self).map_or("", |(_, name)| name)
    }

    /// What the command calls so.
    pub fn named(name: &str) -> Option<Self> {
        Self::NAMES.into_iter().find(|(_, own)| *own == name).map(|(kind, _)| kind)
    }

    /// How long a run may last, s of processor time.
    pub fn longest_s(self) -> f64 {
        match self {
            Self::Strip | Self::Angle | Self::Spatula | Self::Law | Self::Space => 60.0,
            Self::Oblique | Self::Friction | Self::Rough | Self::Rate | Self::Seta => 40.0,
            Self::Tape | Self::Held | Self::Observed => 40.0,
        }
    }
}
