#!/usr/bin/env python3
"""Jumps from names of a declaration and completes one, as an editor does: `tools/editor_check.py`

Speaks with rust-analyzer over its language server protocol, for a small crate in target/editor. Needs
`rustup component add rust-analyzer`.
"""

import json
import os
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
CRATE = ROOT / "target" / "editor"
MANIFEST = f'[package]\nname = "editor"\nedition = "2024"\n\n[workspace]\n\n[dependencies]\nlagrange = {{ path = "{ROOT}" }}\n'
TEXT = """lagrange::system! {
    pub struct CartPole;
    param m: kg = 0.1, l: m = 0.5, g: m/s^2 = 9.81;
    coord x: m, theta: rad;
    input u: N;
    let (px, py) = (x + l * sin(theta), -l * cos(theta));
    kinetic = 1/2 * m * (dot(px)^2 + dot(py)^2 + dot(theta)^2 * l^2);
    potential = m * g * py;
    force x = u;
    output tip = px;
}

fn main() {
    let cart = CartPole { u: 1.0, ..CartPole::default() };
    let state = CartPoleState { x: 0.0, theta: 0.1, x_dot: 0.0, theta_dot: 0.0 };
    println!("{} {}", state.theta_dot, cart.tip(0.0, &[0.0, 0.1], &[0.0, 0.0]) + cart.l);
}
"""
# From the first of these texts, the word at its beginning, to the second.
JUMPS = [
    ("sin(theta)", 4, "theta: rad"),
    ("l * sin", 0, "l: m"),
    ("px)^2", 0, "px, py"),
    ("g * py", 0, "g: m/s"),
    ("u;\n    output", 0, "u: N"),
    ("theta_dot, cart", 0, "theta: rad"),
    ("tip(0.0", 0, "tip = px"),
    ("l);\n}", 0, "l: m"),
]


class Server:
    """rust-analyzer, waiting until it has read the crate."""

    def __init__(self, root):
        environment = {**os.environ, "CARGO_TARGET_DIR": str(CRATE / "target")}
        pipes = {"stdin": subprocess.PIPE, "stdout": subprocess.PIPE, "stderr": subprocess.DEVNULL}
        self.process = subprocess.Popen(["rust-analyzer"], cwd=root, env=environment, **pipes)
        self.count, self.is_ready = 0, False
        capabilities = {"experimental": {"serverStatusNotification": True}}
        options = {"checkOnSave": False, "cachePriming": {"enable": False}}
        settings = {"processId": None, "rootUri": root.as_uri(), "capabilities": capabilities, "initializationOptions": options}
        self.ask("initialize", settings)
        self.tell("initialized", {})

    def send(self, message):
        content = json.dumps({"jsonrpc": "2.0", **message}).encode()
        self.process.stdin.write(b"Content-Length: %d\r\n\r\n" % len(content) + content)
        self.process.stdin.flush()

    def receive(self):
        length = 0
        while line := self.process.stdout.readline().strip():
            if line.lower().startswith(b"content-length"):
                length = int(line.split(b":")[1])
        message = json.loads(self.process.stdout.read(length))
        if message.get("method") == "experimental/serverStatus":
            self.is_ready = message["params"]["quiescent"]
        elif "method" in message and "id" in message:
            self.send({"id": message["id"], "result": None})
        return message

    def tell(self, method, parameters):
        self.send({"method": method, "params": parameters})

    def ask(self, method, parameters):
        self.count += 1
        self.send({"id": self.count, "method": method, "params": parameters})
        while True:
            message = self.receive()
            if message.get("id") == self.count and "method" not in message:
                return message.get("result")

    def wait(self):
        while not self.is_ready:
            self.receive()


def position(text, offset):
    before = text[:offset]
    return {"line": before.count("\n"), "character": offset - before.rfind("\n") - 1}


def main():
    (CRATE / "src").mkdir(parents=True, exist_ok=True)
    (CRATE / "Cargo.toml").write_text(MANIFEST, encoding="utf-8")
    path = CRATE / "src" / "main.rs"
    path.write_text(TEXT, encoding="utf-8")
    server, document, failures = Server(CRATE), {"uri": path.as_uri()}, []
    server.tell("textDocument/didOpen", {"textDocument": {**document, "languageId": "rust", "version": 1, "text": TEXT}})
    server.wait()
    for source, skip, target in JUMPS:
        place = position(TEXT, TEXT.index(source) + skip)
        found = server.ask("textDocument/definition", {"textDocument": document, "position": place}) or []
        starts = [link.get("targetSelectionRange", link.get("range"))["start"] for link in found]
        if position(TEXT, TEXT.index(target)) not in starts:
            failures.append(f"no jump from `{source.split()[0]}` to `{target}`: {starts}")
    # A word that is being typed.
    changed = TEXT.replace("m * g * py;", "m * g * py + th;")
    server.tell("textDocument/didChange", {"textDocument": {**document, "version": 2}, "contentChanges": [{"text": changed}]})
    place = position(changed, changed.index("+ th;") + 4)
    found = server.ask("textDocument/completion", {"textDocument": document, "position": place}) or []
    items = found["items"] if isinstance(found, dict) else found
    labels = [item["label"] for item in items]
    failures += [f"`{name}` is not proposed" for name in ["theta", "px", "m", "u", "pi"] if name not in labels]
    server.process.kill()
    print("\n".join(failures) or f"{len(JUMPS)} jumps, {len(labels)} proposals")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
