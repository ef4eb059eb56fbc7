//! How a film has yielded, and what that left in it.

use crate::beam::element::energy_density::FACE;
use crate::beam::material::yielding::FilmMemory;
use crate::beam::planar::chain::NodeState;
use crate::solve::newton::Solution;
use crate::solve::state::History;
use crate::study::peel::result::Peel;
use crate::study::peel::solution_history::SolutionHistory;
use std::sync::Arc;

/// How a film has yielded at one equilibrium of its path.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Yielded {
    /// Work that yielding has left in the film since rest, aJ: ∫ N dΓ1 + M dκ of every section, less N²/2EA + M²/2EI. It is dissipated, but for what
    /// residual stresses store.
    pub work: f64,
    /// The same in a unit of area that peels, nN/nm, from the way of the front over the process zone before; none where it has not come so far
    pub work_per_area: Option<f64>,
    /// Length that has yielded, nm
    pub length: f64,
    /// The largest curvature that a section has had, over that at which its surfaces yield
    pub largest_curvature: f64,
    /// The largest axial force of a section over σ₀ A. At 1 a film that does not harden flows.
    pub axial_share: f64,
    /// The largest stretch that stays in a section when it is unloaded, Γ1
    pub permanent_stretch: f64,
}

impl Peel {
    /// How the film has yielded where its force is steady, or where its path ends; none of a film that does not yield.
    pub fn yielded(&self) -> Option<Yielded> {
        let last = self.points.len().checked_sub(1)?;
        self.yielded_at(self.plateau.map_or(last, |plateau| (plateau.after + 1).min(last)))
    }

    /// The same at `points[index]`.
    pub fn yielded_at(&self, index: usize) -> Option<Yielded> {
        let trace = self.trace.as_ref()?;
        let law = self.model.film_law()?;
        let here = trace.points.get(index)?;
        let known = film_of(trace, here)?;
        let beam = trace.problem.beam.planar()?;
        let before =
            self.points[..index].iter().rposition(|at| at.front >= self.points[index].front + beam.process_length);
        let per_area = before.and_then(|before| {
            let way = self.points[before].front - self.points[index].front;
            let left = self.work_left(&known) - self.work_left(&film_of(trace, &trace.points[before])?);
            Some(left / way / self.model.section_at(0.0).1)
        });
        let largest = known.memories().map(|(_, memory)| memory.largest().abs()).fold(0.0, f64::max);
        let yielded = known.memories().filter(|(_, memory)| memory.has_yielded());
        let stretch = known.memories().map(|(_, memory)| memory.permanent_stretch(&law)).fold(0.0, f64::max);
        let elements = 0..here.at.mesh.elements();
        let axial = |state: &NodeState| {
            let (sin, cos) = state.values[beam.rotation].sin_cos();
            (state.section.horizontal_force * cos + state.section.vertical_force * sin).abs()
        };
        let states = beam.chain.node_states(beam.configuration(&here.at), elements);
        Some(Yielded {
            work: self.work_left(&known),
            work_per_area: per_area,
            length: yielded.map(|(length, _)| length).sum(),
            largest_curvature: largest / law.yield_strain,
            axial_share: states.iter().map(axial).fold(0.0, f64::max) / (law.yield_strain * self.model.section().axial),
            permanent_stretch: stretch,
        })
    }

    /// Work that yielding has left in the film, aJ.
    fn work_left(&self, known: &Film) -> f64 {
        self.model.section().axial * known.memories().map(|(length, memory)| length * memory.lost()).sum::<f64>()
    }
}

/// What the sections of a film have been through.
struct Film(Arc<History>);

fn film_of(trace: &SolutionHistory, at: &Solution) -> Option<Film> {
    trace.problem.system.commit(&at.at).map(Film)
}

impl Film {
    /// Length of each, nm, with what it remembers.
    fn memories(&self) -> impl Iterator<Item = (f64, FilmMemory)> + '_ {
        self.0.points().map(|(_, length, row)| (length, FilmMemory::read(&row[FACE..])))
    }
}
