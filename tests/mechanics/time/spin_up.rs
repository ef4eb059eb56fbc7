//! A rod that is spun up about one end, in the plane.
//!
//!      free end o=============|> hub, θ = ψ(t) prescribed
//!
//! References: collocation along the rod with Runge-Kutta methods in time (verification/time_rod.csv); the steady stretch ρA ω² L³/(3 EA) to
//! first order, 5.14e-4. Parameters: those of J. C. Simo, L. Vu-Quoc, J. Appl. Mech. 53 (1986), L = 10, EA = 2.8e7, GA = 1e7, EI = 1.4e4,
//! ρA = 1.2, ρI = 6e-4, ψ rises smoothly to a rate of 6 within 15 units of time; and a soft rod, L = 1, EA = 1000, GA = 400, EI = 1, ρA = 1,
//! ρI = 0.01, to a rate of 3 within 3.
//! Expected: the place of the free end to the error of the steps, which falls with the square of their length; work = energy + dissipated.
//! Why: large rotations, centrifugal stiffening, prescribed motion.

use approx::{assert_abs_diff_eq, assert_relative_eq};
use peelkit::beam::{BeamInertia, ReferenceCurve, Section, Viscosity};
use peelkit::model::{Drive as Driven, MovingBeam, RodModel, Support};
use peelkit::solve::Workspace;
use peelkit::solve::time::{Drive, DriveRates, EnergyBalance, Motion, StepControl, TimeIntegrator, TimeOptions};
use std::f64::consts::PI;
use std::sync::Arc;

const TABLE: &str = include_str!("../../../verification/time_rod.csv");

/// A rod and how it is spun up.
#[derive(Clone, Copy)]
struct Spin {
    length: f64,
    section: Section,
    /// ρA and ρI
    inertia: [f64; 2],
    /// The rate in the end, and when it is reached
    speed: f64,
    rise: f64,
    viscosity: Viscosity,
}

const SIMO: Spin = Spin {
    length: 10.0,
    section: Section { axial: 2.8e7, shear: 1e7, bending: 1.4e4 },
    inertia: [1.2, 6e-4],
    speed: 6.0,
    rise: 15.0,
    viscosity: Viscosity::Elastic,
};

const SOFT: Spin = Spin {
    length: 1.0,
    section: Section { axial: 1000.0, shear: 400.0, bending: 1.0 },
    inertia: [1.0, 0.01],
    speed: 3.0,
    rise: 3.0,
    viscosity: Viscosity::Elastic,
};

impl Spin {
    fn beam(&self) -> MovingBeam {
        let rod = RodModel {
            length: self.length,
            section: self.section,
            rest: ReferenceCurve::default(),
            left: Support::FREE,
            right: Support::HINGED,
            drive: Driven::Rotation,
        };
        let [per_length, rotary] = self.inertia;
        rod.in_time(6, BeamInertia::uniform(per_length, rotary, self.viscosity)).unwrap()
    }

    /// ψ(t)
    fn angle(&self, time: f64) -> DriveRates {
        let Self { speed, rise, .. } = *self;
        let w = 2.0 * PI / rise;
        if time >= rise {
            return DriveRates { value: speed * (time - 0.5 * rise), first: speed, second: 0.0 };
        }
        DriveRates {
            value: speed / rise * (0.5 * time * time + ((w * time).cos() - 1.0) / (w * w)),
            first: speed / rise * (time - (w * time).sin() / w),
            second: speed / rise * (1.0 - (w * time).cos()),
        }
    }

