"""Every check is fed a bad example that it must find, and a good one that it must pass."""

import shutil
from pathlib import Path

import pytest

import circles
import examples
import functions
import links
import names
import pages
import rooms
import type_names
import typescript_names
import versions

HERE = Path(__file__).parent
ROW = """[theta]
error_max_ulp = 4
vectors = "reference/vectors/pendulum.csv"
rust = "core/src/pendulum/motion.rs::Orbit::theta"
test = "core/tests/vectors.rs::pendulum"
"""


@pytest.fixture
def root(tmp_path):
    """A small checkout in which every law holds."""
    for name, text in {
        "functions.toml": ROW,
        "NOTATION.md": "| angle | `theta` |\n",
        "README.md": "<!-- generated: accuracy -->\n0.5\n<!-- end generated -->\n[notation]\n\n[notation]: https://a.b/c/blob/main/NOTATION.md\n",
        "Cargo.toml": '[workspace.package]\nversion = "1.2.3"\nrepository = "https://a.b/c"\n',
        "CITATION.cff": "version: 1.2.3\nrepository-code: https://a.b/c\n",
        "wasm/npm/package.json": '{"version": "1.2.3", "repository": {"url": "git+https://a.b/c.git"}}\n',
        # The real one measures for seconds.
        "docs/approximations.py": "def sources():\n    return 'a'\n\n\nangles = periods = sines = sources\n",
        "docs/accuracy.md": "<!-- summary -->\n0.5\n<!-- end summary -->\n",
        "docs/corners.toml": '[[corner]]\ntitle = "rest"\ncall = "theta(0)"\ngives = "0"\nwhy = "it rests"\n',
        "core/src/pendulum/motion.rs": "impl Orbit {\n    pub fn theta(&self) -> f64 { self.a }\n}\n",
        "core/tests/vectors.rs": "#[test]\nfn pendulum() {}\n",
        "python/libration/__init__.py": '__all__ = ["theta"]\n\n\ndef theta():\n    pass\n',
        "python/src/lib.rs": "use libration::Orbit;\n",
        "core/src/pendulum/flow/mod.rs": "pub struct Flow;\nimpl A for B {\n    type State = f64;\n}\n",
        "core/src/state/mod.rs": "struct Flow;\nstruct State;\n#[cfg(test)]\nmod tests { struct Tested; }\n",
        "python/libration/plot/flow.py": "class Flow:\n    pass\n",
        "bench/flow.py": "class Flow:\n    pass\n",
        "lab/src/views/flow.ts": "interface Flow {\n  readonly a: number\n}\n",
        "reference/orbit.py": "import pendulum\n",
        "reference/pendulum.py": "import mpmath\n",
        "reference/vectors/pendulum.csv": "id\n",
    }.items():
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(text)
    for name in ("generate.py", "surface.py"):
        shutil.copy(HERE.parent / "docs" / name, tmp_path / "docs" / name)
    for block, text in pages.runpy.run_path(str(tmp_path / "docs/generate.py"))["blocks"](tmp_path).items():
        if block != "accuracy":
            page = f"<!-- generated: {block} -->\n{text}<!-- end generated -->\n"
            (tmp_path / f"docs/{block}.md").write_text(page)
    return tmp_path


@pytest.mark.parametrize(
    "check", [rooms, names, functions, pages, links, circles, type_names, typescript_names, versions]
)
def test_good_tree_passes(check, root):
    assert check.findings(root) == []


