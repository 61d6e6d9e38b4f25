use super::{errors, read, read_wrong, shown, statements};
use crate::syntax::ast::{AstId, Body, Declaration, JointKind, Mobilizer, Name, Part, SceneStatement, Shape};

/// Formats a statement about bodies as nested lists, its kind first.
pub(super) fn scene(declaration: &Declaration, statement: &SceneStatement) -> String {
    let show = |id: &AstId| shown(&declaration.expressions, *id);
    let labelled = |label: &str, value: &Option<AstId>| match value {
        Some(value) => format!(" ({label} {})", show(value)),
        None => String::new(),
    };
    let named = |word: &str, name: &Option<Name>| match name {
        Some(name) => format!("{word} {} =", name.text),
        None => word.to_owned(),
    };
    match statement {
        SceneStatement::Gravity(value) => format!("gravity {}", show(value)),
        SceneStatement::Body(body) => self::body(declaration, body),
        SceneStatement::Frame(name) => format!("frame {}", name.text),
        SceneStatement::Mobilizer(joint) => mobilizer(declaration, joint),
        SceneStatement::Surface(surface) => {
            let on = surface.on.as_ref().map_or(String::new(), |on| format!(" (on {})", on.text));
            let values = surface.values().into_iter();
            let rest = values.map(|(label, value)| labelled(label, &value)).collect::<String>();
            format!("{} {}{on}{rest}", surface.kind.name(), surface.name.text)
        }
        SceneStatement::Contact(contact) => {
            let word = if contact.is_inside { "inside" } else { "on" };
            let values = contact.values().into_iter();
            let rest = values.map(|(label, value)| labelled(label, &value)).collect::<String>();
            let object = show(&contact.object);
            format!("contact {} = {object} {word} {}{rest}", contact.name.text, contact.surface.text)
        }
        SceneStatement::Contacts(defaults) => {
            let values = defaults.compliance.values().into_iter();
            let rest = values.map(|(label, value)| labelled(label, &value)).collect::<String>();
            format!("contacts {}{rest}", defaults.way.text)
        }
        SceneStatement::Connector(connector) => {
            let mut text = named(connector.kind.name(), &connector.name);
            text += &labelled("from", &connector.from);
            text += &labelled("to", &connector.to);
            text += &labelled("stiffness", &connector.stiffness);
            text += &labelled("rest", &connector.rest);
            text + &labelled("damping", &connector.damping)
        }
        SceneStatement::Joint(joint) => match &joint.kind {
            JointKind::Pin { first, second } => {
                format!("{} {} to {}", named("pin", &joint.name), show(first), show(second))
            }
            JointKind::Slide { point, line } => {
                format!("{} {} on {}", named("slide", &joint.name), show(point), line.text)
            }
            JointKind::Roll { body, line, radius } => {
                let start = named("roll", &joint.name);
                format!("{start} {} on {}{}", body.text, line.text, labelled("radius", radius))
            }
        },
    }
}

fn mobilizer(declaration: &Declaration, joint: &Mobilizer) -> String {
    let labelled = |label: &str, value: &Option<AstId>| match value {
        Some(value) => format!(" ({label} {})", shown(&declaration.expressions, *value)),
        None => String::new(),
    };
    let quaternion = joint.quaternion.iter().map(|quaternion| &quaternion.name);
    let names =
        joint.coordinates.iter().chain(quaternion).map(|name| format!(" {}", name.text)).collect::<String>();
    let mut text = format!("{}{names}: {} to {}", joint.kind.name(), joint.inboard.text, joint.outboard.text);
    text += &labelled("at", &joint.at);
    text += &labelled("turned", &joint.turned);
    text += &labelled("axis", &joint.axis);
    text += &labelled("pitch", &joint.pitch);
    text + &labelled("damping", &joint.damping)
}

