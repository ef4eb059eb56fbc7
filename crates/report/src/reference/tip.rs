//! The keys and columns of `peel coarsen`.

use super::{key, like};
use crate::output_key::OutputKey;

/// Of summary.json of `peel coarsen`, and of what `--json` prints.
#[rustfmt::skip]
pub const TIP_SUMMARY: &[OutputKey] = &[
    key("version", "of the program"),
    key("schema", "number of this set of keys and columns"),
    key("command", "the command line"),
    key("scene", "the scene as it was named on the command line"),
    key("title", "its title"),
    key("end", "`converged`; `tolerance-not-met`: the table was not refined further, and its errors are above the tolerance"),
    key("pad_end", "`sliding`: the pad slides without friction and v changes nothing; `held`: the free end of the pad stays where it adheres"),
    key("tolerance", "error asked of forces and moment, over the largest of each"),
    key("press_nm", "how far below the height without a normal force the table begins"),
    key("lateral_nm", "range of v; null where the pad slides"),
    key("rotation_rad", "range of θ"),
    key("largest_force_nN", "largest normal force of the table: what errors of forces are measured by"),
    key("largest_moment_nN_nm", "largest moment of the table, without its sign: what errors of the moment are measured by"),
    key("reference_stiffness_nN_per_nm", "K0: where the branch is stiffer, an error is K0 times one of the displacement"),
    key("rest_energy_aJ", "E at rest; zero is the stress-free spatula far from the substrate"),
    key("neglected_force_nN", "normal force at which the detached branch begins: farther away it is taken to be zero"),
    key("attached", "the branch on which the pad adheres"),
    key("attached.path_nodes", "nodes along the branch"),
    key("attached.lateral_nodes", "nodes of v"),
    key("attached.rotation_nodes", "nodes of θ"),
    key("attached.limit_nm", "u of the limit point at v = 0 and θ = 0"),
    key("attached.limit_force_nN", "normal force there"),
    key("attached.released_aJ", "energy that is released where it goes over to the other branch there"),
    key("attached.normal_force_error_nN", "bound of the error of P: twice the largest that was measured between the nodes"),
    key("attached.lateral_force_error_nN", "the same for the force along the substrate"),
    key("attached.moment_error_nN_nm", "the same for the moment"),
    key("attached.limit_error_nm", "the same for u at the limit point"),
    key("attached.mesh_error_nm", "twice the largest difference of a limit point on half as many elements again"),
    key("attached.relative_error", "the largest of the errors of forces and moment over what they are measured by"),
    key("attached.checked", "at how many places between the nodes the spatula was solved for them"),
    like("detached", "attached", "the branch on which it does not"),
    key("columns", "pairs of v and θ at which the spatula was followed"),
    key("equilibria", "equilibria at nodes and between them"),
    key("solve_s", "time of the computation"),
    key("parameters", "the scene as it was computed"),
];

/// Of tip_law.csv.
#[rustfmt::skip]
pub const TIP_LAW_COLUMNS: &[OutputKey] = &[
    key("branch", "`attached` or `detached`"),
    key("path", "s: 0 where the branch begins, 1 at its limit point"),
    key("lateral_nm", "v: of the end along the substrate, away from the free end of the pad"),
    key("rotation_rad", "θ: of the end, positive anticlockwise"),
    key("normal_nm", "u: of the end away from the substrate"),
    key("path_slope_nm", "∂u/∂s"),
    key("energy_aJ", "E, stored and of adhesion"),
    key("normal_force_nN", "∂E/∂u: what holds the end"),
    key("lateral_force_nN", "∂E/∂v"),
    key("moment_nN_nm", "∂E/∂θ"),
    key("adhering_nm", "length of the pad that adheres: energy of adhesion over that of a unit length of the free end at rest"),
];

/// Of tip_limits.csv.
#[rustfmt::skip]
pub const TIP_LIMIT_COLUMNS: &[OutputKey] = &[
    key("branch", "`attached`: here the tip snaps off; `detached`: here it snaps on"),
    key("lateral_nm", "v"),
    key("rotation_rad", "θ"),
    key("limit_nm", "u of the limit point"),
    key("normal_force_nN", "∂E/∂u there"),
    key("lateral_force_nN", "∂E/∂v there"),
    key("moment_nN_nm", "∂E/∂θ there"),
    key("energy_aJ", "E there"),
    key("released_aJ", "energy released where the tip goes over to the other branch at the same u, v and θ; empty where the table of that does not reach"),
];