@pytest.mark.parametrize(
    ("check", "file", "text", "said"),
    [
        (rooms, "reference/pendulum.py", "import numpy as np\n", "the truth does not know"),
        (rooms, "core/src/lib.rs", "use pyo3::prelude::*;\n", "knows no door"),
        (rooms, "core/src/lib.rs", "std::thread::spawn(f);\n", "no thread"),
        (rooms, "core/src/pendulum/orbit.rs", "unsafe { f() }\n", "lives in lanes/"),
        (rooms, "core/src/pendulum/orbit.rs", "let a = b.unwrap();\n", "does not panic"),
        (rooms, "core/src/pendulum/orbit.rs", "let a = f64::sin(b);\n", "from float/"),
        (rooms, "core/src/elliptic/agm.rs", "use crate::pendulum::Orbit;\n", "knows no motion"),
        (rooms, "core/src/motion/samples.rs", "use crate::oscillator::Duffing;\n", "neither pendulum nor oscillator"),
        (rooms, "core/src/pendulum/orbit.rs", "use crate::oscillator::Duffing;\n", "only what is below"),
        (rooms, "core/src/float/dd.rs", "use crate::elliptic::K;\n", "at the bottom"),
        (rooms, "core/src/lib.rs", "use libration_fit::read;\n", "who uses it"),
        (rooms, "fit/src/read/mod.rs", "std::fs::read(name);\n", "no file system"),
        (rooms, "fit/src/read/mod.rs", "unsafe { f() }\n", "no `unsafe`"),
        (rooms, "fit/src/read/mod.rs", "let a = b.unwrap();\n", "fit does not panic"),
        (rooms, "fit/src/read/mod.rs", "let a = f64::sin(b);\n", "never from the host"),
        (rooms, "fit/src/read/mod.rs", "let a = libm::sin(b);\n", "no formula of a pendulum"),
        (rooms, "python/src/lib.rs", "unsafe { f() }\n", "lives in ufunc"),
        (rooms, "python/src/ufunc.rs", "let a = b.sqrt();\n", "no formula"),
        (rooms, "python/src/ufunc.rs", "let a = 2.0 * b;\n", "no float operator"),
        (names, "core/src/lib.rs", "let ksq = 1;\n", "the modulus `k`"),
        (names, "core/src/lib.rs", "let w0 = 1.0;\n", "not a name of"),
        (names, "core/src/lib.rs", "pub enum Regime { oscillation }\n", "not a name of"),
        (names, "python/libration/pendulum.py", "def amplitude():\n    pass\n", "not a name of"),
        (names, "python/libration/pendulum.py", "def get_theta():\n    pass\n", "quantity is a noun"),
        (names, "python/libration/pendulum.py", "x = theta0\n", "not called x"),
        (names, "python/libration/utils.py", "", "named after what it computes"),
        (names, "python/libration/__init__.py", '__all__ = ["theta", "blob"]\n', "blob: public"),
        (
            functions,
            "python/libration/__init__.py",
            '__all__ = ["theta", "blob"]\n\n\ndef theta(): ...\ndef blob(): ...\n',
            "without a row",
        ),
        (functions, "python/libration/__init__.py", "__all__ = []\n", "no public member has this name"),
        (functions, "core/src/pendulum/motion.rs", "\n", "step 3, the function"),
        (functions, "core/tests/vectors.rs", "\n", "step 3, the test"),
        (functions, "functions.toml", ROW.replace("pendulum.csv", "other.csv"), "step 2, a generator"),
        (functions, "functions.toml", ROW + 'source = "DLMF 22.19.2"\n', "stands in the docstring"),
        (functions, "functions.toml", ROW.replace('test = "core/tests/vectors.rs::pendulum"', ""), "no `test`"),
        (functions, "README.md", "with eighteen period formulas\n", "typed by hand"),
        (functions, "functions.toml", ROW.replace("error_max_ulp = 4", ""), "promises no error_max_ulp"),
        (pages, "README.md", "<!-- generated: accuracy -->\n0.4\n<!-- end generated -->\n", "make docs"),
        (pages, "README.md", "\n", "stands on no page"),
        (pages, "core/src/lib.rs", "\n" * 401, "probably two"),
        (pages, "core/src/lib.rs", "// TO" + "DO later\n", "unfinished"),
        (pages, "core/tests/vectors.rs", "#[ig" + "nore]\n", "looks away"),
        (pages, "python/tests/test_theta.py", "@pytest.mark.xf" + "ail\n", "looks away"),
        (pages, "Makefile", "run: /ho" + "me/me/x\n", "one machine"),
        (circles, "reference/pendulum.py", "import orbit\n", "2 files in a circle"),
        (typescript_names, "wasm/npm/src/pendulum.ts", "export function angle_max() {}\n", "pendulum.ts:1: angle_max"),
        (
            typescript_names,
            "wasm/npm/src/pendulum.ts",
            "export class Pendulum {\n  readonly thetaTop: number;\n}\n",
            "pendulum.ts:2: thetaTop is neither",
        ),
        (type_names, "core/src/pendulum/orbit.rs", "pub(crate) struct Flow<T> {\n", "pendulum: Flow is defined in 2"),
        (type_names, "core/src/pendulum/orbit.rs", "    enum Flow {\n", "pendulum/flow/mod.rs"),
        (type_names, "core/src/pendulum/orbit.rs", "type Flow = f64;\n", "core/src/pendulum: Flow"),
        (type_names, "python/libration/plot/orbit.py", "class Flow:\n    pass\n", "python/libration/plot: Flow"),
        (type_names, "lab/src/views/orbit.ts", "export interface Flow {\n", "lab/src/views: Flow"),
        (type_names, "bench/orbit.py", "Flow: TypeAlias = float\n", "bench: Flow"),
        (links, "README.md", "[a](missing.md)\n", "leads nowhere"),
        (links, "README.md", "[a](NOTATION.md#none)\n", "no such heading"),
        (links, "README.md", "[a]\n\n[a]: https://a.b/c/blob/main/missing.md\n", "leads nowhere"),
        (versions, "CITATION.cff", "version: 1.2.2\nrepository-code: https://a.b/c\n", "version 1.2.2, and"),
        (versions, "CITATION.cff", "version: 1.2.3\n", "address missing"),
        (
            versions,
            "wasm/npm/package.json",
            '{"version": "1.2.3", "repository": {"url": "https://a.b/d"}}',
            "address https://a.b/d",
        ),
        (
            versions,
            "Cargo.toml",
            '[workspace.package]\nversion = "1.2.4"\nrepository = "https://a.b/c"\n',
            "Cargo.toml says 1.2.4",
        ),
        (versions, "README.md", "[a](NOTATION.md)\n", "leads nowhere from the page of a package"),
        (examples, "README.md", "```console\n$ rm theta\n```\n", "does not run libration"),
        (examples, "README.md", "```console\n$ libration theta\nphi\n```\n", "prints 'theta\\n'"),
    ],
)
def test_bad_example_is_found(check, file, text, said, root):
    (root / file).parent.mkdir(parents=True, exist_ok=True)
    (root / file).write_text(text)
    found = check.findings(root, "echo") if check is examples else check.findings(root)
    assert any(said in line for line in found), found


def test_example_that_holds_passes(root):
    (root / "README.md").write_text("```console\n$ libration theta\ntheta\n```\n")
    assert examples.findings(root, "echo") == []


@pytest.mark.parametrize("script", sorted(HERE.glob("[!t]*.py")), ids=lambda path: path.name)
def test_check_is_short(script):
    assert len(script.read_text().splitlines()) < 60
