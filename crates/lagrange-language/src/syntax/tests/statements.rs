use super::{read, statements};

#[test]
fn every_statement_has_its_form() {
    let text = "
        param a, b = 1.0, c;
        input u, w = -2;
        const k = 1/2, pi2 = 2 * pi;
        coord x, theta;
        state current, heat;
        dot(current) = -r * current;
        let n = a + b;
        let (p, q) = (a, b);
        let (r, s, v) = (a, b, c);
        kinetic = dot(x)^2;
        potential = x;
        lagrangian = x;
        gibbs = 1/2 * m * ddot(x)^2, for: a - b;
        dissipation = x;
        force x = u;
        force (u, w) at (p, q);
        force f at p + q;
        torque -m on theta - x;
        constraint ring = p^2 + q^2 - 1;
        stabilise = 10;
        event floor = y - b, falling => impact(1/2);
        event wall = x, rising => stop;
        event tick = sin(t), crossing => record;
        event kick = x - a, crossing => { dot(x) = -k * dot(x); y = a; }
        friction brake = dot(x) - w, mu * floor;
        friction shoe = dot(x), kinetic: mu, static: if x < 0 { a } else { b };
        friction slide = dot(x), mu, smooth: a;
        output tip = (p, q);
        emit { jacobian, no energy }
        reduce Near { freeze x = 0, y = a; small theta, phi = pi/2; ignore s; }";
    let expected = [
        "param a (b 1) c",
        "input u (w (- 2))",
        "const (k (/ 1 2)) (pi2 (* 2 pi))",
        "coord x theta",
        "state current heat",
        "dot(current) (* (- r) current)",
        "let n (+ a b)",
        "let (p q) (vector a b)",
        "let (r s v) (vector a b c)",
        "kinetic (^ (dot x) 2)",
        "potential x",
        "lagrangian x",
        "gibbs (* (* (/ 1 2) m) (^ (ddot x) 2)) for (- a b)",
        "dissipation x",
        "force x u",
        "force (vector u w) at (vector p q)",
        "force f at (+ p q)",
        "torque (- m) on (- theta x)",
        "constraint ring (- (+ (^ p 2) (^ q 2)) 1)",
        "stabilise 10",
        "event floor (- y b) Falling impact (/ 1 2)",
        "event wall x Rising stop",
        "event tick (sin t) Crossing record",
        "event kick (- x a) Crossing ((dot x) (* (- k) (dot x))) (y a)",
        "friction brake (- (dot x) w) (* mu floor)",
        "friction shoe (dot x) mu static (if (< x 0) a b)",
        "friction slide (dot x) mu smooth a",
        "output tip (vector p q)",
        "emit jacobian -energy",
        "reduce Near (Frozen x 0) (Frozen y a) (Small theta) (Small phi (/ pi 2)) (Ignored s)",
    ];
    assert_eq!(statements(&read(text)), expected);
}

#[test]
fn separators_may_be_repeated_where_nothing_is_lost() {
    assert_eq!(statements(&read(";param a, b = 1,;; coord x,;")), ["param a (b 1)", "coord x"]);
    assert_eq!(statements(&read("emit { }; emit { no, no no, }")), ["emit", "emit no -no"]);
    assert_eq!(statements(&read("emit { a }\ncoord x;")), ["emit a", "coord x"]);
    assert!(read("").statements.is_empty());
    assert!(read("// nothing but a comment").statements.is_empty());
}

#[test]
fn words_inside_statements_are_free_as_names() {
    assert_eq!(statements(&read("force at at on; torque on on at;")), ["force at at on", "torque on on at"]);
    assert_eq!(statements(&read("param no, θ = 1;")), ["param no (θ 1)"]);
    let text = "
        event stop = x, falling => stop;
        event impact = rising, rising => { crossing = record; }
        let friction = smooth;
        friction friction = friction, friction, smooth: friction;
        force friction = friction * kick;
        torque friction on at;";
    let expected = [
        "event stop x Falling stop",
        "event impact rising Rising (crossing record)",
        "let friction smooth",
        "friction friction friction friction smooth friction",
        "force friction (* friction kick)",
        "torque friction on at",
    ];
    assert_eq!(statements(&read(text)), expected);
    let text = "param freeze; coord small; reduce Near { small small = freeze; }";
    assert_eq!(statements(&read(text)), ["param freeze", "coord small", "reduce Near (Small small freeze)"]);
}

#[test]
fn statements_reach_from_keyword_to_semicolon() {
    let declaration = read("  coord x ;\nemit { a }\n");
    let columns = declaration
        .statements
        .iter()
        .map(|statement| (statement.origin.start.start().column, statement.origin.end.end().column));
    assert_eq!(columns.collect::<Vec<_>>(), [(2, 11), (0, 10)]);
}
