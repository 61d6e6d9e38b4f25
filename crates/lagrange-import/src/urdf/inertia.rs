//! Inertia of a whole robot: impossible tensors, and links without inertia.

use lagrange_core::diagnostics::{Report, Severity};

use super::collector::Source;
use super::{Options, messages};
use crate::mistakes::Mistake;
use crate::robot::{Link, Robot};

/// Reports impossible tensors. Inertia of links that are fixed to the ground has no effect.
pub(super) fn report_impossible(source: &mut Source<'_>, robot: &Robot, options: &Options) {
    let fixed = robot.fixed_in_root();
    for (link, is_fixed) in robot.links.iter().zip(fixed) {
        let Some(inertial) = link.inertial.as_ref().filter(|inertial| !inertial.is_physical) else {
            continue;
        };
        let place = (inertial.place, format!("{}, <inertia>", messages::element("link", &link.name)));
        if is_fixed && !options.is_free || options.trusts_inertia {
            source.warning_at(place, messages::IMPOSSIBLE_INERTIA);
        } else {
            source.error_at(place, messages::IMPOSSIBLE_INERTIA).help(messages::IMPOSSIBLE_INERTIA_HELP);
        }
    }
}

/// Reports a link without a moment of inertia as the reason why the equations of motion have no
/// solution.
pub(super) fn report_missing<'s>(
    source: &'s mut Source<'_>,
    robot: &Robot,
    link: usize,
    report: &Report,
) -> &'s mut Mistake {
    let reason = report.diagnostics().iter().find(|diagnostic| diagnostic.severity == Severity::Error);
    let reason = reason.map(|diagnostic| diagnostic.message.as_str()).unwrap_or_default();
    let help = if link == robot.root { messages::FREE_BASE_HELP } else { messages::WITHOUT_INERTIA_HELP };
    let Link { name, place, .. } = &robot.links[link];
    let mistake =
        source.error_at((*place, messages::element("link", name)), messages::without_inertia(reason));
    mistake.help(help);
    mistake
}
