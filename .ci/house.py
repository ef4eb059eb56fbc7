#!/usr/bin/env python3
"""Counts how the library and the crates are built, by their files, folders and imports.

    python3 .ci/house.py                  a table
    python3 .ci/house.py --list [PART]    what it counts, by name
    python3 .ci/house.py --check          exit status 1 where something of CLEAN is found

What is counted, of the files `*.rs` of a part (tests inside of files, `#[cfg(test)]`, are left out: they are users):

files, lines    all of them, tests inside of files as well
short, long     files below 60 lines and above 600 lines; a mod.rs that only declares and exports is not short
wide            folders with more than 12 entries, mod.rs not counted
globs           `pub use path::*`
facades         imports through a facade: a path, in a `use` or in an expression, that reaches its name by a `use` of another file, rather
                than by the modules down to the file that defines it. A `pub use` of a mod.rs or lib.rs is none: it makes a facade.
circles         of files: strongly connected sets of more than one file, where a file leads to each file that defines a name of its paths.
                Neither do `mod` lines lead anywhere, nor what a facade exports, nor the import of a module by itself: its names do.
up              what runs against the order of a folder: paths from a file to the mod.rs or lib.rs of a folder that it stands in, and circles
                of the entries of a folder, where an entry leads to what its files lead to.

The paths of macros are read as they stand. A name that no file of the part defines by an item (a macro made it, say) is taken as defined in
the last module of its path.
"""
import re
import sys
from dataclasses import dataclass, field
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
PARTS = ["src", *sorted(str(d.parent.relative_to(ROOT)) + "/src" for d in ROOT.glob("crates/*/Cargo.toml"))]
CLEAN = ("long", "wide", "globs", "facades", "circles", "up")
SHORT, LONG, WIDE = 60, 600, 12

NO_CODE = re.compile(r'//[^\n]*|/\*.*?\*/|b?r(#+)".*?"\1|b?r"[^"]*"|b?"(?:\\.|[^"\\])*"|b?\'(?:\\[^\n\']+|\\\'|[^\\\'\n])\'', re.S)
USE = re.compile(r"(?:(pub)(\([^)]*\))?\s+)?\buse\s+([^;]+);")
ITEM = re.compile(r"\b(?:fn|struct|enum|union|trait|type|const|static|macro_rules!)\s+(?:mut\s+)?([A-Za-z_]\w*)")
PATH = re.compile(r"(?<![\w:.$'])(?:::)?[A-Za-z_]\w*(?:\s*::\s*[A-Za-z_]\w*)+")


def blank(text: str, start: int, end: int) -> str:
    """The text with spaces from start to end, line ends left."""
    return text[:start] + re.sub(r"[^\n]", " ", text[start:end]) + text[end:]


def code_of(text: str) -> str:
    """The code alone, at the same places: no comments, no strings, no tests."""
    code = NO_CODE.sub(lambda found: re.sub(r"[^\n]", " ", found[0]), text)
    code = re.sub(r"\bin (?=crate\b|super\b)[\w:]+", lambda found: " " * len(found[0]), code)
    while test := re.search(r"#\[cfg\(test\)\]\s*(?:#\[[^\]]*\]\s*)*", code):
        end, depth = test.end(), 0
        while code[end] not in ";}" or depth > 0:
            depth += {"{": 1, "(": 1, "}": -1, ")": -1}.get(code[end], 0)
            end += 1
            if code[end - 1] == "}" and depth == 0:
                break
        else:
            end += 1
        code = blank(code, test.start(), end)
    return code


def leaves(tree: str, before: tuple = ()) -> list:
    """The paths of a `use`: (segments, local name)."""
    tree = tree.strip()
    head, brace, rest = tree.partition("{")
    if brace:
        parts, depth, start = [], 0, 0
        inner = rest[: rest.rindex("}")] + ","
        for at, sign in enumerate(inner):
            depth += {"{": 1, "}": -1}.get(sign, 0)
            if sign == "," and depth == 0:
                parts.append(inner[start:at])
                start = at + 1
        here = before + tuple(s.strip() for s in head.split("::") if s.strip())
        return [leaf for part in parts if part.strip() for leaf in leaves(part, here)]
    path, _, alias = (part.strip() for part in tree.partition(" as "))
    path = before + tuple(s.strip() for s in path.split("::") if s.strip())
    if path[-1] == "self" and len(path) > 1:
        path = path[:-1]
    return [(path, alias or path[-1])]


