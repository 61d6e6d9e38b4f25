//! Diagnostics for statements about bodies.

pub(super) mod mobilizers;

use super::object::Object;
use crate::syntax::ast::ConnectorKind;
use lagrange_expr::solids::SOLIDS;

pub(super) const GRAVITY_TWICE: &str = "`gravity` is declared twice";
pub(super) const GRAVITY_TWICE_HELP: &str = "remove one of them, or write their sum";
pub(super) const OTHER_NAME_HELP: &str = "choose another name";
pub(super) const FIRST_DECLARED: &str = "first declared here";
pub(super) const ORDER_HELP: &str = "a name is known only after its declaration";
pub(super) const DECLARED_HERE: &str = "it is declared here";

pub(super) fn declared_twice(name: &str) -> String {
    format!("the name `{name}` is declared twice")
}

pub(super) fn used_too_early(name: &str) -> String {
    format!("`{name}` is used before it is declared")
}

pub(super) fn write(usage: &str) -> String {
    format!("write `{usage}`")
}

pub(super) fn did_you_mean(name: &str) -> String {
    format!("did you mean `{name}`?")
}

// Bodies.

pub(super) fn no_mass(name: &str) -> String {
    format!("body `{name}` has no mass")
}

pub(super) const NO_MASS_HELP: &str = "give it one, `mass: m;`, or build it from parts, `compound { … }`";

pub(super) fn no_inertia(name: &str) -> String {
    format!("body `{name}` rotates, but has no moment of inertia")
}

pub(super) const NO_INERTIA_HELP: &str = "give it one about the centre of mass, `inertia: slender_rod(m, l);`, or a shape that has one, `shape: slender_rod(l);`";

pub(super) fn one_place(name: &str, are_both: bool) -> String {
    match are_both {
        true => format!("body `{name}` has both a `center` and an `origin`"),
        false => format!("body `{name}` has no position"),
    }
}

pub(super) const ONE_PLACE_HELP: &str =
    "write its centre of mass, `center: (x, y);`, or the origin of its own axes, `origin: (x, y);`";

pub(super) fn center_of(name: &str) -> String {
    format!("the centre of `{name}`")
}

pub(super) fn origin_of(name: &str) -> String {
    format!("the origin of `{name}`")
}

pub(super) fn centroid_of(name: &str) -> String {
    format!("the centroid of `{name}`")
}

pub(super) fn through_of(name: &str) -> String {
    format!("the point on `{name}`")
}

pub(super) const PLACE_OF_PART: &str = "the position of a part";
pub(super) const ANGLE_OF_PART: &str = "the angle of a part";

pub(super) fn mass_of(name: &str) -> String {
    format!("the mass of `{name}`")
}

pub(super) fn inertia_of(name: &str) -> String {
    format!("the moment of inertia of `{name}`")
}

pub(super) fn dimension_of(solid: &str) -> String {
    format!("a dimension of `{solid}`")
}

pub(super) fn place_of(name: &str) -> String {
    format!("the position of `{name}`")
}

pub(super) fn unknown_inertia(name: &str) -> String {
    format!("the moment of inertia of `{name}` about this centroid is unknown")
}

pub(super) const UNKNOWN_INERTIA_HELP: &str = "the shape has one about its own centre of mass; specify the one about the centroid, `inertia: j;`, or remove `centroid`";

pub(super) fn beside_lagrangian(what: &str) -> String {
    format!("{what} cannot be combined with `lagrangian`")
}

pub(super) const BESIDE_LAGRANGIAN_HELP: &str =
    "bodies, springs and dampers add to T and V: write `kinetic` and `potential` instead of the `lagrangian`";

pub(super) fn unknown_solid(name: &str) -> String {
    format!("unknown solid `{name}`")
}

pub(super) fn solids_are() -> String {
    let names = SOLIDS.iter().map(|solid| format!("`{}`", solid.name)).collect::<Vec<_>>();
    format!("shapes are {}", names.join(", "))
}

pub(super) fn wrong_dimensions(name: &str, count: usize) -> String {
    let plural = if count == 1 { "" } else { "s" };
    format!("`{name}` does not take {count} dimension{plural}")
}

pub(super) fn shape_usage(usage: &str) -> String {
    format!("write `shape: {usage}`")
}

pub(super) fn beside_compound(label: &str) -> String {
    format!("`{label}` cannot be combined with `compound`")
}

