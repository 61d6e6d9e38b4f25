//! Derived and emitted results for bodies and frames in space.

use super::{derived, expand, parse};
use crate::model::BodyMotion;
use crate::model::Product;
use crate::pipeline::{Derived, NumericSystem};
use lagrange_expr::expr::ExprId;
use lagrange_expr::expr::evaluate;
use lagrange_expr::symbol::Role;
use quote::quote;

/// An arm with all kinds of steps: rotations about axes other than z, an oblique one, a slide, a
/// screw and a branch.
const ARM: &str = "
    param m = 2, l = 0.7, e = 0.3;
    gravity = (0, 0, -9.81);
    body base { mass: 3; centroid: (0.1, 0, 0.2); inertia: (0.3, 0.25, 0.2, 0.01, 0.02, -0.03); }
    body arm { mass: m; inertia: (0.2, 0.3, 0.4); centroid: (l/2, 0.1, 0); }
    body slider { mass: 1; inertia: (0.1, 0.1, 0.1); }
    body nut { mass: 1; shape: solid_sphere(0.2); }
    frame wrist;
    body hand { mass: 0.5; inertia: (0.02, 0.02, 0.01); }
    revolute q1 = ground to base { at: (0, 0, 0.3); turned: (0.1, 0, 0); }
    revolute q2 = base to arm { at: (0.2, 0, 0.1); turned: (-pi/2, 0, 0.4); axis: (1, e, 0); }
    prismatic s = arm to slider { at: (l, 0, 0); axis: (0, -1, 0); }
    revolute q3 = slider to wrist { at: (0, 0.1, 0); axis: (1, 2, 2); }
    weld wrist to hand { at: (0, 0, 0.1); }
    screw u = base to nut { axis: (0, 1, 0); pitch: 0.5; }
    output w = angular_velocity(wrist);
    output p = wrist.origin;
    output v = velocity(wrist.origin);
    output a = acceleration(slider.center);
    output alpha = angular_acceleration(slider);
    output moment = angular_momentum(slider);
";

/// A body placed by the user with an angle and a time, and its carried bodies.
const CARRIED: &str = "
    coord x, a;
    body cart { mass: 2; inertia: (1, 2, 2.5); centroid: (0.2, 0, 0); center: (x, 0.1*t^2, sin(x)); angles: (a, x, t); sequence: zxz; }
    body rod { mass: 1; inertia: (0.1, 0.1, 0.01); centroid: (0, 0, 0.5); }
    revolute b = cart to rod { at: (0, 0, 1); axis: (1, 0, 0); }
    output w = angular_velocity(rod);
    output v = velocity(rod.origin);
    output v_dot = acceleration(rod.origin);
    output w_dot = angular_acceleration(rod);
";

/// A link with a frame.
const LINK: &str = "
    body arm { mass: 2; inertia: (1, 2, 2.5); centroid: (0, 0, 0.5); }
    frame wrist;
    revolute q1 = ground to arm { axis: (1, 0, 0); }
    weld arm to wrist { at: (0, 0, 1); turned: (0.1, 0.2, 0.3); }
";

const TIME: f64 = 0.4;
const Q: [f64; 5] = [0.3, -0.5, 0.7, 1.1, -0.4];
const V: [f64; 5] = [-0.2, 0.9, 0.4, 0.6, 0.8];

/// Values of a system in some state; accelerations satisfy its equations.
struct Values {
    derived: Derived,
    q: Vec<f64>,
    v: [f64; 5],
    accelerations: Vec<f64>,
}

impl Values {
    fn of(text: &str) -> Values {
        let derived = derived(text);
        let n = derived.model.coordinates.len();
        let accelerations = NumericSystem::new(&derived).acceleration(TIME, &Q[..n], &V[..n]);
        Values { derived, q: Q[..n].to_vec(), v: V, accelerations }
    }

