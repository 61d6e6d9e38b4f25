use super::Number;

fn number(text: &str) -> Number {
    Number::parse_decimal(text).unwrap_or_else(|| panic!("{text} is a literal"))
}

#[test]
fn decimal_literals_are_exact() {
    assert_eq!(number("0.1"), Number::ratio(1, 10).expect("no zero"));
    assert_eq!(number("2.5e-3"), Number::ratio(1, 400).expect("no zero"));
    assert_eq!(number("1_000"), Number::from(1000));
    assert_eq!(&number("0.1") + &number("0.2"), number("0.3"));
    assert_eq!(number("9.81").to_f64(), 9.81);
    assert_eq!(number("1e400").to_f64(), f64::INFINITY);
    assert_eq!(number("1e-400").to_f64(), 0.0);
}

#[test]
fn texts_that_are_no_numbers_are_refused() {
    for text in ["", ".", "e5", "1.2.3", "0x10", "1e", "1e99999999999999999999", "1e1000000000"] {
        assert_eq!(Number::parse_decimal(text), None, "{text}");
    }
}

#[test]
fn arithmetic_leaves_machine_words_and_returns() {
    let large = Number::from(i64::MAX);
    let square = &large * &large;
    assert_eq!(square.to_string(), "85070591730234615847396907784232501249");
    let back = &square * &large.reciprocal().expect("not zero");
    assert_eq!(back, large);
    assert_eq!(&Number::from(i64::MIN) + &large, Number::MINUS_ONE);
    assert_eq!(-&-&Number::from(i64::MIN), Number::from(i64::MIN));
}

#[test]
fn powers_and_roots_are_exact_or_absent() {
    assert_eq!(Number::from(2).power(-3), Number::ratio(1, 8));
    assert_eq!(Number::ZERO.power(-1), None);
    assert_eq!(Number::from(10).power(1_000_000_000), None);
    assert_eq!(Number::MINUS_ONE.power(i32::MAX), Some(Number::MINUS_ONE));
    assert_eq!(number("2.25").exact_sqrt(), Some(number("1.5")));
    assert_eq!(Number::from(2).exact_sqrt(), None);
}

#[test]
fn common_divisors_have_the_sign_of_the_first() {
    for (p, q, expected) in
        [("4", "6", "2"), ("0.5", "0.75", "0.25"), ("4", "0", "4"), ("0", "3", "3"), ("1e30", "3e29", "1e29")]
    {
        let (p, q, expected) = (number(p), number(q), number(expected));
        assert_eq!(p.common_divisor(&q), expected);
        assert_eq!((-&p).common_divisor(&-&q), if p.is_zero() { expected } else { -&expected });
    }
}
