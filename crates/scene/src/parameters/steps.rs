//! The amounts of the steps before the pull.

use super::in_lists::NumberInList;
use peelkit::model::{PeelModel, Step};

/// One a step that has an amount.
pub(super) fn numbers(model: &PeelModel) -> Vec<NumberInList> {
    let with_amount = model.steps.iter().enumerate().filter(|(_, step)| step.motion().is_some());
    with_amount.map(|(index, step)| amount(index, *step)).collect()
}

fn amount(index: usize, step: Step) -> NumberInList {
    let changed = move |model: &mut PeelModel, factor: f64| {
        let step = step.scaled(factor);
        step.check().map_err(|wrong| format!("has a step {} {wrong}", index + 1))?;
        if let Some(place) = model.steps.get_mut(index) {
            *place = step;
        }
        Ok(())
    };
    NumberInList { key: format!("drive.steps[{}]", index + 1), changed: Box::new(changed) }
}
