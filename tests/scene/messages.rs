//! What is said about a scene that cannot be used.
//!
//! Expected: of every mistake the message names the file, the line, the key with its table and what was found, and the
//! remedy says what would be right. Why: a person who peels strips, not one who writes parsers, has to mend the file.

use crate::text::{MINIMAL, PIECES, PROFILE, SPATULA, assert_says, complaint, set, with};
use peelkit_scene::{KEYS, Need, Scene};

#[test]
fn what_does_not_belong_to_a_substrate_is_named() {
    let on = |keys: &str| complaint(&format!("{MINIMAL}[substrate]\n{keys}"));
    assert_says(
        &on("shape = \"sphere\"\nradius = \"9 nm\"\nheight = \"8 nm\""),
        &[
            "line 12: `substrate.height` is a key of [substrate] for another `shape` than \"sphere\"",
            "shape \"sinusoid\"",
            "radius, offset, start",
        ],
    );
    assert_says(
        &on("radius = \"9 nm\""),
        &["`substrate.radius`", "than \"flat\"", "\"sphere\" or \"cylinder\"", "no other keys"],
    );
    assert_says(&on("shape = \"cylinder\""), &["[substrate] lacks `radius`", "radius = \"200 nm\""]);
    assert_says(&on("shape = \"wave\""), &["`substrate.shape` is \"wave\"", "\"flat\", \"sphere\", "]);
    assert_says(
        &on("shape = \"profile\"\ntable = \"no.csv\""),
        &["`substrate.table` names the file dir/no.csv, which cannot be read"],
    );
    assert_says(
        &on("shape = \"sphere\"\nradius = \"9 nm\"\noffset = \"9 nm\""),
        &["`substrate.offset` is 9 nm, and the strip begins beside the body", "less than `radius`"],
    );
    let forced = MINIMAL.replace("[adhesion]", "[adhesion]\nline_load = \"force-only\"");
    assert_says(
        &complaint(&format!("{forced}[substrate]\nshape = \"sphere\"\nradius = \"9 nm\"")),
        &["`adhesion.line_load` is \"force-only\"", "no potential"],
    );
    assert_says(
        &complaint(&format!("{SPATULA}[substrate]\nshape = \"sphere\"\nradius = \"1 nm\"")),
        &["`substrate.shape` lets the beam lie on", "at most 100", "a shorter strip or pad"],
    );
}

#[test]
fn a_list_in_place_of_a_quantity_is_called_one() {
    let error = with("strip.length", "[\"1 nm\", \"2 nm\"]").unwrap_err();
    assert_says(&error, &["`strip.length` is a list: [\"1 nm\", \"2 nm\"]", "a length above zero with its unit"]);
}

#[test]
fn a_scene_peels_one_body() {
    let both = MINIMAL.to_owned() + "[spatula]\ntip_width = \"100 nm\"\n";
    assert_says(
        &complaint(&both),
        &[
            "dir/a.toml, line 10: `spatula.tip_width`",
            "a [strip]",
            "[strip], [spatula], [profile]; a [seta] may stand beside",
        ],
    );
    let error = with("spatula.tip_width", "100 nm").unwrap_err();
    assert_says(&error, &["--set spatula.tip_width=100 nm", "the scene peels a [strip]"]);
}

#[test]
fn what_is_wrong_with_a_table_is_named() {
    for (cell, wrong, parts) in [
        ("40, 20", "40, 0", ["line 3: `profile.table` has in row 2 `width_nm` = 0", "not above zero"]),
        ("100, 10", "30, 10", ["`profile.table` has in row 3 `s_nm` = 30", "does not ascend"]),
        ("angle_deg", "angle", ["`profile.table` has a column `angle`", "angle_deg, roundness"]),
        ("100, 10, 10, 30", "100, 10, 10", ["`profile.table` is no CSV", "s_nm, width_nm, height_nm and, optionally"]),
    ] {
        assert_says(&complaint(&PROFILE.replace(cell, wrong)), &parts);
    }
    let text = PROFILE.split("\"\"\"").collect::<Vec<_>>();
    let parts = ["dir/a.toml, line 3: `profile.table` names the file dir/no.csv, which cannot be read"];
    assert_says(&complaint(&format!("{}\"no.csv\"{}", text[0], text[2])), &parts);
}

