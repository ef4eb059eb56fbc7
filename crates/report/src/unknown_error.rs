//! Which part of the errors of a scene's results is not known.

use peelkit_scene::{Described, Scene};

/// Which part of the errors of the results of a scene has no bound, in words; nothing of a peel, whose peels are as accurate as
/// `accuracy.relative` asks for.
pub fn unknown_error(scene: &Scene) -> Option<&'static str> {
    Some(match scene.describes() {
        Described::Rate(_, None) => {
            "the errors of the mesh and of the steps in time have no bound: compare with another accuracy.elements and a \
             smaller time.tolerance"
        }
        Described::Rate(_, Some(_)) => {
            "the errors of the mesh, of the steps in time and of the law of the tips have no bound: compare with a \
             smaller time.tolerance"
        }
        Described::Solid(_) => "the errors of the mesh of the solid have no bound: compare with a smaller solid.along",
        Described::Array(_) => {
            "events are exact for the law of the setae that is given; how wrong that law is stands beside no result"
        }
        Described::Seta(_) => {
            "the bound on the error of the largest force is that of the mesh of the branches; the error of the law of the \
             tips is not in it, and other results have no bound"
        }
        Described::Peel => return None,
    })
}
