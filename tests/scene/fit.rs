//! The table [fit]: what it holds, how it is written, and what is refused, by key and with what would be right.

use crate::text::assert_refused;
use peelkit::study::{DisplacementError, FitParameter, Loss, ParameterOf, ProfileChoice};
use peelkit_scene::{Scene, SceneError};

const SCENE: &str = r#"
strip = { length = "100 nm", height = "10 nm", youngs_modulus = "2 GPa" }
adhesion = { hamaker_constant = "1e-19 J", equilibrium_distance = "0.4 nm" }
"#;

fn with(table: &str) -> Result<Scene, SceneError> {
    Scene::parse("a.toml", &format!("{SCENE}[fit]\n{table}"), &[])
}

fn with_parameters(parameters: &str) -> Result<Scene, SceneError> {
    with(&format!("parameters = [{parameters}]"))
}

#[test]
fn parameters_are_read_in_the_units_of_the_library() {
    let scene = with(
        r#"
        parameters = ["strip.youngs_modulus from 1 GPa to 5000 MPa", "adhesion.hamaker_constant", "fit.displacement_zero"]
        force_error = "2 pN"
        displacement_error = "0.01 nm"
        displacement_zero = "0.001 um"
        jump = "3 nm"
        use_jump = false
        loss = "huber"
        profile = "all"
        "#,
    )
    .unwrap();
    let parameters = scene.fit_parameters().unwrap();
    let of = |parameter: &FitParameter| (parameter.key.clone(), parameter.initial, parameter.from, parameter.to);
    assert_eq!(of(&parameters[0]), ("strip.youngs_modulus".into(), 2.0, Some(1.0), Some(5.0)));
    assert_eq!(of(&parameters[1]), ("adhesion.hamaker_constant".into(), 0.1, None, None));
    assert_eq!(of(&parameters[2]), ("fit.displacement_zero".into(), 1.0, None, None));
    let kinds: Vec<ParameterOf> = parameters.iter().map(|parameter| parameter.of).collect();
    assert_eq!(kinds, [ParameterOf::Model, ParameterOf::Model, ParameterOf::DisplacementZero { curve: 0 }]);
    let table = scene.fit.as_ref().unwrap();
    let near = |found: Option<f64>, expected: f64| found.is_some_and(|found| (found - expected).abs() < 1e-15);
    assert!(
        near(table.options.force_error, 2e-3)
            && table.options.displacement_error == DisplacementError::Known(0.01)
            && near(table.jump, 3.0)
    );
    assert_eq!((table.options.loss, table.options.profile), (Loss::Huber, ProfileChoice::All));
    assert!(!table.options.use_jump);
    // written and read again it is the same
    assert_eq!(Scene::parse("a.toml", &scene.to_toml(), &[]).unwrap(), scene);
}

#[test]
fn columns_zeros_and_errors_are_read_and_written() {
    let scene = with(
        r#"
        parameters = ["strip.height", "fit.force_zero"]
        columns = { displacement = "Extension", force = "Load (N)" }
        force_zero = "-0.2 mN"
        displacement_error = "none"
        "#,
    )
    .unwrap();
    let table = scene.fit.as_ref().unwrap();
    let columns = &table.columns;
    assert_eq!((columns.displacement.as_deref(), columns.force.as_deref()), (Some("Extension"), Some("Load (N)")));
    assert_eq!(table.options.displacement_error, DisplacementError::None);
    let parameter = &scene.fit_parameters().unwrap()[1];
    assert_eq!((parameter.of, parameter.initial), (ParameterOf::ForceZero { curve: 0 }, -2e5));
    assert_eq!(Scene::parse("a.toml", &scene.to_toml(), &[]).unwrap(), scene);
    assert_refused(
        with("parameters = [\"strip.height\"]\ncolumns = { x = \"u\" }"),
        &["`x`, which is none of displacement"],
    );
}

