#!/usr/bin/env python3
"""Builds the book of docs/ into target/book and follows its links; `tools/book.py --open` also shows it.

mdBook is taken from the path or from target/mdbook, where it is installed if missing. Its warnings are failures, and so is a
link to a page or heading that does not exist.

mdBook in turn calls this file as a preprocessor, which adapts pages of a repository to a book:

- a link to a file outside of docs/ leads to a page with the text of that file, a folder to a list of such pages;
- sections of src/language.md are spread over the pages of docs/language, and links between them follow;
- items of the documentation of Rust, `crate::…`, are words without links.
"""

import json
import os
import re
import shutil
import subprocess
import sys
import webbrowser
from html.parser import HTMLParser
from pathlib import Path
from posixpath import dirname, join, normpath, relpath
from urllib.parse import unquote, urlsplit

ROOT = Path(__file__).resolve().parent.parent
BUILT = ROOT / "target" / "book"
OWN_MDBOOK = ROOT / "target" / "mdbook"
MDBOOK_VERSION = "0.5.4"

LANGUAGE = "src/language.md"
LANGUAGE_PAGES = "language/"
SOURCES = "sources/"
LINK = re.compile(r"\]\(([^()\s]+)\)")
CODE_SPAN = re.compile(r"(`[^`]+`)")
ITEM_OF_RUST = re.compile(r"\[([^\[\]]+)\]\((?:mod@)?crate::[^()]*\)")
FENCE = re.compile(r"^\s*```")
# mdBook makes these the indices of their folders, and does not change links to them.
BOOK_README = re.compile(r"(^|/)README\.md$")
HEADING = re.compile(r"^#+ ")
# Languages for highlighting, by file name extension.
LANGUAGES = {".rs": "rust", ".py": "python", ".toml": "toml", ".sh": "sh"}


def main():
    match sys.argv[1:]:
        case ["--preprocess", "supports", _]:
            return 0
        case ["--preprocess"]:
            return preprocess()
        case [] | ["--open"]:
            return build()
    print(__doc__, file=sys.stderr)
    return 2


def build():
    made = subprocess.run([mdbook(), "build", ROOT / "docs"], stderr=subprocess.PIPE, text=True)
    print(made.stderr, end="", file=sys.stderr)
    if made.returncode or re.search(r"\b(WARN|ERROR)\b", made.stderr):
        return 1
    pages = {path: Page(path) for path in sorted(BUILT.rglob("*.html"))}
    dead = [problem for page in pages.values() for problem in page.dead_links(pages)]
    print("\n".join(dead), file=sys.stderr, end="\n" if dead else "")
    if not dead:
        print(BUILT / "index.html")
        "--open" in sys.argv and webbrowser.open((BUILT / "index.html").as_uri())
    return 1 if dead else 0


def mdbook():
    own = OWN_MDBOOK / "bin" / "mdbook"
    found = shutil.which("mdbook") or (own if own.is_file() else None)
    if not found:
        # It is compiled once and runs for a second, so no optimisation is faster.
        settings = {"CARGO_PROFILE_RELEASE_OPT_LEVEL": "0", "CARGO_PROFILE_RELEASE_LTO": "off"}
        install = ["cargo", "install", "--locked", f"mdbook@{MDBOOK_VERSION}", "--no-default-features", "--features", "search", "--root"]
        subprocess.run([*install, OWN_MDBOOK], env={**os.environ, **settings}, check=True, cwd="/")
    return found or own


class Page(HTMLParser):
    """The links of a built page, and the names to which links may lead."""

    def __init__(self, path):
        super().__init__()
        self.path, self.links, self.names = path, [], set()
        self.feed(path.read_text(encoding="utf-8"))

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        self.names |= {attributes[key] for key in ("id", "name") if attributes.get(key)}
        self.links += [attributes[key] for key in ("href", "src") if attributes.get(key)]

    def dead_links(self, pages):
        # The error page is made for any address.
        for link in self.links if self.path.name != "404.html" else []:
            parts = urlsplit(link)
            if parts.scheme or parts.netloc:
                continue
            target = Path(os.path.normpath(self.path.parent / unquote(parts.path))) if parts.path else self.path
            name = unquote(parts.fragment)
            is_page_without_name = name and target in pages and name not in pages[target].names
            if not target.is_file() or is_page_without_name:
                yield f"{self.path.relative_to(BUILT)}: {link} leads nowhere"


def preprocess():
    _, book = json.load(sys.stdin)
    chapters = [chapter for chapter in walk(book["items"]) if chapter["path"]]
    book["items"] += Sources(chapters).chapters()
    json.dump(book, sys.stdout)
    return 0


def walk(items):
    for item in items:
        if chapter := item.get("Chapter") if isinstance(item, dict) else None:
            yield chapter
            yield from walk(chapter["sub_items"])


