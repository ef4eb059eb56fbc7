//! Arrays of setae in closed form: bundles, elastic foundations, bunching.

use nalgebra::{Matrix4, Vector4};

/// Load of a bundle of equal sharing over one fibre's stiffness times length, max (N - i + 1) x_(i), with x_(i) the strengths in their order.
pub fn bundle_strength(strengths: &[f64]) -> f64 {
    let mut sorted = strengths.to_vec();
    sorted.sort_by(f64::total_cmp);
    let held = |(i, x): (usize, &f64)| (sorted.len() - i) as f64 * x;
    sorted.iter().enumerate().map(held).fold(0.0, f64::max)
}

/// The force, nN, that pulls a dome of radius R (nm) off springs that store w (nN/nm) an area: 2πRw, of many springs.
pub fn dome_pull_off(radius: f64, work: f64) -> f64 {
    2.0 * std::f64::consts::PI * radius * work
}

/// λ = (k/(4 EI p))^(1/4) of a band on rows, 1/nm: k (nN/nm) of a row, p (nm) apart, EI in nN nm².
pub fn winkler_number(row_stiffness: f64, pitch: f64, bending: f64) -> f64 {
    (row_stiffness / (4.0 * bending * pitch)).powf(0.25)
}

/// The force at the end of a half-infinite band at which its first row lets go, smeared: f/(2λp(1 + λa)).
///
/// `strength` f of a row in nN, `lambda` λ in 1/nm, `overhang` a in front of the first row in nm. Discrete rows hold about λp/(1 + λa) of it more.
pub fn winkler_force(strength: f64, lambda: f64, pitch: f64, overhang: f64) -> f64 {
    strength / (2.0 * lambda * pitch * (1.0 + lambda * overhang))
}

/// The moment alone at which it does so, nN nm: f/(2λ²p).
pub fn winkler_moment(strength: f64, lambda: f64, pitch: f64) -> f64 {
    strength / (2.0 * lambda * lambda * pitch)
}

/// How much of a shear at the end of a band on n rows the first row takes, over one: T*/f = sinh(nα)/(2 sinh(α/2) cosh((n - ½)α)), with
/// 2 cosh α = 2 + k_s p/EA. The band holds so many times the strength of a row.
pub fn shear_lag(rows: usize, row_stiffness: f64, pitch: f64, axial: f64) -> f64 {
    let alpha = shear_lag_number(row_stiffness, pitch, axial);
    let n = rows as f64;
    // by e^(-nα), which is finite for long bands
    let top = 1.0 - (-2.0 * n * alpha).exp();
    let bottom = (-0.5 * alpha).exp() + (-(2.0 * n - 0.5) * alpha).exp();
    top / (2.0 * (0.5 * alpha).sinh() * bottom)
}

/// α of a band on rows that are sheared; p/α is how far the shear of its end goes.
pub fn shear_lag_number(row_stiffness: f64, pitch: f64, axial: f64) -> f64 {
    2.0 * (0.5 * (row_stiffness * pitch / axial).sqrt()).asinh()
}

/// The largest force at the end of a half-infinite band on a foundation that softens.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SofteningPeak {
    /// nN
    pub force: f64,
    /// How far the end is lifted, nm
    pub lift: f64,
    /// How long the foundation softens from the end on, nm
    pub zone: f64,
}

