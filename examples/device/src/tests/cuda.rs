//! The text that CUDA compiles, as C with the keywords of CUDA defined away: a loop stands for the
//! threads.

use std::fmt::Write;
use std::path::Path;
use std::process::Command;

use lagrange::integrate::{Method, RungeKutta4, Stepper, Verner98};

lagrange::system! {
    struct Pendulum;
    param l = 0.5, g = 9.81;
    coord theta;
    kinetic = 1/2 * l^2 * dot(theta)^2;
    potential = -g * l * cos(theta);
    emit { kernel }
}

const WORDS: &str = "#define _GNU_SOURCE\n#include <math.h>\n#include <stdio.h>\n#define __CUDACC__\n#define __device__\n\
    #define __global__\n#define __forceinline__ inline\nstatic struct { unsigned int x; } blockIdx, blockDim = { 64 }, threadIdx;\n";

/// Returns a program for two motions by both methods, one after the other.
fn program() -> String {
    let mut calls = String::new();
    for (method, settings) in [("runge_kutta_4", "1e-3, 0.0, 0.0"), ("dormand_prince", "0.1, 1e-12, 1e-12")] {
        let call = format!(
            "{{ double y[] = {{ 0.3, 2.5, 0.0, 1.0 }}, p[] = {{ 0.5, 0.7, 9.81, 9.81 }}, t[] = {{ 0, 0 }}, controls[] = {{ 0, 0, 1e-4, 1e-4 }};\n\
             unsigned int taken[] = {{ 0, 0 }}, statuses[] = {{ 0, 0 }};\n\
             for (int call = 0; call < 100; call++)\n\
             for (threadIdx.x = 0; threadIdx.x < 64; threadIdx.x++)\n\
             lagrange_{method}(y, p, t, controls, taken, statuses, 2.0, {settings}, 2, 100, 100000);\n\
             printf(\"%u %u %.17g %.17g %.17g %.17g\\n\", statuses[0], statuses[1], y[0], y[2], y[1], y[3]); }}\n"
        );
        calls.push_str(&call);
    }
    let mut text = WORDS.to_owned();
    write!(
        text,
        "{}{}int main(void) {{\n{calls}return 0;\n}}\n",
        Pendulum::KERNEL_F64,
        include_str!("../methods.c")
    )
    .expect("a string");
    text
}

#[cfg(unix)]
#[test]
fn threads_one_after_the_other_compute_motions() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("target/tmp");
    std::fs::create_dir_all(&folder).expect("a folder");
    let (source, compiled) = (folder.join("cuda.c"), folder.join("cuda"));
    std::fs::write(&source, program()).expect("a file");
    let options = ["-O1", "-Wall", "-Wextra", "-Werror"];
    let output = Command::new("cc").args(options).arg("-o").args([&compiled, &source]).arg("-lm").output();
    let output = output.expect("a C compiler");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let printed = Command::new(compiled).output().expect("it starts").stdout;
    let printed = String::from_utf8(printed).expect("numbers");
    let mut lines = printed
        .lines()
        .map(|line| line.split(' ').map(|word| word.parse().expect("a number")).collect::<Vec<f64>>());
    let mut compare = |expected: [[f64; 2]; 2], tolerance: f64| {
        let found = lines.next().expect("a line for each method");
        assert_eq!(found[..2], [1.0, 1.0]);
        let agree = found[2..].iter().zip(expected.concat()).all(|(a, b)| (a - b).abs() <= tolerance);
        assert!(agree, "{found:?}, not {expected:?}");
    };
    let starts = [(0.5, [0.3, 0.0]), (0.7, [2.5, 1.0])];
    compare(starts.map(|(l, start)| end(&RungeKutta4 { step: 1e-3 }, l, start)), 1e-12);
    compare(starts.map(|(l, start)| end(&Verner98::tolerance(1e-13), l, start)), 1e-9);
}

/// Returns the end of the scalar code.
fn end(method: &impl Method<Pendulum>, l: f64, start: [f64; 2]) -> [f64; 2] {
    let pendulum = Pendulum { l, ..Pendulum::default() };
    let mut stepper = method.start(&pendulum, 0.0, &start, 2.0).expect("a start");
    while stepper.time() < 2.0 {
        stepper.step(&pendulum, 2.0).expect("a step");
    }
    *stepper.state()
}
