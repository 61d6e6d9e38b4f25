//! Diagnostics for statements about bodies.

pub(super) mod contacts;
pub(super) mod mobilizers;

use super::object::Object;
use crate::syntax::ast::ConnectorKind;
use lagrange_expr::diagnostics::messages;
use lagrange_expr::solids::SOLIDS;

messages! {
    pub(super):

    GRAVITY_TWICE = "`gravity` is declared twice";
    GRAVITY_TWICE_HELP = "remove one of them, or write their sum";
    OTHER_NAME_HELP = "choose another name";
    FIRST_DECLARED = "first declared here";
    ORDER_HELP = "a name is known only after its declaration";
    DECLARED_HERE = "it is declared here";
    declared_twice(name) = "the name `{name}` is declared twice";
    used_too_early(name) = "`{name}` is used before it is declared";
    write(usage) = "write `{usage}`";
    did_you_mean(name) = "did you mean `{name}`?";
    no_mass(name) = "body `{name}` has no mass";
    NO_MASS_HELP = "give it one, `mass: m;`, or build it from parts, `compound { … }`";
    no_inertia(name) = "body `{name}` rotates, but has no moment of inertia";
    NO_INERTIA_HELP =
        "give it one about the centre of mass, `inertia: slender_rod(m, l);`, or a shape that has one, `shape: slender_rod(l);`";

    ONE_PLACE_HELP =
        "write its centre of mass, `center: (x, y);`, or the origin of its own axes, `origin: (x, y);`";
    center_of(name) = "the centre of `{name}`";
    origin_of(name) = "the origin of `{name}`";
    centroid_of(name) = "the centroid of `{name}`";
    through_of(name) = "the point on `{name}`";
    PLACE_OF_PART = "the position of a part";
    ANGLE_OF_PART = "the angle of a part";
    mass_of(name) = "the mass of `{name}`";
    inertia_of(name) = "the moment of inertia of `{name}`";
    dimension_of(solid) = "a dimension of `{solid}`";
    place_of(name) = "the position of `{name}`";
    unknown_inertia(name) = "the moment of inertia of `{name}` about this centroid is unknown";
    UNKNOWN_INERTIA_HELP =
        "the shape has one about its own centre of mass; specify the one about the centroid, `inertia: j;`, or remove `centroid`";
    beside_lagrangian(what) = "{what} cannot be combined with `lagrangian`";
    BESIDE_LAGRANGIAN_HELP =
        "bodies, springs and dampers add to T and V: write `kinetic` and `potential` instead of the `lagrangian`";
    unknown_solid(name) = "unknown solid `{name}`";
    shape_usage(usage) = "write `shape: {usage}`";
    beside_compound(label) = "`{label}` cannot be combined with `compound`";
    BESIDE_COMPOUND_HELP =
        "mass, centre of mass, inertia and shape of a compound follow from its parts: remove one of the two";
    VISUAL_MASS = "a visual has no mass";
    VISUAL_MASS_HELP = "remove this, or write `compound { … }` for parts with a mass";
    PART_WITHOUT_MASS = "a part of a compound needs a mass";
    PART_WITHOUT_MASS_HELP =
        "write it after the shape: `disk(r), mass: m;`; for a hole, the mass that is removed";
    never_turns(name) = "`{name}` never rotates, so it has no instantaneous centre";
    NEVER_TURNS_HELP = "all of its points have the same velocity; give the body an `angle` if it can rotate";
    does_not_turn(name, purpose) = "{name} never rotates, {purpose}";
    THIS = "this";
    TURNED_BY_TORQUE = "so a torque has no effect on it";
    TURNED_BY_SPRING =
        "and neither does the other end, so a torsion spring or damper between them has no effect";
    TURNED_BY_ROLLING = "so it cannot roll";
    DOES_NOT_TURN_HELP = "a body rotates if its `angle` is not constant";

    NO_ANGLE = "this is a point, but an angle is needed";
    NO_ANGLE_HELP = "write the name of a body for its angle, `ground`, or an expression of angles";

    ANGLE_OF_LINK = "a body in space has no single angle";
    ANGLE_OF_LINK_HELP =
        "springs and dampers of joints act on coordinates: write `potential = spring_energy(k, q);`, or `damping: c;` in the joint";
    NO_AXES = "this is not a body or frame in space";
    NO_AXES_HELP = "write `v in name`, with the name of a body or frame of a scene in space";
    only_in_the_plane(statement) = "`{statement}` belongs to scenes in the plane, but this one is in space";
    only_in_space(statement) = "`{statement}` belongs to scenes in space, but this one is in the plane";
    NOT_IN_THE_PLANE_HELP = "in the plane there are `line`, `circle` and `terrain`";
    NOT_IN_SPACE_HELP =
        "scenes in space have bodies, frames, joints with coordinates, pins, springs, dampers and loads";

    TURNED_IN_THE_PLANE = "a part of a compound in the plane is turned by one angle";
    TURNED_IN_THE_PLANE_HELP = "write `angle: e`";
    angle_beside_joint(name) = "the joint that places `{name}` determines its angle";
    ANGLE_BESIDE_JOINT_HELP = "remove it, or specify the rotation in the joint, `turned: e;`";
    SEQUENCE_IN_THE_PLANE = "in the plane there is no sequence of rotations";
    SEQUENCE_IN_THE_PLANE_HELP = "write `angle: e;`";

    IDLE_GRAVITY = "`gravity` acts on bodies, but none is declared";
    IDLE_GRAVITY_HELP =
        "declare one, `body name { … }`, or write its potential energy, `potential = m * g * y;`";

    GROUND_IS_NO_POINT = "the ground is not a point";
    GROUND_IS_NO_POINT_HELP = "write a point of the ground, such as `(0, 0)`";
    no_value(name, what) = "`{name}` is {what} and has no value";
    no_part(name, what, part) = "`{name}` is {what} and has no `{part}`";

    /// Message for the rate of a point that consists of numbers and parameters.
    point_at_rest(function) = "this point does not move, so its {function} is zero";
    POINT_AT_REST_HELP =
        "remove it, or write a point of a body, `name.point(X, Y)`, or one made of coordinates";
    missing_label(statement, label) = "this `{statement}` has no `{label}`";
    PINNED_POINT = "a pinned point";
    SLIDING_POINT = "a sliding point";
    END = "an end of a spring or damper";
    pinned_to_itself(name) = "`{name}` is pinned to itself";
    slides_on_itself(name) = "`{name}` cannot slide on a line that it carries";
    no_corners(name) = "`{name}` has no shape with corners";
    NO_CORNERS_HELP =
        "corners are those of `shape: cuboid(a, b, c)`, `rectangle`, `right_triangle` and `polygon`, and the ends of a `rod`";
    no_corner(name) = "`{name}` has no corner of this number";
    corners_are(name, last) = "write one from `{name}.corner(0)` to `{name}.corner({last})`";
    PINNED_TO_ITSELF_HELP =
        "a joint connects two bodies, or a body and the ground: the distance of two points of one body never changes";
    no_radius(name) = "the radius on which `{name}` rolls is unknown";
    no_radius_help(name) =
        "give `{name}` a round shape, `shape: disk(r);`, or write `roll {name} on line, radius: r;`";
}

