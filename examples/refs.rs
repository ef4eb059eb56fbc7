use peelkit::{adhesion::LineLoad, model::*, study::*};
use rayon::prelude::*;
use std::collections::HashMap;
fn main() {
    let relative: f64 = std::env::args().nth(1).unwrap().parse().unwrap();
    let only: Option<usize> = std::env::args().nth(2).map(|v| v.parse().unwrap());
    let mut rows = Vec::new();
    for file in ["verification/strip.csv", "verification/strip_variants.csv"] {
        let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_path(file).unwrap();
        for row in reader.deserialize() {
            let row: HashMap<String, String> = row.unwrap();
            rows.push(row);
        }
    }
    let out: Vec<String> = rows
        .par_iter()
        .enumerate()
        .filter(|(i, _)| only.is_none_or(|o| o == *i))
        .map(|(i, row)| {
            let n = |k: &str, d: f64| row.get(k).and_then(|v| v.parse::<f64>().ok()).unwrap_or(d);
            let t = |k: &str, d: &str| row.get(k).cloned().unwrap_or(d.into());
            let hold = |k: &str| if t(k, "free") == "fixed" { Hold::Fixed } else { Hold::Free };
            let m = StripModel {
                strip: Strip {
                    length: n("length_nm", 0.0),
                    height: n("height_nm", 10.0),
                    width: n("width_nm", 1.0),
                    youngs_modulus: n("youngs_modulus_GPa", 2.0),
                    poissons_ratio: n("poissons_ratio", 0.2),
                    shear_correction: n("shear_correction", 5.0 / 6.0),
                    bending_stiffness_factor: n("bending_stiffness_factor", 1.0),
                },
                adhesion: Adhesion {
                    hamaker_constant: n("hamaker_constant_J", 1e-19) * 1e18,
                    equilibrium_distance: n("equilibrium_distance_nm", 0.4),
                    line_load: match t("line_load", "full").as_str() {
                        "full" => LineLoad::Full,
                        "force-only" => LineLoad::ForceOnly,
                        _ => LineLoad::AxisGap,
                    },
                    far_face: t("far_face", "true") == "true",
                },
                grip: Grip { rotation: hold("grip_rotation"), horizontal: hold("grip_horizontal") },
            };
            let p = peel(&m, &Accuracy { relative }, &Bounds { points: 5000, time_s: Some(20.0), displacement: None });
            let mut s = format!(
                "{i:3} L {} f {} h {} {} {} {} far {} : {:?} {:?} {:.1} ms",
                m.strip.length,
                m.strip.bending_stiffness_factor,
                m.strip.height,
                t("grip_rotation", ""),
                t("grip_horizontal", ""),
                t("line_load", ""),
                t("far_face", ""),
                p.end,
                p.effort,
                p.solve_s * 1e3
            )
            .replace("newton_iterations", "it")
            .replace("Effort", "");
            if only.is_some() {
                for (i, l) in p.points.iter().enumerate() {
                    println!(
                        "{i} u {:.9} P {:.9} c {:.5} th {:.4} neg {} {} it {}",
                        l.displacement,
                        l.force,
                        l.front,
                        l.end_rotation,
                        l.negative_eigenvalues,
                        l.negative_eigenvalues_load,
                        l.iterations
                    );
                }
                for l in &p.limit_points {
                    println!(
                        "{:?} {} u {:.12} +- {:.1e} P {:.12} +- {:.1e}",
                        l.kind, l.after, l.displacement, l.displacement_error, l.force, l.force_error
                    );
                }
            }
            let lp: Vec<_> = p.limit_points.iter().filter(|l| l.kind == Turn::Displacement).collect();
            let mut cmp = |name: &str, key: &str, got: Option<(f64, f64)>| {
                let Some(text) = row.get(key).filter(|v| !v.is_empty()) else { return };
                let want: f64 = text.parse().unwrap();
                let digits = text.split('.').nth(1).map_or(0, |d| d.split('e').next().unwrap().len()) as i32;
                let round = 0.5 * 10f64.powi(-digits);
                match got {
                    None => s += &format!("\n      {name} MISSING (want {want})"),
                    Some((v, e)) => {
                        let err = (v - want).abs();
                        let bad = if err > relative * want.abs() + round { "BAD" } else { "" };
                        let bound = if err > e + 4.0 * round { "BOUND" } else { "" };
                        if !bad.is_empty() || !bound.is_empty() {
                            s += &format!(
                                "\n      {name} got {v} +- {e:.1e} want {want} rel {:.1e} {bad} {bound}",
                                err / want.abs()
                            );
                        }
                    }
                }
            };
            let k = p.initiation_peak;
            cmp("peak u", "peak_displacement_nm", k.map(|p| (p.displacement, p.displacement_error)));
            cmp("peak P", "peak_force_nN", k.map(|p| (p.force, p.force_error)));
            cmp("peak th", "peak_end_rotation_rad", k.map(|p| (p.end_rotation, relative * p.end_rotation)));
            for j in 0..2 {
                cmp(
                    &format!("lp{} u", j + 1),
                    &format!("lp{}_displacement_nm", j + 1),
                    lp.get(j).map(|l| (l.displacement, l.displacement_error)),
                );
                cmp(
                    &format!("lp{} P", j + 1),
                    &format!("lp{}_force_nN", j + 1),
                    lp.get(j).map(|l| (l.force, l.force_error)),
                );
            }
            s
        })
        .collect();
    for o in out {
        println!("{o}");
    }
}
