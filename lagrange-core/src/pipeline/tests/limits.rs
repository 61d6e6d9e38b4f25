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
    for text in [format!("{smooth} {}", events(MAX_EVENTS)), format!("{dry} {}", events(MAX_EVENTS - 1))] {
        assert!(parse(&format!("{point}{text}")).is_ok(), "{text}");
    }
    // Where there are too many, all dry friction shares one event.
    for (text, most) in [
        (events(MAX_EVENTS + 1), MAX_EVENTS),
        (format!("{dry} {}", events(MAX_EVENTS)), MAX_EVENTS - 1),
        (format!("{} {dry}", events(MAX_EVENTS)), MAX_EVENTS - 1),
    ] {
        let report = parse(&format!("{point}{text}")).expect_err("too many events").to_string();
        assert!(report.contains(&format!("a system can have at most {most} events")), "{report}");
    }
}
