#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Brings assets/i18n/myoface_CODE.ts up to date with the words in the code: new ones come in
untranslated, those that are gone go, translations stay. --check only tells what is missing.

Words of the window are found in tr("…") (context: the class), those of reports in say("…"), those
of the core library in its tables."""
import argparse
import json
import re
import sys
import xml.etree.ElementTree as tree
from pathlib import Path
from xml.sax.saxutils import escape

ROOT = Path(__file__).resolve().parent.parent
LITERAL = r'"(?:[^"\\]|\\.)*"'
JOINED = rf'({LITERAL}(?:\s*{LITERAL})*)'


def text_of(joined):
    pieces = re.findall(LITERAL, joined)
    text = "".join(piece[1:-1] for piece in pieces)
    return text.replace("\\n", "\n").replace('\\"', '"').replace("\\\\", "\\")


def class_of(file):
    """The class whose tr() a file uses: the last one that its header declares."""
    names = {"window_menus": "MainWindow"}
    if file.stem in names:
        return names[file.stem]
    header = file.with_suffix(".h")
    source = header.read_text() if header.exists() else file.read_text()
    found = re.findall(r"class (\w+) final : public|class (\w+) : public", source)
    return [a or b for a, b in found][-1] if found else "QObject"


def window_words():
    words = {}
    for file in sorted((ROOT / "src/app").glob("*.cpp")):
        source = file.read_text()
        own = class_of(file)
        for match in re.finditer(rf"(?:(\w+)::)?\btr\(\s*{JOINED}", source):
            context = match.group(1) or enclosing(source, match.start()) or own
            words.setdefault(context, set()).add(text_of(match.group(2)))
        for match in re.finditer(rf"QT_TR_NOOP\(\s*{JOINED}", source):
            words.setdefault(own, set()).add(text_of(match.group(1)))
    return words


def enclosing(source, at):
    """The class of the member function that a place of a file is in."""
    found = re.findall(r"^(?:\w[\w:<>*&,~ ]* )?\*?&?(\w+)::~?\w+\(", source[:at], re.MULTILINE)
    return found[-1] if found else None


def report_words():
    source = (ROOT / "src/report/report.cpp").read_text()
    words = {text_of(m) for m in re.findall(rf"say\(\s*{JOINED}", source)}
    words |= {text_of(m) for m in re.findall(rf"kDisclaimer =\s*{JOINED}", source)}
    return words


def core_words():
    """English of the core library, with Japanese where its tables have it."""
    words = {}
    for preset in json.loads((ROOT / "assets/expressions.json").read_text())["presets"]:
        words[preset["title"]] = preset["title_ja"]
    for preset in json.loads((ROOT / "assets/weakening.json").read_text())["presets"]:
        words[preset["title"]] = ""
    for line in (ROOT / "assets/norms.csv").read_text().splitlines()[1:]:
        words[line.split(",")[11]] = ""
    source = (ROOT / "src/core/measure/measurement.cpp").read_text()
    for match in re.findall(r'std::pair\("\w+", ("[^"]+")\)', source):
        words[text_of(match)] = ""
    source = (ROOT / "src/core/face/tissue.cpp").read_text()
    for english, japanese in re.findall(r'[{,]\s*"([a-z ]+)",\s*"([^"]*[^\x00-\x7f][^"]*)"', source):
        words[english] = japanese
    words["whole face"] = ""
    source = (ROOT / "src/core/face/landmarks.cpp").read_text()
    row = rf'\{{"\w+", "\w+", "([^"]+)", \w+,\s*{JOINED}'
    for title, definition in re.findall(row, source):
        words[title] = ""
        words[text_of(definition)] = ""
    atlas = json.loads((ROOT / "assets/muscles.json").read_text())
    for entry in next(v for v in atlas.values() if isinstance(v, list)):
        if "title" in entry and "title_ja" in entry:
            words[entry["title"]] = entry["title_ja"]
    source = (ROOT / "src/cli/report_command.cpp").read_text()
    for match in re.findall(r'std::pair\("[\w-]+", ("[^"]+")\)', source):
        words[text_of(match)] = ""
    for file in [*(ROOT / "src/core").rglob("*.cpp"), *(ROOT / "src/app").glob("*_job*.cpp"),
                 ROOT / "src/app/face_files.cpp"]:
        for match in re.findall(rf"report\(\s*{JOINED},", file.read_text()):
            words[text_of(match)] = ""
    words["norm: adults of European descent, 20 to 25 years; band: mean ± 2 sd"] = ""
    return words


def call_arguments(source, at):
    """The text between the bracket at a place and the one that closes it."""
    depth, i, quoted = 0, at, False
    while i < len(source):
        c = source[i]
        if quoted:
            i += c == "\\"
            quoted = c != '"'
        elif c == '"':
            quoted = True
        elif c == "(":
            depth += 1
        elif c == ")":
            depth -= 1
            if depth == 0:
                return source[at + 1:i]
        i += 1
    return ""


def pattern_of(expression):
    """A sum of literals and values as a sentence with %1, %2 …; nothing without enough words."""
    terms, depth, quoted, start = [], 0, False, 0
    i = 0
    while i < len(expression):
        c = expression[i]
        if quoted:
            i += c == "\\"
            quoted = c != '"'
        elif c == '"':
            quoted = True
        elif c in "([{":
            depth += 1
        elif c in ")]}":
            depth -= 1
        elif c == "+" and depth == 0:
            terms.append(expression[start:i])
            start = i + 1
        i += 1
    terms.append(expression[start:])
    text, number = "", 0
    for term in terms:
        inner = re.fullmatch(rf"\s*(?:std::string\()?\s*{JOINED}\s*\)?\s*", term)
        if inner:
            text += text_of(inner.group(1))
        else:
            number += 1
            text += f"%{number}"
    # What stands before the colon is a file, or a place in it: any sentence may have it.
    prefix = re.match(r"%1(?: (?:line|triangle) %2)?: ", text)
    if prefix:
        text = text[prefix.end():]
        for old in range(1, 10):
            if f"%{old}" in text:
                shift = old - 1
                text = re.sub(r"%(\d)", lambda m: f"%{int(m.group(1)) - shift}", text)
                break
    words = re.findall(r"[A-Za-z]{2,}", re.sub(r"%\d", "", text))
    return text if len(words) >= 2 and text.endswith((".", "?", ")")) else None


def sentences():
    """What the core library says about files, scans and gestures: errors and notes."""
    found = set()
    skip = {"plan.cpp", "mass_spring_model.cpp"}  # never met in the window
    files = list((ROOT / "src/core").rglob("*.cpp")) + [ROOT / "src/cli/film.cpp"]
    call = re.compile(r"(?:throw (?:IoError|InvalidInput)|notes\.(?:push_back|emplace_back)"
                      r"|\bfail|\brefuse)\(")
    for file in sorted(files):
        if file.name in skip:
            continue
        source = file.read_text()
        for match in call.finditer(source):
            arguments = call_arguments(source, match.end() - 1)
            for piece in re.findall(r"\? *(" + LITERAL + r")\s*: *(" + LITERAL + r")", arguments):
                found |= {pattern_of(p) for p in piece}
            found.add(pattern_of(arguments))
        for what, done in re.findall(rf"(?:some|note)\([^,]+,\s*{JOINED},\s*{JOINED}\)", source):
            found.add(f"{text_of(what)}: %1. {text_of(done)}")
    found |= {"Target: %1 stays at %2 of %3: %4", "no face was found on it; put a landmark file beside it.",
              "cannot be read: the file is damaged or asks for too much memory.", "Cancelled.",
              "is protected by another passphrase than this one.",
              "is protected by a passphrase, which is needed to open it."}
    found.discard(None)
    return found


def known(file):
    if not file.exists():
        return {}
    result = {}
    for context in tree.parse(file).getroot().findall("context"):
        name = context.find("name").text
        for message in context.findall("message"):
            translation = message.find("translation").text
            if translation:
                result[(name, message.find("source").text)] = translation
                result.setdefault(("", message.find("source").text), translation)
    return result


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--add", help="JSON file: English -> translation")
    arguments = parser.parse_args()
    words = {name: {w: "" for w in found} for name, found in window_words().items()}
    words["report"] = {w: "" for w in report_words()}
    words["core"] = core_words()
    words["sentences"] = {w: "" for w in sentences()}
    added = json.loads(Path(arguments.add).read_text()) if arguments.add else {}
    missing = []
    for code in ["ja"]:
        file = ROOT / f"assets/i18n/myoface_{code}.ts"
        old = known(file)
        lines = ['<?xml version="1.0" encoding="utf-8"?>', "<!DOCTYPE TS>",
                 f'<TS version="2.1" language="{code}" sourcelanguage="en">']
        for name in sorted(words):
            lines += ["<context>", f"    <name>{name}</name>"]
            for source in sorted(words[name]):
                translation = (added.get(source) or old.get((name, source)) or words[name][source]
                               or old.get(("", source), ""))
                state = "" if translation else ' type="unfinished"'
                if not translation:
                    missing.append((name, source))
                lines += ["    <message>", f"        <source>{escape(source)}</source>",
                          f"        <translation{state}>{escape(translation)}</translation>",
                          "    </message>"]
            lines.append("</context>")
        lines.append("</TS>")
        text = "\n".join(lines) + "\n"
        if arguments.check:
            if not file.exists() or file.read_text() != text:
                sys.exit(f"{file.name} is not up to date: run scripts/translations.py")
        else:
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(text)
    for name, source in missing:
        print(f"{name}: {source!r}", file=sys.stderr)
    if missing:
        sys.exit(f"{len(missing)} words without a translation")


if __name__ == "__main__":
    main()
