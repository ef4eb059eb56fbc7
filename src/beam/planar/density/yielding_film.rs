//! The three-field Reissner beam of [`ShearedBeam`] whose film yields.

use super::reissner::{of_axis, section_of, stored};
use super::sheared::ShearedBeam;
use crate::beam::element::energy_density::{
    Coupling, EnergyDensity, FACE, MEMORY, Point, PointResponse, SectionState, StepEnd,
};
use crate::beam::material::yielding::{FilmLaw, FilmMemory, PROFILE, Strain, Strained, plastic_strain};
use crate::number::Real;

/// A strip that yields, under a cohesive law on level ground. Fields and face as of [`ShearedBeam`]; the stored energy has that of [`FilmLaw`] in place
/// of ½EA Γ1² + ½EI κ². Behind what [`Point::memory`] has of its face stands its plastic strain.
#[derive(Clone, Debug)]
pub(crate) struct YieldingFilm {
    /// The same film, if it were elastic
    pub elastic: ShearedBeam<true>,
    /// How its sections yield
    pub law: FilmLaw,
}

impl YieldingFilm {
    /// Γ1 at a rotation under the slopes ξ' and y', and ∂Γ1/∂θ.
    #[inline(always)]
    fn stretch<T: Real>([sin, cos]: [T; 2], slope: [T; 3]) -> [T; 2] {
        let [dx, dy, _] = of_axis(slope, T::splat(0.0));
        [dx * cos + dy * sin - 1.0, dy * cos - dx * sin]
    }

    /// How a section is strained.
    fn strain(&self, rotation: f64, slope: [f64; 3]) -> Strain {
        let (sin, cos) = rotation.sin_cos();
        [Self::stretch([sin, cos], slope)[0], slope[2] * self.law.half_height]
    }

    /// What it makes of a section.
    fn strained(&self, point: &Point<f64, 3>) -> Strained {
        self.law.at(&plastic_strain(&point.memory[FACE..]), self.strain(point.value[2], point.slope))
    }

    /// Adds what yielding changes of an elastic section.
    #[inline(always)]
    fn add_yielding<T: Real>(&self, point: &Point<T, 3>, response: &mut PointResponse<T, 3>) {
        let (axial, half) = (self.elastic.profile.at(point.place).section.axial, self.law.half_height);
        let (sin, cos) = point.value[2].sin_cos();
        let [stretch, by_rotation] = Self::stretch([sin, cos], point.slope);
        let known: [T; PROFILE + 2] = std::array::from_fn(|k| match k {
            0 => stretch,
            1 => point.slope[2] * half,
            _ => point.memory[FACE + k - 2],
        });
        let [energy, force, moment, stretch_stretch, stretch_bend, bend_bend] = T::each_of(known, |known| {
            let strain = [known[0], known[1]];
            let [at, elastic] = [self.law.at(&plastic_strain(&known[2..]), strain), FilmLaw::elastic(strain)];
            [
                at.energy - elastic.energy,
                at.forces[0] - elastic.forces[0],
                at.forces[1] - elastic.forces[1],
                at.stiffness[0] - elastic.stiffness[0],
                at.stiffness[1] - elastic.stiffness[1],
                at.stiffness[2] - elastic.stiffness[2],
            ]
        })
        .map(|number| number * axial);
        let (moment, mixed, bend_bend) = (moment * half, stretch_bend * half, bend_bend * (half * half));
        let add = |sum: &mut T, what: T| *sum = *sum + what;
        add(&mut response.energy, energy);
        add(&mut response.by_value[2], force * by_rotation);
        add(&mut response.by_slope[2], moment);
        add(&mut response.value_value[2][2], stretch_stretch * by_rotation * by_rotation - force * (stretch + 1.0));
        add(&mut response.value_slope[2][2], mixed * by_rotation);
        add(&mut response.slope_value[2][2], mixed * by_rotation);
        add(&mut response.slope_slope[2][2], bend_bend);
        let (along, across) = ([cos, sin], [-sin, cos]);
        for f in 0..2 {
            add(&mut response.by_slope[f], force * along[f]);
            let turned = stretch_stretch * by_rotation * along[f] + force * across[f];
            add(&mut response.value_slope[2][f], turned);
            add(&mut response.slope_value[f][2], turned);
            add(&mut response.slope_slope[f][2], mixed * along[f]);
            add(&mut response.slope_slope[2][f], mixed * along[f]);
            for g in 0..2 {
                add(&mut response.slope_slope[f][g], stretch_stretch * along[f] * along[g]);
            }
        }
    }
}

impl EnergyDensity<3> for YieldingFilm {
    const COUPLING: Coupling<3> = Coupling {
        value_value: <ShearedBeam<true> as EnergyDensity<3>>::COUPLING.value_value,
        value_slope: [[false; 3], [false; 3], [true; 3]],
        slope_slope: [[true; 3]; 3],
    };

    #[inline(always)]
    fn response<T: Real>(&self, place: T, value: [T; 3], slope: [T; 3], border: f64) -> PointResponse<T, 3> {
        self.elastic.response(place, value, slope, border)
    }

    const HAS_HISTORY: bool = true;

    #[inline(always)]
    fn add_remembered<T: Real>(&self, point: &Point<T, 3>, response: &mut PointResponse<T, 3>) {
        self.elastic.add_remembered(point, response);
        self.add_yielding(point, response);
    }

    /// Of its face as of [`ShearedBeam`]; behind that: [`FilmMemory`].
    fn remember(&self, end: &StepEnd<3>, known: &mut [f64]) -> f64 {
        let (face, film) = known.split_at_mut(FACE);
        let mut memory = FilmMemory::read(film);
        self.law.advance(&mut memory, self.strain(end.value[2], end.slope), end.before);
        memory.write(film);
        self.elastic.remember(end, face)
    }

