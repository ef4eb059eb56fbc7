//! Strips that friction holds against collocation.

use super::turns::Turns;
use crate::suite::check::{Check, Topic};

pub(in crate::suite) const TOPIC: Topic =
    Topic { name: "friction", about: "strips with friction along the substrate: collocation", checks };

const TABLE: Turns = Turns {
    table: include_str!("../../../verification/friction.csv"),
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

fn checks() -> Vec<Check> {
    TABLE.checks()
}