    fn at(&self, roots: &[ExprId]) -> Vec<f64> {
        let graph = &self.derived.model.graph;
        let parameters = self.derived.model.parameters.iter().map(|parameter| parameter.default);
        let parameters =
            parameters.map(|default| evaluate(graph, &[default.expect("a number")], |_| f64::NAN)[0]);
        let parameters = parameters.collect::<Vec<_>>();
        evaluate(graph, roots, |role| match role {
            Role::Parameter(i) => parameters[i as usize],
            Role::Time => TIME,
            Role::Coordinate(i) => self.q[i as usize],
            Role::Velocity(i) => self.v[i as usize],
            Role::Acceleration(i) => self.accelerations[i as usize],
            _ => f64::NAN,
        })
    }

    fn output(&self, name: &str) -> Vec<f64> {
        let output = self.derived.model.outputs.iter().find(|output| output.name == name);
        self.at(&output.expect("an output").components)
    }

    fn frame(&self, name: &str) -> Vec<f64> {
        let frame = self.derived.model.scene.frames.iter().find(|frame| frame.name.text == name);
        self.at(&frame.expect("a frame").values)
    }

    fn motion(&self, name: &str) -> [f64; BodyMotion::VALUES[1]] {
        let motions = &self.derived.model.scene.motions;
        let motion = motions.iter().find(|motion| motion.body.text == name).expect("a body");
        self.at(&motion.values).try_into().expect("as many as there are")
    }

    /// Returns the six rows of a Jacobian.
    fn jacobian(&self, name: &str) -> Vec<Vec<f64>> {
        let twists = &self.derived.model.scene.twists;
        let index = twists.iter().position(|twist| twist.name.text == name).expect("a frame");
        let values = self.at(&self.derived.equations.frame_jacobians[index]);
        values.chunks(self.q.len()).map(<[f64]>::to_vec).collect()
    }

    fn bias(&self, name: &str) -> Vec<f64> {
        let twists = &self.derived.model.scene.twists;
        let index = twists.iter().position(|twist| twist.name.text == name).expect("a frame");
        self.at(&self.derived.equations.frame_biases[index])
    }

    /// Returns the values with a coordinate displaced.
    fn moved(&mut self, coordinate: usize, by: f64) -> &Values {
        let n = self.q.len();
        self.q = Q[..n].to_vec();
        self.q[coordinate] += by;
        self
    }
}

#[track_caller]
fn assert_near(found: &[f64], expected: &[f64], tolerance: f64) {
    assert_eq!(found.len(), expected.len());
    for (found, expected) in found.iter().zip(expected) {
        assert!((found - expected).abs() <= tolerance * expected.abs().max(1.0), "{found} is not {expected}");
    }
}

fn times_velocities(rows: &[Vec<f64>]) -> Vec<f64> {
    rows.iter().map(|row| row.iter().zip(V).map(|(entry, v)| entry * v).sum()).collect()
}

fn column(rotation: &[f64], column: usize) -> [f64; 3] {
    [0, 1, 2].map(|row| rotation[3 * row + column])
}

#[test]
fn rotations_are_orthonormal_and_right_handed() {
    let values = Values::of(&format!("{ARM} emit {{ frames }}"));
    for name in ["base", "arm", "slider", "nut", "wrist", "hand"] {
        let frame = values.frame(name);
        let [x, y, z] = [0, 1, 2].map(|axis| column(&frame, axis));
        for (a, b, product) in [(x, x, 1.0), (y, y, 1.0), (z, z, 1.0), (x, y, 0.0), (y, z, 0.0), (z, x, 0.0)]
        {
            assert_near(&[(0..3).map(|i| a[i] * b[i]).sum::<f64>()], &[product], 1e-14);
        }
        let crossed = [x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]];
        assert_near(&crossed, &z, 1e-14);
    }
    assert_near(&values.frame("wrist")[9..], &values.output("p"), 1e-14);
}

#[test]
fn jacobians_by_velocities_are_what_outputs_say() {
    let values = Values::of(&format!("{ARM} emit {{ frame_jacobians }}"));
    let found = times_velocities(&values.jacobian("wrist"));
    assert_near(&found[..3], &values.output("w"), 1e-13);
    assert_near(&found[3..], &values.output("v"), 1e-13);
}