#[test]
fn bounds_are_read_as_a_table_or_as_one_text_and_written_as_a_table() {
    let of_text = r#""strip.height", "strip.youngs_modulus from 1 GPa to 5000 MPa", "strip.width to 2 nm", "strip.poissons_ratio from 0.1""#;
    let of_tables = r#"
        { key = "strip.height" }, { key = "strip.youngs_modulus", from = "1 GPa", to = "5 GPa" },
        { key = "strip.width", to = "2 nm" }, { key = "strip.poissons_ratio", from = 0.1 }"#;
    let scene = with_parameters(of_text).unwrap();
    assert_eq!(with_parameters(of_tables).unwrap(), scene);
    let written = scene.to_toml();
    assert!(written.contains(r#"parameters = ["strip.height", { "#), "{written}");
    assert!(written.contains(r#"key = "strip.youngs_modulus""#) && !written.contains(" from 1"), "{written}");
    assert_eq!(Scene::parse("a.toml", &written, &[]).unwrap(), scene);
}

#[test]
fn tables_of_a_key_and_its_bounds_are_refused_as_texts_are() {
    let table = |entries: &str, part: &str| {
        parameters_refused(&format!("\"strip.width\", {{ {entries} }}"), &["line 5", "in parameter 2", part]);
    };
    table("from = \"1 nm\"", "no `key`");
    table("key = \"strip.hight\"", "Did you mean `strip.height`?");
    table("key = \"strip.height\", form = \"1 nm\"", "`form`, which is none of key, from, to");
    table("key = \"strip.height\", from = 9", "a number without a unit: write \"9 nm\" if that is meant");
    table("key = \"strip.height\", from = \"-9 nm\"", "`from` of `strip.height` that is out of range");
    table("key = \"strip.height\", from = \"12 nm\", to = \"8 nm\"", "`from` is not below `to`");
    table("key = \"accuracy.relative\"", "not a number of the model");
}

#[test]
fn what_is_left_out_has_its_default() {
    let scene = with_parameters("\"strip.height\"").unwrap();
    let table = scene.fit.as_ref().unwrap();
    assert_eq!((table.options.force_error, table.jump), (None, None));
    assert_eq!(table.options.displacement_error, DisplacementError::Estimated);
    assert_eq!((table.options.loss, table.options.profile), (Loss::Squares, ProfileChoice::Poor));
    let plain = Scene::parse("a.toml", SCENE, &[]).unwrap();
    assert!(plain.fit.is_none() && !plain.to_toml().contains("fit") && plain.fit_parameters().unwrap().is_empty());
}

#[test]
fn the_table_can_be_set_on_the_command_line() {
    let set = |key: &str, value: &str| (key.to_owned(), value.to_owned());
    let parameters = set("fit.parameters", "[\"strip.height\"]");
    let scene = Scene::parse("a.toml", SCENE, &[parameters.clone(), set("fit.loss", "soft-l1")]).unwrap();
    assert_eq!(scene.fit.as_ref().map(|table| table.options.loss), Some(Loss::SoftL1));
    let error = Scene::parse("a.toml", SCENE, &[parameters, set("fit.loss", "hubber")]).unwrap_err();
    assert!(format!("{error}").contains("did you mean \"huber\""), "{error}");
    let error = Scene::parse("a.toml", SCENE, &[set("fit.loss", "huber")]).unwrap_err().to_string();
    assert!(error.contains("fit.parameters") && error.contains("required"), "{error}");
}

#[track_caller]
fn refused(table: &str, parts: &[&str]) {
    assert_refused(with(table), parts);
}

#[track_caller]
fn parameters_refused(parameters: &str, parts: &[&str]) {
    refused(&format!("parameters = [{parameters}]"), parts);
}

#[test]
fn parameters_that_cannot_be_fitted_are_refused_by_key_and_line() {
    refused("", &["line 4", "parameters"]);
    refused("parameters = 3", &["line 5", "fit.parameters", "is 3, no list"]);
    parameters_refused("3", &["has as parameter 1 3, which is neither a text nor a table"]);
    parameters_refused("\"strip.hight\"", &["line 5", "parameter 1 \"strip.hight\"", "did you mean", "strip.height"]);
    parameters_refused("\"strip.section\"", &["not a number of the model"]);
    parameters_refused("\"accuracy.relative\"", &["not a number of the model"]);
    parameters_refused("\"strip.height\", \"strip.height from 9 nm\"", &["names `strip.height` twice"]);
    parameters_refused("\"spatula.tip_width\"", &["names `spatula.tip_width`", "[spatula]"]);
    parameters_refused(
        "\"grip.stiffness\"",
        &["names `grip.stiffness`, which has no value in the scene", "Add `grip.stiffness`"],
    );
}

#[test]
fn bounds_that_bound_nothing_are_refused() {
    parameters_refused("\"strip.height from 9\"", &["whose bound", "unit"]);
    parameters_refused("\"strip.height from 9 GPa\"", &["whose bound"]);
    parameters_refused("\"strip.height from -9 nm\"", &["whose bound -9 nm is out of range"]);
    parameters_refused("\"strip.height from 12 nm to 8 nm\"", &["whose first bound is not below its second"]);
    parameters_refused("\"strip.height 8 nm to 12 nm\"", &["something else than from A to B"]);
    parameters_refused("\"strip.height from\"", &["something else than from A to B"]);
    parameters_refused(
        "\"strip.height from 11 nm to 12 nm\"",
        &["do not hold its value in the scene, 10 nm", "around it"],
    );
}

#[test]
fn other_keys_are_refused_where_they_say_nothing() {
    let with = |line: &str| format!("parameters = [\"strip.height\"]\n{line}");
    refused(&with("loss = \"cauchy\""), &["line 6", "fit.loss", "\"cauchy\"", "none of its values"]);
    refused(&with("profile = 1"), &["line 6", "fit.profile", "is 1, no word"]);
    refused(&with("force_error = 0.1"), &["fit.force_error", "unit"]);
    refused(&with("force_error = \"-1 pN\""), &["fit.force_error", "out of range"]);
    refused(&with("jump = \"0 nm\""), &["fit.jump", "out of range"]);
    refused(&with("use_jump = 1"), &["fit.use_jump", "true or false"]);
    refused(&with("start = 1"), &["fit", "start"]);
}
