#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The tree of the sources, one line per file, from the first sentence of each header.

    scripts/structure.py            writes it into docs/structure.md
    scripts/structure.py --check    fails if docs/structure.md is not what would be written
"""
import pathlib
import re
import sys
import textwrap

ROOT = pathlib.Path(__file__).resolve().parent.parent
PAGE = ROOT / "docs" / "structure.md"
BEGIN, END = "<!-- scripts/structure.py -->", "<!-- end -->"


def rooms(name):
    """A list of the layer test: the rooms of a tree from the ground up, or the headers of the core."""
    test = (ROOT / "tests" / "layers" / "check_layers.cmake").read_text()
    return re.search(rf"set\({name} ([^)]*)\)", test).group(1).split()


def purpose(header):
    """The first sentence of the comment that a header opens with."""
    lines = []
    for line in header.read_text().splitlines():
        if line.startswith("/// "):
            lines.append(line[4:])
        elif lines:
            break
    if not lines:
        sys.exit(f"{header.relative_to(ROOT)}: does not say what it is for")
    text = " ".join(lines)
    sentence = re.match(r"(.*?[^A-Z])[.](?:\s|$)", text)
    text = (sentence.group(1) if sentence else text.rstrip(".")).rstrip(":")
    # One line: what follows a colon or semicolon is for those who open the file.
    return text if len(text) < 100 else re.split(r"[:;] ", text)[0]


def reading_order():
    """The place of each header in the list of the umbrella."""
    umbrella = (ROOT / "include" / "vcavity" / "vcavity.hpp").read_text()
    return {name: i for i, name in enumerate(re.findall(r'#include "vcavity/([^"]+)"', umbrella))}


def lines_of(folder, order):
    place = reading_order()
    yield f"{folder.relative_to(ROOT)}/"
    for room in order:
        path = folder / room
        if path.is_file() and path.suffix == ".hpp":
            yield f"  {room:28} {purpose(path)}"
        if not path.is_dir():
            continue
        yield f"  {room}/"
        for header in sorted(path.rglob("*.hpp"), key=lambda h: (place.get(str(h.relative_to(folder)), 999), h)):
            yield f"    {str(header.relative_to(path)):26} {purpose(header)}"


def core():
    """What to read first, and how long it is."""
    headers = rooms("core_headers")
    lines = sum((ROOT / "include" / "vcavity" / header).read_text().count("\n") for header in headers)
    names = [f"[`{header}`](../include/vcavity/{header})" for header in headers]
    text = f"The core, from a ray to the directional reflectance, is {', '.join(names[:-1])} and {names[-1]}, in {lines} lines."
    return "\n".join(textwrap.wrap(text, 120, break_long_words=False, break_on_hyphens=False))


def tree():
    library = list(lines_of(ROOT / "include" / "vcavity", rooms("library_rooms")))
    tools = list(lines_of(ROOT / "src" / "tools", rooms("tool_rooms")))
    return "\n".join([BEGIN, core(), "", "```text", *library, "", *tools, "```", END])


def main():
    page = PAGE.read_text()
    before, rest = page.split(BEGIN)
    written = before + tree() + rest.split(END)[1]
    if sys.argv[1:] == ["--check"]:
        if written != page:
            sys.exit("docs/structure.md is out of date; run scripts/structure.py")
    elif sys.argv[1:]:
        sys.exit(__doc__)
    else:
        PAGE.write_text(written)


main()