fn body(declaration: &Declaration, body: &Body) -> String {
    let show = |id: &AstId| shown(&declaration.expressions, *id);
    let labelled = |label: &str, value: &Option<AstId>| match value {
        Some(value) => format!(" ({label} {})", show(value)),
        None => String::new(),
    };
    let shape = |shape: &Shape| {
        let dimensions = shape.dimensions.iter().map(|id| format!(" {}", show(id))).collect::<String>();
        format!("({}{dimensions})", shape.solid.text)
    };
    let part = |part: &Part| {
        let rest = labelled("mass", &part.mass) + &labelled("at", &part.at) + &labelled("angle", &part.angle);
        let rest = rest + &labelled("turned", &part.turned);
        format!(" ({}{}{rest})", if part.is_hole { "hole " } else { "" }, shape(&part.shape))
    };
    let mut text = format!("body {}", body.name.text);
    text += &labelled("mass", &body.mass);
    text += &labelled("inertia", &body.inertia);
    text += &labelled("center", &body.center);
    text += &labelled("origin", &body.origin);
    text += &labelled("centroid", &body.centroid);
    text += &labelled("angle", &body.angle);
    text += &labelled("angles", &body.angles);
    text.extend(body.sequence.as_ref().map(|sequence| format!(" (sequence {})", sequence.text)));
    text.extend(body.tensor.as_ref().map(|tensor| {
        let components = tensor.iter().map(|id| format!(" {}", show(id))).collect::<String>();
        format!(" (tensor{components})")
    }));
    text.extend(body.shape.as_ref().map(|found| format!(" (shape {})", shape(found))));
    text + &body.parts.iter().map(part).collect::<String>()
}

#[test]
fn bodies_and_joints_in_space_have_their_form() {
    let text = "
        gravity = (0, 0, -g);
        body link { mass: m; centroid: (a, 0, b); inertia: (1, 2, 3, xy, 0, -1/2); }
        frame hand;
        body top { mass: m; inertia: (1, 2, 2); center: (0, 0, l); angles: (psi, theta, phi); sequence: zxz; }
        body case { compound { cuboid(a, b, c), mass: m, at: (0, 0, 1), turned: (0, pi/2, 0); } }
        revolute q = ground to link { at: (0, 0, h); turned: (-pi/2, 0, 0); axis: (0, 1, 0); damping: c; }
        prismatic s = link to hand;
        screw alpha = hand to nut { pitch: p; };
        cylindrical (phi, z) = nut to rod { axis: (1, 0, 0); }
        universal (a, b) = rod to fork { at: (0, 0, 1); }
        planar (x, y, psi) = ground to puck;
        weld fork to tool { at: (l, 0, 0); }
        force f along dot(q);
        output w = velocity(link.point(1, 2, 3)) in link;
        let revolute = 1;
        let weld = revolute + 1;
    ";
    let expected = [
        "gravity (vector 0 0 (- g))",
        "body link (mass m) (centroid (vector a 0 b)) (tensor 1 2 3 xy 0 (/ (- 1) 2))",
        "frame hand",
        "body top (mass m) (inertia (vector 1 2 2)) (center (vector 0 0 l)) (angles (vector psi theta phi)) \
         (sequence zxz)",
        "body case ((cuboid a b c) (mass m) (at (vector 0 0 1)) (turned (vector 0 (/ pi 2) 0)))",
        "revolute q: ground to link (at (vector 0 0 h)) (turned (vector (/ (- pi) 2) 0 0)) (axis (vector 0 1 0)) \
         (damping c)",
        "prismatic s: link to hand",
        "screw alpha: hand to nut (pitch p)",
        "cylindrical phi z: nut to rod (axis (vector 1 0 0))",
        "universal a b: rod to fork (at (vector 0 0 1))",
        "planar x y psi: ground to puck",
        "weld: fork to tool (at (vector l 0 0))",
        "force f along (dot q)",
        "output w (in (velocity (point link 1 2 3)) link)",
        "let revolute 1",
        "let weld (+ revolute 1)",
    ];
    assert_eq!(statements(&read(text)), expected);
}