pub(super) const BESIDE_COMPOUND_HELP: &str =
    "mass, centre of mass, inertia and shape of a compound follow from its parts: remove one of the two";
pub(super) const VISUAL_MASS: &str = "a visual has no mass";
pub(super) const VISUAL_MASS_HELP: &str = "remove this, or write `compound { … }` for parts with a mass";
pub(super) const PART_WITHOUT_MASS: &str = "a part of a compound needs a mass";
pub(super) const PART_WITHOUT_MASS_HELP: &str =
    "write it after the shape: `disk(r), mass: m;`; for a hole, the mass that is removed";

pub(super) fn never_turns(name: &str) -> String {
    format!("`{name}` never rotates, so it has no instantaneous centre")
}

pub(super) const NEVER_TURNS_HELP: &str =
    "all of its points have the same velocity; give the body an `angle` if it can rotate";

pub(super) fn does_not_turn(name: &str, purpose: &str) -> String {
    format!("{name} never rotates, {purpose}")
}

pub(super) const THIS: &str = "this";
pub(super) const TURNED_BY_TORQUE: &str = "so a torque has no effect on it";
pub(super) const TURNED_BY_SPRING: &str =
    "and neither does the other end, so a torsion spring or damper between them has no effect";
pub(super) const TURNED_BY_ROLLING: &str = "so it cannot roll";
pub(super) const DOES_NOT_TURN_HELP: &str = "a body rotates if its `angle` is not constant";

pub(super) const NO_ANGLE: &str = "this is a point, but an angle is needed";
pub(super) const NO_ANGLE_HELP: &str =
    "write the name of a body for its angle, `ground`, or an expression of angles";

pub(super) const ANGLE_OF_LINK: &str = "a body in space has no single angle";
pub(super) const ANGLE_OF_LINK_HELP: &str = "springs and dampers of joints act on coordinates: write `potential = spring_energy(k, q);`, or `damping: c;` in the joint";
pub(super) const NO_AXES: &str = "this is not a body or frame in space";
pub(super) const NO_AXES_HELP: &str =
    "write `v in name`, with the name of a body or frame of a scene in space";

pub(super) fn only_in_the_plane(statement: &str) -> String {
    format!("`{statement}` belongs to scenes in the plane, but this one is in space")
}

pub(super) const NOT_IN_SPACE_HELP: &str =
    "scenes in space have bodies, frames, joints with coordinates, pins, springs, dampers and loads";

pub(super) const TURNED_IN_THE_PLANE: &str = "a part of a compound in the plane is turned by one angle";
pub(super) const TURNED_IN_THE_PLANE_HELP: &str = "write `angle: e`";

pub(super) fn angle_beside_joint(name: &str) -> String {
    format!("the joint that places `{name}` determines its angle")
}

pub(super) const ANGLE_BESIDE_JOINT_HELP: &str =
    "remove it, or specify the rotation in the joint, `turned: e;`";
pub(super) const SEQUENCE_IN_THE_PLANE: &str = "in the plane there is no sequence of rotations";
pub(super) const SEQUENCE_IN_THE_PLANE_HELP: &str = "write `angle: e;`";

pub(super) const IDLE_GRAVITY: &str = "`gravity` acts on bodies, but none is declared";
pub(super) const IDLE_GRAVITY_HELP: &str =
    "declare one, `body name { … }`, or write its potential energy, `potential = m * g * y;`";

pub(super) const GROUND_IS_NO_POINT: &str = "the ground is not a point";
pub(super) const GROUND_IS_NO_POINT_HELP: &str = "write a point of the ground, such as `(0, 0)`";

// Names of objects in expressions.

pub(super) fn no_value(name: &str, what: &str) -> String {
    format!("`{name}` is {what} and has no value")
}

pub(super) fn value_help(name: &str, object: &Object) -> String {
    match object {
        Object::Body(_) => format!(
            "points of it are `{name}.center` and `{name}.point(X, Y)`; other parts are `{name}.angle`, `{name}.mass` and `{name}.inertia`"
        ),
        Object::Link { is_frame: false, .. } => {
            format!(
                "points of it are `{name}.center` and `{name}.point(X, Y, Z)`; another part is `{name}.mass`"
            )
        }
        Object::Link { .. } => format!("points of it are `{name}.origin` and `{name}.point(X, Y, Z)`"),
        Object::Line(_) => {
            format!(
                "parts of it are `{name}.distance(P)`, `{name}.along(P)`, `{name}.tangent` and `{name}.normal`"
            )
        }
        Object::Connector(_) => format!("parts of it are `{name}.length` and `{name}.force`"),
        Object::Joint(joint) => {
            let parts = joint.parts.iter().map(|(part, _)| format!(", `{name}.{part}`"));
            format!("its force is `{name}.force`{}", parts.collect::<String>())
        }
    }
}

