//! Strips that friction holds against collocation.

use super::check::{Check, Topic};
use super::turns::Turns;

pub(super) const TOPIC: Topic =
    Topic { name: "friction", about: "strips with friction along the substrate: collocation", run };

const TABLE: Turns = Turns {
    topic: TOPIC.name,
    table: include_str!("../../../../verification/friction.csv"),
    source: "verification/friction.py: collocation",
    named: &[
        ("tau0_GPa", "τ0 = ", " GPa"),
        ("friction_coefficient", "μ = ", ""),
        ("pull_angle_deg", "", " degrees"),
        ("grip_across", "normal to the pull ", ""),
        ("grip_rotation", "rotation ", ""),
        ("length_nm", "L = ", " nm"),
    ],
};

fn run() -> Vec<Check> {
    TABLE.checks()
}