    /// How far the free end is along and across the line of the hub at these times, and the balance of energy at the start and at the end.
    fn run(self, h: f64, times: &[f64]) -> (Vec<[f64; 2]>, [EnergyBalance; 2]) {
        let beam = self.beam();
        let at = beam.statics.initial(4);
        let still = vec![0.0; at.values.len()];
        let memory = beam.dynamics.system.relaxed_memory(&at);
        let motion = Motion::new(0.0, at, still.clone(), still, memory);
        let options = TimeOptions::new(StepControl::Fixed(h));
        let drive = Drive::Displacement(Arc::new(move |time| self.angle(time)));
        let mut run = TimeIntegrator::new(&beam.dynamics, drive, motion, options, Workspace::default());
        let mut places = Vec::new();
        for &time in times {
            while run.motion().time < time - 1e-9 {
                run.advance(time).unwrap();
            }
            let (sin, cos) = self.angle(time).value.sin_cos();
            let values = &run.motion().at.values;
            let (x, y) = (self.length - values[0], -values[1]);
            places.push([x * cos + y * sin - self.length, y * cos - x * sin]);
        }
        (places, [*run.start(), *run.balance()])
    }
}

/// By extrapolation from two lengths of the steps, the place that collocation finds, elastic and viscous.
#[test]
fn the_free_end_is_where_collocation_has_it() {
    for (case, viscosity) in
        [("elastic", Viscosity::Elastic), ("kelvin-voigt", Viscosity::KelvinVoigt { retardation_time: 0.02 })]
    {
        let rows: Vec<Vec<f64>> = TABLE
            .lines()
            .filter(|line| line.starts_with(case))
            .map(|line| line.split(',').skip(1).map(|cell| cell.parse().unwrap()).collect())
            .collect();
        assert!(rows.len() >= 8, "{case}: {} rows", rows.len());
        let times: Vec<f64> = rows.iter().map(|row| row[0]).collect();
        let [(coarse, _), (fine, _)] = [2.5e-3, 1.25e-3].map(|h| Spin { viscosity, ..SOFT }.run(h, &times));
        for ((row, coarse), fine) in rows.iter().zip(coarse).zip(fine) {
            for k in 0..2 {
                let found = fine[k] + (fine[k] - coarse[k]) / 3.0;
                assert_abs_diff_eq!(found, row[1 + k], epsilon = 1e-5);
            }
        }
    }
}

/// Of second order: half the step, a quarter of the error.
#[test]
fn of_second_order() {
    let at = |h: f64| SIMO.run(h, &[8.0]).0[0][1];
    let [a, b, c] = [0.02, 0.01, 0.005].map(at);
    assert_relative_eq!((a - b) / (b - c), 4.0, max_relative = 0.02);
}

/// Once it turns steadily it is stretched by its own mass: to first order ρA ω² L³/(3 EA), and to a share of (ω L)²ρA/EA more.
#[test]
fn the_steady_stretch() {
    // a viscous rod has come to rest on its hub
    let viscosity = Viscosity::KelvinVoigt { retardation_time: 0.5 };
    let (places, _) = Spin { viscosity, ..SIMO }.run(0.01, &[60.0]);
    let first = 1.2 * 36.0 * 1000.0 / (3.0 * 2.8e7);
    assert_relative_eq!(places[0][0], first, max_relative = 3e-3);
    assert!(places[0][1].abs() < 1e-4, "it does not trail any more: {:?}", places[0]);
}

/// Work of the hub = kinetic + stored + dissipated, to the error of the steps.
#[test]
fn work_goes_where_it_should() {
    for viscosity in [
        Viscosity::Elastic,
        Viscosity::KelvinVoigt { retardation_time: 0.02 },
        Viscosity::StandardLinearSolid { relaxation_time: 0.05, stiffness_ratio: 3.0 },
    ] {
        let defect = |h: f64| {
            let (_, [start, end]) = Spin { viscosity, ..SIMO }.run(h, &[20.0]);
            assert_relative_eq!(end.kinetic, 0.5 * 36.0 * 1.2 * 1000.0 / 3.0, max_relative = 2e-3);
            end.defect(&start) / end.work
        };
        let [coarse, fine] = [0.0025, 0.00125].map(defect);
        assert!(fine.abs() < 1e-4, "{viscosity:?}: {fine:.2e} of the work");
        assert_relative_eq!(coarse / fine, 4.0, max_relative = 0.1);
    }
}
