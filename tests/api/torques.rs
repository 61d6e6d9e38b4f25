//! Torques on angles, as moments on the bodies that these turn.

use lagrange::body::Motion;
use lagrange::scene::{Item, Scene};

lagrange::system! {
    /// Three rotors on different angles, a brake, and torques on angles in every notation.
    struct Rotors;

    param j = 1.5, r = 0.4;
    coord q1, q2, q3;
    input u, v, w, z, s;

    let third = q3 + sin(t);
    body one { mass: j; center: (0, 0); angle: q1 + 1; shape: disk(r); }
    body two { mass: 2 * j; center: (1, 0); angle: q1 + q2; shape: disk(r); }
    body three { mass: 3 * j; center: (2, 0); angle: third; shape: disk(r); }
    torque u on q2;
    torque v on q1 + q2 - 3;
    torque w on -third;
    torque z on third - q1;
    torque s on 2 * q1;
    torque u * v on two;
    emit { motion, drawing }
}

lagrange::system! {
    /// Two bodies that turn alike: a torque on their angle acts on neither in particular.
    struct Twins;

    coord q;
    body one { mass: 1; center: (0, 0); angle: q; shape: disk(1); }
    body two { mass: 1; center: (3, 0); angle: q; shape: disk(1); }
    torque 5 on q;
    emit { drawing }
}

fn omitted<M: Scene<Scalar = f64>>(system: &M, q: &M::Coordinates, v: &M::Velocities) -> Vec<String> {
    let mut names = Vec::new();
    system.items(0.3, q, v, &mut |item| {
        if let Item::Omitted { name } = item {
            names.push(name.to_owned());
        }
    });
    names
}

/// J α = Σ M for every body. The left side follows from the equations of motion, the right side
/// from the drawing.
#[test]
fn moments_add_up_to_those_of_euler() {
    for trial in 0..40 {
        let number = |k: u32| f64::from(trial * 17 + k * 7).sin() * 2.0;
        let rotors = Rotors { u: number(1), v: number(2), w: number(3), z: number(4), ..Rotors::default() };
        let (q, v) = ([number(5), number(6), number(7)], [number(8), number(9), number(10)]);
        let motions = [
            rotors.one_motion(0.3, &q, &v),
            rotors.two_motion(0.3, &q, &v),
            rotors.three_motion(0.3, &q, &v),
        ];
        for (name, Motion { inertia, angular_acceleration, .. }) in
            ["one", "two", "three"].into_iter().zip(motions)
        {
            let mut sum = 0.0;
            rotors.items(0.3, &q, &v, &mut |item| {
                if let Item::Moment { body: Some(body), moment, .. } = item
                    && body == name
                {
                    sum += moment;
                }
            });
            let expected = inertia * angular_acceleration;
            assert!(
                (sum - expected).abs() < 1e-12 * (1.0 + expected.abs()),
                "{trial} {name}: {sum} {expected}"
            );
            assert!(expected.abs() > 1e-9, "something acts on each of them");
        }
    }
}

#[test]
fn ambiguous_torques_are_named() {
    assert_eq!(omitted(&Rotors::default(), &[0.1, 0.2, 0.3], &[0.0; 3]), ["torque on an angle"]);
    assert_eq!(omitted(&Twins, &[0.1], &[0.0]), ["torque on `q`"]);
}