/// The foundation holds k_f w up to u1, and from there down to nothing at u2. None where the force is largest only beyond u2.
///
/// `foundation` k_f in nN/nm², `bending` EI in nN nm², `first` u1 and `last` u2 in nm. Inside of the zone
/// w = u2 + A cosh μx + B sinh μx + C cos μx + D sin μx, μ⁴ = k_f u1/((u2 - u1) EI); behind it w'' = -2λw' - 2λ²w, w''' = 2λ²w' + 4λ³w.
pub fn softening_peak(foundation: f64, bending: f64, first: f64, last: f64) -> Option<SofteningPeak> {
    let lambda = (foundation / (4.0 * bending)).powf(0.25);
    let mu = (foundation * first / ((last - first) * bending)).powf(0.25);
    // the band with a zone of this length: force and lift of its end
    let of = |zone: f64| {
        let (x, l, m) = (mu * zone, lambda, mu);
        let (ch, sh, c, s) = (x.cosh(), x.sinh(), x.cos(), x.sin());
        // rows: w and its derivatives by x of the four functions, at the end of the zone
        let w = [ch, sh, c, s];
        let w1 = [m * sh, m * ch, -m * s, m * c];
        let w2 = [m * m * ch, m * m * sh, -m * m * c, -m * m * s];
        let w3 = [m.powi(3) * sh, m.powi(3) * ch, m.powi(3) * s, -m.powi(3) * c];
        let matrix = Matrix4::from_fn(|row, k| match row {
            0 => [1.0, 0.0, -1.0, 0.0][k],
            1 => w[k],
            2 => (w2[k] + 2.0 * l * w1[k]) / (m * m),
            _ => (w3[k] - 2.0 * l * l * w1[k]) / m.powi(3),
        });
        let right =
            Vector4::new(0.0, first - last, -2.0 * l * l * first / (m * m), 4.0 * l.powi(3) * first / m.powi(3));
        let a = matrix.lu().solve(&right)?;
        // V = EI w''' at the end, where the force lifts
        Some((bending * m.powi(3) * (a[1] - a[3]), last + a[0] + a[2]))
    };
    let force = |zone: f64| of(zone).map_or(f64::NEG_INFINITY, |(force, _)| force);
    // the first zone at which the force falls, in steps of a hundredth of its own length
    let step = 0.01 / mu;
    let mut at = step;
    while force(at + step) > force(at) {
        at += step;
        if at * mu > 2.0 * std::f64::consts::PI {
            return None;
        }
    }
    let (mut low, mut high) = ((at - step).max(0.0), at + step);
    let golden = 0.5 * (5f64.sqrt() - 1.0);
    while high - low > 1e-9 / mu {
        let (a, b) = (high - golden * (high - low), low + golden * (high - low));
        if force(a) > force(b) { high = b } else { low = a }
    }
    let zone = 0.5 * (low + high);
    let (force, lift) = of(zone)?;
    (lift <= last).then_some(SofteningPeak { force, lift, zone })
}

/// E_eff, GPa, of an array of inclined shafts that is pressed: 3 E I D sin φ/(L² cos² φ (1 ± μ tan φ)).
///
/// `modulus` E in GPa, `inertia` I in nm⁴, `density` D in 1/nm², `length` L in nm, `angle` φ from the ground in rad. `friction` ±μ is positive
/// where the tips slide along the direction in which the shafts lean, and negative against it. From a cantilever with the load at its tip.
pub fn array_modulus(modulus: f64, inertia: f64, density: f64, length: f64, angle: f64, friction: f64) -> f64 {
    let across = length * angle.cos();
    3.0 * modulus * inertia * density * angle.sin() / (across * across * (1.0 + friction * angle.tan()))
}

/// The longest fibre, nm, that does not bunch with its neighbour: c* = (9 EI g²/γ_L)^(1/4) (as Glassmaker et al. 2004).
///
/// `radius` R and the clear `gap` g in nm, `modulus` E in GPa, `surface_energy` γ in nN/nm. Two cylinders that touch without load hold the energy
/// γ_L = (3/2) W a0 a length, a0³ = 32 W R_e²/(πE*), W = 2γ, R_e = R/2, E* = E/(2(1 - ν²)).
pub fn bunching_length(radius: f64, gap: f64, modulus: f64, poisson: f64, surface_energy: f64) -> f64 {
    let pi = std::f64::consts::PI;
    let (work, effective) = (2.0 * surface_energy, modulus / (2.0 * (1.0 - poisson * poisson)));
    let half_width = (32.0 * work * 0.25 * radius * radius / (pi * effective)).cbrt();
    let bending = modulus * 0.25 * pi * radius.powi(4);
    (9.0 * bending * gap * gap / (1.5 * work * half_width)).powf(0.25)
}
