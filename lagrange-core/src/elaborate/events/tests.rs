use crate::elaborate::elaborate;
use crate::model::{Action, Model, ReactionKind};
use lagrange_expr::diagnostics::Report;
use lagrange_expr::expr::evaluate;
use lagrange_expr::expr::{Dependencies, ExprId};
use lagrange_expr::symbol::Role;
use lagrange_language::bodies::plain;
use lagrange_language::syntax::ast::Direction;
use lagrange_language::syntax::parse_text;

const POINT: &str = "param m = 2, h = 3, mu = 0.3;
    coord x, y;
    kinetic = 1/2 * m * (dot(x)^2 + dot(y)^2);
    output used = m + h + mu;";

/// Returns the model of a point in a plane with these statements, or the errors.
fn read(statements: &str) -> Result<Model, String> {
    let mut report = Report::default();
    let text = format!("{POINT}\n{statements}");
    let declaration = parse_text(&text, &mut report).expect("tokens");
    let model = elaborate(&plain(declaration, &mut report), &mut report).filter(|_| !report.has_errors());
    model.ok_or_else(|| report.to_string())
}

fn model(statements: &str) -> Model {
    read(statements).unwrap_or_else(|report| panic!("{statements}\n{report}"))
}

/// Returns the first line of the errors.
fn mistake(statements: &str) -> String {
    let report = read(statements).expect_err(statements);
    report.lines().next().expect("an error").to_owned()
}

/// Evaluates expressions at t = 0.5, (x, y) = (0.7, 1.1) and velocities (-0.2, 0.4).
fn at_a_state<const K: usize>(model: &Model, expressions: [ExprId; K]) -> [f64; K] {
    let value = |role| match role {
        Role::Parameter(index) => [2.0, 3.0, 0.3][index as usize],
        Role::Time => 0.5,
        Role::Coordinate(index) => [0.7, 1.1][index as usize],
        Role::Velocity(index) => [-0.2, 0.4][index as usize],
        _ => f64::NAN,
    };
    let values = evaluate(&model.graph, &expressions, value);
    values.try_into().expect("as many values as expressions")
}

fn assert_near<const K: usize>(found: [f64; K], expected: [f64; K]) {
    for (a, b) in found.iter().zip(expected) {
        assert!((a - b).abs() < 1e-14, "{found:?}, not {expected:?}");
    }
}

fn contact(model: &Model, index: usize) -> [ExprId; 3] {
    let reaction = &model.reactions[index];
    match reaction.kind {
        ReactionKind::Contact { gap, restitution } => [gap, reaction.velocity, restitution],
        other => panic!("{other:?} is no contact"),
    }
}

#[test]
fn gaps_are_positive_where_bodies_are_free() {
    let model = model(
        "event floor = y, falling => impact(0);
         event ceiling = y - h, rising => impact(1);",
    );
    assert_near(at_a_state(&model, contact(&model, 0)), [1.1, 0.4, 0.0]);
    assert_near(at_a_state(&model, contact(&model, 1)), [1.9, -0.4, 1.0]);
    assert_near(at_a_state(&model, [model.events[1].value]), [-1.9]);
    assert_eq!(model.events[1].direction, Direction::Rising);
}

#[test]
fn rates_of_gaps_hold_what_time_does() {
    let model = model("event racket = y - sin(2 * t), falling => impact(1 / (1 + dot(y)^2));");
    let expected = [1.1 - 1.0_f64.sin(), 0.4 - 2.0 * 1.0_f64.cos(), 1.0 / 1.16];
    assert_near(at_a_state(&model, contact(&model, 0)), expected);
}

