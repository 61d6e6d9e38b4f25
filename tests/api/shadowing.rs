//! Systems in a scope where every name that generated code could use has another meaning.
#![allow(dead_code, non_camel_case_types, unused_macros, reason = "what shadows is there to be ignored")]

mod core {}
mod std {}
mod lagrange {}
mod private {}
mod scalar {}

type f64 = u8;
type f32 = u8;
type str = u8;
type usize = u8;

struct Option;
struct Result;
struct Some;
struct None;
struct Ok;
struct Err;
struct PhantomData;
struct Scalar;
struct G;
static L: bool = true;

trait Default {}
trait From {}
trait Into {}
trait Clone {}
trait Copy {}
trait Debug {}
trait PartialEq {}
trait Add {}
trait OdeSystem {}
trait MechanicalSystem {}
trait EnergyFunction {}
trait ConstrainedSystem {}
trait ContactSystem {}
struct Contact;
struct Friction;
struct Terms;
struct Mode;

/// Methods that shadow those of plain numbers and of every system.
trait Shadow: Sized {
    fn sin(self) -> u8 {
        0
    }
    fn sin_cos(self) -> u8 {
        0
    }
    fn sqrt(self) -> u8 {
        0
    }
    fn powi(self, _: i32) -> u8 {
        0
    }
    fn multiply_add(self, _: u8, _: u8) -> u8 {
        0
    }
    fn acceleration(self) -> u8 {
        0
    }
    fn rhs(&self) -> u8 {
        0
    }
    fn energy(&self) -> u8 {
        0
    }
    fn add(self, _: u8) -> u8 {
        0
    }
    fn neg(self) -> u8 {
        0
    }
    fn into(self) -> u8 {
        0
    }
    fn zip(self, _: u8) -> u8 {
        0
    }
    fn terms(&self) -> u8 {
        0
    }
    fn modes(&self) -> u8 {
        0
    }
    fn reactions(&self) -> u8 {
        0
    }
    fn multipliers(&self) -> u8 {
        0
    }
    fn event_values(&self) -> u8 {
        0
    }
}

impl<T> Shadow for T {}

fn sin(_: u8) {}
fn cos(_: u8) {}
fn sin_cos(_: u8) {}
fn sqrt(_: u8) {}
fn powi(_: u8) {}
fn multiply_add(_: u8) {}
fn theta() {}
fn sin_theta() {}
fn self_() {}

macro_rules! compile_error {
    ($($anything:tt)*) => { nonsense! };
}
macro_rules! unreachable {
    ($($anything:tt)*) => { nonsense! };
}
macro_rules! system {
    ($($anything:tt)*) => { nonsense! };
}

::lagrange::system! {
    #[derive(::core::clone::Clone)]
    pub struct Pendulum;

    param m = 1.0, L = 2.0, G = 9.81, c = sqrt(2);
    coord theta, phi;
    kinetic = 1/2 * m * L^2 * (dot(theta)^2 + sin(theta)^2 * dot(phi)^2);
    potential = m * G * L * cos(theta) + if phi < 0 { c * phi } else { 0 };
    output x = (L * sin(theta) * cos(phi), L^3 * (1 + theta^2)^0.5, sqrt(theta));
    emit { bias, latex }
    reduce Meridian { freeze phi = sqrt(L); small theta = 1/2; }
}

::lagrange::system! {
    pub struct Any<S>;

    param m = 1.0, L = 2.0, G = 9.81;
    coord theta;
    kinetic = 1/2 * m * L^2 * dot(theta)^2;
    potential = m * G * L * cos(theta) + if theta < 0 { theta } else { 0 };
    reduce AnyNear { small theta = G; }
}

::lagrange::system! {
    #[scalar(f32)]
    pub struct Unused;

    param unused = 1.0, _unused = 1.0;
    coord theta;
    kinetic = 1/2 * unused * dot(theta)^2;
}

::lagrange::system! {
    #[derive(::core::clone::Clone)]
    pub struct Touching;

    param values = 1.0, terms = 0.5, modes = 1.0, state = 9.81, event_functions = 0.1, G = 2.0;
    coord x, y, z, L;
    kinetic = 1/2 * values * (dot(x)^2 + dot(y)^2 + dot(z)^2 + dot(L)^2);
    potential = values * state * y;
    constraint reactions = z - x;
    constraint multipliers = G * dot(L) - dot(x);
    event react = y, falling => impact(terms);
    event begin = x - modes, rising => { dot(x) = -event_functions * dot(x); z = x; }
    event correct = z - G, crossing => stop;
    friction friction = dot(x), event_functions * react;
    friction mode = dot(x), event_functions * react, smooth: terms;
    output events = (react, friction, mode);
    output both = reactions + multipliers;
}

::lagrange::system! {
    pub struct AnyTouching<S>;

    param G = 9.81;
    coord x;
    kinetic = 1/2 * dot(x)^2;
    potential = G * x;
    event T = x, falling => impact(0);
    event U = x - G, rising => { x = 0; }
}

#[test]
fn names_of_the_surroundings_are_not_taken_for_others() {
    let pendulum = <Pendulum as ::core::default::Default>::default();
    let a = Pendulum::acceleration(&pendulum, 0.0, &[0.5, 0.0], &[0.0, 1.0]);
    let expected = 9.81 / 2.0 * ::core::primitive::f64::sin(0.5) + ::core::primitive::f64::sin(1.0) / 2.0;
    crate::assert_close(a[0], expected);
    let any = Any { m: 1.0, L: 2.0, G: 9.81, switches: ::lagrange::event::Switches::FREE };
    crate::assert_close(
        Any::acceleration(&any, 0.0, &[0.5], &[0.0])[0],
        9.81 / 2.0 * ::core::primitive::f64::sin(0.5),
    );
    let touching = <Touching as ::core::default::Default>::default();
    let a = Touching::acceleration(&touching, 0.0, &[0.5, 1.0, 0.5, 0.0], &[0.0; 4]);
    crate::assert_close(a[1], -9.81);
    let any = AnyTouching::<::core::primitive::f64> { G: 9.81, T: ::core::default::Default::default() };
    crate::assert_close(AnyTouching::acceleration(&any, 0.0, &[0.5], &[0.0])[0], -9.81);
}
