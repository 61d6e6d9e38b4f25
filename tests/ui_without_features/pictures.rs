use lagrange::draw::Drawing;

lagrange::system! {
    struct Sled;

    coord x;
    body runner { mass: 2; center: (x, 0); shape: disk(1); }
    emit { drawing }
}

fn main() {
    let sled = Sled::default();
    let picture = Drawing::of(&sled).at(0.0, &[0.0, 0.0]).unwrap();
    picture.save("sled.svg").unwrap();
}