#[test]
fn every_statement_about_bodies_has_its_form() {
    let text = "
        gravity = (0, -g);
        body rod {
            mass: m;
            inertia: slender_rod(m, l);
            center: (x, y);
            centroid: (l/2, 0);
            angle: a;
            shape: slender_rod(l);
        }
        body mass_point { mass: 1; origin: (x, 0); };
        body wheel {
            angle: phi;
            origin: (x, y);
            compound {
                rectangle(a, b), mass: m1;
                disk(r), mass: m2, at: (u, v), angle: e;
                hole point_mass(), mass: m3,;
                polygon((0, 0), (1, 0), (0, 1)), angle: e, mass: 1;
            }
            centroid: 0;
        }
        line floor { }
        line ramp { through: (x, y); angle: e; on: cart; }
        spring k1 { from: p; to: rod; stiffness: k; rest: l; }
        spring { from: rod.point(x, y); to: (0, 0); stiffness: k; };
        damper { to: q; from: p; damping: c; }
        torsion_spring { from: ground; to: rod; stiffness: k; rest: pi/2; }
        torsion_damper brake { from: a; to: rod; damping: c; }
        pin hinge = rod.point(l/2, 0) to (0, 0);
        pin (0, 0) to rod;
        slide foot = rod.point(0, 0) on floor;
        slide (x, y) on floor;
        roll wheel on floor;
        roll contact = wheel on floor;
        roll wheel on floor, radius: 2 * r;
        force f at rod;";
    let expected = [
        "gravity (vector 0 (- g))",
        "body rod (mass m) (inertia (slender_rod m l)) (center (vector x y)) (centroid (vector (/ l 2) 0)) \
         (angle a) (shape (slender_rod l))",
        "body mass_point (mass 1) (origin (vector x 0))",
        "body wheel (origin (vector x y)) (centroid 0) (angle phi) ((rectangle a b) (mass m1)) \
         ((disk r) (mass m2) (at (vector u v)) (angle e)) (hole (point_mass) (mass m3)) \
         ((polygon (vector 0 0) (vector 1 0) (vector 0 1)) (mass 1) (angle e))",
        "line floor",
        "line ramp (on cart) (through (vector x y)) (angle e)",
        "spring k1 = (from p) (to rod) (stiffness k) (rest l)",
        "spring (from (point rod x y)) (to (vector 0 0)) (stiffness k)",
        "damper (from p) (to q) (damping c)",
        "torsion_spring (from ground) (to rod) (stiffness k) (rest (/ pi 2))",
        "torsion_damper brake = (from a) (to rod) (damping c)",
        "pin hinge = (point rod (/ l 2) 0) to (vector 0 0)",
        "pin (vector 0 0) to rod",
        "slide foot = (point rod 0 0) on floor",
        "slide (vector x y) on floor",
        "roll wheel on floor",
        "roll contact = wheel on floor",
        "roll wheel on floor (radius (* 2 r))",
        "force f at rod",
    ];
    assert_eq!(statements(&read(text)), expected);
}

#[test]
fn words_of_scenes_are_free_as_names() {
    let text = "
        param line, spring = 1, pin, slide, roll, mass, disk, hole;
        coord damper, torsion_spring;
        let torsion_damper = if pin < spring { slide } else { roll };
        force pin at slide;
        torque pin on roll;
        event slide = pin - line, rising => { roll = pin; }
        friction roll = slide, spring;
        body spring { mass: mass; center: center; angle: angle; shape: shape(hole); }
        line line { on: on; through: through; }
        spring spring { from: from; to: to; stiffness: rest; }
        pin pin to roll;
        pin pin = pin to pin;
        slide slide on line;
        roll slide = roll on line, radius: radius;
        output point = line.point(slide.x);
        emit { no pin, roll }";
    let declaration = read(text);
    assert_eq!(declaration.statements.len(), 16);
    let text = statements(&declaration);
    assert_eq!(text[3..5], ["force pin at slide", "torque pin on roll"]);
    assert_eq!(text[10..13], ["pin pin to roll", "pin pin = pin to pin", "slide slide on line"]);
}

#[test]
fn names_of_a_scene_are_declared() {
    let text = "body a {} line b {} spring c {} spring {} pin d = a to a; slide e = a on b; roll f = a on b;";
    let declaration = read(text);
    let places = declaration.places();
    let declared = ["a", "b", "c", "d", "e", "f", "g"].map(|name| places.contains(&name.to_owned()));
    assert_eq!(declared, [true, true, true, true, true, true, false]);
}

