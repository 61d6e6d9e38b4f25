//! Messages about wrong files: line, element, mistake, remedy.

use lagrange_import::urdf::{Options, import};
use lagrange_import::{Mistake, listing};

use crate::files::{path, read};

/// Returns all messages about a file, without help.
pub(crate) fn said(text: &str) -> Vec<String> {
    match import(text, &Options::default()) {
        Ok(imported) => imported.warnings.iter().map(first_line).collect(),
        Err(mistakes) => mistakes.iter().map(first_line).collect(),
    }
}

fn first_line(mistake: &Mistake) -> String {
    mistake.to_string().lines().next().unwrap_or_default().to_owned()
}

pub(crate) const GOOD: &str = r#"<robot name="r">
<link name="base"/>
<link name="arm">
<inertial>
<origin xyz="0 0 0.1"/>
<mass value="1"/>
<inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/>
</inertial>
</link>
<joint name="q" type="revolute">
<origin xyz="0 0 1" rpy="0 0 0"/>
<parent link="base"/>
<child link="arm"/>
<axis xyz="0 0 1"/>
<limit lower="-1" upper="1" effort="1" velocity="1"/>
</joint>
</robot>
"#;

/// Replacements of one piece of the good file by another, with the resulting messages.
const EDITS: &[(&str, &str, &[&str])] = &[
    ("", "", &[]),
    (
        "<mass value=\"1\"/>",
        "<mass value=\"-1\"/>",
        &["6:1: error: link \"arm\", <mass>: the mass is negative"],
    ),
    ("<mass value=\"1\"/>", "", &["4:1: error: link \"arm\", <inertial>: <mass> is missing"]),
    (
        "<mass value=\"1\"/>",
        "<mass/>",
        &["6:1: error: link \"arm\", <mass>: the attribute `value` is missing"],
    ),
    (
        "<mass value=\"1\"/>",
        "<mass value=\"nan\"/>",
        &["6:7: error: link \"arm\", <mass>: `value` must be a number, but this is \"nan\""],
    ),
    (
        "<mass value=\"1\"/>",
        "<mass value=\"1e999\"/>",
        &["6:7: error: link \"arm\", <mass>: `value` must be a number, but this is \"1e999\""],
    ),
    (
        "<mass value=\"1\"/>",
        "<mass value=\"0\"/>",
        &["7:1: error: link \"arm\", <inertia>: there is inertia without mass"],
    ),
    (
        "<mass value=\"1\"/>",
        "<mass value=\"1\"/><mass value=\"2\"/>",
        &["6:18: error: link \"arm\", <mass>: this is repeated"],
    ),
    (
        "izz=\"1\"",
        "izz=\"2.1\"",
        &[
            "7:1: error: link \"arm\", <inertia>: these moments and products of inertia are physically impossible",
        ],
    ),
    ("izz=\"1\"", "", &["7:1: error: link \"arm\", <inertia>: the attribute `izz` is missing"]),
    ("0 0 0.1", "0 0", &["5:9: error: link \"arm\", <origin>: `xyz` must be three numbers, but these are 2"]),
    ("0 0 0.1", "0 0 x", &["5:9: error: link \"arm\", <origin>: `xyz` must be a number, but this is \"x\""]),
    (
        "<origin xyz=\"0 0 0.1\"/>",
        "<origin xzy=\"0 0 0.1\"/>",
        &[
            "5:9: error: link \"arm\", <origin>: the attribute `xzy` is unknown, and ignoring it may change the motion",
        ],
    ),
    (
        "<inertial>\n",
        "<inertail></inertail><inertial>\n",
        &[
            "4:1: error: link \"arm\", <inertail>: this element is unknown here, and ignoring it may change the motion",
        ],
    ),
    (
        "<inertial>\n",
        "<gravity>1</gravity><inertial>\n<gravity/>",
        &[
            "4:1: warning: link \"arm\", <gravity>: this element is unknown and ignored, here and in one more place",
        ],
    ),
    ("<parent link=\"base\"/>", "", &["10:1: error: joint \"q\": <parent> is missing"]),
    (
        "<child link=\"arm\"/>",
        "<child/>",
        &["13:1: error: joint \"q\", <child>: the attribute `link` is missing"],
    ),
    (
        "<parent link=\"base\"/>",
        "<parent link=\"Base\"/>",
        &["12:1: error: joint \"q\", <parent>: unknown parent link \"Base\""],
    ),
    (
        "<parent link=\"base\"/>",
        "<parent link=\"arm\"/>",
        &["10:1: error: joint \"q\": joints form a loop through link \"arm\", away from the base"],
    ),
    ("type=\"revolute\"", "type=\"revolut\"", &["10:1: error: joint \"q\": unknown joint type \"revolut\""]),
    ("type=\"revolute\"", "", &["10:1: error: joint \"q\": the attribute `type` is missing"]),
    (
        "<axis xyz=\"0 0 1\"/>",
        "<axis xyz=\"0 0 0\"/>",
        &["14:1: error: joint \"q\", <axis>: the axis is zero"],
    ),
    (
        "lower=\"-1\"",
        "lower=\"2\"",
        &["15:1: warning: joint \"q\", <limit>: the lower limit is above the upper one"],
    ),
    (
        "effort=\"1\"",
        "effort=\"much\"",
        &["15:29: error: joint \"q\", <limit>: `effort` must be a number, but this is \"much\""],
    ),
    (
        "</joint>",
        "<dynamics damping=\"-1\"/></joint>",
        &["16:1: error: joint \"q\", <dynamics>: the damping is negative, so the motion would gain energy"],
    ),
    (
        "</joint>",
        "<mimic joint=\"p\"/></joint>",
        &["16:1: error: joint \"q\", <mimic>: unknown joint \"p\" to mimic"],
    ),
    (
        "</joint>",
        "<mimic joint=\"q\"/></joint>",
        &["16:1: error: joint \"q\", <mimic>: the joint mimics itself"],
    ),
    (
        "</joint>",
        "<mimic joint=\"p\"/></joint><link name=\"leg\"><inertial><mass value=\"1\"/>\
         <inertia ixx=\"1\" iyy=\"1\" izz=\"1\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/></inertial></link>\
         <joint name=\"p\" type=\"continuous\"><parent link=\"arm\"/><child link=\"leg\"/><mimic joint=\"q\"/></joint>",
        &[
            "16:1: error: joint \"q\", <mimic>: the joint mimics one that mimics it, directly or through others",
        ],
    ),
    (
        "</robot>",
        "<link name=\"arm\"/></robot>",
        &["17:1: error: link \"arm\": this name already belongs to the link in line 3"],
    ),
    (
        "</robot>",
        "<link name=\"b\"/></robot>",
        &[
            "17:1: error: link \"b\": no joint places this link, nor link \"base\" in line 2: only one can be the base",
        ],
    ),
    ("</robot>", "<link/></robot>", &["17:1: error: link \"\": it has no name"]),
    (
        "</robot>",
        "<joint name=\"p\" type=\"fixed\"><parent link=\"base\"/><child link=\"arm\"/></joint></robot>",
        &["17:51: error: joint \"p\", <child>: joint \"q\" in line 10 already places link \"arm\""],
    ),
    (
        "</robot>",
        "<joint name=\"q\" type=\"fixed\"><parent link=\"arm\"/><child link=\"b\"/></joint><link name=\"b\"/></robot>",
        &["17:1: error: joint \"q\": this name already belongs to the joint in line 10"],
    ),
    (
        "</robot>",
        "<link name=\"a\"/><link name=\"b\"/>\n<joint name=\"j\" type=\"fixed\"><parent link=\"a\"/><child link=\"b\"/></joint>\n<joint name=\"k\" type=\"fixed\"><parent link=\"b\"/><child link=\"a\"/></joint></robot>",
        &["18:1: error: joint \"j\": joints form a loop through link \"b\", away from the base"],
    ),
    (
        "</robot>",
        "<joint name=\"p\" type=\"fixed\"><parent link=\"arm\"/><child link=\"base\"/></joint></robot>",
        &["2:1: error: link \"base\": joints form a loop: every link is the child of one"],
    ),
    (
        "type=\"revolute\"",
        "type=\"fixed\"",
        &["2:1: error: link \"base\": nothing moves: there is no joint that moves a mass"],
    ),
    (
        "</link>",
        "<visual><geometry><box size=\"1 1 -1\"/></geometry></visual></link>",
        &["9:19: error: link \"arm\", <box>: `size` is negative"],
    ),
    (
        "</link>",
        "<visual><geometry><sphere/></geometry></visual></link>",
        &["9:19: error: link \"arm\", <sphere>: the attribute `radius` is missing"],
    ),
    ("</link>", "<visual/></link>", &["9:1: error: link \"arm\", <visual>: <geometry> is missing"]),
    (
        "<robot name=\"r\">",
        "<robot name=\"r\" xmlns:xacro=\"http://www.ros.org/wiki/xacro\"><xacro:arm/>",
        &["1:61: error: <arm>: this is a xacro file, from which URDF is generated"],
    ),
    ("<robot name=\"r\">", "<robot>", &["1:1: error: <robot>: the attribute `name` is missing"]),
    ("</link>", "</lonk>", &["9:1: error: expected 'link' tag, not 'lonk' at 9:1"]),
];

