lagrange::system! {
    struct Cart;

    coord x;
    kinetic = 1/2 * dot(x)^2;
    emit { mas_matrix, no enery, plot, hessian }
}

fn main() {}