#[test]
fn missing_pieces_of_statements_about_bodies_are_reported() {
    let cases = [
        ("gravity (0, 1);", "error at 1:9: expected `=`, found `(`"),
        ("body;", "error at 1:5: expected a name, found `;`"),
        ("body { mass: 1; }", "error at 1:6: expected a name, found `{`"),
        ("body sin { mass: 1; }", "error at 1:6: `sin` is a function and cannot be declared"),
        ("body a;", "error at 1:7: expected `{`, found `;`"),
        ("body a mass: 1;", "error at 1:8: expected `{`, found `mass`"),
        ("body a = { mass: 1; }", "error at 1:8: expected `{`, found `=`"),
        ("body a { 3; }", "error at 1:10: expected a label of a body, found `3`"),
        ("body a { colour: 3; }", "error at 1:10: unknown label `colour` for a body"),
        ("body a { centre: (x, y); }", "error at 1:10: unknown label `centre` for a body"),
        ("body a { mass: 1; mass: 2; }", "error at 1:19: `mass` is given twice"),
        ("body a { mass = 1; }", "error at 1:15: expected `:`, found `=`"),
        ("body a { mass 1; }", "error at 1:15: expected `:`, found `1`"),
        ("body a { mass: ; }", "error at 1:16: expected an expression, found `;`"),
        ("body a { mass: 1 }", "error at 1:16: missing `;` after this"),
        ("body a { mass: 1 2; }", "error at 1:18: expected an operator or `;`, found `2`"),
        ("body a { mass: 1, angle: b; }", "error at 1:17: expected `;`, found `,`"),
        ("body a { shape: 1; }", "error at 1:17: expected the name of a solid, found `1`"),
        ("body a { shape: disk; }", "error at 1:21: expected `(`, found `;`"),
        ("body a { shape: disk(r) + 1; }", "error at 1:25: expected an operator or `;`, found `+`"),
        ("body a { compound: { disk(r), mass: 1; } }", "error at 1:18: expected `{`, found `:`"),
        ("body a { compound; }", "error at 1:18: expected `{`, found `;`"),
        ("body a { compound { } }", "error at 1:19: this body has no parts"),
        ("body a { compound { disk; } }", "error at 1:25: expected `(`, found `;`"),
        ("body a { compound { disk(r) mass: 1; } }", "error at 1:29: expected `,`, found `mass`"),
        ("body a { compound { disk(r), mas: 1; } }", "error at 1:30: unknown label `mas` for a part"),
        ("body a { compound { disk(r), mass: 1 } }", "error at 1:36: missing `;` after this"),
        ("line;", "error at 1:5: expected a name, found `;`"),
        ("line a { on: (0, 0); }", "error at 1:14: expected a name, found `(`"),
        ("line a { from: (0, 0); }", "error at 1:10: unknown label `from` for a line"),
        ("spring a = b;", "error at 1:10: expected `{`, found `=`"),
        ("spring { damping: c; }", "error at 1:10: unknown label `damping` for a spring"),
        ("damper { stiffness: c; }", "error at 1:10: unknown label `stiffness` for a damper"),
        ("pin a;", "error at 1:6: expected `to`, found `;`"),
        ("pin a on b;", "error at 1:7: expected `to`, found `on`"),
        ("pin a, b;", "error at 1:6: expected `to`, found `,`"),
        ("slide a to b;", "error at 1:9: expected `on`, found `to`"),
        ("slide a on (0, 0);", "error at 1:12: expected a name, found `(`"),
        ("slide a on b.;", "error at 1:13: expected `;`, found `.`"),
        ("roll a on b radius: 1;", "error at 1:13: expected `,` or `;`, found `radius`"),
        ("roll a on b, 1;", "error at 1:14: expected `radius`, found `1`"),
        ("roll a on b, radios: 1;", "error at 1:14: unknown label `radios` for rolling"),
        ("pin sin = a to b;", "error at 1:5: `sin` is a function and cannot be declared"),
        ("pin a to b", "error at 1:10: missing `;` after this"),
    ];
    for (text, message) in cases {
        assert_eq!(errors(text), [message], "{text}");
        assert_eq!(errors(&format!("{text}\ncoord x x;")).len(), 2, "{text}");
    }
}

#[test]
fn a_body_with_mistakes_is_declared_and_lacks_nothing() {
    let text = "
coord x;
body rod {
    mas: 1;
    colour: red;
    inertia: 2 3;
    center: (x, 0)
    angle: x +;
    shape disk(r);
}
body wheel { compound { disk(), ; 3; hole disk(r), mass: 1 } origin: (x, 0); }
spring { from: a; too: b; stifness = k; }
damper brake { }
line ramp { angel: x; throug (0, 0); }
let y = rod.point(0, 1) + brake.length;
pin rod too wheel;
slide rod on ramp
roll wheel on ramp, radius 3;
coord z;";
    let (declaration, report) = read_wrong(text);
    let expected = "\
error at 4:5: unknown label `mas` for a body
  help: did you mean `mass`?
error at 5:5: unknown label `colour` for a body
  help: the labels of a body are `mass`, `inertia`, `center`, `origin`, `centroid`, `angle`, `angles`, `sequence`, `shape`, `compound`, `visual`
error at 6:16: expected an operator or `;`, found `3`
  help: write `*` between the factors of a product
error at 7:18: missing `;` after this
  note at 8:5: the next line begins here
  help: each line between the braces ends in `;`
error at 8:15: expected an expression, found `;`
  help: write an operand after `+`, or remove it
error at 9:11: expected `:`, found `disk`
  help: write `shape: disk(r);`
error at 11:35: expected the name of a solid, found `3`
  help: write the name of a solid with its dimensions, such as `disk(r)` or `rectangle(a, b)`
error at 11:58: missing `;` after this
  help: each line between the braces ends in `;`
error at 12:19: unknown label `too` for a spring
  help: did you mean `to`?
error at 12:27: unknown label `stifness` for a spring
  help: did you mean `stiffness`?
error at 12:36: expected `:`, found `=`
  help: write `stiffness: …;`
error at 14:13: unknown label `angel` for a line
  help: did you mean `angle`?
error at 14:23: unknown label `throug` for a line
  help: did you mean `through`?
error at 14:30: expected `:`, found `(`
  help: write `through: …;`
error at 16:9: expected `to`, found `too`
  help: write `pin p to q;` or `pin name = p to q;`
error at 17:14: missing `;` after this
  note at 18:1: the next statement begins here
  help: statements end in `;`
error at 18:28: expected `:`, found `3`
  help: write `roll wheel on floor;` or `roll name = wheel on floor, radius: r;`, with the names of a body and a line
";
    assert_eq!(report, expected);
    let expected = [
        "coord x",
        "body rod (mass 1) (inertia ?) (center (vector x 0)) (angle ?)",
        "body wheel (origin (vector x 0)) ((disk)) (hole (disk r) (mass 1))",
        "spring (from a) (to b) (stiffness k)",
        "damper brake =",
        "line ramp (angle x)",
        "let y (+ (point rod 0 1) (.length brake))",
        "slide rod on ramp",
        "coord z",
    ];
    assert_eq!(statements(&declaration.expect("tokens")), expected);
}