#[test]
fn what_is_wrong_with_pieces_is_named() {
    for (good, wrong, parts) in [
        (
            "length = \"150",
            "lenght = \"150",
            ["line 8: `profile.pieces` has in piece 2 the key `lenght`", "did you mean `length`?"],
        ),
        (
            "length = \"150 nm\"\n",
            "",
            ["line 8: `profile.pieces` has in piece 2 no `length`", "each with length, width"],
        ),
        (
            "length = \"150 nm\"",
            "length = 150",
            ["has in piece 2 `length` = 150, a number without a unit", "\"150 nm\""],
        ),
        ("\"0.25 um\"", "\"um\"", ["line 4: `profile.pieces` has in piece 1 `length` = \"um\"", "begin with a number"]),
        (
            "\"0.25 um\"",
            "\"0.25\"",
            ["piece 1 `length` = \"0.25\", whose amount has no unit (nm", "length = \"90 nm\""],
        ),
        ("\"0.25 um\"", "\"0 um\"", ["piece 1 `length` = 0 nm", "not above zero"]),
        ("\"0.25 um\"", "[\"1 nm\"]", ["piece 1 `length` = a list", "not a length with its unit"]),
        ("\"30 deg\"", "\"30 nm\"", ["piece 2 `bend` = \"30 nm\"", "none of an angle (rad, deg)"]),
        ("\"30 deg\"", "\"181 deg\"", ["rotates the underside by 181 deg up to the end of piece 2", "-180 to 180"]),
        ("[\"5 nm\", \"50 nm\"]", "[\"5 nm\"]", ["piece 2 `height` = a list, which has 1 values", "or two"]),
        (
            "[\"5 nm\", \"50 nm\"]",
            "\"6 nm\"",
            ["ends piece 1 with a height of 5 nm and begins the next with 6 nm", "the same"],
        ),
        (
            "height_course = \"smooth\"",
            "height_course = \"linear\"",
            ["has a kink between piece 1", "omit height_course from both"],
        ),
        ("[0, 1]", "[0, 1.5]", ["piece 2 `roundness` = 1.5", "from 0 to 1"]),
        ("[0, 1]", "\"round\"", ["piece 2 `roundness` = \"round\"", "not a number"]),
        ("course = \"smooth\"", "course = \"s5\"", ["piece 2 `course` = \"s5\"", "neither \"linear\" nor \"smooth\""]),
        ("[profile]", "[profile]\npieces = []", ["line ", "duplicate key"]),
        ("youngs", "table = \"a.csv\"\nyoungs", ["names the file dir/a.csv", "which cannot be read"]),
    ] {
        assert!(PIECES.contains(good), "{good}");
        assert_says(&complaint(&PIECES.replacen(good, wrong, 1)), &parts);
    }
    let without = PIECES.split("[[").next().unwrap();
    for (list, said) in [
        ("[]", "`profile.pieces` has 0 pieces; it takes 1 to 200"),
        ("[1]", "`profile.pieces` has as piece 1 1, no table of its keys"),
        ("{ length = \"1 nm\" }", "`profile.pieces` is a table"),
        ("\"pad\"", "`profile.pieces` is \"pad\""),
        (
            "[{ length = \"1 nm\", width = \"1 nm\", height = \"1 nm\" }]\ntable = \"s_nm\\n\"",
            "`profile.table` is given beside `profile.pieces`",
        ),
    ] {
        assert_says(&complaint(&format!("{without}pieces = {list}\n")), &["dir/a.toml, line ", said]);
    }
    let table = "[{ length = \"1 nm\", width = \"1 nm\", height = \"1 nm\" }]";
    let error = Scene::parse("a.toml", PROFILE, &set("profile.pieces", table)).unwrap_err();
    assert_says(
        &error.to_string(),
        &["--set profile.pieces=", "is given beside `profile.table`, and the beam has one geometry"],
    );
    assert_says(error.remedy(), &["Remove one of `pieces` and `table`."]);
}

