#!/usr/bin/env python3
"""Writes the tables of keys in the documents anew, from what a program prints.

    spoke schema --markdown | docs/write_keys.py

Each table stands between the lines <!-- keys: NAME --> and <!-- end of keys -->. A test of the
models says when one is out of date.
"""

import pathlib
import re
import sys

FOLDER = pathlib.Path(__file__).resolve().parent
BLOCK = re.compile(r"(<!-- keys: (.+?) -->\n\n).*?(\n<!-- end of keys -->)", re.DOTALL)


def read_tables(text):
    """The tables by the names in their headings."""
    parts = re.split(r"^### (.+)\n\n", text, flags=re.MULTILINE)[1:]
    return {name: table.strip("\n") + "\n" for name, table in zip(parts[::2], parts[1::2])}


def main():
    tables = read_tables(sys.stdin.read())
    for file in sorted(FOLDER.glob("*.md")):
        old = file.read_text(encoding="utf-8")
        new = BLOCK.sub(lambda block: block[1] + tables[block[2]] + block[3], old)
        if new != old:
            file.write_text(new, encoding="utf-8")
            print("written:", file)


if __name__ == "__main__":
    main()
