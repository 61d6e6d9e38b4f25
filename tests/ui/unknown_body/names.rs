lagrange::system! {
    struct Scene;

    param m = 1.0, l = 2.0, k = 3.0;
    coord x, a, b;
    spring { from: (0, 0); to: arm.point(l, 0); stiffness: k; }
    body arm { mass: m; origin: (x, 0); angle: a; shape: slender_rod(l); }
    body hand { mass: m; center: arm.point(l, 0); angle: b; shape: disk(l/10); }
    line wall { angle: b; on: amr; }
    force (1, 0) at hnad.point(0, 0);
    slide hand on wal;
    roll wall on hand;
    output speed = velocity(finger.point(0, 0));
    output reach = arm.tip;
    output gap = wall.distance(hand, arm);
}

fn main() {}