@dataclass
class Module:
    """A file of a part."""

    path: tuple
    file: Path
    text: str
    children: set = field(default_factory=set)
    # (segments, local name, exported, place of the statement)
    uses: list = field(default_factory=list)

    def __post_init__(self):
        self.code = code_of(self.text)
        self.body = self.code
        for use in USE.finditer(self.code):
            self.uses += [(path, name, bool(use[1]), use.span()) for path, name in leaves(use[3])]
            self.body = blank(self.body, *use.span())
        self.items = set(ITEM.findall(self.body))
        self.names = {name: path for path, name, _, _ in self.uses if name != "*"}
        self.exports = {name: path for path, name, exported, _ in self.uses if exported and name != "*"}
        self.globs = [path[:-1] for path, name, _, _ in self.uses if name == "*"]
        self.tests = {self.path + (name,) for name in re.findall(r"#\[cfg\(test\)\]\s*mod (\w+);", self.text)}

    def is_facade(self) -> bool:
        return self.file.name in ("mod.rs", "lib.rs")


class Part:
    """The modules of a crate, and what their paths lead to."""

    def __init__(self, root: Path):
        self.root, self.modules = root, {}
        for file in sorted(root.rglob("*.rs")):
            path = file.relative_to(root).with_suffix("").parts
            if path[-1] in ("mod", "lib", "main"):
                path = path[:-1]
            self.modules[path] = Module(path, file, file.read_text())
        tests = {test for module in self.modules.values() for test in module.tests}
        self.tests = {path for path in self.modules for test in tests if path[: len(test)] == test}
        for path in self.modules:
            if path:
                self.modules[path[:-1]].children.add(path[-1])

    def resolve(self, at: tuple, path: tuple, passed: tuple = (), by_glob: bool = False):
        """Where a path of the module `at` leads: (module, name or None, modules whose `use` it passes); None out of the crate."""
        first, rest = path[0], path[1:]
        if first in ("crate", "self", "super"):
            at = {"crate": (), "self": at, "super": at[:-1]}[first]
            return self.resolve(at, rest, passed) or (at, rest[0], passed) if rest else (at, None, passed)
        module = self.modules[at]
        names = module.exports if by_glob else module.names
        if first in module.children and (rest or not (first in names or first in module.items)):
            child = at + (first,)
            return self.resolve(child, rest, passed) or (child, rest[0], passed) if rest else (child, None, passed)
        if first in module.items:
            return (at, first, passed)
        if first in names:
            found = self.resolve(at, names[first], passed + (at,)) if names[first] != path[:1] else None
            if found and found[1] is None and rest:
                return self.resolve(found[0], rest, found[2]) or (found[0], rest[0], found[2])
            return found
        for glob in module.globs:
            if glob[0] not in {"crate", "self", "super", *module.children, *module.names}:
                continue
            target = self.resolve(at, glob + ("?",), passed + (at,))
            if target and target[1] == "?" and target[0] != at:
                found = self.resolve(target[0], path, target[2], by_glob=True)
                if found:
                    return found
        return None

    def paths(self, module: Module):
        """Every path of a file: (segments, exported, place)."""
        for path, name, exported, place in module.uses:
            # of a module and an item of one name, the file uses the module where it goes on by ::
            as_module = re.search(rf"(?<![\w:]){name}\s*::", module.body) and path[0] in ("crate", "self", "super")
            if as_module:
                found = self.resolve(module.path, path + ("?",))
                if found and found[1] == "?":
                    continue
            yield path[:-1] if name == "*" else path, exported, place
        for found in PATH.finditer(module.body):
            if not found[0].startswith("::"):
                yield tuple(s.strip() for s in found[0].split("::")), False, found.span()

    def imports(self):
        """(importing module, module that defines, through a facade, exported, path)"""
        for module in (self.modules[path] for path in self.modules if path not in self.tests):
            for path, exported, _ in self.paths(module):
                found = self.resolve(module.path, path)
                if found and found[1] is not None and found[0] != module.path:
                    through = any(passed != module.path for passed in found[2])
                    yield module, self.modules[found[0]], through, exported and module.is_facade(), path


