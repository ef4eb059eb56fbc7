//! The table [uncertainty]: what it holds, how it is written, and what is refused, by key and with what would be right.

use crate::text::assert_refused;
use peelkit::study::PeelQuantity;
use peelkit::study::uncertainty::{Correlation, Distribution, Indices};
use peelkit_scene::Scene;

const SCENE: &str = r#"
strip = { length = "100 nm", height = "10 nm", youngs_modulus = "2 GPa" }
adhesion = { hamaker_constant = "1e-19 J", equilibrium_distance = "0.4 nm" }
"#;
const HEIGHT: &str = r#"{ key = "strip.height", distribution = "normal", deviation = "0.5 nm" }"#;

fn with(table: &str) -> Result<Scene, peelkit_scene::SceneError> {
    Scene::parse("a.toml", &format!("{SCENE}[uncertainty]\n{table}"), &[])
}

fn with_input(input: &str) -> Result<Scene, peelkit_scene::SceneError> {
    with(&format!("inputs = [{input}]"))
}

#[test]
fn distributions_are_read_in_the_units_of_the_library() {
    let scene = with(
        r#"
        inputs = [
            { key = "strip.height", distribution = "normal", mean = "0.011 um", deviation = "0.5 nm" },
            { key = "strip.youngs_modulus", distribution = "lognormal", log_deviation = 0.2 },
            { key = "adhesion.hamaker_constant", distribution = "uniform", from = "0.8e-19 J", to = "120 zJ" },
            { key = "drive.angle", distribution = "triangular", from = "80 deg", to = "100 deg" },
            { key = "strip.poissons_ratio", distribution = "uniform", from = 0.1, to = 0.3 },
        ]
        correlations = [{ keys = ["strip.youngs_modulus", "strip.height"], coefficient = -0.3 }]
        quantities = ["peak.force_nN", "first_jump.work_aJ"]
        samples = 500
        seed = 7
        indices = false
        "#,
    )
    .unwrap();
    let table = scene.uncertainty.as_ref().unwrap();
    let plan = table.plan(&scene);
    let distributions: Vec<Distribution> = plan.inputs.iter().map(|input| input.distribution).collect();
    let deg = |angle: f64| angle.to_radians();
    // a mean, median or mode that is left out is the value of the scene
    assert_eq!(distributions[0], Distribution::Normal { mean: 11.0, deviation: 0.5 });
    assert_eq!(distributions[1], Distribution::Lognormal { median: 2.0, log_deviation: 0.2 });
    let Distribution::Uniform { from, to } = distributions[2] else { panic!() };
    assert!((from - 0.08).abs() < 1e-15 && (to - 0.12).abs() < 1e-15);
    assert_eq!(distributions[3], Distribution::Triangular { from: deg(80.0), mode: deg(90.0), to: deg(100.0) });
    assert_eq!(plan.correlations, [Correlation { inputs: [1, 0], coefficient: -0.3 }]);
    assert_eq!((plan.samples, plan.seed, plan.indices), (500, 7, Indices::Omitted));
    assert_eq!(table.quantities, [PeelQuantity::PeakForce, PeelQuantity::FirstJumpWork]);
    let model = table.model(&scene, &[9.0, 3.0, 0.1, deg(85.0), 0.2]).unwrap();
    assert_eq!((model.free_end().1, model.material().youngs_modulus, model.pull.angle), (9.0, 3.0, deg(85.0)));
    assert!(table.model(&scene, &[-9.0, 3.0, 0.1, 1.0, 0.2]).unwrap_err().found.contains("strip.height"));
    // written and read again it is the same
    assert_eq!(Scene::parse("a.toml", &scene.to_toml(), &[]).unwrap(), scene);
}

#[test]
fn what_is_left_out_follows_the_scene() {
    let set = [("strip.height".to_owned(), "12 nm".to_owned())];
    let text = format!("{SCENE}[uncertainty]\ninputs = [{HEIGHT}]");
    let scene = Scene::parse("a.toml", &text, &set).unwrap();
    let plan = scene.uncertainty.as_ref().unwrap().plan(&scene);
    assert_eq!(plan.inputs[0].distribution.mean(), 12.0);
    assert_eq!((plan.samples, plan.seed, plan.indices), (10_000, 0, Indices::Estimated));
    // a scene without the table is written without it
    let plain = Scene::parse("a.toml", SCENE, &[]).unwrap();
    assert!(plain.uncertainty.is_none() && !plain.to_toml().contains("uncertainty"));
}

#[test]
fn the_table_can_be_set_on_the_command_line() {
    let set = |key: &str, value: &str| (key.to_owned(), value.to_owned());
    let inputs = set("uncertainty.inputs", &format!("[{HEIGHT}]"));
    let scene = Scene::parse("a.toml", SCENE, &[inputs.clone(), set("uncertainty.samples", "400")]).unwrap();
    assert_eq!(scene.uncertainty.as_ref().map(|table| (table.inputs.len(), table.samples)), Some((1, 400)));
    let error = Scene::parse("a.toml", SCENE, &[inputs, set("uncertainty.samples", "1.5")]).unwrap_err().to_string();
    assert!(error.contains("uncertainty.samples") && error.contains("not whole"), "{error}");
    let error = Scene::parse("a.toml", SCENE, &[set("uncertainty.seed", "1")]).unwrap_err().to_string();
    assert!(error.contains("uncertainty.inputs") && error.contains("required"), "{error}");
}

