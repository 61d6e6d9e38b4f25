lagrange::system! {
    struct Pulled;

    coord x, y;
    kinetic = 1/2 * (dot(x)^2 + dot(y)^2);
    constraint rope = x^2 + y^2 - 1;
    force x = -rope;
    potential = rope * x;
    dissipation = rope * dot(x)^2;
    constraint other = x - rope;
    force (rope, 0) at (x, y);
    torque x on rope;
    output rate = dot(rope);
    output tension = rope;
}

fn main() {}
