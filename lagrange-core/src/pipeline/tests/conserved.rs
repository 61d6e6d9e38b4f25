//! Conserved quantities found by `emit { conserved }`.

use super::derived;

/// Returns the names of the outputs added to a declaration.
fn conserved(text: &str) -> Vec<String> {
    let outputs = derived(&format!("{text} emit {{ conserved }}")).model.outputs;
    let names = outputs.iter().filter_map(|output| output.name.strip_prefix("conserved_"));
    names.map(str::to_owned).collect()
}

fn of_three(statements: &str) -> Vec<String> {
    conserved(&format!("coord x, y, z; kinetic = 1/2 * (dot(x)^2 + dot(y)^2 + dot(z)^2); {statements}"))
}

#[test]
fn translations_and_rotations_of_free_points_are_found() {
    let rotations = ["angular_momentum", "angular_momentum_2", "angular_momentum_3"];
    assert_eq!(of_three(""), [&["energy", "x", "y", "z"][..], &rotations].concat());
    assert_eq!(of_three("potential = -1 / sqrt(x^2 + y^2 + z^2);"), [&["energy"][..], &rotations].concat());
    // Planes x − y = constant rotate about their normal.
    assert_eq!(of_three("potential = (x - y)^2;"), ["energy", "x_y", "z", "angular_momentum"]);
    assert_eq!(of_three("potential = cos(x - 2*y);"), ["energy", "x_y", "z", "angular_momentum"]);
    // About the point (3, 0), not the origin.
    assert_eq!(of_three("potential = (x - 3)^2 + y^2 + z;"), ["energy", "angular_momentum"]);
    // Time dependence only removes the energy.
    assert_eq!(of_three("potential = sin(t) * (x^2 + y^2) + z;"), ["angular_momentum"]);
}

#[test]
fn forces_and_dissipation_end_what_they_act_along() {
    assert_eq!(of_three("force x = 1; potential = y^2 + z^3;"), Vec::<String>::new());
    // Two constant forces that cancel each other.
    assert_eq!(of_three("force x = 1; potential = y^2 + z;"), ["x_z"]);
    // A force between two points acts on both.
    assert_eq!(of_three("force x = z - x; force z = x - z; potential = y;"), ["x_z"]);
    assert_eq!(of_three("dissipation = 1/2 * (dot(x) - dot(y))^2; potential = z;"), ["x_y"]);
    assert_eq!(of_three("input u; force x = u; potential = y + z^2;"), Vec::<String>::new());
}

#[test]
fn constraints_contacts_and_events_end_what_they_change() {
    assert_eq!(of_three("potential = y^2 + z; constraint rod = x^2 + y^2 - 1;"), ["energy"]);
    let rod = "potential = z; constraint rod = x^2 + y^2 - 1;";
    assert_eq!(of_three(rod), ["energy", "angular_momentum"]);
    assert_eq!(of_three("potential = z; constraint wire = y - x * sin(t);"), Vec::<String>::new());
    let impact = "potential = z; event touch = x - y, falling => impact(1/2);";
    assert_eq!(of_three(impact), ["x_y"]);
    assert_eq!(of_three("potential = y^2 + z; friction rub = dot(x) - dot(y), 3;"), Vec::<String>::new());
    let swap = "potential = z; event gate = x - 1, rising => { dot(y) = dot(x); dot(x) = dot(y); }";
    assert_eq!(of_three(swap), ["x_y"]);
    assert_eq!(
        of_three("potential = y^2 + z; event gate = x - 1, rising => { dot(x) = 0; }"),
        Vec::<String>::new()
    );
}

#[test]
fn formulas_in_pieces_need_a_proof() {
    // Flat at the sampled points, but not beyond.
    assert_eq!(of_three("potential = max(0, x - 100)^2 + y^2 + z;"), ["energy"]);
    assert_eq!(of_three("potential = if x < 50 { 0 } else { (x - 50)^3 } + y^2 + z;"), ["energy"]);
    assert_eq!(of_three("potential = max(0, x - y)^2 + z;"), ["energy", "x_y"]);
    let table = "table hill(s) = [(0, 1), (50, 1), (100, 3)], interpolation: natural, outside: error; potential = hill(x) + y^2 + z;";
    assert_eq!(of_three(table), ["energy"]);
}

#[test]
fn weak_and_steep_forces_count() {
    let weak = "potential = -6.67e-11 / sqrt(x^2 + y^2) + 1e-30 * z;";
    assert_eq!(of_three(weak), ["energy", "angular_momentum"]);
    assert_eq!(of_three("potential = x^2 + y + 1e-12 * z;"), ["energy"]);
    assert_eq!(of_three("potential = tanh(1000 * (x - 5)) + y^2 + z;"), ["energy"]);
    assert_eq!(of_three("potential = exp(-1000 * (x - y)) + z^2 + y;"), ["energy"]);
    assert_eq!(of_three("potential = exp(-1000 * (x - y)^2) + z;"), ["energy", "x_y"]);
}

#[test]
fn bodies_in_space_turn_about_what_leaves_them_unchanged() {
    let top = |inertia: &str| {
        conserved(&format!(
            "param m = 1, l = 1, g = 10, a = 2, c = 3; gravity = (0, 0, -g);
             body top {{ mass: m; inertia: {inertia}; centroid: (0, 0, l); }} ball tip = ground to top;"
        ))
    };
    assert_eq!(top("(a, a, c)"), ["energy", "angular_momentum", "angular_momentum_2"]);
    assert_eq!(top("(a, 3, c)"), ["energy", "angular_momentum"]);
}

#[test]
fn names_that_are_declared_are_left_alone() {
    assert_eq!(of_three("output conserved_y = 1; potential = x^2 + z;"), ["y", "energy", "y_2"]);
}

#[test]
fn descriptions_say_along_what() {
    let outputs =
        derived("coord x, y; kinetic = dot(x)^2 + dot(y)^2; potential = (x - 2*y)^2; emit { conserved }");
    let described = outputs.model.outputs.iter().filter_map(|output| output.description.as_deref());
    let expected = ["Conserved energy v·∂L/∂v − L", "Conserved momentum along 2 × `x` + `y`"];
    assert_eq!(described.collect::<Vec<_>>(), expected);
}
