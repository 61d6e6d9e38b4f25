//! Powers as methods and columns, along a motion that sticks and slips.

use lagrange::Simulate;
use lagrange::system::OutputSystem;

lagrange::system! {
    /// A block on a running belt, with a spring and a damper.
    #[derive(Debug)]
    struct Block;

    param m: kg = 1.5, k: N/m = 40, c: N*s/m = 0.5, belt: m/s = 0.3, limit: N = 3;
    coord x: m;
    input push: N = 1;
    start dot(x) = belt;
    kinetic = 1/2 * m * dot(x)^2;
    potential = spring_energy(k, x);
    dissipation = 1/2 * c * dot(x)^2;
    force x = push * cos(3 [1/s] * t);
    friction rub = dot(x) - belt, limit;
    emit { power }
}

#[test]
fn powers_of_a_block_on_a_belt_balance_while_it_sticks_and_slips() {
    let names = ["power_x", "power_rub", "power_dissipation", "power_balance"];
    assert_eq!(Block::OUTPUTS, names);
    assert_eq!(Block::default().power_dissipation(0.0, &[0.1], &[2.0]), -2.0);
    let block = Block::default();
    let run = block.simulate(block.start()).until(3.0).every(1e-3).tolerance(1e-11).energy().outputs();
    let run = run.run().unwrap();
    let [push, rub, lost, balance] = names.map(|name| run.column(name).unwrap());
    let (times, speed, energy) = (run.times(), run.x_dot(), run.column("energy").unwrap());
    assert!(balance.iter().all(|balance| balance.abs() < 1e-12));
    let mut sticking = 0;
    for (index, &speed) in speed.iter().enumerate() {
        let force = rub[index] / speed;
        if (speed - 0.3).abs() < 1e-12 {
            sticking += 1;
            let expected = 40.0 * run.x()[index] + 0.5 * 0.3 - (3.0 * times[index]).cos();
            assert!((force - expected).abs() < 1e-9, "{force} {expected}");
        } else if speed.abs() > 1e-6 {
            assert!((force - (0.3 - speed).signum() * 3.0).abs() < 1e-9, "{force}");
        }
    }
    assert!(sticking > 100 && sticking < speed.len() - 100, "{sticking} of {}", speed.len());
    // The trapezoidal rule. Intervals at the beginning of slipping or sticking have an error of 3 N
    // · 0.3 m/s · 1 ms.
    let power = |index: usize| push[index] + rub[index] + lost[index];
    let steps = 1..times.len();
    let supplied = steps.map(|i| (times[i] - times[i - 1]) * (power(i) + power(i - 1)) / 2.0).sum::<f64>();
    assert!((supplied - (energy[energy.len() - 1] - energy[0])).abs() < 5e-3, "{supplied}");
}

lagrange::system! {
    /// A driven and damped oscillator in any number type.
    struct Oscillator<S>;

    param m = 1.5, k = 40, c = 0.5;
    coord x;
    input push = 2;
    kinetic = 1/2 * m * dot(x)^2;
    potential = spring_energy(k, x);
    dissipation = 1/2 * c * dot(x)^2;
    force x = push;
    emit { power, lanes }
}

#[test]
fn powers_exist_in_every_number_and_beside_lanes() {
    let (double, single) = (Oscillator::<f64>::default(), Oscillator::<f32>::default());
    for speed in [-2.0, 0.0, 0.25_f32] {
        let wide = f64::from(speed);
        assert_eq!(double.power_x(0.0, &[0.1], &[wide]), 2.0 * wide);
        assert_eq!(single.power_x(0.0, &[0.1], &[speed]), 2.0 * speed);
        assert_eq!(double.power_dissipation(0.0, &[0.1], &[wide]), -0.5 * wide * wide);
        assert_eq!(single.power_dissipation(0.0, &[0.1], &[speed]), -0.5 * speed * speed);
        // The residual of the balance.
        assert!(double.power_balance(0.0, &[0.1], &[wide]).abs() < 1e-14);
        assert!(single.power_balance(0.0, &[0.1], &[speed]).abs() < 1e-5);
    }
}
