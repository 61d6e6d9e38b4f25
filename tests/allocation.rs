//! No method allocates memory while stepping, as microcontrollers and game loops require.
//!
//! These tests have their own binary, since it replaces the allocator.

use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;

use lagrange::integrate::{
    BlanesMoan4, GaussLegendre4, GaussLegendre6, ImplicitMidpoint, Method, RungeKutta4, Stepper,
    StormerVerlet, SymplecticEuler, Variational, Verner98, integrate,
};
use lagrange::scene::{Item, Scene};

lagrange::system! {
    /// A point mass on a massless rod.
    #[derive(Clone, Debug)]
    struct Pendulum;

    param g = 9.81;
    coord theta;
    kinetic = 1/2 * dot(theta)^2;
    potential = -g * cos(theta);
    emit { jacobian, momentum_rates }
}

lagrange::system! {
    /// A block that bounces to rest on a rough floor.
    struct Block;

    param g = 9.81, mu = 0.3;
    coord x, y;
    kinetic = 1/2 * (dot(x)^2 + dot(y)^2);
    potential = g * y;
    event floor = y, falling => impact(1/2);
    friction rub = dot(x), mu * floor;
}

lagrange::system! {
    /// A rod on a hinge.
    struct Rod;

    param l = 1.0;
    coord x, y, a;
    gravity = (0, -9.81);
    body rod { mass: 2; shape: polygon((0, 0), (l, 0), (0, l)); center: (x, y); angle: a; }
    pin rod to (0, 0);
    emit { motion, drawing }
}

thread_local! {
    static REQUESTS: Cell<u64> = const { Cell::new(0) };
}

/// The allocator of the platform, with a count of the requests in each thread.
struct Counting;

// SAFETY: all requests reach the allocator of the platform unchanged.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        REQUESTS.set(REQUESTS.get() + 1);
        // SAFETY: the caller's promises are passed on.
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, place: *mut u8, layout: Layout) {
        // SAFETY: the caller's promises are passed on.
        unsafe { System.dealloc(place, layout) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

/// Counts memory requests from the start on, over steps and the states between them.
fn requests(method: &impl Method<Pendulum>) -> u64 {
    let pendulum = Pendulum::default();
    let before = REQUESTS.get();
    let mut stepper = method.start(&pendulum, 0.0, &[1.0, 0.0], 1.0).expect("starts");
    while stepper.time() < 1.0 {
        stepper.step(&pendulum, 1.0).expect("goes on");
        let middle = 0.5 * (stepper.last_time() + stepper.time());
        assert!(stepper.interpolate(&pendulum, middle)[0].is_finite());
    }
    REQUESTS.get() - before
}

#[test]
fn bodies_and_pictures_ask_for_no_memory() {
    let (rod, before) = (Rod::default(), REQUESTS.get());
    let mut sum = rod.rod_motion(0.0, &[1.0, 0.5, 0.2], &[0.3, 0.1, 2.0]).kinetic_energy();
    rod.items(0.0, &[1.0, 0.5, 0.2], &[0.3, 0.1, 2.0], &mut |item| match item {
        Item::Body { motion, parts, .. } => sum += motion.moment_about([0.0; 2]) + parts.len() as f64,
        Item::Force { force: [x, y], .. } => sum += x + y,
        _ => {}
    });
    assert!(sum.is_finite());
    assert_eq!(REQUESTS.get() - before, 0);
}

#[test]
fn the_counter_counts() {
    let before = REQUESTS.get();
    drop(std::hint::black_box(Box::new(1)));
    assert_eq!(REQUESTS.get() - before, 1);
}

#[test]
fn no_method_asks_for_memory() {
    let step = 0.01;
    assert_eq!(requests(&SymplecticEuler { step }), 0);
    assert_eq!(requests(&StormerVerlet { step }), 0);
    assert_eq!(requests(&BlanesMoan4 { step }), 0);
    assert_eq!(requests(&RungeKutta4 { step }), 0);
    assert_eq!(requests(&Verner98::tolerance(1e-9)), 0);
    assert_eq!(requests(&ImplicitMidpoint { step }), 0);
    assert_eq!(requests(&GaussLegendre4 { step }), 0);
    assert_eq!(requests(&GaussLegendre6 { step }), 0);
    assert_eq!(requests(&GaussLegendre4 { step }.plain()), 0);
    assert_eq!(requests(&Variational { step }), 0);
}

#[test]
fn contacts_and_friction_ask_for_no_memory() {
    let (before, mut jumps, mut last) = (REQUESTS.get(), 0, -1.0);
    let observe = |t, _: &[f64; 4]| {
        jumps += u32::from(t == last);
        last = t;
    };
    let method = Verner98::tolerance(1e-9);
    let end = integrate(&Block::default(), 0.0, [0.0, 1.0, 2.0, 0.0], 3.0, &method, observe);
    assert_eq!(REQUESTS.get() - before, 0);
    let [_, y, u, v] = end.expect("comes to rest");
    assert!(y.abs() < 1e-12 && u == 0.0 && v == 0.0, "at rest");
    assert!(jumps > 10, "{jumps}");
}