#[test]
fn unreadable_statements_are_not_reported_as_missing() {
    let (declaration, _) =
        read_wrong("body a { mass 1; } spring { x; } body b { shape: 3; mass: 1; center: 2; }");
    let expected = [
        "body a (mass ?) (inertia ?) (center ?)",
        "spring (from ?) (to ?) (stiffness ?)",
        "body b (mass 1) (inertia ?) (center 2)",
    ];
    assert_eq!(statements(&declaration.expect("tokens")), expected);
}

#[test]
fn a_forgotten_semicolon_is_seen_at_the_next_statement_of_a_scene() {
    let text = "let a = x\nline b {}\nlet a = x\nspring { from: a; }\nlet a = x\nspring s {}\nlet a = x\npin a to b\n\
                gravity = (0, 0)\nbody c {}\nslide a on b\nroll a on b\nlet e = 1\nroll f = a on b\ncoord x";
    let errors = errors(text);
    let lines = errors.iter().filter(|error| error.ends_with("missing `;` after this")).count();
    assert_eq!((lines, errors.len()), (11, 11), "{errors:#?}");
}

#[test]
fn surfaces_and_contacts_have_their_form() {
    let text = "
        line slope { on: cart; angle: -a; }
        plane side { through: (0, 0, 1); normal: (1, 0, 1); }
        circle bowl { center: (0, 1); radius: r; }
        cylinder pipe { on: cart; axis: (1, 0, 0); radius: r; }
        terrain hills { on: cart; height(x, y): h(x) + sum(x in 0..2, x * y); }
        contact touch = wheel on ground;
        contact coin = disk on ground { rim: 1; axis: (0, 1, 0); }
        contact foot[2] = leg.point(0, 0, -l) on side { radius: r; kinetic: a; static: b; restitution: e; }
        contact roll = ball inside bowl { friction: mu; };
        contact soft = ball on ground { friction: mu; stiffness: k; dissipation: d; stiction: v; }
        contact ball_on = ball on ground { rolling: a; spinning: b; }
        contacts: rigid;
        contacts: compliant { penetration: d; load: f; stiction_rate: w; }
        contacts: Foot { compliant: 1; }
        let contact = 1;
        let sphere = contact + 1;
    ";
    let expected = [
        "line slope (on cart) (angle (- a))",
        "plane side (through (vector 0 0 1)) (normal (vector 1 0 1))",
        "circle bowl (center (vector 0 1)) (radius r)",
        "cylinder pipe (on cart) (axis (vector 1 0 0)) (radius r)",
        "terrain hills (on cart) (height (+ (h x ) sum(x  in 0..2, x  * y )))",
        "contact touch = wheel on ground",
        "contact coin = disk on ground (rim 1) (axis (vector 0 1 0))",
        "contact foot = (point leg 0 0 (- l)) on side (radius r) (kinetic a) (static b) (restitution e)",
        "contact roll = ball inside bowl (friction mu)",
        "contact soft = ball on ground (friction mu) (stiffness k) (dissipation d) (stiction v)",
        "contact ball_on = ball on ground (rolling a) (spinning b)",
        "contacts rigid",
        "contacts compliant (penetration d) (load f) (stiction_rate w)",
        "place contacts Foot",
        "let contact 1",
        "let sphere (+ contact 1)",
    ];
    assert_eq!(statements(&read(text)), expected);
}