    fn remembers_face(&self) -> bool {
        self.elastic.remembers_face()
    }

    fn yields(&self) -> bool {
        true
    }

    fn is_symmetric(&self) -> bool {
        self.elastic.is_symmetric()
    }

    fn knots(&self) -> &'static [f64] {
        self.elastic.knots()
    }

    fn opening(&self, place: f64, value: [f64; 3], memory: [f64; MEMORY]) -> f64 {
        self.elastic.opening(place, value, memory)
    }

    fn adhesion_response(&self, place: f64, value: [f64; 3], memory: [f64; MEMORY]) -> PointResponse<f64, 3> {
        self.elastic.adhesion_response(place, value, memory)
    }

    fn section_state(&self, point: &Point<f64, 3>, _: f64) -> SectionState {
        let station = self.elastic.profile.at(point.place);
        let slopes = of_axis(point.slope, station.rise);
        let mut response = stored(&station, point.value[2], slopes);
        self.add_yielding(point, &mut response);
        // in place of the work of this step
        let strained = self.strained(point);
        response.energy -= station.section.axial * (strained.energy - strained.given_back());
        section_of(&response, slopes)
    }

    fn section_state_from_forces(&self, place: f64, value: [f64; 3], forces: [f64; 3], border: f64) -> SectionState {
        self.elastic.section_state_from_forces(place, value, forces, border)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::adhesion::levels::half_space::HalfSpace;
    use crate::adhesion::section::calibrated::Cohesive;
    use crate::adhesion::section::cohesive::CohesiveShape;
    use crate::adhesion::section::law::Law;
    use crate::adhesion::section::line_load::{LineLaw, LineLoad};
    use crate::adhesion::section::sheared::ShearedLaw;
    use crate::beam::material::yielding::FILM;
    use crate::beam::section::Material;
    use crate::beam::varying::Profile;

    /// The strip of the paper, 10 nm high, that yields at a strain of 0.02.
    fn film() -> YieldingFilm {
        let half_space = HalfSpace { hamaker_constant: 0.1, equilibrium_distance: 0.4 };
        let cohesive = Cohesive::calibrated(CohesiveShape::Exponential, 0.08, 0.03, &half_space);
        let (law, height) = (Law::Cohesive(cohesive), 10.0);
        let material = Material { yield_strength: Some(0.04), tangent_modulus: Some(0.1), ..Material::of(2.0, 0.2) };
        let section = material.section(1.0, height, 0.0);
        let elastic = ShearedBeam {
            profile: Profile::uniform(section, 1.0, height),
            law: LineLaw { half_space, height, law, line_load: LineLoad::Full, far_face: false },
            sheared: ShearedLaw::sliding(cohesive),
            heals: true,
        };
        YieldingFilm { elastic, law: material.film_law(&section).unwrap() }
    }

    /// Fields and slopes of a section of a film that is bent back under tension, and has been bent to κ h/2 = 0.15.
    const AT: [f64; 6] = [0.0, 0.9, 0.7, -0.214, 0.653, 0.021];

    /// Forces are the slopes of the energy, and second derivatives those of forces, by central differences to 1e-7 of the stiffnesses; the tangent is
    /// symmetric.
    #[test]
    fn derivatives_are_those_of_differences() {
        let film = film();
        let mut row = [0.0; FACE + FILM];
        for slope in [[-0.21, 0.66, 0.01], [-0.215, 0.655, 0.03], [-0.213, 0.652, 0.025]] {
            film.remember(&StepEnd { place: 4.0, value: [0.0, 0.7, 0.7], slope, before: 1.0 }, &mut row);
        }
        let memory: [f64; MEMORY] = std::array::from_fn(|k| row[k]);
        assert!(FilmMemory::read(&row[FACE..]).has_yielded());
        let at = |values: [f64; 6]| {
            let [value, slope] = [0, 3].map(|from| std::array::from_fn(|k| values[from + k]));
            let mut response = film.response(4.0, value, slope, 0.0);
            film.add_remembered(&Point { place: 4.0, value, slope, memory }, &mut response);
            response
        };
        let forces = |response: &PointResponse<f64, 3>| [response.by_value, response.by_slope].concat();
        let here = at(AT);
        for k in 0..6 {
            let moved = |by: f64| {
                let mut values = AT;
                values[k] += by;
                at(values)
            };
            let [low, high] = [moved(-1e-6), moved(1e-6)];
            let stiffness = film.elastic.profile.at(4.0f64).section.bending;
            let by_difference = (high.energy - low.energy) / 2e-6;
            assert!((by_difference - forces(&here)[k]).abs() < 1e-7 * stiffness, "{k}: {by_difference}");
            for (j, (low, high)) in forces(&low).iter().zip(forces(&high)).enumerate() {
                let tangent = match (j < 3, k < 3) {
                    (true, true) => here.value_value[j][k],
                    (true, false) => here.value_slope[j][k - 3],
                    (false, true) => here.slope_value[j - 3][k],
                    (false, false) => here.slope_slope[j - 3][k - 3],
                };
                assert!(((high - low) / 2e-6 - tangent).abs() < 1e-5 * stiffness, "{j} {k}: {tangent}");
            }
        }
        for j in 0..3 {
            for k in 0..3 {
                assert!((here.slope_slope[j][k] - here.slope_slope[k][j]).abs() < 1e-12);
                assert!((here.value_slope[j][k] - here.slope_value[k][j]).abs() < 1e-12);
            }
        }
    }
}