#[test]
fn lengths_of_a_spatula_that_do_not_fit_are_named() {
    for (line, parts) in [
        ("tip_rounding_length = \"241 nm\"", ["`spatula.tip_rounding_length` is 241 nm", "(240 nm)"]),
        ("tip_rounding_length = \"9 nm\"\ntip_rounding_width = \"201 nm\"", ["_width` is 201 nm", "(200 nm)"]),
        ("bend_length = \"751 nm\"", ["`spatula.bend_length` is 751 nm", "(750 nm)"]),
        ("shaft_angle = \"200 deg\"", ["`spatula.shaft_angle` is 200 deg", "from -180 to 180 deg"]),
        ("shaft_angle = \"4 nm\"", ["nm measures a length, not an angle", "45 deg"]),
        ("shaft_angle = 45", ["is 45, a number without a unit", "Write \"45 deg\""]),
    ] {
        let text = SPATULA.replace("[spatula]\n", &format!("[spatula]\n{line}\n"));
        assert_says(&complaint(&text), &parts);
    }
}

#[test]
fn every_mistake_in_a_value_is_named_with_its_line_and_remedy() {
    let lines = [
        ("length = 100", r#"`strip.length` is 100, a number without a unit"#, r#""100 nm""#),
        (r#"length = "100""#, r#"`strip.length` is "100", a number without a unit"#, r#""100 nm""#),
        (r#"length = "nm""#, "does not begin with a number", r#"length = "100 nm""#),
        (r#"length = "100 NM""#, r#"unit "NM" is not known"#, r#"Did you mean "nm"?"#),
        (r#"length = "100 GPa""#, "GPa measures a pressure, not a length", "nm, um, mm, m"),
        (r#"length = "100 nN""#, "nN measures a force, not a length", "nm, um, mm, m"),
        (r#"length = "-1 nm""#, "is -1 nm, which is out of range", "above zero"),
        (r#"length = "0 nm""#, "is 0 nm, which is out of range", "above zero"),
        (r#"length = "nan nm""#, "not a finite number", "above zero"),
        (r#"length = "inf nm""#, "not a finite number", "above zero"),
        (r#"length = "1e999 nm""#, "not a finite number", "above zero"),
        (r#"length = "1e-999 nm""#, "is 0 nm", "above zero"),
        ("length = nan", "a number without a unit", "nm"),
        ("length = true", "`strip.length` is true", "a length above zero"),
        ("length = [100]", "`strip.length` is a list", "a length above zero"),
        ("length = 2026-01-01", "`strip.length` is a date", "a length above zero"),
        ("length.nm = 100", "`strip.length` is a table", "a length above zero"),
        ("poissons_ratio = 0.5", "`strip.poissons_ratio` is 0.5", "between -1 and 0.5, both excluded"),
        ("poissons_ratio = -1", "`strip.poissons_ratio` is -1", "between -1 and 0.5, both excluded"),
        ("poissons_ratio = nan", "not a finite number", "between -1 and 0.5"),
        (r#"poissons_ratio = "0.2""#, "a number in quotes", "poissons_ratio = 0.2"),
        (r#"poissons_ratio = "0.2 nm""#, r#"is "0.2 nm""#, "a number between"),
        ("shear_correction = 0", "`strip.shear_correction` is 0", "a number above zero"),
        ("bending_stiffness_factor = -1", "`strip.bending_stiffness_factor` is -1", "a number above zero"),
        ("bending_stiffness_factor = inf", "not a finite number", "a number above zero"),
        ("lenght = 1", "`strip.lenght` is not a key", "Did you mean `length`?"),
        ("rotation = 1", "`strip.rotation` is not a key", "`rotation` stands in the table [grip]"),
        (
            "horizontl = 1",
            "`strip.horizontl` is not a key",
            "Did you mean `horizontal`, which stands in the table [grip]",
        ),
        ("colour = 1", "`strip.colour` is not a key", "length, height, width"),
    ];
    for (line, found, remedy) in lines {
        let complaint = complaint(&format!("title = \"x\"\n[strip]\n{line}\n"));
        assert_says(&complaint, &["dir/a.toml, line 3: ", found, remedy]);
    }
}

#[test]
fn every_mistake_in_a_choice_or_another_table_is_named() {
    let lines = [
        ("[adhesion]", r#"line_load = "fulll""#, r#"`adhesion.line_load` is "fulll""#, r#"Did you mean "full"?"#),
        ("[adhesion]", r#"line_load = "none""#, r#"`adhesion.line_load` is "none""#, r#""force-only" or "axis-gap""#),
        ("[adhesion]", r#"far_face = "true""#, "`adhesion.far_face`", "Remove the quotes"),
        ("[adhesion]", "far_face = 1", "`adhesion.far_face` is 1", "true or false"),
        ("[adhesion]", r#"hamaker_constant = "1e-19 nm""#, "nm measures a length, not an energy", "J"),
        ("[adhesion]", r#"equilibrium_distance = "0""#, "a number without a unit", "nm"),
        ("[grip]", r#"rotation = "Fixed""#, r#"is "Fixed""#, r#"Did you mean "fixed"?"#),
        ("[grip]", "horizontal = false", "`grip.horizontal` is false", r#""free" or "fixed""#),
        ("[accuracy]", "relative = 1e-12", "`accuracy.relative` is 1e-12", "from 1e-11 to 1e-2"),
        ("[accuracy]", "relative = 0.1", "`accuracy.relative` is 0.1", "from 1e-11 to 1e-2"),
        ("[bounds]", "points = 0", "`bounds.points` is 0", "a whole number from 1"),
        ("[bounds]", "points = 2.5", "which is not whole", "a whole number from 1"),
        ("[bounds]", "points = 99999999999999999999", "`bounds.points`", "a whole number from 1"),
        ("[bounds]", "time = 60", "a number without a unit", r#""60 s""#),
        ("[grip]", "stiffness = 0.5", "a number without a unit", r#""0.5 N/m""#),
        ("[bounds]", r#"displacement = "1 s""#, "s measures a time, not a length", "nm"),
        ("[girp]", "rotation = 1", "[girp] is not a table", "Did you mean [grip]?"),
        (
            "[spring]",
            "rotation = 1",
            "[spring] is not a table",
            "[strip], [spatula], [profile], [seta], [adhesion], [substrate], [friction], [grip]",
        ),
        ("[[strip]]", "length = 1", "`strip` is a list", "write [strip]"),
    ];
    for (table, line, found, remedy) in lines {
        let complaint = complaint(&format!("{table}\n{line}\n"));
        assert_says(&complaint, &["dir/a.toml, line ", found, remedy]);
    }
}

#[test]
fn a_key_in_no_table_and_a_table_that_is_none_are_named() {
    assert_says(&complaint("length = \"1 nm\""), &["line 1: `length`", "in the table [strip]"]);
    assert_says(&complaint("titel = \"x\""), &["line 1: `titel`", "Did you mean `title`?"]);
    assert_says(&complaint("title = 3"), &["line 1: `title` is 3", "a text in quotes"]);
    assert_says(&complaint("\nstrip = 3"), &["line 2: `strip` is 3", "write [strip]"]);
    assert_says(&complaint("[strip]\ntitle = \"x\""), &["line 2: `strip.title`", "at the top of the file"]);
}

#[test]
fn what_is_missing_is_named_with_an_example() {
    assert_says(&complaint(""), &["line 1: the scene lacks the table [strip]", r#"length = "100 nm""#]);
    let no_adhesion = MINIMAL.split("[adhesion]").next().unwrap();
    assert_says(&complaint(no_adhesion), &["the scene lacks the table [adhesion]", r#"hamaker_constant = "1e-19 J""#]);
    let no_table = PROFILE.split("table").next().unwrap();
    assert_says(
        &complaint(no_table),
        &["line 2: [profile] lacks `table` or `pieces` instead", "s_nm,width_nm,height_nm\\n0,20,5"],
    );
    for key in KEYS.iter().filter(|key| {
        key.need == Need::Required
            && !["profile", "substrate", "uncertainty", "fit", "optimise", "time"].contains(&key.table)
    }) {
        let without: Vec<&str> = MINIMAL.lines().filter(|line| !line.starts_with(key.name)).collect();
        let example = format!("{} = ", key.name);
        let lacks = format!("[{}] lacks `{}`", key.table, key.name);
        assert_says(&complaint(&without.join("\n")), &["line ", &lacks, &example]);
    }
}

#[test]
fn what_is_not_toml_is_named_with_its_line() {
    assert_says(&complaint("[strip]\nlength = 100 nm"), &["line 2: `length` is not TOML", r#"length = "100 nm""#]);
    assert_says(&complaint("[strip\n"), &["line 1: this is not TOML", "peel new"]);
    assert_says(&complaint("[strip]\nlength = \"1 nm\"\nlength = \"2 nm\""), &["line 3: `length`", "duplicate"]);
    assert_says(&complaint("{\"strip\": 1}"), &["line 1: ", "is not TOML"]);
    assert_says(&complaint("[strip]\nlength = \"1 nm"), &["line 2: `length` is not TOML"]);
}
