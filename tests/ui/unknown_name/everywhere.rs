lagrange::system! {
    struct CartPole;

    param mc = 1.0, mp = 0.1, l = 0.5, g = 9.81;
    coord x;
    let (px, py) = (x + l * sin(theta), -l * cos(theta));
    kinetic = 1/2 * mc * dot(x)^2 + 1/2 * mp * (dot(px)^2 + dot(py)^2);
    potential = mp * g * py + theta^2;
    force theta = -dot(theta);
}

fn main() {}
