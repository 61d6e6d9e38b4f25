lagrange::system! {
    struct Rod;

    coord x;
    body rod { mass: 1; center: (x, 0); }
    output rod_motion = x;
    emit { motion, drawing, statements }
}

lagrange::system! {
    struct Held;

    coord x, y;
    body redundant { mass: 1; center: (x, y); }
    constraint wall = x;
    emit { motion, drawing, statements }
}

fn main() {
    // Requested items exist nevertheless.
    let motion = Held::default().redundant_motion(0.0, &[0.0; 2], &[0.0; 2]);
    lagrange::scene::Scene::items(&Held::default(), 0.0, &motion.center, &motion.velocity, &mut |_| {});
    println!("{}", Held::STATEMENTS);
    lagrange::scene::Scene::items(&Rod::default(), 0.0, &[0.0], &[0.0], &mut |_| {});
}
