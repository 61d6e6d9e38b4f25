lagrange::system! {
    struct Arm;

    coord x, y;
    kinetic = kinetic_energy(1, dot((x, y)));
    emit { prepared }
    reduce ArmPrepared { freeze x = 0; }
}

fn main() {}
