//! Diagnostics for white noise.

use lagrange_expr::diagnostics::messages;

messages! {
    pub(in crate::elaborate):

    DENSITY = "a spectral density";
    DENSITY_HELP =
        "write a number that is not negative, or an expression of parameters, time and the state: `noise w, density: 2 * c * kT;`";
    NEGATIVE = "a spectral density must not be negative";
    too_many(most) = "a system may have at most {most} noises";
    TOO_MANY_HELP = "add independent noises up: the density of their sum is the sum of their densities";
    NONLINEAR = "noise must act linearly";
    NONLINEAR_HELP =
        "white noise has no square and no other function: multiply it by what does not depend on noise, `force x = size * w;`";
    misplaced(name) = "the noise `{name}` has no values here";
    MISPLACED_HELP =
        "white noise acts through forces and rates only: `force x = w;`, `dot(a) = -a + w;`; make it a `state` to see it filtered";
    rate(name) = "the noise `{name}` has no rate";
    in_momentum(name) =
        "a velocity is multiplied by the state `{name}`, and a momentum would have the noise in its rate";
    IN_MOMENTUM_HELP =
        "let noise drive a second state, and make the rate of this one a function of it";
    beside_noise(name) = "noise cannot act beside `{name}`";
    DECLARED_HERE = "the noise is declared here";
    CONSTRAINED_HELP =
        "declare coordinates that satisfy the constraint, or an `input` with values of `Random::white`";
    TOUCHING_HELP =
        "contacts and friction take forces with values: declare an `input` with values of `Random::white`";
    REDUCED_HELP = "declare the reduced system in a separate `lagrange::system!`";
}
