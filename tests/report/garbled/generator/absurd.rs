//! Scenes that mean something, with absurd numbers.

use super::dice::Dice;
use peelkit::model::Attraction;
use peelkit_scene::{Dimension, KEYS, Kind};

/// A scene whose every number lies anywhere in a range that no strip has seen, for a run of at most 60 points and 0.2 s.
pub fn absurd_scene(dice: &mut Dice) -> String {
    let body = dice.pick(&["strip", "strip", "strip", "spatula"]);
    absurd_scene_of(body, dice)
}

/// Four pieces: lengths over six decades, widths over twelve, heights as far apart, bends of either sign, and as round as
/// may be.
fn absurd_pieces(dice: &mut Dice) -> String {
    let size = dice.decades(1e-3, 1e9);
    let mut height = dice.decades(1e-3, 1e9);
    let mut piece = |_| {
        let begins = std::mem::replace(&mut height, dice.decades(1e-3, 1e9));
        let length = size * dice.decades(1e-6, 1.0);
        let [width, next] = [0; 2].map(|_| dice.decades(1e-3, 1e9));
        let (bend, course) = (dice.between(-44.9, 44.9), dice.pick(&["linear", "smooth"]));
        let [round, rounder] = [0; 2].map(|_| dice.between(0.0, 1.0));
        format!(
            "{{ length = \"{length:e} nm\", width = [\"{width:e} nm\", \"{next:e} nm\"], \
             height = [\"{begins:e} nm\", \"{height:e} nm\"], roundness = [{round}, {rounder}], bend = \"{bend} deg\", \
             course = \"{course}\" }}"
        )
    };
    (0..4).map(&mut piece).collect::<Vec<_>>().join(", ")
}

/// The same of a body of this table.
pub fn absurd_scene_of(body: &str, dice: &mut Dice) -> String {
    let mut text = String::new();
    let mut line = |line: String| text += &(line + "\n");
    if dice.below(4) == 0 {
        line("terms = \"auto\"".into());
    }
    line(format!("[{body}]"));
    let keys = KEYS.iter().filter(|key| key.table == body && matches!(key.kind, Kind::Quantity(Dimension::Length, _)));
    let lengths: Vec<(&str, f64)> = keys.map(|key| (key.name, dice.decades(1e-3, 1e9))).collect();
    let behind: f64 = lengths.iter().filter(|l| ["neck_length", "shaft_length"].contains(&l.0)).map(|l| l.1).sum();
    for (name, length) in lengths {
        // a bend ends on the shaft
        let length = if name == "bend_length" { length.min(behind) } else { length };
        line(format!("{name} = \"{length:e} nm\""));
    }
    if body == "profile" {
        line(format!("pieces = [{}]", absurd_pieces(dice)));
    }
    if body == "spatula" {
        line(format!("shaft_angle = \"{} deg\"", dice.between(-179.9, 179.9)));
    }
    line(format!("youngs_modulus = \"{:e} GPa\"", dice.decades(1e-9, 1e9)));
    line(format!("poissons_ratio = {}", dice.between(-0.999_999, 0.499_999)));
    line(format!("shear_correction = {:e}", dice.decades(1e-6, 1e6)));
    line(format!("bending_stiffness_factor = {:e}", dice.decades(1e-9, 1e9)));
    line("[adhesion]".into());
    line(format!("hamaker_constant = \"{:e} J\"", dice.decades(1e-30, 1e-10)));
    line(format!("equilibrium_distance = \"{:e} nm\"", dice.decades(1e-4, 1e4)));
    // that of the half space twice as often as any other
    let laws: Vec<_> = [Attraction::BodyForce].into_iter().chain(Attraction::all()).map(Attraction::name).collect();
    let law = dice.pick(&laws);
    line(format!("law = \"{law}\""));
    if !law.contains("-") && dice.below(2) == 0 {
        line(format!(
            "work = \"{:e} J/m2\"\nstrength = \"{:e} GPa\"",
            dice.decades(1e-9, 1e6),
            dice.decades(1e-9, 1e6)
        ));
    }
    let line_load = dice.pick(&["full", "force-only", "axis-gap"]);
    line(format!("line_load = \"{line_load}\""));
    line(format!("far_face = {}", dice.pick(&[true, false])));
    let rubs = law.contains("-") && dice.below(4) == 0;
    if rubs {
        line("[friction]".into());
        line(format!("strength = \"{:e} GPa\"", dice.decades(1e-9, 1e6)));
        line(format!("coefficient = {:e}", dice.decades(1e-6, 1e3)));
    }
    line("[grip]".into());
    let rotation = dice.pick(&["free", "fixed"]);
    line(format!("rotation = \"{rotation}\""));
    let horizontal = dice.pick(&["free", "fixed"]);
    line(format!("horizontal = \"{horizontal}\""));
    if body == "strip" && horizontal == "fixed" && !rubs && dice.below(3) == 0 {
        line(format!("pretension = \"{:e} nN\"", dice.decades(1e-9, 1e9)));
    }
    line("[bounds]\npoints = 60\ntime = \"0.2 s\"".into());
    if dice.below(4) == 0 {
        line(format!("displacement = \"{:e} nm\"", dice.decades(1e-3, 1e9)));
    }
    line("[accuracy]".into());
    line(format!("relative = {:e}", dice.decades(1.000_001e-11, 0.999_999e-2)));
    if dice.below(4) == 0 {
        line(format!("order = {}", 1 + dice.below(8)));
    }
    if dice.below(4) == 0 {
        line(format!("elements = {}", dice.decades(1.0, 2000.0).floor()));
    }
    if dice.below(4) == 0 {
        line(format!("step = {:e}", dice.decades(1.000_001e-6, 0.499_999)));
    }
    if dice.below(3) == 0 {
        line(format!("[drive]\nangle = \"{} deg\"", dice.between(0.001, 179.999)));
        if rotation == "fixed" && law != "surface-traction" && line_load != "force-only" && dice.below(2) == 0 {
            line(format!("turn = \"{:e} deg/nm\"", dice.between(-500.0, 500.0)));
        }
        if dice.below(2) == 0 {
            let turn = format!("\"turn {} deg\"", dice.between(-180.0, 180.0));
            let turn = if rotation == "fixed" { turn } else { "\"hold\"".into() };
            let step = |word: &str, amount: f64| format!("\"{word} {amount:e} nm\"");
            let first = step(dice.pick(&["press", "lift"]), dice.decades(1e-6, 1e6));
            let second = step(dice.pick(&["drag", "push"]), dice.decades(1e-6, 1e6));
            line(format!("steps = [{first}, {second}, {turn}]"));
        }
    }
    text
}
