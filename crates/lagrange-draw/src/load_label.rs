//! Labels of forces and moments.
//!
//! Weights are G, forces of springs, dampers and pins F, normal forces N, friction forces H,
//! moments M. Names are added as subscripts if there are several. A drawing may replace letters.

use std::collections::BTreeSet;

use crate::load::{Load, Value};
use crate::snapshot::{Snapshot, Stored};
use lagrange_plot::label::Label;
use lagrange_plot::notation::{formula, symbol};
use lagrange_runtime::scene::{Item, Joint, LoadOrigin, Plane};

/// Forces and moments of a scene in the plane, for a page that draws its items.
#[derive(Clone, PartialEq, Debug)]
pub struct LiveLoads {
    /// Letter and subscript of each force or moment, in the order of the items.
    pub labels: Vec<[String; 2]>,
    /// Note on loads that act but are not drawn; empty if there are none.
    pub note: String,
}

impl LiveLoads {
    /// Collects the loads of the scene visited by `visit`.
    pub fn new(visit: impl FnOnce(&mut dyn FnMut(Item<'_, f64, Plane>))) -> LiveLoads {
        let snapshot = Snapshot::collected(visit);
        let label = |load: &Load| {
            let label = load_label(load, &snapshot);
            let (letter, subscript) = label.split_once("_{").unwrap_or((&label, ""));
            [letter, subscript.trim_end_matches('}')].map(|part| Label::parse(part).plain())
        };
        LiveLoads {
            labels: snapshot.loads.iter().map(label).collect(),
            note: omitted_loads(std::slice::from_ref(&snapshot)),
        }
    }
}

/// Returns the label of a force or moment.
pub(super) fn load_label(load: &Load, snapshot: &Snapshot) -> String {
    let has_others = snapshot.bodies.len() > 1;
    if let Some(label) = given_label(load, snapshot, has_others) {
        return label;
    }
    let letter = match load.value {
        Value::Force(_) => "F",
        Value::Moment(_) => "M",
    };
    match (load.cause, &load.body) {
        (LoadOrigin::Gravity, Some(body)) => symbol("G", body, has_others),
        // Declared loads have no individual names.
        (LoadOrigin::Applied, _) if ["force", "torque"].contains(&&*load.name) => letter.into(),
        (LoadOrigin::Connector, _) => symbol(letter, &load.name, true),
        (LoadOrigin::Joint, _) => of_joint(load, snapshot).unwrap_or_else(|| formula(&load.name)),
        (LoadOrigin::Contact, _) => {
            let contacts = snapshot.loads.iter().filter(|load| load.cause == LoadOrigin::Contact);
            contact_label(&load.name, contacts.map(|load| &*load.name))
        }
        _ => formula(&load.name),
    }
}

/// Returns the label that replaces the usual one. Weights share a name, and may share a letter.
pub(super) fn given_label<D: Stored>(
    load: &Load<D>,
    snapshot: &Snapshot<D>,
    has_others: bool,
) -> Option<String> {
    let letter = snapshot.letter(&load.name)?;
    match (load.cause, &load.body) {
        (LoadOrigin::Gravity, Some(body)) if !letter.contains('_') => Some(symbol(letter, body, has_others)),
        _ => Some(letter.to_owned()),
    }
}

/// Returns the symbol of the normal force or friction of a contact; `names` lists all such forces.
pub(super) fn contact_label<'a>(name: &str, names: impl Iterator<Item = &'a str>) -> String {
    let letter = if name.ends_with(".friction") { "H" } else { "N" };
    symbol(letter, owner(name), names.map(owner).collect::<BTreeSet<&str>>().len() > 1)
}

/// Returns the symbol of a constraint force, if the scene has its joint.
fn of_joint(load: &Load, snapshot: &Snapshot) -> Option<String> {
    let name = owner(&load.name);
    let joint = snapshot.joints.iter().find(|joint| joint.name == name)?;
    let letter = match (joint.kind, load.name.strip_prefix(name)) {
        (Joint::Slide, _) | (_, Some(".normal")) => "N",
        (_, Some(".friction")) => "H",
        _ => "F",
    };
    let joints = snapshot.loads.iter().filter(|load| load.cause == LoadOrigin::Joint);
    let joints = joints.map(|load| owner(&load.name));
    Some(symbol(letter, name, joints.collect::<BTreeSet<&str>>().len() > 1))
}

/// Returns the name of the joint or contact, the part before a dot.
fn owner(name: &str) -> &str {
    name.split_once('.').map_or(name, |(owner, _)| owner)
}

/// Returns the note about loads that act but cannot be drawn; empty if there are none.
pub(super) fn omitted_loads<D: Stored>(snapshots: &[Snapshot<D>]) -> String {
    let mut omitted: Vec<&String> = Vec::new();
    for name in snapshots.iter().flat_map(|snapshot| &snapshot.omitted) {
        if !omitted.contains(&name) {
            omitted.push(name);
        }
    }
    if omitted.is_empty() {
        return String::new();
    }
    let of = |name: &String| match name.split_once(" on `") {
        Some((load, angle)) => {
            format!("{load} on {}", Label::parse(&formula(angle.trim_end_matches('`'))).plain())
        }
        None if name.contains(' ') => name.clone(),
        None => format!("force of {}", name.replace('_', " ")),
    };
    format!("not drawn: {}", omitted.into_iter().map(of).collect::<Vec<_>>().join(", "))
}

#[cfg(test)]
mod tests {
    use super::load_label;
    use crate::load::{Load, Value};
    use crate::snapshot::Snapshot;
    use lagrange_runtime::scene::{Joint, LoadOrigin};

    fn force(name: &str, cause: LoadOrigin) -> Load {
        let body = Some("rod".to_string());
        Load { name: name.to_string(), cause, body, at: [0.0, 0.0], value: Value::Force([1.0, 0.0]) }
    }

    #[test]
    fn forces_have_the_symbols_of_textbooks() {
        let joint =
            |name: &str, kind| crate::snapshot::Joint { name: name.to_string(), kind, at: [0.0, 0.0] };
        let wheel = Snapshot { joints: vec![joint("contact", Joint::Roll)], ..Snapshot::default() };
        let loads =
            vec![force("contact.normal", LoadOrigin::Joint), force("contact.friction", LoadOrigin::Joint)];
        let wheel = Snapshot { loads, ..wheel };
        assert_eq!(wheel.loads.iter().map(|load| load_label(load, &wheel)).collect::<Vec<_>>(), ["N", "H"]);

        let mut rod = Snapshot { joints: vec![joint("hinge", Joint::Pin)], ..Snapshot::default() };
        rod.loads = vec![
            force("hinge", LoadOrigin::Joint),
            force("k1", LoadOrigin::Connector),
            force("force", LoadOrigin::Applied),
        ];
        assert_eq!(
            rod.loads.iter().map(|load| load_label(load, &rod)).collect::<Vec<_>>(),
            ["F", "F_{k1}", "F"]
        );
        rod.joints.push(joint("foot", Joint::Slide));
        rod.loads.push(force("foot", LoadOrigin::Joint));
        assert_eq!(load_label(&rod.loads[0], &rod), "F_{hinge}", "there are several joints now");
        assert_eq!(load_label(&rod.loads[3], &rod), "N_{foot}");
        assert_eq!(
            load_label(&force("S", LoadOrigin::Joint), &rod),
            "S",
            "the scene has no joint of that name"
        );
    }
}
