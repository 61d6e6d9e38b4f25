//! Quantities of contacts that parameters put out of range, and contacts without a normal.

use lagrange::Simulate;
use lagrange::contact::Stepped;
use lagrange::system::{RangedKind, StepFailure};

lagrange::system! {
    /// A ball on soft ground, with every label of a compliant contact.
    #[derive(Clone, Debug)]
    struct Soft;

    param k = 1e4, d = 1, mu = 0.5, v = 1e-3, w = 1e-2, roll = 0.01, spin = 0.01, r = 0.1;
    gravity = (0, 0, -9.81);
    body ball { mass: 1; shape: solid_sphere(0.1); }
    free ball;
    contact touch = ball on ground {
        stiffness: k; dissipation: d; friction: mu; stiction: v; stiction_rate: w; rolling: roll;
        spinning: spin; radius: r;
    }
}

lagrange::system! {
    /// A ball that sinks into soft ground by d under f.
    #[derive(Clone, Debug)]
    struct Sinking;

    param d = 1e-3, f = 10, r = 0.1;
    gravity = (0, 0, -9.81);
    body ball { mass: 1; shape: solid_sphere(r); }
    free ball;
    contact touch = ball on ground { penetration: d; load: f; }
}

lagrange::system! {
    /// A ball on rigid ground whose normal is a parameter.
    #[derive(Clone, Debug)]
    struct Hard;

    param a = 0.3, b = 0.4, e = 0.5, roll = 0, n = 1, rim = 0.2, up = 1;
    gravity = (0, 0, -9.81);
    plane floor { normal: (0, 0, n); }
    body ball { mass: 1; shape: solid_sphere(0.1); }
    free ball;
    contact touch[1] = ball on floor { kinetic: a; static: b; restitution: e; rolling: roll; }
    contact edge = ball.point(0, 0, 0) on floor { rim: rim; axis: (0, 0, up); }
}

/// A ball at rest on the ground.
const START: [f64; 13] = [0.0, 0.0, 0.5, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0];

/// Returns the message of the runs of a system, which must be that of the check.
macro_rules! refused {
    ($system:expr $(, $method:expr)?) => {{
        let system = $system;
        let checked = system.check_parameters().expect_err("a value out of range");
        assert_eq!(checked.kind, RangedKind::OfContact);
        let error = system.simulate(START).until(0.1).run().map(drop).expect_err("a run");
        assert!(error.cause.is_refusal() && error.to_string().starts_with(&checked.to_string()), "{error}");
        $(
            let error = system.simulate(START).until(0.1).method($method).run().map(drop).expect_err("steps");
            assert!(error.to_string().starts_with(&checked.to_string()), "{error}");
        )?
        checked.to_string()
    }};
}

#[test]
fn quantities_of_compliant_contacts_are_refused_by_name() {
    let soft = Soft::default();
    assert!(soft.check_parameters().is_ok() && soft.simulate(START).until(0.1).run().is_ok());
    let said = refused!(Soft { k: -1.0, ..soft });
    assert_eq!(said, "the `stiffness` of contact `touch` is -1.0, but it must be greater than 0.0");
    let said = refused!(Soft { k: 0.0, ..soft });
    assert_eq!(said, "the `stiffness` of contact `touch` is 0.0, but it must be greater than 0.0");
    let said = refused!(Soft { d: f64::NAN, ..soft });
    assert_eq!(said, "the `dissipation` of contact `touch` is NaN, but it must be at least 0.0");
    let zero_or_more = [
        (Soft { d: -1e-300, ..soft }, "dissipation"),
        (Soft { mu: -0.1, ..soft }, "friction"),
        (Soft { roll: -1.0, ..soft }, "rolling"),
        (Soft { spin: -1.0, ..soft }, "spinning"),
        (Soft { r: -0.1, ..soft }, "radius"),
    ];
    for (system, label) in zero_or_more {
        let said = refused!(system);
        let start = format!("the `{label}` of contact `touch` is -");
        assert!(said.starts_with(&start) && said.ends_with("it must be at least 0.0"), "{said}");
    }
    for (system, label) in [(Soft { v: 0.0, ..soft }, "stiction"), (Soft { w: 0.0, ..soft }, "stiction_rate")]
    {
        let said = refused!(system);
        assert!(said.starts_with(&format!("the `{label}` of contact `touch` is 0.0, ")), "{said}");
    }
    let none = Soft { d: 0.0, mu: 0.0, roll: 0.0, spin: 0.0, r: 0.0, ..soft };
    assert!(none.simulate(START).until(0.1).run().is_ok());
    let sinking = Sinking::default();
    assert!(refused!(Sinking { d: 0.0, ..sinking }).starts_with("the `penetration` of contact `touch`"));
    assert!(refused!(Sinking { f: -1.0, ..sinking }).starts_with("the `load` of contact `touch`"));
    assert!(
        refused!(Sinking { r: -0.1, ..sinking }).starts_with("the radius of the body in contact `touch`")
    );
}