/// Columns of the lower rows are slopes of the origin; columns of the upper rows are the axial
/// vectors of ∂R/∂q Rᵀ.
#[test]
fn jacobians_are_slopes_of_frames() {
    const STEP: f64 = 1e-5;
    let mut values = Values::of(&format!("{ARM} emit {{ frames, frame_jacobians }}"));
    for name in ["base", "arm", "slider", "nut", "wrist", "hand"] {
        let (jacobian, frame) = (values.jacobian(name), values.frame(name));
        for coordinate in 0..values.q.len() {
            let [ahead, behind] = [STEP, -STEP].map(|by| values.moved(coordinate, by).frame(name));
            values.moved(coordinate, 0.0);
            let slope = ahead.iter().zip(&behind).map(|(a, b)| (a - b) / (2.0 * STEP)).collect::<Vec<_>>();
            let product =
                |i: usize, j: usize| (0..3).map(|k| slope[3 * i + k] * frame[3 * j + k]).sum::<f64>();
            let axial = [product(2, 1), product(0, 2), product(1, 0)];
            let found = jacobian.iter().map(|row| row[coordinate]).collect::<Vec<_>>();
            assert_near(&found, &[&axial, &slope[9..]].concat(), 1e-9);
        }
    }
}

#[test]
fn entries_of_joints_that_do_not_move_a_frame_are_exactly_zero() {
    let values = Values::of(&format!("{ARM} emit {{ frame_jacobians }}"));
    let graph = &values.derived.model.graph;
    let n = values.q.len();
    // Coordinates q1, q2, s, q3, u; slides rotate nothing, and wrist and slider are on separate
    // branches.
    let moved = [("base", [1, 0, 0, 0, 0]), ("arm", [1, 1, 0, 0, 0]), ("nut", [1, 0, 0, 0, 1])];
    for (name, moves) in moved {
        let twists = &values.derived.model.scene.twists;
        let index = twists.iter().position(|twist| twist.name.text == name).expect("a frame");
        let jacobian = &values.derived.equations.frame_jacobians[index];
        for (coordinate, moves) in moves.into_iter().enumerate() {
            let is_zero = (0..6).all(|row| graph.is_zero(jacobian[row * n + coordinate]));
            assert_eq!(is_zero, moves == 0, "{name}, coordinate {coordinate}");
        }
    }
    let slider = &values.derived.equations.frame_jacobians[2];
    assert!((0..3).all(|row| graph.is_zero(slider[row * n + 2])), "a slide turns nothing");
}

#[test]
fn motions_are_what_outputs_say() {
    let values = Values::of(&format!("{ARM} emit {{ motion, frames }}"));
    let motion = values.motion("slider");
    assert_near(&motion[31..34], &values.output("a"), 1e-12);
    assert_near(&motion[34..], &values.output("alpha"), 1e-12);
    assert_near(&motion[16..25], &values.frame("slider")[..9], 1e-14);
    let base = values.motion("base");
    let tensor = [0.3, 0.01, 0.02, 0.01, 0.25, -0.03, 0.02, -0.03, 0.2];
    assert_near(&base[..13], &[&[3.0][..], &tensor, &[0.1, 0.0, 0.2]].concat(), 1e-15);
    let frame = values.frame("base");
    let center = [0, 1, 2].map(|row| frame[9 + row] + 0.1 * frame[3 * row] + 0.2 * frame[3 * row + 2]);
    assert_near(&base[13..16], &center, 1e-14);
}

/// The sum of all bodies' kinetic energies is that of the system.
#[test]
fn motions_have_the_energy_of_the_system() {
    let values = Values::of(&format!("{ARM} emit {{ motion }}"));
    let energy = |name: &str| {
        let motion = values.motion(name);
        let (inertia, rotation, velocity, spin) =
            (&motion[1..10], &motion[16..25], &motion[25..28], &motion[28..31]);
        let own = [0, 1, 2].map(|axis| (0..3).map(|i| column(rotation, axis)[i] * spin[i]).sum::<f64>());
        let turning = (0..9).map(|i| own[i / 3] * inertia[i] * own[i % 3]).sum::<f64>();
        0.5 * (motion[0] * velocity.iter().map(|v| v * v).sum::<f64>() + turning)
    };
    let found = ["base", "arm", "slider", "nut", "hand"].map(energy).iter().sum::<f64>();
    let system = NumericSystem::new(&values.derived);
    let expected = system.product(Product::KineticEnergy, TIME, &Q, &V).expect("a kinetic energy");
    assert_near(&[found], &expected, 1e-13);
}

