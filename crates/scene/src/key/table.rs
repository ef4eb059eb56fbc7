//! The tables of a scene: what each is for, and which scenes have it.

use crate::body::body_of;
use crate::scene::Scene;

/// A table of a scene.
#[derive(Debug)]
pub struct Table {
    /// Its name; empty of what stands above the tables
    pub name: &'static str,
    /// What it is for
    pub about: &'static str,
    /// Which of its keys a scene with a seta has
    pub(crate) beside_seta: BesideSeta,
    /// Whether a scene has it, or may be given any of its keys
    pub(crate) is_in: fn(&Scene) -> bool,
    /// Gives a scene one that names it
    pub(crate) begin: fn(&mut Scene),
}

/// Which keys of a table a scene with a seta has.
#[derive(Debug)]
pub(crate) enum BesideSeta {
    None,
    All,
    These(&'static [&'static str]),
    AllBut(&'static str),
}

impl Table {
    /// Whether a scene of an array of setae has a key of it.
    pub(crate) fn stands_beside_setae(&self, name: &str) -> bool {
        match self.name {
            "setae" | "patch" | "lamella" | "toe" | "optimise" | "uncertainty" => true,
            "bounds" => name == "time",
            "" => name == "title",
            "output" => name == "units",
            "drive" => name == "angle",
            _ => false,
        }
    }
}

impl BesideSeta {
    pub(crate) fn has(&self, name: &str) -> bool {
        match self {
            Self::None => false,
            Self::All => true,
            Self::These(names) => names.contains(&name),
            Self::AllBut(other) => *other != name,
        }
    }
}

/// One that every scene has.
const fn table(name: &'static str, about: &'static str, beside_seta: BesideSeta) -> Table {
    Table { name, about, beside_seta, is_in: |_| true, begin: |_| {} }
}

/// One that a scene has of several.
const fn body(name: &'static str, about: &'static str, is_in: fn(&Scene) -> bool) -> Table {
    Table { name, about, beside_seta: BesideSeta::All, is_in, begin: |_| {} }
}

pub(crate) static TOP: Table = table("", "What stands above the tables.", BesideSeta::These(&["title"]));
pub(crate) static STRIP: Table = body("strip", "A uniform strip.", |s| body_of(s) == STRIP.name);
pub(crate) static SPATULA: Table =
    body("spatula", "A gecko's spatula: a flat pad on a round, bent shaft.", |s| body_of(s) == SPATULA.name);
pub(crate) static PROFILE: Table = body("profile", "A beam of any outline.", |s| body_of(s) == PROFILE.name);
/// What is done to a scene that has it besides says the reading of a scene: it looks at its body.
pub(crate) static SETA: Table = body("seta", "A gecko's seta: a shaft that forks into spatulae.", |s| s.seta.is_some());
pub(crate) static ADHESION: Table =
    table("adhesion", "What attracts the beam: van der Waals forces, or a cohesive law.", BesideSeta::All);
pub(crate) static SUBSTRATE: Table = table("substrate", "What the beam lies on.", BesideSeta::None);
pub(crate) static FRICTION: Table = table("friction", "What holds the beam along the ground.", BesideSeta::None);
pub(crate) static GRIP: Table = table("grip", "What holds the right end, which is pulled.", BesideSeta::None);
pub(crate) static DRIVE: Table =
    table("drive", "Where the grip goes, and what it does before.", BesideSeta::These(&["angle", "azimuth", "steps"]));
/// One of an array of setae, which begins it.
const fn of_array(name: &'static str, about: &'static str, is_in: fn(&Scene) -> bool, begin: fn(&mut Scene)) -> Table {
    Table { name, about, beside_seta: BesideSeta::None, is_in, begin }
}

pub(crate) static SETAE: Table = of_array(
    "setae",
    "An array of setae: how many, and the law of each.",
    |s| s.array.is_some(),
    |s| _ = s.array_table(),
);
pub(crate) static PATCH: Table = of_array(
    "patch",
    "What setae stand on: a rigid backing.",
    |s| s.array.as_ref().is_some_and(|array| array.patch.is_some()),
    |s| _ = s.array_table().patch_table(),
);
pub(crate) static LAMELLA: Table = of_array(
    "lamella",
    "What setae stand on: an elastic band.",
    |s| s.array.as_ref().is_some_and(|array| array.lamella.is_some()),
    |s| _ = s.array_table().lamella_table(),
);
pub(crate) static TOE: Table = of_array(
    "toe",
    "A pad whose branches are lamellae.",
    |s| s.array.as_ref().is_some_and(|array| array.toe.is_some()),
    |s| _ = s.array_table().toe_table(),
);
pub(crate) static SOLID: Table = Table {
    name: "solid",
    about: "A body that is computed as a solid: with which elements.",
    beside_seta: BesideSeta::None,
    is_in: |scene| scene.solid.is_some(),
    begin: |scene| _ = scene.solid_table(),
};
pub(crate) static TIME: Table = Table {
    name: "time",
    about: "A pull at a rate.",
    beside_seta: BesideSeta::AllBut("held"),
    is_in: |scene| scene.time.is_some(),
    begin: |scene| _ = scene.time_table(),
};
pub(crate) static ACCURACY: Table = table(
    "accuracy",
    "How accurate the results are to be, and by what elements and steps.",
    BesideSeta::These(&["relative", "order"]),
);
pub(crate) static PATH: Table = table("path", "As far as what the path is followed.", BesideSeta::None);
pub(crate) static OUTPUT: Table = table(
    "output",
    "Where the path is computed besides, what is looked for on the way, and in what units it is drawn.",
    BesideSeta::All,
);
pub(crate) static BOUNDS: Table = table("bounds", "Where a computation stops at the latest.", BesideSeta::All);
pub(crate) static FIT: Table = Table {
    name: "fit",
    about: "What peel fit determines.",
    beside_seta: BesideSeta::All,
    is_in: |scene| scene.fit.is_some(),
    begin: |scene| _ = scene.fit_table(),
};
pub(crate) static OPTIMISE: Table = Table {
    name: "optimise",
    about: "What peel optimise seeks.",
    beside_seta: BesideSeta::All,
    is_in: |scene| scene.optimisation.is_some(),
    begin: |scene| _ = scene.optimisation_table(),
};
pub(crate) static UNCERTAINTY: Table = Table {
    name: "uncertainty",
    about: "What peel uncertainty samples.",
    beside_seta: BesideSeta::All,
    is_in: |scene| scene.uncertainty.is_some(),
    begin: |scene| _ = scene.uncertainty_table(),
};
