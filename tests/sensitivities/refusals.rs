//! Errors of motions without derivatives.

use lagrange::Simulate;
use lagrange::integrate::StepFailure;
use lagrange::system::{Action, Direction};

lagrange::system! {
    /// A mass pushed by a force from some time on.
    #[derive(Clone, Debug)]
    struct Pushed;
    param m = 1.0, from = 0.5;
    coord x;
    input u;
    kinetic = 1/2 * m * dot(x)^2;
    force x = u + if t > from { 1 } else { 0 };
    emit { jacobian }
}

#[test]
fn an_unknown_name_lists_the_known_ones() {
    let error = Pushed::default().simulate([0.0, 0.0]).until(1.0).sensitivities(["mass"]).run().unwrap_err();
    assert_eq!(
        error.to_string(),
        "there is no parameter, input or state `mass`; there are `m`, `from`, `u`, `x`, `x_dot` (at time 0.0)"
    );
}

#[test]
fn times_of_jumps_and_controllers_are_refused() {
    let run = || Pushed::default();
    let moved = run().simulate([0.0, 0.0]).until(1.0).sensitivities(["from"]).run().unwrap_err();
    assert!(moved.to_string().starts_with("the equations jump at times that depend on `from`"), "{moved}");
    assert!(run().simulate([0.0, 0.0]).until(1.0).sensitivities(["m"]).run().is_ok());
    let pushed = run();
    let sampled =
        pushed.simulate([0.0, 0.0]).until(1.0).sampled(0.1, |_: &Pushed, _, _| PushedInputs { u: 1.0 });
    let error = sampled.sensitivities(["m"]).run().unwrap_err();
    assert!(error.to_string().contains("sampled controllers"), "{error}");
    let twice = pushed.simulate([0.0, 0.0]).until(1.0).sensitivities(["m", "m"]).run().unwrap_err();
    assert!(twice.to_string().starts_with("two columns are called `d(x)/d(m)`"), "{twice}");
}

lagrange::system! {
    /// A mass on a spring without a load.
    #[derive(Clone, Debug)]
    struct Swing;
    param k = 1.0;
    coord x;
    kinetic = 1/2 * dot(x)^2;
    potential = 1/2 * k * x^2;
    emit { jacobian }
}

/// The wall exists for one stiffness only.
#[test]
fn a_reaction_that_is_not_smooth_is_refused_by_name() {
    let swing = Swing::default();
    let run = swing.simulate([0.0, 1.5]).until(2.0).event_with(
        "wall",
        Direction::Rising,
        |_, _, [x, _]| x - 1.0,
        |swing, event| match swing.k == 1.0 {
            true => Action::Replace([event.state[0], -event.state[1]]),
            false => Action::Continue,
        },
    );
    let error = run.sensitivities(["x", "k"]).run().unwrap_err();
    assert!(matches!(error.cause, StepFailure::NotDifferentiable { variable: "k", .. }), "{error}");
    let text = error.to_string();
    assert!(
        text.starts_with("the motion after event `wall` has no derivative with respect to `k`"),
        "{text}"
    );
    assert!((error.time() - (1.0_f64 / 1.5).asin()).abs() < 1e-12);
}

/// Runs that only record events, or end at one, need no derivatives of them.
#[test]
fn events_without_a_reaction_leave_derivatives_alone() {
    let swing = Swing::default();
    let value = |_: &Swing, _, [x, _]: &[f64; 2]| x - 1.0;
    let run = || swing.simulate([0.0, 1.5]).until(2.0).tolerance(1e-12);
    let plain = run().sensitivities(["k"]).run().unwrap();
    let watched = run().event("wall", Direction::Rising, value).sensitivities(["k"]).run().unwrap();
    let [plain, watched] = [plain, watched].map(|motion| motion.sensitivities(motion.len() - 1).unwrap()[0]);
    assert!((plain[0] - watched[0]).abs() < 1e-10 && (plain[1] - watched[1]).abs() < 1e-10);
    let stopped = run().stop_at("wall", Direction::Rising, value).sensitivities(["k"]).run().unwrap();
    // x = v sin(w t)/w with w = √k, differentiated with respect to k at a fixed time.
    let t = stopped.end_time();
    let exact = 1.5 * (0.5 * t * t.cos() - 0.5 * t.sin());
    assert!((stopped.column("d(x)/d(k)").unwrap().last().unwrap() - exact).abs() < 1e-10);
}