#[test]
fn what_time_alone_moves_is_left_out_of_jacobians() {
    let values = Values::of(&format!("{CARRIED} emit {{ frame_jacobians }}"));
    let at_rest = Values { v: [0.0; 5], ..Values::of(CARRIED) };
    let found = times_velocities(&values.jacobian("rod"));
    for (output, rows) in [("w", &found[..3]), ("v", &found[3..])] {
        let rest = at_rest.output(output);
        assert!(rest.iter().any(|component| component.abs() > 0.01), "time moves it, too");
        let expected =
            values.output(output).iter().zip(rest).map(|(all, rest)| all - rest).collect::<Vec<_>>();
        assert_near(rows, &expected, 1e-13);
    }
}

/// The bias contains the part due to time alone. The accelerations of outputs come from the
/// recursion in body-fixed axes.
#[test]
fn jacobians_times_accelerations_and_biases_are_accelerations() {
    for (text, name, outputs) in [(ARM, "slider", ["alpha", "a"]), (CARRIED, "rod", ["w_dot", "v_dot"])] {
        let values = Values::of(&format!("{text} emit {{ frame_jacobians }}"));
        let product =
            |row: &Vec<f64>| row.iter().zip(&values.accelerations).map(|(entry, a)| entry * a).sum::<f64>();
        let (jacobian, bias) = (values.jacobian(name), values.bias(name));
        let sums = jacobian.iter().zip(bias).map(|(row, bias)| product(row) + bias).collect::<Vec<_>>();
        assert_near(&sums, &outputs.map(|output| values.output(output)).concat(), 1e-12);
    }
}

#[test]
fn requested_products_leave_the_equations_unchanged() {
    for text in [ARM, CARRIED] {
        let [silent, asked] = ["", "emit { motion, frames, frame_jacobians }"].map(|emit| {
            let values = Values::of(&format!("{text} {emit}"));
            (values.derived.equations.costs, values.accelerations)
        });
        assert_eq!(silent, asked);
    }
}

#[test]
fn statements_hold_what_products_need_and_nothing_else() {
    let statements =
        |emit: &str| parse(&format!("{ARM} {emit}")).expect("a correct declaration").statements();
    let plain = ARM.split("output").next().expect("text before");
    let bare = |emit: &str| parse(&format!("{plain} {emit}")).expect("a correct declaration").statements();
    assert_eq!(statements("emit { frames, no frames }"), statements(""));
    assert!(!bare("emit { statements }").contains("let wrist_x"));
    assert!(bare("emit { frames, statements }").contains("let wrist_x"));
    // Jacobians need the positions of origins, and no axes of the last frame.
    let jacobians = bare("emit { frame_jacobians }");
    assert!(jacobians.contains("let hand_origin") && !jacobians.contains("let wrist_x"), "{jacobians}");
}

fn items(text: &str) -> String {
    expand(text.parse().expect("tokens"), &quote!(::lagrange)).to_string()
}

#[test]
fn only_requested_methods_are_emitted() {
    let methods =
        ["fn arm_motion", "fn arm_frame", "fn wrist_frame", "fn arm_jacobian", "fn wrist_bias_acceleration"];
    let with = |emit: &str| {
        let text = items(&format!("struct Arm; {LINK} {emit}"));
        assert!(!text.contains("wrist_motion"), "a frame has no mass");
        methods.map(|method| text.contains(method))
    };
    assert_eq!(with(""), [false; 5]);
    assert_eq!(with("emit { motion }"), [true, false, false, false, false]);
    assert_eq!(with("emit { frames }"), [false, true, true, false, false]);
    assert_eq!(with("emit { frame_jacobians, motion, no motion }"), [false, false, false, true, true]);
    let broken = "output o = unknown; emit { motion, frames, frame_jacobians }";
    assert_eq!(with(broken), [true; 5], "the skeleton has them, too");
    let skeleton = items(&format!("struct Arm; {LINK} {broken}"));
    assert!(skeleton.contains("SpatialMotion") && skeleton.contains("[[f64 ; 1] ; 6]"));
}

