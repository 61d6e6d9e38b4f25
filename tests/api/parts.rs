//! Parts: items of declarations composed of parts, and the library of parts in `parts`.

use lagrange::Simulate;

lagrange::system! {
    /// A motor that turns a drum to an angle, through a gear with backlash.
    #[derive(Clone, Debug)]
    struct Machine;

    include "../parts/control.lag";
    include "../parts/dc_motor.lag";
    include "../parts/gear.lag";

    param rotor = 0.002, drum = 0.5, bearing = 0.2, target = 1;
    coord phi, theta;
    kinetic = 1/2 * rotor * dot(phi)^2 + 1/2 * drum * dot(theta)^2;
    dissipation = 1/2 * bearing * dot(theta)^2;

    sensor: LowPass { signal: theta; }
    controller: Pid { error: target - sensor.value; }
    motor: DcMotor { shaft: phi; voltage: controller.signal; }
    gear: Gear { drive: phi; load: theta; ratio: 10; }
    output deviation = target - theta;
}

mod swing {
    lagrange::system! { include "../crates/lagrange-cli/tests/data/swing.lag"; }
}

#[test]
fn a_file_is_compiled_as_the_command_reads_it() {
    let swing = swing::Swing::default();
    let run = swing.simulate(swing.start()).until(1.0).run().expect("moves");
    // As `docs/command_line.md` shows.
    assert!((run.last()[0] - -0.4991571869228085).abs() < 1e-12, "{:?}", run.last());
}

#[test]
fn a_machine_of_parts_moves_as_in_an_independent_integration() {
    let machine = Machine {
        sensor_time_constant: 0.05,
        controller_kp: 40.0,
        controller_ki: 5.0,
        controller_kd: 2.0,
        controller_filter: 0.02,
        motor_inductance: 0.01,
        gear_stiffness: 400.0,
        gear_damping: 0.5,
        gear_backlash: 0.02,
        ..Machine::default()
    };
    let run = machine.simulate([0.0; 8]).until(2.0).tolerance(1e-13).run().expect("a motion");
    // From `tools/machine_of_parts.py`.
    let reference = [
        9.5346433536054,
        0.96653420065798,
        1.1985781028407,
        -0.14279493381666,
        -0.28822393443078,
        0.65096989199065,
        -46.012147066580,
        -4.9432119659178,
    ];
    for (value, expected) in run.last().iter().zip(reference) {
        assert!((value - expected).abs() < 1e-10 * expected.abs().max(1.0), "{value} {expected}");
    }
    let deviation = machine.deviation(0.0, &[0.0, 0.25, 0.0, 0.0, 0.0, 0.0], &[0.0; 2]);
    assert_eq!(deviation, 0.75);
}

lagrange::system! {
    /// A car frame on two struts, seen from the side.
    #[derive(Clone, Debug)]
    struct Car;

    include "../parts/strut.lag";

    param mass = 600, g = 9.81;
    coord z, pitch;
    gravity = (0, -g);
    body chassis { mass: mass; center: (0, z); angle: pitch; inertia: 500; }
    strut[i in 0..2]: Strut { lower: (2 * i - 1, 0); upper: chassis.point(2 * i - 1, 0); }
    emit { statements }
}

#[test]
fn fields_and_columns_of_members_have_the_names_of_their_placements() {
    let car = Car { strut_1_stiffness: 25_000.0, ..Car::default() };
    assert_eq!((car.strut_0_stiffness, car.strut_1_damping), (20_000.0, 1500.0));
    let run = car.simulate([0.5, 0.0, 0.0, 0.0]).until(0.5).outputs().run().expect("a motion");
    assert!(run.column("strut[0].tension").is_some() && run.column("strut[1].tension").is_some());
    assert!(Car::STATEMENTS.contains("strut_1_stiffness"));
    // At rest on both struts, k (l − z) carries half of the weight.
    let z = 0.5 - 300.0 * 9.81 / 20_000.0;
    let resting = Car::default().acceleration(0.0, &[z, 0.0], &[0.0; 2]);
    assert!(resting.iter().all(|a| a.abs() < 1e-12), "{resting:?}");
}

