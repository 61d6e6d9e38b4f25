//! Links: mass, its distribution, and shapes.

use lagrange_core::elaborate::is_physical;
use roxmltree::Node;

use super::collector::Source;
use super::messages;
use super::source::{attribute_of, elements, tagged};
use crate::decimal::Decimal;
use crate::robot::{Inertial, Link, Shape, Solid};
use crate::rotation::{roll_pitch_yaw, turned_tensor};

const ENTRIES: [&str; 6] = ["ixx", "iyy", "izz", "ixy", "ixz", "iyz"];
/// Smallest entry of a tensor per kilogram. Smaller ones correspond to distances of a nanometre and
/// are attributed to cancellation.
const NEGLIGIBLE: f64 = 1e-18;
/// Solids with the attributes that specify their dimensions.
const SOLIDS: [(&str, &[&str], Solid); 3] = [
    ("box", &["size"], Solid::Box),
    ("cylinder", &["radius", "length"], Solid::Cylinder),
    ("sphere", &["radius"], Solid::Sphere),
];

pub(super) fn link<'d>(source: &mut Source<'d>, node: Node<'_, 'd>) -> Link {
    source.allow_only(node, &["name", "type"], &["inertial", "visual", "collision"]);
    let inertial = source.child(node, "inertial").and_then(|inertial| self::inertial(source, inertial));
    let is_shape = |child: &Node<'_, '_>| ["visual", "collision"].contains(&child.tag_name().name());
    let shapes = elements(node).filter(is_shape).filter_map(|child| shape(source, child)).collect();
    let name = attribute_of(node, "name").unwrap_or_default().to_owned();
    let mut link = Link { name, inertial, shapes, collides_as_mesh: false, place: node.range().start };
    link.collides_as_mesh = tagged(node, "collision").count() > link.collisions().count();
    link
}

/// Reads the inertia; `None` for a massless link, or after a mistake.
fn inertial<'d>(source: &mut Source<'d>, node: Node<'_, 'd>) -> Option<Inertial> {
    source.allow_only(node, &[], &["origin", "mass", "inertia"]);
    let [centroid, turned] = source.origin(node);
    let mass = source.required_child(node, "mass", "<mass value=\"m\"/>");
    let mass = mass.and_then(|mass| {
        source.allow_only(mass, &["value"], &[]);
        let number = source.number(mass, "value")?;
        if number.value() < 0.0 {
            source.error(mass, messages::MASS_NOT_POSITIVE);
        }
        Some(number)
    });
    let form = "<inertia ixx=\"…\" ixy=\"…\" ixz=\"…\" iyy=\"…\" iyz=\"…\" izz=\"…\"/>";
    let inertia = source.required_child(node, "inertia", form)?;
    source.allow_only(inertia, &ENTRIES, &[]);
    let [xx, yy, zz, xy, xz, yz] = ENTRIES.map(|entry| source.number(inertia, entry));
    let (mass, tensor) = (mass?, [xx?, yy?, zz?, xy?, xz?, yz?]);
    if mass.value() <= 0.0 {
        if tensor.iter().any(|entry| !entry.is_zero()) && mass.is_zero() {
            source.error(inertia, messages::MASSLESS_INERTIA).help(messages::MASSLESS_INERTIA_HELP);
        }
        return None;
    }
    let least = NEGLIGIBLE * mass.value();
    let tensor = tensor.map(|entry| if entry.value().abs() < least { Decimal::zero() } else { entry });
    let rotation = roll_pitch_yaw(turned.each_ref().map(Decimal::value));
    let tensor = turned_tensor(rotation, &tensor);
    let is_physical = is_physical(tensor.each_ref().map(Decimal::value));
    Some(Inertial { mass, centroid, tensor, is_physical, place: inertia.range().start })
}

/// Reads a primitive; `None` for a mesh.
fn shape<'d>(source: &mut Source<'d>, node: Node<'_, 'd>) -> Option<Shape> {
    source.allow_only(node, &["name", "group"], &["origin", "geometry", "material"]);
    let [at, turned] = source.origin(node);
    let geometry = source.required_child(node, "geometry", "<geometry><box size=\"x y z\"/></geometry>")?;
    let kinds = SOLIDS.map(|(tag, ..)| tag);
    source.allow_only(geometry, &[], &[kinds[0], kinds[1], kinds[2], "mesh", "capsule"]);
    let Some((element, attributes, solid)) = SOLIDS
        .iter()
        .find_map(|(tag, attributes, solid)| Some((tagged(geometry, tag).next()?, *attributes, *solid)))
    else {
        if elements(geometry).next().is_none() {
            source.error(geometry, messages::NO_GEOMETRY);
        }
        return None;
    };
    source.allow_only(element, attributes, &[]);
    let dimensions = dimensions(source, element, attributes)?;
    Some(Shape { is_visual: node.tag_name().name() == "visual", solid, dimensions, at, turned })
}

/// Reads dimensions that must not be negative, in the order of the attributes.
fn dimensions<'d>(source: &mut Source<'d>, solid: Node<'_, 'd>, attributes: &[&str]) -> Option<Vec<Decimal>> {
    let mut dimensions = Vec::new();
    for &attribute in attributes {
        source.text(solid, attribute)?;
        let numbers = match attribute {
            "size" => source.numbers::<3>(solid, attribute).map(Vec::from),
            _ => source.optional_number(solid, attribute).map(|number| vec![number]),
        }?;
        if numbers.iter().any(|number| number.value() < 0.0) {
            source.error(solid, messages::negative(attribute));
        }
        dimensions.extend(numbers);
    }
    Some(dimensions)
}