#[test]
fn reactions_and_events_keep_the_order_of_their_declaration() {
    let model = model(
        "friction slide = dot(x), mu;
         event first = x, crossing => record;
         event floor = y, falling => impact(0);
         friction slow = dot(y), mu, smooth: 0.1;
         event wall = x - h, rising => impact(1/2);
         event last = t - h, rising => stop;",
    );
    let names: Vec<_> = model.reactions.iter().map(|reaction| reaction.name.as_str()).collect();
    assert_eq!(names, ["slide", "floor", "slow", "wall"]);
    for (index, reaction) in (0..).zip(&model.reactions) {
        let symbol = model.graph.symbols().find(Role::Reaction(index)).expect("a symbol");
        assert_eq!(model.graph.symbols().get(symbol).name, reaction.name);
        assert_eq!(model.graph.dependencies(reaction.symbol), Dependencies::REACTION);
    }
    let modes: Vec<_> = model.reactions.iter().map(|reaction| reaction.kind.has_mode()).collect();
    assert_eq!(modes, [true, true, false, true]);
    let events: Vec<_> = model.events.iter().map(|e| format!("{} {:?}", e.name, e.action)).collect();
    assert_eq!(events, ["first Record", "floor Impact(1)", "wall Impact(3)", "last Stop"]);
}

#[test]
fn assignments_are_entries_of_the_whole_state() {
    let model = model(
        "coord z;
         kinetic = 1/2 * dot(z)^2;
         event swap = x - y, crossing => { x = y; dot(z) = h; y = x; dot(x) = -dot(y); }",
    );
    let Action::Assign(assignments) = &model.events[0].action else { panic!("no assignments") };
    let indices: Vec<_> = assignments.iter().map(|assignment| assignment.index).collect();
    assert_eq!(indices, [0, 5, 1, 3]);
    let values = std::array::from_fn(|i| assignments[i].value);
    assert_near(at_a_state(&model, values), [1.1, 3.0, 0.7, -0.4]);
}

#[test]
fn velocities_stand_behind_coordinates_that_are_declared_later() {
    let model = model("event hit = x, falling => { dot(x) = 0; } coord z; kinetic = 1/2 * dot(z)^2;");
    let Action::Assign(assignments) = &model.events[0].action else { panic!("no assignments") };
    assert_eq!(assignments[0].index, 3);
}

#[test]
fn a_single_limit_holds_for_slipping_and_for_sticking() {
    let model = model(
        "friction one = dot(x) - 1/2, mu;
         friction two = 2 * dot(y), kinetic: mu, static: mu + x;
         friction three = dot(x), mu, smooth: 1/h;",
    );
    let ReactionKind::Friction { kinetic, fixed } = model.reactions[0].kind else { panic!("no friction") };
    assert_eq!(kinetic, fixed);
    assert_near(at_a_state(&model, [kinetic, model.reactions[0].velocity]), [0.3, -0.7]);
    let ReactionKind::Friction { kinetic, fixed } = model.reactions[1].kind else { panic!("no friction") };
    assert_near(at_a_state(&model, [kinetic, fixed, model.reactions[1].velocity]), [0.3, 1.0, 0.8]);
    let ReactionKind::Smooth { limit, width } = model.reactions[2].kind else { panic!("not smooth") };
    assert_near(at_a_state(&model, [limit, width]), [0.3, 1.0 / 3.0]);
}

#[test]
fn limits_may_hold_forces_and_so_may_outputs_and_events() {
    let model = model(
        "constraint track = x + y;
         event floor = y, falling => impact(0);
         friction slide = dot(x), (mu + dot(x)^2) * floor + (if x < 0 { track } else { 2 * floor }) + h;
         friction belt = dot(x) - 1, mu * slide, smooth: 0.1;
         event leaves = track, falling => stop;
         event jerks = ddot(x) - track, rising => record;
         output pull = track;
         output pair = (floor, slide);",
    );
    let depends = |id: ExprId, kind| model.graph.dependencies(id).intersects(kind);
    let ReactionKind::Friction { kinetic, .. } = model.reactions[1].kind else { panic!("no friction") };
    assert!(depends(kinetic, Dependencies::REACTION) && depends(kinetic, Dependencies::MULTIPLIER));
    assert!(depends(model.events[1].value, Dependencies::MULTIPLIER));
    assert!(depends(model.events[2].value, Dependencies::ACCELERATION));
    let uses = |name: &str| {
        let output = model.outputs.iter().find(|output| output.name == name).expect("an output");
        (output.uses_multipliers, output.uses_reactions)
    };
    assert_eq!([uses("used"), uses("pull"), uses("pair")], [(false, false), (true, false), (false, true)]);
}

