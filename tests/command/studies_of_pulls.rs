//! `peel uncertainty`, `peel optimise` and `peel fit` of setae and of pulls at a rate.
//!
//!     peel run, with another value --> its curve --> peel fit: that value again
//!
//! Reference: `peel run` of the same scene: with the inputs of a sample, with the best design, and with the parameter that is fitted. Parameters: a seta
//! of two tips, which pulls off in some ms, and a strip of 40 nm, viscous, pulled at a rate as far as 6 nm. Expected: numbers of these commands are
//! those of `peel run`, to the last digit where they are the same computation; what a computation costs is told before the others; the summary says
//! which errors have no bound; what such a scene does not have is refused with what it has. Why: a number of a study that is no number of a run is none.

use crate::peel::{refuses, run as peel};
use serde_json::Value;
use std::path::Path;

const SETA: &str = "[seta]\nforks = 1\nshaft_diameter = \"2 um\"\n[spatula]\n[accuracy]\nrelative = 1e-4\n";
const RATE: &str = "[strip]\nlength = \"40 nm\"\nheight = \"10 nm\"\nyoungs_modulus = \"2 GPa\"\n[time]\nrate = \"10 mm/s\"\n\
                    density = \"1300 kg/m3\"\nmaterial = \"kelvin-voigt\"\nretardation_time = \"0.1 us\"\ndisplacement = \"6 nm\"\ntolerance = 1e-3\n\
                    [accuracy]\nelements = 12\n";
const ADHESION: &str = "[adhesion]\nhamaker_constant = \"1e-19 J\"\nequilibrium_distance = \"0.4 nm\"\n";

/// The object that a command prints which ends well.
#[track_caller]
fn json(dir: &Path, arguments: &[&str]) -> (Value, String) {
    let (status, text, beside) = peel(dir, &[arguments, &["--json"]].concat());
    assert_eq!(status, Some(0), "{beside}");
    (serde_json::from_str(&text).unwrap(), beside)
}

fn scene(text: &str, more: &str) -> tempfile::TempDir {
    let dir = tempfile::tempdir().unwrap();
    std::fs::write(dir.path().join("a.toml"), format!("{text}{ADHESION}{more}")).unwrap();
    dir
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value}"))
}

#[test]
fn a_sample_of_a_pull_is_a_run() {
    let of = |quantities: &str, key: &str, deviation: &str| {
        format!(
            "[uncertainty]\nquantities = {quantities}\nsamples = 40\nindices = false\n\
             inputs = [{{ key = \"{key}\", distribution = \"normal\", deviation = \"{deviation}\" }}]\n"
        )
    };
    let seta = of("[\"peak.force_nN\", \"balance.work_aJ\"]", "seta.youngs_modulus", "0.1 GPa");
    let rate = of("[\"largest_force.force_nN\", \"balance.work_aJ\"]", "time.retardation_time", "0.01 us");
    let cases = [
        (SETA, seta, "seta.youngs_modulus", " GPa", "pull-offs of a seta"),
        (RATE, rate, "time.retardation_time", " s", "pulls at a rate"),
    ];
    for (text, table, key, unit, what) in cases {
        let dir = scene(text, &table);
        let (found, beside) = json(dir.path(), &["uncertainty", "a.toml", "--out", "out"]);
        // 40 samples, the means, and two to a side and two alone
        assert!(beside.starts_with(&format!("note: at most 45 {what} are computed; the first took ")), "{beside}");
        assert_eq!(
            (found["sample"]["computed"].as_u64(), found["derivatives_by"].as_str()),
            (Some(40), Some("differences"))
        );
        assert!(found["unknown_error"].as_str().is_some_and(|why| why.contains("no bound")), "{found}");
        let samples = std::fs::read_to_string(dir.path().join("out/samples.csv")).unwrap();
        let mut rows = csv::Reader::from_reader(samples.as_bytes());
        let names = rows.headers().unwrap().clone();
        let row = rows.records().nth(3).unwrap().unwrap();
        let at = |name: &str| row[names.iter().position(|other| other.starts_with(name)).unwrap()].to_owned();
        let input = format!("{key}={}{unit}", at(key));
        let (run, _) = json(dir.path(), &["run", "a.toml", "--set", &input]);
        for (of, result) in found["results"].as_array().unwrap().iter().map(|of| (of["of"].as_str().unwrap(), of)) {
            let (group, name) = of.split_once('.').unwrap();
            let (sample, expected) = (at(of).parse::<f64>().unwrap(), number(&run[group][name]));
            assert!((sample / expected - 1.0).abs() < 1e-12, "{of}: {sample} {expected}");
            assert!(number(&result["deviation"]["value"]) > 0.0);
        }
    }
}