// Bodies.

pub(super) fn one_place(name: &str, are_both: bool) -> String {
    match are_both {
        true => format!("body `{name}` has both a `center` and an `origin`"),
        false => format!("body `{name}` has no position"),
    }
}

pub(super) fn solids_are() -> String {
    let names = SOLIDS.iter().map(|solid| format!("`{}`", solid.name)).collect::<Vec<_>>();
    format!("shapes are {}", names.join(", "))
}

pub(super) fn wrong_dimensions(name: &str, count: usize) -> String {
    let plural = if count == 1 { "" } else { "s" };
    format!("`{name}` does not take {count} dimension{plural}")
}

// Names of objects in expressions.

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
        Object::Surface(_) => format!("write `contact touch = wheel on {name};` for what touches it"),
        Object::Contact(contact) => {
            let parts = contact.parts.iter().map(|(part, _)| format!("`{name}.{part}`"));
            format!("parts of it are {}", parts.collect::<Vec<_>>().join(", "))
        }
        Object::Joint(joint) => {
            let parts = joint.parts.iter().map(|(part, _)| format!(", `{name}.{part}`"));
            format!("its force is `{name}.force`{}", parts.collect::<String>())
        }
    }
}

pub(super) fn wrong_arguments(function: &str, count: usize) -> String {
    let plural = if count == 1 { "" } else { "s" };
    format!("`{function}` does not take {count} argument{plural}")
}

/// Returns the usage of a function; arguments in brackets are optional.
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
