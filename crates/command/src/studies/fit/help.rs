//! The help of `peel fit`.

/// Of `peel fit -h`.
pub const SHORT: &str = "\
Example: peel fit strip-fit.toml --data strip-fit.csv
More: peel fit --help, on the table [fit] and the files; peel keys fit";

/// Of `peel fit --help`.
pub const LONG: &str = "\
Examples:
  peel fit strip-fit.toml --data strip-fit.csv
  peel fit strip-fit.toml --data strip-fit.csv --set fit.loss=huber --set fit.profile=all
  peel fit strip-fit.toml --data strip-fit.csv --set 'fit.parameters=[\"strip.youngs_modulus\"]'

The scene names what is fitted:
  [fit]
  parameters = [\"adhesion.hamaker_constant\", \"fit.displacement_zero\",
      { key = \"strip.youngs_modulus\", from = \"1 GPa\", to = \"5 GPa\" }]
  force_error = \"0.003 nN\"        standard error of a measured force; without it, it is estimated from the residuals

The search begins at the values of the scene. Without bounds a parameter above zero stays within a factor of 100 of its
first value. Compared is the first stable branch of the path, as a machine with the stiffness grip.stiffness records
it. Where the measured force falls to zero for good, or at fit.jump, the test jumps: points behind are not fitted, and
the displacement of the jump is a datum.

Files:
  summary.json       parameters with standard errors, 95 % intervals, correlations, combinations, jump and warnings
  fit.csv            one row for each measured point: what the model gives, residual, weight
  profiles.csv       profile likelihoods, of parameters that are poorly determined
  parameters.toml    the scene with the parameters that were found
  fit.svg, .png      the measured curve, that of the model, and the residuals
  profiles.svg, .png the profile likelihoods

Ctrl-C ends the search with the best parameters so far (exit status 3). To go on, fit parameters.toml.";
