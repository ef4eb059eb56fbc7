//! The help of `peel coarsen`.

/// Of `peel coarsen -h`.
pub const SHORT: &str = "\
Example: peel coarsen spatula.toml
More: peel coarsen --help, on the ranges and the files";

/// Of `peel coarsen --help`.
pub const LONG: &str = "\
Examples:
  peel coarsen spatula.toml
  peel coarsen spatula.toml --rotation '-20 deg,20 deg' --press '100 nm' --tolerance 1e-4
  peel coarsen spatula.toml --set grip.horizontal=fixed --lateral '-20 nm,10 nm'
  peel coarsen seta.toml --set seta.lateral_stiffness='1 N/m' --out out/seta-law

The end of the spatula is held at a height u, at a place v along the substrate and at a rotation θ, all from where
it is in the stress-free configuration. Computed is its energy E(u, v, θ); forces and moment are its gradient. The
pull of the scene plays no part, nor whether its grip turns freely. grip.horizontal says what the pad does:
  free    it slides without friction; v changes nothing, and there is no force along the substrate
  fixed   its free end stays where it adheres; v counts, and its range is small: the spatula is stiff along its shaft

The table has two branches. On one the pad adheres, from where the tip is pressed to the limit point at which it snaps
off; on the other it does not, from far away to the limit point at which it snaps on. Between the two there is no stable
equilibrium: a tip jumps. The table is refined, with the spatula solved between its nodes, until twice the largest
error found is within the tolerance.

Files:
  summary.json        ranges, limits, error bounds and the scene
  tip_law.csv         one row for each node: u, v, θ, energy, forces, moment
  tip_limits.csv      one row for each limit point: where the tip snaps off or on, and the energy released there
  tip_law.svg, .png   normal force against displacement, for several θ and v

The tips of a seta follow the table with seta.tip_law = \"table\"; seta.tip_table names the folder.

A scene with a [seta] gives the law of the seta: what holds its root, E(u, v), sheet by sheet. The root is pulled at 15
to 105 degrees until the last tip lets go. The places at which the first one does lie on a plane, u·d = c. Up to there
the law is a potential of degree --degree. Behind it come sheets of degree 2 with fewer tips, each up to a plane of its
own. There are as few as meet the tolerance in peak and work of each pull, and at most --sheets. Errors are stated, with
each path left out as well. The pull and the steps of the scene play no part.

  summary.json        sheets, exit planes, stiffness, errors of each degree, and the scene
  seta_law.toml       coefficients, exit planes, errors, the seta, and a check sum
  seta_paths.csv      one row for each equilibrium: force of the resolved seta, and by the law
  seta_law.svg, .png  both against displacement, along each pull, with the first exit

Arrays take it with setae.law, the name of the folder; a [lamella] takes degree 2. With setae.seta, the scene of the
seta, a missing folder is made by whatever command computes the array, and the law of another seta is refused.

Exit status 3: the tolerance was not met; the law is written all the same, with its errors.";
