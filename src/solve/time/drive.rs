//! How what moves the grip goes in time: smoothly, because a jump in velocity makes a force of its own.

use std::sync::Arc;

/// A function of time with its first and second derivatives.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct DriveRates {
    /// The value
    pub value: f64,
    /// d/dt
    pub first: f64,
    /// d²/dt²
    pub second: f64,
}

/// What is prescribed of the driven unknown, as a function of time.
#[derive(Clone)]
pub enum Drive {
    /// The displacement of what moves the grip, nm, or rad where it turns
    Displacement(Arc<dyn Fn(f64) -> DriveRates + Send + Sync>),
    /// The force, nN, or nN·nm; zero lets the structure fly
    Force(Arc<dyn Fn(f64) -> f64 + Send + Sync>),
}

impl Drive {
    /// A displacement that follows a ramp.
    pub fn ramp(ramp: Ramp) -> Self {
        Self::Displacement(Arc::new(move |time| ramp.at(time)))
    }
}

/// From one displacement to another at a constant rate, with accelerations at both ends that are smooth: the rate goes from
/// zero to its full value as s(τ) = τ³ (10 - 15τ + 6τ²), τ = t/`smooth`, and back in the same way.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ramp {
    /// Displacement at time zero
    pub from: f64,
    /// Displacement where it stops
    pub to: f64,
    /// Rate in between, per unit of time; without a sign
    pub rate: f64,
    /// How long it accelerates, and as long it comes to rest
    pub smooth: f64,
}

impl Ramp {
    /// With accelerations over this share of the way's duration at the full rate, at most one half.
    pub fn new(from: f64, to: f64, rate: f64, share: f64) -> Self {
        Self { from, to, rate, smooth: share.min(0.5) * ((to - from) / rate).abs() }
    }

    /// When it has come to rest.
    pub fn end(&self) -> f64 {
        ((self.to - self.from) / self.rate).abs() + self.smooth
    }

    /// Displacement, rate and acceleration at a time.
    pub fn at(&self, time: f64) -> DriveRates {
        let (way, end) = ((self.to - self.from).abs(), self.end());
        let sign = (self.to - self.from).signum();
        let from = |time: f64| self.accelerated(time.max(0.0));
        let rates = if time < 0.5 * end {
            from(time)
        } else {
            let back = from(end - time);
            DriveRates { value: way - back.value, first: back.first, second: -back.second }
        };
        DriveRates { value: self.from + sign * rates.value, first: sign * rates.first, second: sign * rates.second }
    }

    fn accelerated(&self, time: f64) -> DriveRates {
        if time >= self.smooth {
            return DriveRates { value: self.rate * (time - 0.5 * self.smooth), first: self.rate, second: 0.0 };
        }
        let t = time / self.smooth;
        DriveRates {
            value: self.rate * self.smooth * t.powi(4) * (2.5 - 3.0 * t + t * t),
            first: self.rate * t.powi(3) * (10.0 - 15.0 * t + 6.0 * t * t),
            second: self.rate / self.smooth * 30.0 * t * t * (1.0 - t).powi(2),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_abs_diff_eq;

    /// Value, rate and acceleration are derivatives of one another everywhere, and it goes where it is sent.
    #[test]
    fn a_ramp_is_smooth_and_arrives() {
        let ramp = Ramp::new(3.0, -2.0, 0.7, 0.2);
        assert_abs_diff_eq!(ramp.at(-1.0).value, 3.0);
        assert_abs_diff_eq!(ramp.at(ramp.end() + 1.0).value, -2.0, epsilon = 1e-14);
        let step = 1e-5;
        for k in 1..100 {
            let time = 0.01 * f64::from(k) * ramp.end();
            let (before, here, after) = (ramp.at(time - step), ramp.at(time), ramp.at(time + step));
            assert_abs_diff_eq!((after.value - before.value) / (2.0 * step), here.first, epsilon = 1e-8);
            assert_abs_diff_eq!((after.first - before.first) / (2.0 * step), here.second, epsilon = 1e-8);
        }
    }
}