#[test]
fn the_best_design_of_a_pull_is_a_run() {
    let of = |objective: &str, key: &str, from: &str, to: &str| {
        format!(
            "[optimise]\nobjective = \"{objective}\"\nstarts = 1\nevaluations = 7\nneighbours = 1\n\
             parameters = [{{ key = \"{key}\", from = \"{from}\", to = \"{to}\" }}]\n"
        )
    };
    let seta = of("peak.force_nN", "seta.shaft_angle", "30 deg", "75 deg");
    let rate = of("balance.work_aJ", "time.retardation_time", "0.05 us", "0.3 us");
    for (text, table, result, has_bound) in [(SETA, seta, "peak", true), (RATE, rate, "balance", false)] {
        let dir = scene(text, &table);
        let (found, beside) = json(dir.path(), &["optimise", "a.toml", "--out", "out"]);
        assert!(beside.starts_with("note: at most 10 pull"), "{beside}");
        assert!(number(&found["gain"]) > 1.0, "{found}");
        assert_eq!(found["after"]["error"].is_number(), has_bound, "{found}");
        assert!(found["unknown_error"].is_string() && found["certificate"]["gradient"].is_null());
        for file in ["history.csv", "optimum.toml", "optimum.svg"] {
            assert!(dir.path().join("out").join(file).exists(), "{file}");
        }
        let (run, _) = json(dir.path(), &["run", "out/optimum.toml"]);
        let name = found["of"].as_str().unwrap().split_once('.').unwrap().1;
        assert_eq!(run[result][name], found["after"]["objective"]);
    }
}

/// Every third row of the curve of a run with another value of the key, before the force falls to zero, and rows without force behind.
#[test]
fn a_fitted_pull_has_the_value_of_the_run() {
    let of = |parameter: &str| {
        format!("[fit]\nforce_error = \"1e-3 nN\"\nprofile = \"none\"\nparameters = [\"{parameter}\"]\n")
    };
    let seta = of("seta.youngs_modulus from 1 GPa to 5 GPa");
    let rate = of("time.retardation_time from 0.02 us to 0.5 us");
    let cases = [
        (SETA, seta, "seta.youngs_modulus", "2.2 GPa", 2.2, true),
        (RATE, rate, "time.retardation_time", "0.12 us", 0.12e-6, false),
    ];
    for (text, table, key, value, known, detaches) in cases {
        let dir = scene(text, &table);
        json(dir.path(), &["run", "a.toml", "--set", &format!("{key}={value}"), "--out", "run"]);
        let curve = std::fs::read_to_string(dir.path().join("run/curve.csv")).unwrap();
        let mut rows = csv::Reader::from_reader(curve.as_bytes());
        let names = rows.headers().unwrap().clone();
        let place = |name: &str| names.iter().position(|other| other == name).unwrap();
        let [u, p] = ["displacement_nm", "force_nN"].map(place);
        let all: Vec<(f64, f64)> =
            rows.records().map(Result::unwrap).map(|row| (row[u].parse().unwrap(), row[p].parse().unwrap())).collect();
        let top = all.iter().map(|at| at.1).fold(0.0, f64::max);
        let last = all.iter().rposition(|at| at.1 > 0.5 * top).unwrap();
        let step = (last / 20).max(1);
        let mut data: String = "displacement_nm,force_nN\n".to_owned();
        all[..last].iter().step_by(step).for_each(|(u, p)| data += &format!("{u},{p}\n"));
        if detaches {
            (0..4).for_each(|k| data += &format!("{},0\n", all[last].0 + 0.5 + 5.0 * f64::from(k)));
        }
        std::fs::write(dir.path().join("data.csv"), data).unwrap();
        let (found, beside) = json(dir.path(), &["fit", "a.toml", "--data", "data.csv", "--out", "out"]);
        assert!(beside.starts_with("note: each step of the search takes 3 pull"), "{beside}");
        assert_eq!(found["end"], "converged");
        let fitted = &found["fitted"][0];
        assert!((number(&fitted["value"]) / known - 1.0).abs() < 2e-2, "{fitted}");
        assert_eq!(found["jump"]["modelled_nm"].is_number(), detaches, "{}", found["jump"]);
        assert!(found["unknown_error"].is_string());
    }
}

#[test]
fn what_a_pull_does_not_have_is_refused_with_what_it_has() {
    let inputs =
        "inputs = [{ key = \"adhesion.hamaker_constant\", distribution = \"normal\", deviation = \"0.001 aJ\" }]\n";
    let uncertain = format!("[uncertainty]\n{inputs}quantities = [\"first_jump.work_aJ\"]\n");
    let best = "[optimise]\nobjective = \"initiation_peak.force_nN\"\nparameters = [{ key = \"adhesion.hamaker_constant\", from = \"0.05 aJ\", to = \"0.2 aJ\" }]\n";
    let quick = best.replace("initiation_peak.force_nN", "balance.work_aJ") + "method = \"quasi-newton\"\n";
    let cases: [(&str, &str, &str, &str); 4] = [
        (
            SETA,
            &uncertain,
            "uncertainty",
            "Of the pull-off of a seta there are peak.force_nN, peak.displacement_nm, balance.work_aJ",
        ),
        (
            RATE,
            &uncertain,
            "uncertainty",
            "Of a pull at a rate there are largest_force.force_nN, largest_force.displacement_nm, balance.work_aJ",
        ),
        (SETA, best, "optimise", "which the pull-off of a seta does not have"),
        (RATE, &quick, "optimise", "a pull at a rate has no derivatives"),
    ];
    for (text, table, command, says) in cases {
        refuses(&[("a.toml", &format!("{text}{ADHESION}{table}"))], &[command, "a.toml"], &[says]);
    }
}
