//! Where the end of a spatula is held, and what it takes to hold it there.

use serde::{Deserialize, Serialize};

/// Where the end S = L of a spatula is held, in its plane, from where it is in the stress-free configuration that lies on the substrate.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct TipPlace {
    /// u, away from the substrate, nm
    pub normal: f64,
    /// v, along the substrate, away from the free end of the pad, nm
    pub lateral: f64,
    /// θ, rad; positive anticlockwise
    pub rotation: f64,
}

impl TipPlace {
    /// u, v and θ in this order.
    pub fn coordinates(self) -> [f64; 3] {
        [self.normal, self.lateral, self.rotation]
    }

    /// The place at a share of the way to another one.
    pub fn toward(self, other: Self, share: f64) -> Self {
        let between = |from: f64, to: f64| from + share * (to - from);
        Self {
            normal: between(self.normal, other.normal),
            lateral: between(self.lateral, other.lateral),
            rotation: between(self.rotation, other.rotation),
        }
    }
}

/// The energy of a spatula whose end is held, with its derivatives by u, v and θ.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct TipResponse {
    /// E, stored and of adhesion, aJ; zero where the spatula is stress-free and far from the substrate
    pub energy: f64,
    /// ∂E/∂(u, v, θ): what holds the end, nN, nN and nN·nm
    pub force: [f64; 3],
    /// ∂²E/∂(u, v, θ)², symmetric: nN/nm, nN and nN·nm
    pub stiffness: [[f64; 3]; 3],
}

/// Whether the free end of the pad stays where it adheres.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum PadEnd {
    /// It stays at x = 0 and carries the force along the substrate.
    #[default]
    Held,
    /// It slides without friction: there is no force along the substrate, and v changes nothing.
    Sliding,
}
