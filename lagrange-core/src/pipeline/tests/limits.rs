//! Limits shared by several kinds of statements.

use crate::limits::MAX_EVENTS;
use crate::pipeline::parse;

#[test]
fn dry_friction_counts_as_an_event_and_smooth_friction_does_not() {
    let point = "coord x; kinetic = 1/2 * dot(x)^2; ";
    let events = |count: usize| -> String {
        (0..count).map(|i| format!("event e{i} = x - {i}, rising => record;")).collect()
    };
    let (dry, smooth) = ("friction dry = dot(x), 1;", "friction smooth = dot(x), 1, smooth: 1;");
    for friction in [dry, smooth] {
        let text = format!("{point} {friction} {}", events(MAX_EVENTS));
        assert!(parse(&text).is_ok(), "{text}");
        let text = format!("{point} {} {friction}", events(MAX_EVENTS + 1));
        let report = parse(&text).expect_err("too many events").to_string();
        assert!(report.contains(&format!("a system can have at most {MAX_EVENTS} events")), "{report}");
    }
}
