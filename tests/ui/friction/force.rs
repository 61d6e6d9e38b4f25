lagrange::system! {
    struct Forces;

    coord x, y;
    kinetic = 1/2 * (dot(x)^2 + dot(y)^2);
    event floor = y, falling => impact(0);
    friction slide = dot(x), 0.3 * floor;
    force x = -slide;
    potential = floor * y;
    constraint held = x - slide;
    event slips = slide - 1, rising => stop;
    event jump = x, rising => { dot(y) = floor; };
    stabilise = floor;
    output forces = (slide, floor);
    reduce Flat { freeze y = slide; }
}

lagrange::system! {
    struct Whole;

    coord x, y;
    kinetic = 1/2 * (dot(x)^2 + dot(y)^2);
    friction slide = dot(x), 0.3;
    reduce Plane { freeze y = 0; }
}

fn main() {}
