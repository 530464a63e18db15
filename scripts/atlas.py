#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes docs/user/muscles.md, the atlas as a table, from assets/muscles.json."""
import json
import pathlib

root = pathlib.Path(__file__).resolve().parent.parent
atlas = json.loads((root / "assets/muscles.json").read_text(encoding="utf-8"))

lines = [
    "# The muscles",
    "",
    "What the program knows of each mimic muscle, and of the two that close the jaw and those that open it. Made from",
    "[assets/muscles.json](../../assets/muscles.json) by `scripts/atlas.py`. Names in the first column are those of the",
    "command line; `.L` and `.R` follow for one side of a pair.",
    "",
    "| | |",
    "|---|---|",
    "| ![Muscles and skull from the front](pictures/atlas-front.png) | ![The same from the side](pictures/atlas-side.png) |",
    "| ![Skin cut away at the midline](pictures/atlas-cut.png) | ![The spring network, coloured by muscle](pictures/atlas-springs.png) |",
    "",
    "Colours tell muscles apart, both sides of a pair alike; pale ends are tendons. In the window the name, action unit and effect",
    "of a muscle appear where the mouse rests on it, and the status line names the region of the skin and the muscles under it.",
    "",
    "| name | English, *Latin*, Japanese | kind | action unit | nerve | from → to | does | clinical |",
    "|---|---|---|---|---|---|---|---|",
]
for m in atlas["muscles"]:
    side = "pair" if m["side"] == "paired" else "single"
    lines.append(
        f"| `{m['id']}` | {m['title']}<br>*{m['latin']}*<br>{m['title_ja']} | {m['kind']}, {side} | {m['action_unit']} "
        f"| {m['nerve']} | {m['origin']} → {m['insertion']} | {m['does']}<br>{m['does_ja']} | {m['note']}<br>{m['note_ja']} |"
    )
lines += [
    "",
    "Nerves without a number are branches of the facial nerve. Kinds: *linear* one bundle from bone to skin, *sheet* fibres side by",
    "side, *sphincter* a ring, *volume* a thick belly between bones that bulges. Action units are those of the Facial Action Coding",
    "System. Paths, zones and gains are set once for the average head and carried onto every face.",
    "",
]
(root / "docs/user/muscles.md").write_text("\n".join(lines), encoding="utf-8")
