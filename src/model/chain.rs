//! Chains of a density, with elements of order 1 to 8 chosen when the program runs.

use crate::beam::element::energy_density::EnergyDensity;
use crate::beam::element::integrand::PlanarIntegrand;
use crate::beam::planar::chain::Chain;
use crate::beam::planar::uniform_chain::elements::UniformChain;

/// Two unknowns a node, both free at the left end.
pub(super) fn two_field(density: impl EnergyDensity<2> + 'static, order: usize) -> Box<dyn Chain> {
    let density: Box<dyn PlanarIntegrand<2>> = Box::new(density);
    if density.has_border() {
        Box::new(UniformChain::new::<true>(density, order, [None; 2]))
    } else {
        Box::new(UniformChain::new::<false>(density, order, [None; 2]))
    }
}

/// Three unknowns a node and no border; `pinned_left` holds fields of the left end where it has a value.
pub(super) fn three_field(
    density: impl EnergyDensity<3> + 'static,
    order: usize,
    pinned_left: [Option<f64>; 3],
) -> Box<dyn Chain> {
    Box::new(UniformChain::new::<false>(Box::new(density), order, pinned_left))
}