class Sources:
    """Follows the links of chapters to files outside of docs/, and these to others."""

    def __init__(self, chapters):
        self.files = []
        language = [chapter for chapter in chapters if chapter["path"].startswith(LANGUAGE_PAGES)]
        for chapter in language:
            chapter["content"] = one_page(chapter["content"])
        self.sections = {name: chapter["path"] for chapter in language for name in names_of_headings(chapter["content"])}
        for chapter in chapters:
            chapter["content"] = self.with_links(chapter["content"], "docs/" + chapter["path"], chapter["path"])

    def chapters(self):
        """Returns a part of the book with a page for each file; pages may lead to further files."""
        made = []
        for file in self.files:
            path = page_of(file)
            made.append({"name": file, "content": self.page(file, path), "number": None, "sub_items": [], "path": path})
            made[-1] |= {"source_path": None, "parent_names": ["Sources"]}
        if not made:
            return []
        made.sort(key=lambda chapter: chapter["path"])
        top = {"name": "Sources", "content": "# Sources\n\nFiles to which pages of the book lead.\n", "number": None}
        top |= {"sub_items": [{"Chapter": chapter} for chapter in made], "path": SOURCES + "index.md", "source_path": None}
        return ["Separator", {"Chapter": top | {"parent_names": []}}]

    def page(self, file, path):
        source = ROOT / file
        if source.is_dir():
            listed = subprocess.run(["git", "ls-files", "."], cwd=source, capture_output=True, text=True, check=True).stdout.split()
            # The names of programs suffice; data are not for readers.
            listed = [name for name in listed if Path(name).suffix in {*LANGUAGES, ".md", ".lag"}]
            text = "".join(f"- [`{name}`]({name})\n" for name in listed)
            return self.with_links(f"# `{file}`\n\n{text}", file + "/", path)
        text = source.read_text(encoding="utf-8")
        if source.suffix == ".md":
            return self.with_links(one_page(text) if file == LANGUAGE else text, file, path)
        fence = "`" * 4
        return f"# `{file}`\n\n{fence}{LANGUAGES.get(source.suffix, 'text')}\n{text.rstrip()}\n{fence}\n"

    def with_links(self, text, file, path):
        """Returns the text of a file of the repository with its links as the page at a path needs them."""

        def changed(line):
            # Calls of elements, `f[1](x)`, look like links.
            parts = CODE_SPAN.split(ITEM_OF_RUST.sub(r"\1", line))
            return "".join(part if CODE_SPAN.match(part) else LINK.sub(lambda match: f"]({self.link(match[1], file, path)})", part) for part in parts)

        return outside_code(text, changed)

    def link(self, link, file, path):
        parts = urlsplit(link)
        if parts.scheme or parts.netloc:
            return link
        target = normpath(join(dirname(file), parts.path)) if parts.path else file
        if parts.fragment and (target == LANGUAGE or not parts.path and path.startswith(LANGUAGE_PAGES)):
            target = self.sections.get(parts.fragment, path)
        elif target.startswith("docs/"):
            target = BOOK_README.sub(r"\1index.md", target.removeprefix("docs/"))
        else:
            if target not in self.files:
                self.files.append(target)
            target = page_of(target)
        # Links to headings of the same page stay short.
        way = "" if target == path and parts.fragment else relpath(target, dirname(path) or ".")
        return way + (f"#{parts.fragment}" if parts.fragment else "")


def page_of(file):
    """Returns the path of the page of a file. `README.md` would become the index of its folder."""
    stem = file.removesuffix(".md").replace("README", "readme").replace(".", "_")
    return f"{SOURCES}{stem}.md"


def kinds(text):
    """Returns the lines of a page, each with its kind."""
    is_code = False
    for line in text.split("\n"):
        if FENCE.match(line):
            is_code = not is_code
            yield line, "begin" if is_code else "end"
        else:
            yield line, "code" if is_code else "text"


def outside_code(text, change):
    return "\n".join(change(line) if kind == "text" else line for line, kind in kinds(text))


def one_page(text):
    """Returns a page of included sections with one title, and with the code that rustdoc takes for Rust marked as such."""
    title, lines = None, []
    for line, kind in kinds(text):
        if kind == "text" and HEADING.match(line):
            # A page of one section has the title of this section.
            lines += [line] if title is None else [] if line == title else ["#" + line]
            title = title or line
        else:
            lines.append("```rust" if kind == "begin" and line == "```" else line)
    return "\n".join(lines)


def names_of_headings(text):
    return [name_of_heading(line.lstrip("# ")) for line, kind in kinds(text) if kind == "text" and HEADING.match(line)]


def name_of_heading(heading):
    return re.sub(r"[^\w\- ]", "", heading.strip().lower()).replace(" ", "-")


if __name__ == "__main__":
    sys.exit(main())