#[test]
fn mistakes_are_reported_with_line_and_element() {
    let wrong = EDITS.iter().filter_map(|(piece, other, expected)| {
        assert!(GOOD.contains(piece), "{piece}");
        let said = said(&GOOD.replacen(piece, other, 1));
        (said != *expected).then(|| format!("{other}\n  {said:?}\n  {expected:?}"))
    });
    let wrong = wrong.collect::<Vec<_>>();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn other_files_are_no_robots() {
    let cases = [
        ("", "1:1: error: the document does not have a root node"),
        ("robot", "1:1: error: unknown token at 1:1"),
        ("<sdf/>", "1:1: error: <sdf>: this is not a <robot>"),
        ("<robot name=\"r\"/>", "1:1: error: <robot>: the robot has no links"),
    ];
    for (text, expected) in cases {
        assert_eq!(said(text)[0], expected, "{text}");
    }
}

#[test]
fn every_mistake_of_a_file_is_reported() {
    let text = read("wrong.urdf");
    let mistakes = import(&text, &Options::default()).expect_err("all is wrong");
    let told = listing("wrong.urdf", &mistakes);
    if std::env::var_os("UPDATE_GOLDEN").is_some() {
        std::fs::write(path("wrong.mistakes"), &told).expect("written");
    }
    assert_eq!(told, read("wrong.mistakes"));
}
