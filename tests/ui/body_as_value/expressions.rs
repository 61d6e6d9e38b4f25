lagrange::system! {
    struct Scene;

    param m = 1.0, l = 2.0, k = 3.0;
    coord x, y, a;
    body rod { mass: m; origin: (x, y); angle: a; shape: slender_rod(l); }
    line floor { through: (0, 0); }
    spring tie { from: (0, 1); to: rod; stiffness: k; rest: l; }
    slide foot = rod.point(l, 0) on floor;
    potential = k * rod;
    output height = rod - floor;
    output strain = tie / l;
    output load = foot;
    constraint held = rod.point(0, 0);
    force x = rod.angel;
}

fn main() {}
