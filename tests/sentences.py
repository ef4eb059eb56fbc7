#!/usr/bin/env python3
"""Length of the sentences and private words of the book and of the README.

    python3 tests/sentences.py              exit status 1 where a sentence is too long or a word private
    python3 tests/sentences.py --words 25   prints every sentence of more words, with its place

Tables made from the code, blocks of code and pictures are left out. A cell of a table counts as text, a piece of code as one word.
Reference: none; the limits are those of CONTRIBUTING.md.
"""

import argparse
import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
# a sentence of more words fails
LONGEST = 25
# a word of the project alone, and the term of the field
PRIVATE = {
    r"blind to tilt": "independent of the section's rotation",
    r"turns? back\b": "has a limit point",
    r"turning points?": "limit point",
    r"what pulls": "adhesion model",
    r"laid down under tension": "adhered under pretension",
    r"free of stress": "stress-free",
    r"held across the pull": "constrained normal to the pull",
    r"no mesh tried did better": "the tolerance was not met on any mesh",
    r"a mesh that stays": "a fixed mesh",
    r"drawn scenes": "randomly sampled scenes",
    r"behind its snap-off": "beyond its snap-off",
    r"hang together": "are connected",
    r"comes? to rest": "settles in equilibrium",
    r"(?:is|are) told": "is reported",
    r"followed warily": "followed with shorter steps",
    r"throw-away": "leave it out",
    r"gives way": "yields",
    r"before this version|changes of this version|before the workspace": "leave out what an older build did",
}
# with the initials of authors, but not the letters that stand for a force or a displacement
ABBREVIATIONS = re.compile(r"\b(?:Figs?|eqs?|Eqs?|e\.g|i\.e|cf|vs|no|No|vol|[A-DF-GI-KM-ORSVX-Z]|Phys|Comput|Commun|Tech|Graph|Appl|Mech|Exp|Biol)\.$")


def paragraphs(text):
    """The texts of a page, each with the line where it begins: paragraphs, items of lists, cells of tables."""
    found, lines, begin, fenced, made = [], [], 0, False, False

    def end():
        if lines:
            found.append((begin, " ".join(lines)))
            lines.clear()

    for number, line in enumerate(text.splitlines(), 1):
        if line.lstrip().startswith("```"):
            fenced = not fenced
            end()
            continue
        if re.match(r"<!-- .*: begin -->", line) or re.match(r"<!-- .*: end -->", line):
            made = "begin" in line
            end()
            continue
        plain = line.strip()
        skipped = fenced or made or not plain or line.startswith(("    ", "#", "![", "<", "$$"))
        if skipped:
            end()
            continue
        if plain.startswith("|"):
            end()
            found.extend((number, cell) for cell in plain.strip("|").split(" | "))
            continue
        if re.match(r"(?:[-*>]|\d+\.) ", plain):
            end()
            plain = re.sub(r"^(?:[-*>]|\d+\.) ", "", plain)
        if not lines:
            begin = number
        lines.append(plain)
    end()
    return found


def sentences(text):
    """The sentences of a paragraph."""
    text = re.sub(r"`[^`]*`", "code", text)
    text = re.sub(r"\$[^$]*\$|\\\\\(.*?\\\\\)", "formula", text)
    text = re.sub(r"!?\[([^]]*)\]\([^)]*\)", r"\1", text)
    text = text.replace("**", "").replace("*", "")
    begin = 0
    for stop in re.finditer(r"[.!?][)\"']?\s+", text):
        sentence = text[begin : stop.end()].strip()
        if not ABBREVIATIONS.search(sentence):
            yield sentence
            begin = stop.end()
    if text[begin:].strip():
        yield text[begin:].strip()


def words(sentence):
    """Words and numbers; signs alone are none."""
    return [word for word in sentence.split() if re.search(r"\w", word)]


def pages():
    """The README and the pages of the book, without the list of its chapters."""
    return [ROOT / "README.md", *sorted(path for path in (ROOT / "docs").rglob("*.md") if path.name != "SUMMARY.md")]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--words", type=int, metavar="N", help="print every sentence of more than N words")
    asked = parser.parse_args()
    found, private, total = [], [], 0
    for page in pages():
        name = str(page.relative_to(ROOT))
        for line, paragraph in paragraphs(page.read_text(encoding="utf-8")):
            for sentence in sentences(paragraph):
                total += 1
                found.append((len(words(sentence)), name, line, sentence))
                private += [
                    f"{name}:{line}: “{match}”: {term}"
                    for word, term in PRIVATE.items()
                    for match in re.findall(word, sentence)
                ]
    found.sort(key=lambda sentence: -sentence[0])
    if asked.words is not None:
        for count, name, line, sentence in sorted(found, key=lambda sentence: sentence[1:3]):
            if count > asked.words:
                print(f"{name}:{line}: {count}: {sentence}")
        return 0
    too_long = [sentence for sentence in found if sentence[0] > LONGEST]
    print(f"{total} sentences, {len(too_long)} of more than {LONGEST} words; {len(private)} private words")
    for count, name, line, sentence in too_long[:10]:
        print(f"  {count} words, {name}:{line}: {sentence[:100]}")
    for line in private[:10]:
        print(f"  {line}")
    return int(bool(too_long or private))


if __name__ == "__main__":
    sys.exit(main())