pub(super) fn no_part(name: &str, what: &str, part: &str) -> String {
    format!("`{name}` is {what} and has no `{part}`")
}

/// Message for the rate of a point that is made of numbers and parameters.
pub(super) fn point_at_rest(function: &str) -> String {
    format!("this point does not move, so its {function} is zero")
}

pub(super) const POINT_AT_REST_HELP: &str =
    "remove it, or write a point of a body, `name.point(X, Y)`, or one made of coordinates";

pub(super) fn wrong_arguments(function: &str, count: usize) -> String {
    let plural = if count == 1 { "" } else { "s" };
    format!("`{function}` does not take {count} argument{plural}")
}

/// Arguments in brackets may be left out.
pub(super) fn usage(function: &str, arguments: &[&str]) -> String {
    let plain = |name: &&str| name.trim_matches(['[', ']']).to_owned();
    let all = arguments.iter().map(plain).collect::<Vec<_>>().join(", ");
    let needed = arguments.iter().filter(|name| !name.starts_with('[')).map(plain).collect::<Vec<_>>();
    let needed = needed.join(", ");
    match function {
        "distance" | "along" => format!("write `floor.{function}({all})`"),
        _ if all == needed => format!("write `body.{function}({all})`"),
        _ => format!("write `body.{function}({needed})` or `body.{function}({all})`"),
    }
}

pub(super) fn not_an_object(function: &str, what: &str, name: Option<&str>) -> String {
    match name {
        Some(name) => format!("`{function}` needs {what}, but `{name}` is not one"),
        None => format!("`{function}` needs {what}"),
    }
}

pub(super) fn object_help(function: &str, what: &str, nearest: Option<&str>) -> String {
    match nearest {
        Some(nearest) => did_you_mean(nearest),
        None => format!("declare {what} and write its name before the point: `name.{function}(…)`"),
    }
}

pub(super) fn other_object(name: &str, wanted: &str, found: Option<&str>) -> String {
    match found {
        Some(found) => format!("`{name}` is {found}, not {wanted}"),
        None => format!("unknown {} `{name}`", wanted.trim_start_matches("a ")),
    }
}

pub(super) fn declare_object(wanted: &str) -> String {
    match wanted {
        "a line" => "declare it first: `line floor { through: (0, 0); angle: 0; }`".to_owned(),
        _ => {
            "declare it first: `body name { mass: m; center: (x, y); angle: a; shape: disk(r); }`".to_owned()
        }
    }
}

// Connectors and joints.

pub(super) fn missing_label(statement: &str, label: &str) -> String {
    format!("this `{statement}` has no `{label}`")
}

pub(super) fn connector_help(kind: ConnectorKind) -> &'static str {
    match kind {
        ConnectorKind::Spring => "write `spring name { from: P; to: Q; stiffness: k; rest: l; }`",
        ConnectorKind::Damper => "write `damper name { from: P; to: Q; damping: c; }`",
        ConnectorKind::TorsionSpring => {
            "write `torsion_spring name { from: ground; to: body; stiffness: k; rest: angle; }`"
        }
        ConnectorKind::TorsionDamper => "write `torsion_damper name { from: ground; to: body; damping: c; }`",
    }
}

pub(super) const PINNED_POINT: &str = "a pinned point";
pub(super) const SLIDING_POINT: &str = "a sliding point";
pub(super) const END: &str = "an end of a spring or damper";

pub(super) fn pinned_to_itself(name: &str) -> String {
    format!("`{name}` is pinned to itself")
}

pub(super) fn slides_on_itself(name: &str) -> String {
    format!("`{name}` cannot slide on a line that it carries")
}

pub(super) const PINNED_TO_ITSELF_HELP: &str = "a joint connects two bodies, or a body and the ground: the distance of two points of one body never changes";

pub(super) fn no_radius(name: &str) -> String {
    format!("the radius on which `{name}` rolls is unknown")
}

pub(super) fn no_radius_help(name: &str) -> String {
    format!("give `{name}` a round shape, `shape: disk(r);`, or write `roll {name} on line, radius: r;`")
}
