//! Diagnostics for contacts and the surfaces on which they are.

use lagrange_expr::diagnostics::messages;

messages! {
    pub(in crate::bodies):

    label(label) = "`{label}` of contact";
    length_of_direction(name) = "length of the direction of `{name}` in contact";
    radius_of_surface(name) = "radius of `{name}` in contact";
    RADIUS_OF_BODY = "radius of the body in contact";
    LENGTH_OF_AXIS = "length of `axis` of contact";
    TOUCHING_POINT = "a touching point";
    place_of(name) = "the position of `{name}`";
    radius_of(name) = "the radius of `{name}`";
    direction_of(name) = "the direction of `{name}`";

    surface_without_radius(kind, name) = "the {kind} `{name}` has no radius";
    radius_not_positive(name) = "the radius of `{name}` is not positive";
    SURFACE_RADIUS_HELP = "write `radius: r;` with a positive length";
    zero_direction(label, name) = "the {label} of `{name}` has the length zero";
    ZERO_DIRECTION_HELP = "write a vector that is not zero, such as `(0, 0, 1)`; its length does not matter";

    terrain_without_height(name) = "the terrain `{name}` has no height";
    height_in_the_plane(name) = "in the plane, the height of `{name}` depends on one coordinate";
    HEIGHT_IN_THE_PLANE_HELP = "write `height(x): e;`";
    height_in_space(name) = "in space, the height of `{name}` depends on two coordinates";
    height_not_scalar(name) = "the height of `{name}` must be a scalar, but this is a vector";
    HEIGHT_NOT_SCALAR_HELP = "write the component across the ground alone";
    HEIGHT_IN_SPACE_HELP = "write `height(x, y): e;`, even if y is not in e";

    no_body_touches(contact) = "the contact `{contact}` needs a body or a point of one";
    NO_BODY_TOUCHES_HELP =
        "write a round body, `wheel`, a point, `foot.point(X, Y)`, in space `foot.point(X, Y, Z)`, or corners, `case.corners`";
    no_outline(contact, name) =
        "the contact `{contact}` is of `{name}`, whose shape has neither a radius nor corners";
    NO_OUTLINE_HELP =
        "write a point of it, `name.point(X, Y)`, or the radius around its centre, `radius: r;`";
    NO_OUTLINE_IN_SPACE_HELP =
        "write a point of it, `name.point(X, Y, Z)`, the radius around its centre, `radius: r;`, or on planes a circle such as the end of a cylinder, `rim: r; axis: (0, 0, 1);`";
    corners_of_another(contact, name) =
        "the contact `{contact}` uses all corners of `{name}`, which must be declared in the same place";
    loop_over_corners(count) = "write a loop: `for k in 0..{count} {{ contact foot[k] = case.corner(k) on ground {{ … }} }}`";
    edges_on_round(contact, name, surface) =
        "the contact `{contact}` is of `{name}` on the round body `{surface}`, which it may touch between its corners";
    EDGES_ON_ROUND_HELP =
        "write `name.corners` if only its corners can touch, or give the round body the shape of a ball, a rod or a cuboid";
    ground_touches(contact) = "in the contact `{contact}` the ground cannot touch anything";
    GROUND_TOUCHES_HELP = "write the body that moves first: `contact name = wheel on ground;`";
    no_surface(contact, name, found) = "the contact `{contact}` needs a surface, but `{name}` is {found}";
    not_round(contact, name) = "the contact `{contact}` needs a surface, but `{name}` is not round";
    FACE_HELP =
        "declare a `plane` that is `on:` the body, for points and corners on its face, or name a whole cuboid, rod or ball: `contact name = case on crate;`";
    unknown_surface(contact, name) = "the contact `{contact}` is on the unknown surface `{name}`";
    NO_SURFACE_HELP =
        "write `ground`, the name of a `line`, `plane` or `terrain`, of a `circle`, `sphere` or `cylinder`, or of a round body";
    inside_of_open(contact, name) = "the contact `{contact}` is inside of `{name}`, which encloses nothing";
    INSIDE_OF_OPEN_HELP = "write `on` for what touches a line, a plane, a terrain or the ground";
    rim_in_the_plane(contact) = "the contact `{contact}` has a rim, which belongs to scenes in space";
    RIM_IN_THE_PLANE_HELP = "in the plane, write the radius around the point, `radius: r;`";
    rim_on_round(contact, name, found) = "the rim of the contact `{contact}` can touch planes only, but `{name}` is {found}";
    RIM_ON_ROUND_HELP = "write `ground` or the name of a `plane`, or declare balls with `radius: r;` at points of the rim";
    rim_of(name) = "the radius of the rim of `{name}`";
    rim_not_positive(contact) = "the radius of the rim of the contact `{contact}` is not positive";
    RIM_HELP = "it is the radius of the circle that touches: write a positive length";
    faces_in_the_plane(contact) = "the contact `{contact}` is of two bodies in the plane that are not round";
    FACES_IN_THE_PLANE_HELP = "in the plane, write corners of one of them on a `line` that is `on:` the other one";
    faces_with_rim(contact) = "the contact `{contact}` of faces and edges has a rim";
    FACES_WITH_RIM_HELP = "omit the rim: cuboids and rods touch with all of their faces and edges";
    compliant_faces(contact) = "the contact `{contact}` of faces and edges has a stiffness";
    COMPLIANT_FACES_HELP =
        "omit it: contact points of faces jump, and so would their forces; simulate with the method `Stepped`";
    faces_that_turn(contact) = "the contact `{contact}` of faces and edges has rolling or spinning friction";
    FACES_THAT_TURN_HELP =
        "omit it: such a contact has several points, whose sliding friction resists rolling and spinning";
    inside_of_block(contact) = "the contact `{contact}` is inside of a body that has no inside";
    INSIDE_OF_BLOCK_HELP = "write `on`, or planes for the walls of a container";
    touches_itself(contact, name) = "in the contact `{contact}`, `{name}` touches itself";
    TOUCHES_ITSELF_HELP = "write a surface of the ground or of another body: the gap within one body never changes";

    negative_radius(contact) = "the radius of the contact `{contact}` is negative";
    NEGATIVE_RADIUS_HELP = "it is the distance of the surface of the body from the point; 0 for the point alone";
    negative_coefficient(contact) = "a coefficient of friction of the contact `{contact}` is negative";
    NEGATIVE_COEFFICIENT_HELP = "it is the ratio of the largest friction force to the normal force, so at least 0";
    negative_turning(kind, contact) = "the coefficient of {kind} friction of the contact `{contact}` is negative";
    NEGATIVE_TURNING_HELP =
        "it is a length, the largest moment of this friction divided by the normal force, so at least 0";
    spins_in_the_plane(contact) = "the contact `{contact}` in the plane has spinning friction";
    SPINS_IN_THE_PLANE_HELP = "nothing in the plane turns about a normal: write `rolling: a;`, or omit it";
    static_below_kinetic(contact) = "the static coefficient of the contact `{contact}` is below the kinetic one";
    STATIC_BELOW_KINETIC_HELP =
        "a body that begins to slip would stick again at once: make the static coefficient at least as large";
    restitution_out_of_range(contact) =
        "the coefficient of restitution of the contact `{contact}` is not between 0 and 1";
    RESTITUTION_HELP =
        "it is the ratio of the speeds after and before: 0 if bodies stay together, 1 if no energy is lost";

    without_stiffness(name, label) = "the contact `{name}` has a `{label}`, but no stiffness";
    ADD_STIFFNESS_HELP =
        "add `stiffness: k;` in N/m for a compliant contact; a rigid one has coefficients of friction and of restitution only";
    compliant_restitution(name) = "the contact `{name}` has a stiffness and a restitution";
    COMPLIANT_RESTITUTION_HELP =
        "write `dissipation: d;` in s/m instead, about 3 (1 - e) / (2 v) for the restitution e at the speed v";
    compliant_coefficients(name) = "the contact `{name}` has a stiffness and two coefficients of friction";
    COMPLIANT_COEFFICIENTS_HELP =
        "write `friction: mu; stiction: v;` instead: friction that creeps never sticks";
    without_stiction(name) = "the contact `{name}` has a stiffness and friction, but no stiction speed";
    ADD_STICTION_HELP =
        "add `stiction: v;` in m/s, the speed at which what would stick may creep, such as `stiction: 0.001;`";
    without_friction(name) = "the contact `{name}` has a stiction speed, but no friction";
    WITHOUT_FRICTION_HELP = "add `friction: mu;`, or remove the stiction speed";
    without_stiction_rate(name) =
        "the contact `{name}` has a stiffness and a friction against turning, but no angular stiction speed";
    ADD_STICTION_RATE_HELP =
        "add `stiction_rate: w;` in rad/s, at which what would not turn may creep, such as `stiction_rate: 0.01;`";
    without_turning(name) =
        "the contact `{name}` has an angular stiction speed, but neither rolling nor spinning friction";
    WITHOUT_TURNING_HELP = "add `rolling: a;` or `spinning: a;` in m, or remove the angular stiction speed";
    second_law(name) = "the contact `{name}` has a stiffness and a penetration";
    SECOND_LAW_HELP = "write `stiffness: k;`, or `penetration: d; load: f;` for the stiffness f/d";
    half_a_law(name, label, other) = "the contact `{name}` has a `{label}`, but no `{other}`";
    HALF_A_LAW_HELP = "write both, `penetration: d; load: f;`, for the stiffness f/d, or `stiffness: k;`";
    not_positive(label, name) = "the {label} of the contact `{name}` is not positive";
    PENETRATION_HELP = "a compliant contact sinks by this length, more than 0, under its load";
    LOAD_HELP = "it is the normal force, more than 0, at the penetration: about the weight on the contact";
    SECOND_CONTACTS = "the way of contacts is declared twice";
    FIRST_CONTACTS = "the first one is here";
    SECOND_CONTACTS_HELP = "keep one of the lines: it holds for all contacts";

    stiffness_of(name) = "the stiffness of the contact `{name}`";
    stiffness_not_positive(contact) = "the stiffness of the contact `{contact}` is not positive";
    STIFFNESS_HELP = "it is the normal force for each metre of penetration: the weight divided by the penetration at rest";
    negative_dissipation(contact) = "the dissipation of the contact `{contact}` is negative";
    DISSIPATION_HELP =
        "it is d in the normal force k δ (1 + d δ̇) at the depth δ: 0 if no energy is lost";
    stiction_not_positive(contact) = "the stiction speed of the contact `{contact}` is not positive";
    STICTION_HELP = "it is v in the friction force μ N s / sqrt(s^2 + v^2) at the slip velocity s";
    stiction_rate_not_positive(contact) = "the angular stiction speed of the contact `{contact}` is not positive";
    STICTION_RATE_HELP =
        "it is w in the moment a N ω / sqrt(ω^2 + w^2) at the angular velocity ω, in rad/s";
}