#[track_caller]
fn refused(table: &str, parts: &[&str]) {
    assert_refused(with(table), parts);
}

#[test]
fn what_cannot_be_sampled_is_refused_by_key_and_line() {
    let input = |input: &str| format!("inputs = [{input}]");
    refused("", &["line 4", "inputs"]);
    refused("inputs = []", &["line 5", "uncertainty.inputs", "nothing is uncertain"]);
    refused("inputs = 3", &["uncertainty.inputs", "is 3"]);
    refused(&input("3"), &["has as input 1 3"]);
    refused(&input(r#"{ distribution = "normal" }"#), &["input 1 no `key`"]);
    refused(&input(r#"{ key = "strip.hight", distribution = "normal", deviation = "1 nm" }"#), &["strip.height"]);
    refused(&input(r#"{ key = "strip.height", distribution = "gauss" }"#), &["\"gauss\"", "normal, lognormal"]);
    refused(&input(r#"{ key = "strip.height", distribution = "normal" }"#), &["no `deviation`"]);
    refused(
        &input(r#"{ key = "strip.height", distribution = "normal", deviation = 0.5 }"#),
        &["without a unit", "0.5 nm"],
    );
    refused(&input(r#"{ key = "strip.height", distribution = "normal", deviation = "1 GPa" }"#), &["strip.height"]);
    refused(
        &input(r#"{ key = "strip.height", distribution = "uniform", from = "9 nm", to = "8 nm" }"#),
        &["from = 9", "to = 8"],
    );
    refused(&input(r#"{ key = "strip.height", distribution = "uniform", mean = "9 nm" }"#), &["`mean`", "from and to"]);
    refused(
        &input(r#"{ key = "strip.section", distribution = "uniform", from = 1, to = 2 }"#),
        &["no number of the model"],
    );
    refused(
        &input(r#"{ key = "accuracy.relative", distribution = "uniform", from = 1e-6, to = 1e-5 }"#),
        &["no number of the model"],
    );
    refused(
        &input(r#"{ key = "spatula.tip_width", distribution = "normal", deviation = "1 nm" }"#),
        &["[spatula]", "[strip]"],
    );
    refused(
        &input(r#"{ key = "grip.stiffness", distribution = "lognormal", log_deviation = 0.1 }"#),
        &["without a mean"],
    );
    refused(&input(&format!("{HEIGHT}, {HEIGHT}")), &["strip.height is given twice"]);
    refused(&format!("{}\nsamples = 10", input(HEIGHT)), &["uncertainty.samples", "10 samples are too few", "120"]);
    refused(&format!("{}\nseed = -1", input(HEIGHT)), &["uncertainty.seed", "out of range"]);
    refused(&format!("{}\nindices = 1", input(HEIGHT)), &["uncertainty.indices", "true or false"]);
    refused(
        &format!("{}\nquantities = [\"peak.force\"]", input(HEIGHT)),
        &["\"peak.force\"", "did you mean \"peak.force_nN\""],
    );
    refused(&format!("{}\nquantities = []", input(HEIGHT)), &["no result is asked for"]);
    let correlated = |with: &str| format!("{}\ncorrelations = [{{ {with} }}]", input(HEIGHT));
    refused(
        &correlated(r#"keys = ["strip.height", "strip.width"], coefficient = 0.5"#),
        &["\"strip.width\"", "no input"],
    );
    refused(&correlated(r#"keys = ["strip.height", "strip.height"], coefficient = 0.5"#), &["with itself"]);
    refused(&correlated(r#"keys = ["strip.height"], coefficient = 0.5"#), &["not two texts"]);
    refused(&correlated(r#"keys = ["strip.height", "strip.width"]"#), &["no number `coefficient`"]);
}

#[test]
fn a_distribution_that_leaves_the_range_of_its_key_is_refused() {
    let input = |input: &str| with_input(input).map_err(|error| format!("{error} {}", error.remedy()));
    // Φ(-4) is 3.2e-5, Φ(-5) 2.9e-7
    let normal = |deviation: f64| {
        input(&format!(r#"{{ key = "strip.height", distribution = "normal", deviation = "{deviation} nm" }}"#))
    };
    let error = normal(2.5).unwrap_err();
    for part in ["line 5", "input 1 strip.height", "3.2e-5", "mean 10, deviation 2.5 in nm", "lognormal"] {
        assert!(error.contains(part), "{part:?} is not in {error}");
    }
    assert!(normal(2.0).is_ok());
    assert!(normal(10.0).unwrap_err().contains("15.87 %"));
    let ratio = |to: f64| {
        input(&format!(r#"{{ key = "strip.poissons_ratio", distribution = "uniform", from = 0.1, to = {to} }}"#))
    };
    assert!(ratio(0.49).is_ok());
    assert!(ratio(0.6).unwrap_err().contains("20.00 % of whose distribution is outside"));
    // right by themselves, and not with the rest of the scene
    let spatula = r#"
        adhesion = { hamaker_constant = "1e-19 J", equilibrium_distance = "0.4 nm" }
        spatula = { tip_rounding_length = "230 nm" }
        uncertainty = { inputs = [{ key = "spatula.pad_length", distribution = "uniform", from = "220 nm", to = "260 nm" }] }
    "#;
    let error = Scene::parse("b.toml", spatula, &[]).unwrap_err().to_string();
    assert!(error.contains("reaches 220") && error.contains("tip_rounding_length"), "{error}");
}
