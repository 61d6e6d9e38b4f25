//! Elementary functions of jets, by textbook derivatives (Abramowitz and Stegun, *Handbook of
//! Mathematical Functions*, chapter 4).

use lagrange_core::expr::Function;
use lagrange_core::number::Number;

use crate::digits::Real;
use crate::jet::{Field, Jet};

impl Field {
    /// Returns a rational power.
    pub(crate) fn power(&mut self, a: &Jet, exponent: &Number) -> Jet {
        let base = &a.value[0];
        if base.is_zero() && exponent.to_i32().is_none() {
            return self.without_slope(a);
        }
        let mut factor = self.integer(1);
        let mut exponent = exponent.clone();
        let derivatives = [0; 4].map(|_| {
            let derivative = if factor.is_zero() {
                self.integer(0)
            } else {
                let power = self.arithmetic.power(base, &exponent);
                let power = self.rounded(power);
                self.product(&factor, &power)
            };
            let number = self.arithmetic.number(&exponent);
            factor = self.product(&factor, &number);
            exponent = &exponent - &Number::ONE;
            derivative
        });
        self.compose(a, &derivatives)
    }

    /// Returns zero without derivatives, as for a root of zero.
    fn without_slope(&self, a: &Jet) -> Jet {
        let nothing = |series: &Vec<Real>| series.iter().map(|_| Real::nan(None)).collect::<Vec<_>>();
        let mut root =
            Jet { value: nothing(&a.value), variations: a.variations.iter().map(nothing).collect() };
        root.value[0] = self.integer(0);
        root
    }

    pub(crate) fn sqrt(&mut self, a: &Jet) -> Jet {
        self.power(a, &Number::HALF)
    }

    /// Returns √(Σ aᵢ²).
    pub(crate) fn norm(&mut self, a: &[Jet]) -> Jet {
        let square = self.dot(a, a);
        self.sqrt(&square)
    }

    /// Returns the value of an elementary function of one or two arguments.
    pub(crate) fn call(&mut self, function: Function, arguments: &[Jet]) -> Jet {
        let a = &arguments[0];
        match function {
            Function::Sqrt => self.sqrt(a),
            Function::Hypot => self.norm(arguments),
            Function::Power => {
                let logarithm = self.call(Function::Ln, &arguments[..1]);
                let exponent = self.multiply(&logarithm, &arguments[1]);
                self.call(Function::Exp, &[exponent])
            }
            Function::Atan2 => self.direction(a, &arguments[1]),
            Function::Min | Function::Max => {
                let least = function == Function::Min;
                let order = a.value[0].cmp(&arguments[1].value[0]).unwrap_or(0);
                let is_first = if least { order < 0 } else { order > 0 };
                if is_first { a.clone() } else { arguments[1].clone() }
            }
            _ => {
                let derivatives = self.derivatives(function, &a.value[0]);
                self.compose(a, &derivatives)
            }
        }
    }

    /// Returns the angle of (x, y): its present value, plus the angle from there.
    fn direction(&mut self, y: &Jet, x: &Jet) -> Jet {
        let now = self.function(Function::Atan2, &[y.value[0].clone(), x.value[0].clone()]);
        let [fixed_x, fixed_y] = [x, y].map(|side| self.series(&side.value[..1]));
        let along = self.dot(&[x.clone(), y.clone()], &[fixed_x.clone(), fixed_y.clone()]);
        let fixed_y = self.negate(&fixed_y);
        let across = self.dot(&[x.clone(), y.clone()], &[fixed_y, fixed_x]);
        let tangent = self.divide(&across, &along);
        let turn = self.call(Function::Atan, &[tangent]);
        let now = self.series(&[now]);
        self.add(&now, &turn)
    }

    fn derivatives(&mut self, function: Function, x: &Real) -> [Real; 4] {
        let f = self.function(function, std::slice::from_ref(x));
        let one = self.integer(1);
        match function {
            Function::Sin | Function::Cos => {
                let co = if function == Function::Sin { Function::Cos } else { Function::Sin };
                let other = self.function(co, std::slice::from_ref(x));
                let slope = if function == Function::Sin { other } else { other.neg() };
                [f.clone(), slope.clone(), f.neg(), slope.neg()]
            }
            Function::Sinh | Function::Cosh => {
                let co = if function == Function::Sinh { Function::Cosh } else { Function::Sinh };
                let other = self.function(co, std::slice::from_ref(x));
                [f.clone(), other.clone(), f, other]
            }
            Function::Exp => [f.clone(), f.clone(), f.clone(), f],
            Function::Ln => {
                let inverse = self.quotient(&one, x);
                let square = self.product(&inverse, &inverse);
                let third = self.polynomial(&[0, 2], &inverse);
                let third = self.product(&third, &square);
                [f, inverse, square.neg(), third]
            }
            // t' = 1 ± t², t'' = ± 2 t t', t''' = ± 2 t'² + 4 t² t'
            Function::Tan | Function::Tanh => {
                let sign = if function == Function::Tan { 1 } else { -1 };
                let slope = self.polynomial(&[1, 0, sign], &f);
                let twice = self.polynomial(&[0, 2 * sign], &f);
                let second = self.product(&twice, &slope);
                let factor = self.polynomial(&[2 * sign, 0, 6], &f);
                let third = self.product(&factor, &slope);
                [f, slope, second, third]
            }
            // w = (1 − x²)^(−1/2), w' = x w³, w'' = (1 + 2 x²) w⁵
            Function::Asin | Function::Acos => {
                let rest = self.polynomial(&[1, 0, -1], x);
                let root = self.function(Function::Sqrt, std::slice::from_ref(&rest));
                let w = self.quotient(&one, &root);
                let second = self.product(x, &w);
                let second = self.quotient(&second, &rest);
                let third = self.polynomial(&[1, 0, 2], x);
                let square = self.product(&rest, &rest);
                let third = self.quotient(&third, &square);
                let third = self.product(&third, &w);
                let slopes = [w, second, third];
                let [w, second, third] =
                    if function == Function::Asin { slopes } else { slopes.map(|slope| slope.neg()) };
                [f, w, second, third]
            }
            // w = 1/(1 + x²), w' = −2 x w², w'' = (6 x² − 2) w³
            Function::Atan => {
                let denominator = self.polynomial(&[1, 0, 1], x);
                let w = self.quotient(&one, &denominator);
                let [square, twice] = [self.product(&w, &w), self.polynomial(&[0, -2], x)];
                let second = self.product(&twice, &square);
                let factor = self.polynomial(&[-2, 0, 6], x);
                let cube = self.product(&square, &w);
                [f, w, second, self.product(&factor, &cube)]
            }
            Function::Abs => {
                let sign = self.arithmetic.call(Function::Sign, std::slice::from_ref(x));
                // At the kink itself the slope is zero, and has no slope.
                let bend = if x.is_zero() { Real::nan(None) } else { self.integer(0) };
                [f, sign, bend.clone(), bend]
            }
            _ => [f, self.integer(0), self.integer(0), self.integer(0)],
        }
    }

    /// Returns Σ cₖ xᵏ by Horner's rule.
    fn polynomial(&mut self, coefficients: &[i32], x: &Real) -> Real {
        let zero = self.integer(0);
        coefficients.iter().rev().fold(zero, |sum, &coefficient| {
            let product = self.product(&sum, x);
            self.sum(&product, &self.integer(coefficient))
        })
    }
}
