lagrange::system! {
    struct WithoutAccelerations;

    coord x;
    let T = 1/2 * dot(x)^2;
    kinetic = T;
    gibbs = 1/2 * dot(x)^2, for: T;
}

lagrange::system! {
    struct OfHighDegree;

    coord x;
    let T = 1/2 * dot(x)^2;
    kinetic = T;
    gibbs = ddot(x)^3, for: T;
    gibbs = sin(ddot(x)), for: T;
}

lagrange::system! {
    struct ForAccelerations;

    coord x;
    kinetic = 1/2 * dot(x)^2;
    gibbs = 1/2 * ddot(x)^2, for: ddot(x);
}

lagrange::system! {
    struct ForNothing;

    coord x;
    kinetic = 1/2 * dot(x)^2;
    gibbs = 1/2 * ddot(x)^2;
    gibbs = 1/2 * ddot(x)^2 for x;
    gibbs = 1/2 * ddot(x)^2, for x;
}

lagrange::system! {
    struct OfAForce;

    coord x, y;
    let T = 1/2 * (dot(x)^2 + dot(y)^2);
    kinetic = T;
    constraint wall = x;
    gibbs = 1/2 * (ddot(x)^2 + ddot(y)^2) + wall * ddot(x), for: T;
}

fn main() {}
