//! A tape whose adhesive resists its opening, pulled straight up at a constant velocity.
//!
//!                  /|\ V
//!                   |             traction a(δ) (1 + <dδ/dt>/v0)ⁿ
//!      _____________|
//!     ==========
//!
//! Reference: `verification/opening_rate.csv`, steady states in the frame of the front, by solve_bvp of scipy. Parameters: tapes of 25 and 50 µm, 100 J/m²,
//! v0 = 10 µm/s, n = 0.2 to 1, V = 0 to 0.1 m/s. Expected: the force behind the first millimetre is the steady one, and the balance of energy closes. Why: the
//! force of a tape grows with the speed by a power of its adhesive, and that is what its maker measures.

use peelkit::adhesion::{Attraction, CohesiveShape, OpeningRate};
use peelkit::beam::Material;
use peelkit::model::{Adhesion, Body, Grip, MovingMaterial, PeelModel, Strip};
use peelkit::study::{PullInTime, PullRate, TimeAccuracy, Until, pull_in_time};

const UM: f64 = 1e3;
const MM: f64 = 1e6;

struct Row {
    height: f64,
    strength: f64,
    opening: OpeningRate,
    velocity: f64,
    /// nN
    force: f64,
}

fn rows() -> Vec<Row> {
    let table = include_str!("../../../verification/opening_rate.csv");
    let rows = table.lines().filter(|line| line.starts_with(|first: char| first.is_ascii_digit()));
    rows.map(|line| {
        let n: Vec<f64> = line.split(',').map(|cell| cell.parse().unwrap()).collect();
        let velocity = 1e-6 * n[8];
        Row {
            height: UM * n[0],
            strength: 1e-3 * n[5],
            opening: OpeningRate { reference: 1e-6 * n[6], exponent: n[7] },
            velocity,
            force: 1e9 * n[9],
        }
    })
    .collect()
}

impl Row {
    fn tape(&self) -> PeelModel {
        let (length, width, material) = (6.0 * MM, 25.0 * MM, Material::of(2.0, 0.35));
        let strip = Strip { length, height: self.height, width, material, crack: None, layers: None };
        let law = Adhesion {
            attraction: Attraction::Cohesive(CohesiveShape::Exponential),
            work: Some(100.0),
            strength: Some(self.strength),
            ..Adhesion::default()
        };
        let equilibrium_distance = law.distance_of_work_and_strength().unwrap();
        PeelModel::of(Body::Strip(strip), Adhesion { equilibrium_distance, ..law }, Grip::FREE)
    }

    fn pulled(&self, to: f64, accuracy: &TimeAccuracy) -> PullInTime {
        let pull = PullRate { until: Until::Held(0.0), ..PullRate::new(to, self.velocity) };
        // without inertia
        let material = MovingMaterial { opening: Some(self.opening), ..MovingMaterial::default() };
        pull_in_time(&self.tape(), &material, &pull, accuracy, None).unwrap()
    }
}

/// On the default mesh the mean is good to 5e-5 and no step misses more than 4e-4, which is the corner of the traction where the face begins to be pulled; on
/// 120 elements no step misses more than 1e-4.
#[test]
fn the_steady_force_is_that_of_the_frame_of_the_front() {
    let worst = |row: &Row, elements: Option<usize>| {
        let pull = row.pulled(3.0 * MM, &TimeAccuracy { elements, tolerance: 1e-5, ..TimeAccuracy::default() });
        let steady = pull.points.iter().filter(|point| (2.0 * MM..2.9 * MM).contains(&point.displacement));
        let misses: Vec<f64> = steady.map(|point| point.force / row.force - 1.0).collect();
        assert!(misses.len() > 30 && pull.balance_error() < 1e-4, "{} {:.1e}", misses.len(), pull.balance_error());
        let mean = misses.iter().sum::<f64>() / misses.len() as f64;
        let largest = misses.iter().fold(0.0_f64, |largest, miss| largest.max(miss.abs()));
        println!(
            "V {:.0e} m/s, n {}, h {} nm: {} elements, mean {mean:.1e}, largest {largest:.1e}, balance {:.1e}",
            row.velocity,
            row.opening.exponent,
            row.height,
            pull.elements,
            pull.balance_error()
        );
        [mean.abs(), largest]
    };
    let rows = rows();
    for row in [3, 4, 6, 8, 11, 13, 14].map(|k: usize| &rows[k]) {
        let [mean, largest] = worst(row, None);
        assert!(mean < 5e-5 && largest < 4e-4, "{mean:.1e} {largest:.1e}");
    }
    let [mean, largest] = worst(&rows[4], Some(120));
    assert!(mean < 5e-5 && largest < 1e-4, "{mean:.1e} {largest:.1e}");
}

/// What closes has the traction at rest: held behind the pull, the tape comes to the force of the equilibria from above.
#[test]
fn behind_the_pull_the_force_falls_to_that_at_rest() {
    let rows = rows();
    let (row, at_rest) = (&rows[3], rows[0].force);
    let material = MovingMaterial { opening: Some(row.opening), ..MovingMaterial::default() };
    let pull = PullRate { until: Until::Held(3e13), ..PullRate::new(2.0 * MM, row.velocity) };
    let accuracy = TimeAccuracy { tolerance: 1e-4, ..TimeAccuracy::default() };
    let found = pull_in_time(&row.tape(), &material, &pull, &accuracy, None).unwrap();
    let last = found.last();
    assert!(last.force > at_rest && last.force < 1.01 * at_rest, "{} {at_rest}", last.force);
    assert!(found.largest_force() > 2.2 * at_rest && found.balance_error() < 1e-3, "{:.1e}", found.balance_error());
}

#[test]
fn it_belongs_to_a_cohesive_law_and_has_a_range() {
    let row = &rows()[3];
    let refused = |model: &PeelModel, opening: OpeningRate| {
        let material = MovingMaterial { opening: Some(opening), ..MovingMaterial::default() };
        model.in_time(&material, 7).err().map(|why| why.to_string()).unwrap_or_default()
    };
    let tape = row.tape();
    let half_space = PeelModel { adhesion: Adhesion::default(), ..row.tape() };
    assert!(refused(&half_space, row.opening).contains("a law that is not cohesive is not followed in time"));
    let wrong = OpeningRate { exponent: 3.0, ..row.opening };
    assert!(refused(&tape, wrong).contains("the exponent of the rate of opening is 3; it must be from 0.01 to 2"));
    assert!(refused(&tape, OpeningRate { reference: 0.0, ..row.opening }).contains("it must be positive"));
    assert_eq!(refused(&tape, row.opening), "");
}
