//! Zeros, infinities, NaN, the ends of the range, and text.

use lagrange_double::{Double, ParseDoubleError};
use lagrange_runtime::{Number, Scalar};

const EDGES: [f64; 16] = [
    0.0,
    -0.0,
    1.0,
    -1.0,
    0.5,
    -0.5,
    2.0,
    -2.0,
    3.0,
    -3.0,
    1.5,
    f64::INFINITY,
    f64::NEG_INFINITY,
    f64::NAN,
    1e5,
    -1e5,
];

fn same(found: Double, wanted: f64, what: &str) {
    let found = f64::from(found);
    let is_same = if wanted.is_nan() || found.is_nan() {
        wanted.is_nan() && found.is_nan()
    } else if wanted == 0.0 || wanted.is_infinite() {
        found == wanted && found.is_sign_negative() == wanted.is_sign_negative()
    } else {
        (found - wanted).abs() <= 4e-16 * wanted.abs()
    };
    assert!(is_same, "{what}: {found:?} instead of {wanted:?}");
}

#[test]
fn functions_have_the_zeros_and_infinities_of_doubles() {
    type Unary = (&'static str, fn(Double) -> Double, fn(f64) -> f64);
    let functions: [Unary; 13] = [
        ("sin", Number::sin, Number::sin),
        ("cos", Number::cos, Number::cos),
        ("tan", Number::tan, Number::tan),
        ("asin", Number::asin, Number::asin),
        ("acos", Number::acos, Number::acos),
        ("atan", Number::atan, Number::atan),
        ("sinh", Number::sinh, Number::sinh),
        ("cosh", Number::cosh, Number::cosh),
        ("tanh", Number::tanh, Number::tanh),
        ("exp", Number::exp, Number::exp),
        ("ln", Number::ln, Number::ln),
        ("sqrt", Number::sqrt, Number::sqrt),
        ("abs", Number::abs, Number::abs),
    ];
    for (name, double, plain) in functions {
        for x in EDGES {
            same(double(x.into()), plain(x), &format!("{name} {x:?}"));
        }
    }
}

#[test]
fn functions_of_two_numbers_have_the_zeros_and_infinities_of_doubles() {
    type Binary = (&'static str, fn(Double, Double) -> Double, fn(f64, f64) -> f64);
    let functions: [Binary; 9] = [
        ("+", |x, y| x + y, |x, y| x + y),
        ("-", |x, y| x - y, |x, y| x - y),
        ("*", |x, y| x * y, |x, y| x * y),
        ("/", |x, y| x / y, |x, y| x / y),
        ("atan2", Number::atan2, Number::atan2),
        ("hypot", Number::hypot, Number::hypot),
        ("powf", Number::powf, Number::powf),
        ("min", Number::min, Number::min),
        ("max", Number::max, Number::max),
    ];
    for (name, double, plain) in functions {
        for x in EDGES {
            for y in EDGES {
                same(double(x.into(), y.into()), plain(x, y), &format!("{x:?} {name} {y:?}"));
            }
        }
    }
}

#[test]
fn results_near_the_ends_of_the_range_are_as_good_as_doubles() {
    let sizes = [5e-324, 3e-310, 2.3e-308, 1e-300, 7e-290, 1e-150, 1e150, 3e300, 9e307, f64::MAX];
    for x in sizes {
        for y in sizes {
            let (a, b) = (Double::from(x), Double::from(y));
            same(a + b, x + y, "sum");
            same(a * b, x * y, "product");
            if x * y > 1e-307 || x * y == 0.0 {
                same(a / b, x / y, "quotient");
            }
            same(a.hypot(b), x.hypot(y), "length");
        }
        same(Double::from(x).sqrt(), x.sqrt(), "root");
        same(Double::from(x).ln(), x.ln(), "logarithm");
        same(Double::from(x).sin(), x.sin(), "sine");
    }
    for x in [709.7, 709.8, -708.0, -740.0, -745.2, 1e300, -1e300] {
        same(Double::from(x).exp(), x.exp(), "power");
    }
}

#[test]
fn text_is_read_and_written_to_the_full_width() {
    let read = |text: &str| text.parse::<Double>().expect("a number");
    for text in
        ["9.81", "0.1", "-0.00001234", "1e-9", "6.674301234567890123456789012345e-11", "1.5e300", "123456789"]
    {
        assert_eq!(read(text).to_string(), text.to_owned());
    }
    assert_eq!(read("0.1").parts(), (0.1, -5.551_115_123_125_783e-18));
    assert_eq!(Double::from(0.1).to_string(), "0.10000000000000000555111512312578");
    assert_eq!(read("00100.00"), Double::from(100.0));
    assert_eq!(read("1e99999999999999999999").parts().0, f64::INFINITY);
    assert_eq!(read("-1e-99999").to_string(), "-0");
    assert_eq!((read("inf").parts().0, read("-inf").to_string()), (f64::INFINITY, "-inf".to_owned()));
    assert!(!read("NaN").is_finite());
    for text in ["", ".", "-", "e5", "1e", "1e+", "1.2.3", "0x10", "1_000", "--1", "1 ", "abc", "é"] {
        assert_eq!(text.parse::<Double>(), Err(ParseDoubleError), "{text}");
    }
}

#[test]
fn comparisons_look_at_both_parts() {
    let (one, tiny) = (Double::ONE, Double::from(1e-30));
    assert!(one < one + tiny && one - tiny < one && one != one + tiny);
    assert_eq!((Double::NAN.partial_cmp(&one), one.partial_cmp(&Double::NAN)), (None, None));
    assert!(!Double::NAN.less_equal(one) && Double::NAN != Double::NAN);
    assert_eq!((one - tiny).floor_below(9), Some(0));
    assert_eq!((one + tiny).floor_below(9), Some(1));
    assert!((one + Double::epsilon()) - one == Double::epsilon());
    assert!((one - tiny).powf(Double::from(f64::INFINITY)) == Double::ZERO);
    assert!((one + tiny).powf(Double::from(f64::INFINITY)) == Double::from(f64::INFINITY));
}
