//! Emitted types through the traits of `lagrange::system`.

use lagrange::Number;
use lagrange::integrate::{RungeKutta4, integrate};
use lagrange::system::{EnergyFunction, MechanicalSystem, OdeSystem};

lagrange::system! {
    struct Pendulum;

    param m = 1.0, l = 1.0, g = 9.81;
    coord theta;
    kinetic = 1/2 * m * (l * dot(theta))^2;
    potential = -m * g * l * cos(theta);
}

lagrange::system! {
    struct Planet<S>;

    param mu = 1.0;
    coord r, phi;
    kinetic = 1/2 * (dot(r)^2 + r^2 * dot(phi)^2);
    potential = -mu / r;
}

/// Returns the largest change of energy along a motion.
fn drift<T, const N: usize, const TWICE: usize>(system: &T, start: [T::Scalar; TWICE], end: f64) -> T::Scalar
where
    T: EnergyFunction<
            Coordinates = [<T as OdeSystem>::Scalar; N],
            Velocities = [<T as OdeSystem>::Scalar; N],
            State = [<T as OdeSystem>::Scalar; TWICE],
        >,
{
    let energy = |y: &[T::Scalar; TWICE]| {
        let (q, v) = y.split_at(N);
        let coordinates = |slice: &[T::Scalar]| core::array::from_fn(|i| slice[i]);
        system.energy(T::Scalar::ZERO, &coordinates(q), &coordinates(v))
    };
    let (first, mut largest) = (energy(&start), T::Scalar::ZERO);
    let observe = |_, y: &_| largest = largest.max((energy(y) - first).abs());
    let method = RungeKutta4 { step: T::Scalar::from_f64(end / 2000.0) };
    integrate(system, T::Scalar::ZERO, start, T::Scalar::from_f64(end), &method, observe)
        .expect("a finite motion");
    largest
}

#[test]
fn integrators_and_generic_code_take_any_system() {
    assert!(drift(&Pendulum::default(), [1.0, 0.0], 5.0) < 1e-8);
    assert!(drift(&Planet { mu: 1.0 }, [1.0, 0.0, 0.0, 1.1], 10.0) < 1e-9);
    assert!(drift(&Planet { mu: 1.0_f32 }, [1.0, 0.0, 0.0, 1.1], 10.0) < 1e-5);
}

#[test]
fn coordinates_are_known_by_name() {
    fn names<T: MechanicalSystem>(_: &T) -> &'static [&'static str] {
        T::COORDINATES
    }
    assert_eq!(names(&Planet { mu: 1.0_f32 }), ["r", "phi"]);
    assert_eq!(names(&Pendulum::default()), ["theta"]);
}

#[test]
fn traits_and_methods_agree() {
    fn through_traits<T: MechanicalSystem + OdeSystem>(system: &T, y: &T::State) -> T::State {
        system.rhs(T::Scalar::ZERO, y)
    }
    let pendulum = Pendulum::default();
    assert_eq!(through_traits(&pendulum, &[0.4, 0.2]), pendulum.rhs(0.0, &[0.4, 0.2]));
    let acceleration = MechanicalSystem::acceleration(&pendulum, 0.0, &[0.4], &[0.2]);
    assert_eq!(acceleration, pendulum.acceleration(0.0, &[0.4], &[0.2]));
}