lagrange::system! {
    /// Two discs thrown along the ground without spin.
    #[derive(Clone, Debug)]
    struct Discs;

    include "../parts/wheel.lag";

    part Disc(mass, g) {
        param radius = 0.3;
        coord x, spin;
        kinetic = 1/2 * mass * dot(x)^2 + 1/4 * mass * radius^2 * dot(spin)^2;
        wheel: Wheel { hub: x; spin: spin; load: mass * g; radius: radius; }
    }
    param g = 9.81;
    disc[i in 0..2]: Disc { mass: 2 + i; g: g; }
    emit { statements }
}

/// A disc slides until it has lost a third of its speed, for v / (3 μ g).
#[test]
fn discs_of_parts_in_parts_slide_until_they_roll() {
    let discs = Discs { disc_0_wheel_grip: 0.2, disc_1_wheel_grip: 0.1, ..Discs::default() };
    let speeds = [3.0, 1.5];
    let start = DiscsState {
        disc_0_x: 0.0,
        disc_0_spin: 0.0,
        disc_1_x: 0.0,
        disc_1_spin: 0.0,
        disc_0_x_dot: speeds[0],
        disc_0_spin_dot: 0.0,
        disc_1_x_dot: speeds[1],
        disc_1_spin_dot: 0.0,
    };
    let run = discs.simulate(start).until(2.0).run().expect("a motion");
    let end = DiscsState::from(run.last());
    let distance = |v: f64, grip: f64| {
        let slide = v / (3.0 * grip * 9.81);
        v * slide - grip * 9.81 * slide * slide / 2.0 + 2.0 / 3.0 * v * (2.0 - slide)
    };
    for (speed, v) in [(end.disc_0_x_dot, speeds[0]), (end.disc_1_x_dot, speeds[1])] {
        assert!((speed - 2.0 / 3.0 * v).abs() < 1e-9, "{speed}");
    }
    for (x, expected) in [(end.disc_0_x, distance(speeds[0], 0.2)), (end.disc_1_x, distance(speeds[1], 0.1))]
    {
        assert!((x - expected).abs() < 1e-9, "{x} {expected}");
    }
    assert!((end.disc_0_spin_dot * 0.3 - end.disc_0_x_dot).abs() < 1e-12);
    assert!(Discs::STATEMENTS.contains("kinetic = 1/2 * (2 + 1) * dot(disc_1_x)^2"), "{}", Discs::STATEMENTS);
}

lagrange::system! {
    /// Tanks that drain by a valve, beside a cart.
    #[derive(Clone, Debug)]
    struct Plant;

    part Tank(inflow) {
        param area[2]: m^2 = [2, 1];
        coord gate: m = 0.5;
        coord flap[2]: rad;
        state level[2]: m = 1;
        solve depth: m: 0 = depth^2 - level[0] * level[1], start: level[0];
        kinetic = 1 [kg] * dot(gate)^2 + 1 [kg*m^2] * inner(dot(flap), dot(flap));
        for i in 0..2 {
            dot(level[i]) = (inflow - 2 [m^2/s] * depth) / area[i];
        }
    }
    tank[i in 0..2]: Tank { inflow: -0.5 [m^3/s] * i; }
    coord cart: m;
    kinetic = 1 [kg] * dot(cart)^2;
}

/// Indices of placements precede the name of a member, and a rate has the unit of its coordinate
/// per second.
#[test]
fn rates_of_members_have_their_names_and_units() {
    let run = Plant::default().simulate(Plant::default().start()).until(0.1).run().expect("a motion");
    let units = [
        ("tank[1].gate", "m"),
        ("tank[0].gate_dot", "m/s"),
        ("tank[1].flap[0]", "rad"),
        ("tank[1].flap_dot[1]", "rad/s"),
        ("tank[0].level[1]", "m"),
        ("cart_dot", "m/s"),
    ];
    for (column, unit) in units {
        assert_eq!((run.column(column).is_some(), run.unit(column)), (true, Some(unit)), "{column}");
    }
}

#[test]
fn errors_name_unknowns_of_members_as_they_are_written() {
    let run = Plant::default().simulate(Plant::default().start()).until(9.0).run();
    let message = run.expect_err("the second tank runs dry").to_string();
    assert!(message.contains("there is no solution for `tank[1].depth`"), "{message}");
}