#[test]
fn limits_that_are_not_linear_in_forces_are_refused() {
    let declared = "constraint track = x + y; event floor = y, falling => impact(0);";
    for limit in ["floor^2", "floor * track", "abs(track)", "1 / floor", "if floor < 1 { 0 } else { 1 }"] {
        let found = mistake(&format!("{declared} friction slide = dot(x), mu * ({limit});"));
        assert!(found.contains("is not linear in the forces"), "{limit}: {found}");
    }
}

#[test]
fn slip_velocities_are_linear_in_the_velocities() {
    model("friction slide = x * dot(x) + sin(t) - dot(y) / 2, 1;");
    for slip in ["dot(x)^2", "abs(dot(x))", "dot(x) * dot(y)", "sin(dot(x))"] {
        let found = mistake(&format!("friction slide = {slip}, 1;"));
        assert!(found.contains("is not linear in the velocities"), "{slip}: {found}");
    }
    for slip in ["(dot(x), 0)", "(0, dot(x))"] {
        model(&format!("friction slide = {slip}, 1;"));
    }
    let found = mistake("friction slide = (0, 0), 1;");
    assert!(found.contains("does not depend on any velocity"), "{found}");
    let found = mistake("friction slide = x, 1;");
    assert!(found.contains("does not depend on any velocity"), "{found}");
}

#[test]
fn ends_of_the_range_of_restitution_are_possible() {
    for restitution in ["0", "1", "0.5", "mu", "h", "mu * abs(dot(y))"] {
        model(&format!("event floor = y, falling => impact({restitution});"));
    }
    for restitution in
        ["sin(1)", "exp(-1/1000)", "1 - 1/1000000", "sqrt(2) / 2", "min(2, 1)", "if 1 < 2 { 1 } else { 3 }"]
    {
        model(&format!("event floor = y, falling => impact({restitution});"));
    }
    for restitution in [
        "-1/100",
        "1.01",
        "pi",
        "-pi",
        "exp(1/1000)",
        "1 + 1/1000000",
        "sqrt(2)",
        "-sin(1)",
        "max(2, 1)",
        "1 - 5/4",
        "tan(1)",
    ] {
        let found = mistake(&format!("event floor = y, falling => impact({restitution});"));
        assert!(found.contains("is not between 0 and 1"), "{restitution}: {found}");
    }
    for restitution in ["bounce", "2 * bounce - 1/2", "exp(-bounce)"] {
        let declared = |value: &str| {
            format!("const bounce = {value}; event floor = y, falling => impact({restitution});")
        };
        model(&declared("3/5"));
        let found = mistake(&declared("-9/8"));
        assert!(found.contains("is not between 0 and 1"), "{restitution}: {found}");
    }
}

/// Returns the warnings about a point with these valid statements.
fn warnings(statements: &str) -> String {
    let mut report = Report::default();
    let declaration = parse_text(&format!("{POINT}\n{statements}"), &mut report).expect("tokens");
    elaborate(&plain(declaration, &mut report), &mut report).expect("a model");
    report.to_string()
}