#[test]
fn quantities_of_rigid_contacts_are_refused_by_every_way() {
    let (hard, steps) = (Hard::default(), Stepped::every(0.01));
    assert!(hard.check_parameters().is_ok() && hard.simulate(START).until(0.1).run().is_ok());
    let said = refused!(Hard { a: -0.1, ..hard }, steps);
    assert_eq!(said, "the `kinetic` of contact `touch[1]` is -0.1, but it must be at least 0.0");
    let said = refused!(Hard { b: 0.1, ..hard }, steps);
    assert_eq!(said, "the `static` of contact `touch[1]` is 0.1, but it must be at least 0.3");
    let said = refused!(Hard { e: 1.5, ..hard }, steps);
    let wanted =
        "the coefficient of restitution of contact `touch[1]` is 1.5, but it must be from 0.0 to 1.0";
    assert_eq!(said, wanted);
    let said = refused!(Hard { n: 0.0, ..hard }, steps);
    let wanted = "the length of the direction of `floor` in contact `touch[1]` is 0.0, but it must be greater than 0.0";
    assert_eq!(said, wanted);
    assert!(refused!(Hard { rim: 0.0, ..hard }, steps).starts_with("the `rim` of contact `edge` is 0.0"));
    assert!(refused!(Hard { up: 0.0, ..hard }, steps).starts_with("the length of `axis` of contact `edge`"));
    assert!(refused!(Hard { roll: -1.0, ..hard }, steps).starts_with("the `rolling` of contact `touch[1]`"));
    // A normal of any other length and sign is one.
    assert!(Hard { n: 1e-3, ..hard.clone() }.simulate(START).until(0.1).run().is_ok());
}

lagrange::system! {
    /// A free ball and a second one, which is soft or hard.
    #[derive(Clone, Debug)]
    struct SoftPair;

    param q = 0.1;
    gravity = (0, 0, -9.81);
    body first { mass: 1; shape: solid_sphere(0.1); }
    free first;
    sphere post { center: (0, 0, 0); radius: q; }
    contact touch = first on post { stiffness: 1e4; }
}

lagrange::system! {
    #[derive(Clone, Debug)]
    struct HardPair;

    param q = 0.1;
    gravity = (0, 0, -9.81);
    body first { mass: 1; shape: solid_sphere(0.1); }
    free first;
    sphere post { center: (0, 0, 0); radius: q; }
    contact touch = first on post { friction: 0.3; }
}

#[test]
fn contacts_whose_centres_coincide_are_named() {
    let start = {
        let mut start = START;
        start[2] = 0.0;
        start
    };
    let said = "the gap or normal of contact `touch` is undefined at time 0.0";
    let hard = HardPair::default();
    let causes = [
        SoftPair::default().simulate(start).until(0.1).run().map(drop).map_err(|error| error.cause),
        hard.simulate(start).until(0.1).run().map(drop).map_err(|error| error.cause),
        hard.simulate(start)
            .until(0.1)
            .method(Stepped::every(0.01))
            .run()
            .map(drop)
            .map_err(|error| error.cause),
    ];
    for cause in causes {
        let cause = cause.expect_err("no normal");
        assert!(cause.to_string().contains(said), "{cause}");
        assert!(matches!(cause, StepFailure::Undefined(_)), "{cause}");
    }
    // Parameters and states that are not finite are named first.
    let mut lost = START;
    lost[0] = f64::NAN;
    for said in [
        HardPair { q: f64::NAN, ..HardPair::default() }.simulate(START).until(0.1).run().map(drop),
        HardPair::default().simulate(lost).until(0.1).run().map(drop),
    ]
    .map(|error| error.expect_err("NaN").to_string())
    {
        assert!(!said.contains("the gap or normal"), "{said}");
    }
}

lagrange::system! {
    /// A rod whose lower end slips on the ground. It is drawn in the vertical plane.
    #[derive(Clone, Debug)]
    struct Rod;

    param mu = 3;
    coord x, y, phi;
    gravity = (0, -9.81);
    body rod { mass: 1; center: (x, y); angle: phi; shape: rod(2); }
    contact tip = rod.point(-1, 0) on ground { friction: mu; }
}

/// The moment of inertia is 1/3. A unit of the normal force at the angle φ accelerates the end by
/// 1 + 3 cos² φ. A unit of friction does so by 3 sin φ cos φ. The critical coefficient is their
/// quotient.
#[test]
fn painleve_names_the_contact_with_the_critical_coefficient() {
    let phi = std::f64::consts::FRAC_PI_3;
    let critical = (1.0 + 3.0 * phi.cos().powi(2)) / (3.0 * phi.sin() * phi.cos());
    // The lower end slips backwards at 1 m/s, and rotation does not lift it.
    let start = |slip: f64| [0.0, phi.sin(), phi, slip, 0.0, 0.0];
    let mut named = 0;
    for mu in [1.2 * critical, 2.0 * critical] {
        for slip in [1.0, -1.0] {
            let run = Rod { mu, ..Rod::default() }.simulate(start(slip)).until(1e-3).run();
            let Err(error) = run else { continue };
            let StepFailure::Painleve { contact: "tip", coefficient, critical: Some(found) } = error.cause
            else {
                panic!("{error}")
            };
            assert!(coefficient == mu && (found - critical).abs() < 1e-12, "{error}");
            assert!(error.to_string().contains("of contact `tip` leaves no consistent forces"), "{error}");
            named += 1;
        }
    }
    assert_eq!(named, 2);
    for slip in [1.0, -1.0] {
        let run = Rod { mu: 0.99 * critical, ..Rod::default() }.simulate(start(slip)).until(1e-3).run();
        assert!(run.is_ok());
    }
}
