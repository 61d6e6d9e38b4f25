lagrange::system! {
    pub struct CartPole;

    param mc = 1.0, mp = 0.1, l = 0.5, g = 9.81;
    coord x, theta;
    input u;

    let p = (x + l * sin(theta), -l * cos(theta));
    kinetic = 1/2 * mc * dot(x)^2 + kinetic_energy(mp, dot(p))
    potential = mp * g * p;
    force X = u;
    output tip = p;
    output swing = dot(thetta);
    emit { bias, latex }
}

fn main() {
    let cart = CartPole { l: 0.7, ..CartPole::default() };
    let (q, v) = ([0.0, 0.1], [0.0; 2]);
    let state = CartPoleState { x: 0.0, theta: 0.1, x_dot: 0.0, theta_dot: 0.0 };
    let y: [f64; 4] = state.into();
    let a: [f64; 2] = cart.acceleration(0.0, &q, &v);
    let _ = (cart.rhs(0.0, &y), cart.mass_matrix(0.0, &q)[1][1], cart.forcing(0.0, &q, &v));
    let _ = (cart.momenta(0.0, &q, &v), cart.inverse_dynamics(0.0, &q, &v, &a), cart.bias(0.0, &q, &v));
    let _ = cart.kinetic_energy(0.0, &q, &v) + cart.potential_energy(0.0, &q) + cart.energy(0.0, &q, &v);
    let [_, height] = cart.tip(0.0, &q, &v);
    let _ = height + cart.swing(0.0, &q, &v) + cart.l + cart.u;
    let _ = CartPole::EQUATIONS_LATEX.len();
    let _ = lagrange::integrate::rk4_step(&cart, 0.0, &y, 0.1);
}
