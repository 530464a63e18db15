#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Prints docs/references.bib as a page of the API reference; with a FILE, that file with its @cite
turned into links to the page."""
import re
import sys
from pathlib import Path

if len(sys.argv) > 1:
    text = Path(sys.argv[1]).read_text()
    sys.stdout.write(re.sub(r"@cite (\w+)", r'@ref bib_\1 "\1"', text))
    sys.exit(0)
print("# References")
bib = (Path(__file__).resolve().parent.parent / "docs/references.bib").read_text()
for key, body in re.findall(r"^@\w+\{(\w+), (.*)\}$", bib, re.MULTILINE):
    fields = dict(re.findall(r"(\w+) = \{((?:[^{}]|\{[^{}]*\})*)\}", body))
    plain = {name: re.sub(r"\\.|[{}]", "", value).replace("--", "–") for name, value in fields.items()}
    where = plain.get("journal") or plain.get("booktitle") or plain.get("publisher") or plain.get("institution", "")
    parts = [plain["author"].replace(" and ", "; "), f"*{plain['title']}*", where, plain.get("year", "")]
    print(f"\n- @anchor bib_{key} **{key}**: " + ", ".join(part for part in parts if part) + ".")
