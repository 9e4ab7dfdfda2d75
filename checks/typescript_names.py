"""TypeScript's names are those of NOTATION.md in camelCase: theta_max is thetaMax; its own stand there as they are.

Looked at is what the npm package exports: functions, constants, and the members of classes and interfaces.
"""

import re
from pathlib import Path

from tree import files, finish

TOP = re.compile(r"^export (?:async )?(?:function|const) (\w+)")
MEMBER = re.compile(r"^  (?:readonly )?(\w+)\??(?:<\w+>)?(?:\(.*[{;,(]|: .*;)$")
HIDDEN = re.compile(r"^  private |^  (?:constructor|return|throw|if|for|const)\b|^  (?:core|super)\(")
# Words of the language and of the tables that TypeScript shares with every library.
PLAIN = {"of", "name", "names", "entries", "entry", "steps", "step", "until", "toString"}


def camel(name: str) -> str:
    """theta_max as thetaMax."""
    first, *rest = name.split("_")
    return first + "".join(word.capitalize() for word in rest)


def findings(root: Path) -> list[str]:
    dictionary = set(re.findall(r"`(\w+)`", (root / "NOTATION.md").read_text(encoding="utf-8")))
    known = (
        dictionary | {camel(name) for name in dictionary} | {name[0].lower() + name[1:] for name in dictionary} | PLAIN
    )
    found = []
    for path in files(root, "wasm/npm/src", ".ts"):
        # What the package does not export: the module's own functions.
        inner, internal = path.name in ("core.ts", "exports.ts", "registry.ts"), False
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            match = TOP.match(line) or (not inner and not HIDDEN.match(line) and MEMBER.match(line))
            if match and not internal and not inner and match[1] not in known:
                where = f"{path.relative_to(root).as_posix()}:{number}"
                found.append(f"{where}: {match[1]} is neither in NOTATION.md nor the camelCase of a name there")
            internal = "@internal" in line
    return found


if __name__ == "__main__":
    finish(findings)