/// Returns the first line of the single error.
#[track_caller]
fn mistake(text: &str) -> String {
    let report = parse(text).err().unwrap_or_else(|| panic!("no mistake in {text}"));
    assert_eq!(report.diagnostics().len(), 1, "{report}");
    report.diagnostics()[0].message.clone()
}

#[test]
fn products_of_scenes_in_space_are_refused_in_the_plane() {
    let rod = "coord x, y, a; body rod { mass: 2; shape: slender_rod(3); center: (x, y); angle: a; }";
    for product in ["frames", "frame_jacobians"] {
        let message = mistake(&format!("{rod} emit {{ {product} }}"));
        assert!(message.starts_with(&format!("`{product}` is for bodies and frames in space")), "{message}");
        let message = mistake(&format!("coord x; kinetic = dot(x)^2; emit {{ {product} }}"));
        assert_eq!(message, format!("`{product}` is not defined for a system without rigid bodies"));
    }
}

#[test]
fn names_of_methods_are_taken() {
    for (product, method) in [
        ("frames", "wrist_frame"),
        ("frame_jacobians", "arm_jacobian"),
        ("frame_jacobians", "arm_bias_acceleration"),
        ("motion", "arm_motion"),
    ] {
        let free = parse(&format!("{LINK} output {method} = q1;"));
        assert!(free.is_ok(), "{free:?}");
        let message = mistake(&format!("{LINK} output {method} = q1; emit {{ {product} }}"));
        assert!(message.starts_with(&format!("an output cannot be called `{method}`")), "{message}");
    }
    assert!(parse(&format!("{LINK} output wrist_motion = q1; emit {{ motion }}")).is_ok());
    let parameter = LINK.replace("wrist", "parameter") + "emit { frame_jacobians }";
    assert!(parse(&parameter).is_ok());
    let derivative = mistake(&(parameter + "emit { jacobian }"));
    assert!(derivative.contains("`parameter_jacobian`"), "{derivative}");
}

#[test]
fn frames_must_not_depend_on_velocities() {
    let point = "coord x; body p { mass: 1; inertia: (0, 0, 0); center: (x, 0, 0); angles: (dot(x), 0, 0); sequence: zxz; }";
    assert!(parse(point).is_ok());
    for products in ["frames", "frame_jacobians", "frames, frame_jacobians"] {
        let message = mistake(&format!("{point} emit {{ {products} }}"));
        assert_eq!(message, "the frame of `p` must not depend on velocities");
    }
}

#[test]
fn frames_of_reduced_types_are_those_where_coordinates_are_frozen() {
    let products = "emit { motion, frames, frame_jacobians }";
    let mut full = Values::of(&format!("{ARM} {products} reduce Held {{ freeze q2 = 1/5; freeze s = e; }}"));
    (full.q[1], full.q[2]) = (0.2, 0.3);
    let (jacobian, frame) = (full.jacobian("wrist"), full.frame("wrist"));
    let part = full.derived.reduced.remove(0);
    let (model, equations) = (&part.reduced.model, &part.equations);
    let at = |roots: &[ExprId]| {
        evaluate(&model.graph, roots, |role| match role {
            Role::Parameter(i) => [2.0, 0.7, 0.3][i as usize],
            Role::Coordinate(i) => [Q[0], Q[3], Q[4]][i as usize],
            _ => f64::NAN,
        })
    };
    let expected = jacobian.iter().flat_map(|row| [row[0], row[3], row[4]]).collect::<Vec<_>>();
    assert_near(&at(&equations.frame_jacobians[4]), &expected, 1e-14);
    assert_near(&at(&model.scene.frames[4].values), &frame, 1e-14);
    assert_eq!(model.scene.motions.len(), 5);
}
