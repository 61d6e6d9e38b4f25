lagrange::system! {

}

fn main() {}