def circles(edges: set) -> list:
    """The strongly connected sets of more than one node."""
    after = {}
    for start, end in edges:
        after.setdefault(start, set()).add(end)

    def reached(start) -> set:
        seen, todo = set(), [start]
        while todo:
            for node in after.get(todo.pop(), ()):
                if node not in seen:
                    seen.add(node)
                    todo.append(node)
        return seen

    reach = {node: reached(node) for node in after}
    sets = {frozenset(other for other in reach[node] if node in reach.get(other, ())) for node in reach}
    return sorted(sorted(map(str, one)) for one in sets if len(one) > 1)


def count(root: Path) -> dict:
    """What is counted, each a list of what it found."""
    part = Part(root)
    modules = part.modules.values()
    name = lambda module: str(module.file.relative_to(root))
    lines = {name(module): module.text.count("\n") for module in modules}
    only_facade = {name(m) for m in modules if m.is_facade() and not m.items}
    folders = [d for d in [root, *root.rglob("*")] if d.is_dir()]
    entries = {str(d.relative_to(root)): sum(1 for e in d.iterdir() if e.name != "mod.rs") for d in folders}
    edges, facades, up, rooms = set(), set(), set(), {}
    for module, to, through, exports, path in part.imports():
        if exports:
            continue
        if through:
            facades.add(f"{name(module)}: {'::'.join(path)}")
        edges.add((name(module), name(to)))
        if to.is_facade() and module.path[: len(to.path)] == to.path:
            up.add(f"{name(module)} -> {name(to)}")
        common = next((i for i, (a, b) in enumerate(zip(module.path, to.path)) if a != b), None)
        if common is not None:
            folder = rooms.setdefault(module.path[:common], set())
            folder.add((module.path[common], to.path[common]))
    return {
        "files": list(lines),
        "lines": range(sum(lines.values())),
        "short": [file for file in lines if lines[file] < SHORT and file not in only_facade],
        "long": [file for file in lines if lines[file] > LONG],
        "wide": [folder for folder in entries if entries[folder] > WIDE],
        "globs": [f"{name(m)}: {'::'.join(u[0])}" for m in modules for u in m.uses if u[1] == "*" and u[2]],
        "facades": sorted(facades),
        "circles": [" ".join(circle) for circle in circles(edges)],
        "up": sorted(up) + [f"{'/'.join(f) or '.'}: {' '.join(c)}" for f in sorted(rooms) for c in circles(rooms[f])],
    }


def main() -> int:
    arguments = sys.argv[1:]
    if arguments[:1] == ["--check"]:
        bad = [
            f"{part}: {what}: {one}" for part in PARTS for what, found in count(ROOT / part).items() if what in CLEAN for one in found
        ]
        print("\n".join(bad) or f"nothing of {', '.join(CLEAN)} in {', '.join(PARTS)}")
        return 1 if bad else 0
    if arguments[:1] == ["--list"]:
        for part in arguments[1:] or PARTS:
            for what, found in count(ROOT / part).items():
                if what not in ("files", "lines"):
                    print(f"\n{part}: {len(found)} {what}", *found, sep="\n    ")
        return 0
    counted = {part: count(ROOT / part) for part in PARTS}
    head = list(counted["src"])
    print(f"{'':20}" + "".join(f"{what:>9}" for what in head))
    for part in PARTS:
        print(f"{part:20}" + "".join(f"{len(counted[part][what]):9}" for what in head))
    print(f"{'all':20}" + "".join(f"{sum(len(counted[part][what]) for part in PARTS):9}" for what in head))
    return 0


if __name__ == "__main__":
    sys.exit(main())