#[test]
fn friction_in_two_directions_of_one_contact_is_warned_of() {
    let contacts = "event floor = y, falling => impact(0); event wall = x, falling => impact(0);";
    for (first, second) in [
        ("dot(x), mu * floor", "dot(y), mu * floor"),
        ("dot(x), mu * floor", "dot(x) + dot(y), floor / 2 + wall"),
        ("dot(x) + dot(y), kinetic: mu * floor, static: floor", "dot(x) - dot(y), kinetic: 0, static: floor"),
        ("dot(x), mu * floor, smooth: 1", "dot(y), mu * floor"),
    ] {
        let found = warnings(&format!("{contacts} friction one = {first}; friction other = {second};"));
        assert!(found.contains("`one` and `other` limit the friction of the contact `floor`"), "{found}");
        assert!(found.contains("up to √2 times too much"), "{found}");
        assert_eq!(found.matches("warning at").count(), 1, "{found}");
    }
    for (first, second) in [
        ("dot(x), mu * floor", "dot(y), mu * wall"),
        ("dot(x), mu * floor", "dot(x), floor"),
        ("dot(x) + dot(y), mu * floor", "2 * dot(x) + 2 * dot(y) - 3, floor"),
        ("dot(x), mu", "dot(y), mu"),
        ("(dot(x), dot(y)), mu * floor", "dot(x) - dot(y), floor / 9"),
        ("dot(x), mu * floor", "(dot(x), dot(y)), floor / 9"),
        // Friction in a plane is a cone already, beside which rotations have others.
        ("(dot(x), dot(y)), mu * floor", "(2 * dot(x), dot(y)), floor / 9"),
        ("dot(x), floor / 9", "(dot(x), dot(y)), mu * floor"),
        ("(dot(x), dot(y)), mu * floor", "dot(x) + dot(y), floor / 9"),
    ] {
        let found = warnings(&format!("{contacts} friction one = {first}; friction other = {second};"));
        assert_eq!(found, "", "{first}; {second}");
    }
}

#[test]
fn moments_of_a_contact_are_not_warned_of() {
    let found = warnings(
        "coord phi;
        body wheel { mass: 2; center: (x, y); angle: phi; shape: disk(0.1); }
        contact touch = wheel on ground { friction: 0.3; rolling: 0.001; }",
    );
    assert_eq!(found, "");
}

#[test]
fn negative_shares_of_a_contact_force_are_no_limit() {
    let found = mistake("event floor = y, falling => impact(0); friction rub = dot(x), -0.3 * floor;");
    assert!(found.contains("is negative"), "{found}");
    model("constraint track = y; friction rub = dot(x), -0.3 * track;");
    model("event floor = y, falling => impact(0); friction rub = dot(x), 2 - 0.3 * floor;");
}

#[test]
fn events_must_change() {
    for function in ["m - h", "1", "2 * m"] {
        let found = mistake(&format!("input u; event never = {function}, rising => stop;"));
        assert!(found.contains("is constant"), "{found}");
    }
    for function in ["t - u", "x", "dot(x) * m", "ddot(x) - u", "u", "u - m"] {
        model(&format!("input u = 1; event now = {function}, rising => stop; output control = u;"));
    }
}

#[test]
fn constraints_are_stabilised_at_a_rate_that_stays() {
    let stabilised = model("constraint track = x + y; stabilise = 2 * h;");
    let rate = stabilised.stabilisation.expect("a rate");
    assert_near(at_a_state(&stabilised, [rate]), [6.0]);
    assert!(model("constraint track = x + y;").stabilisation.is_none());
    assert!(model("constraint track = x + y; stabilise = 0;").stabilisation.is_some());
    let found = mistake("constraint track = x + y; stabilise = 1 + x;");
    assert!(found.contains("cannot depend on this"), "{found}");
    let found = mistake("stabilise = 1;");
    assert!(found.contains("no constraint to stabilise"), "{found}");
}

#[test]
fn a_faulty_contact_causes_no_second_mistake() {
    let text = "event floor = y^2 * dot(y), falling => impact(0);
        friction slide = dot(x), mu * floor;
        output normal = floor;";
    let report = read(text).expect_err("a gap with a velocity");
    assert_eq!(report.matches("error").count(), 1, "{report}");
}
