"""Circles of every make are found, and what only looks like one passes."""

import pytest

import circles

GOOD = {
    "core/src/lib.rs": "pub mod orbit;\nmod state;\nmod time;\n\npub use orbit::Orbit;\npub use state::*;\n",
    "core/src/orbit.rs": "use crate::time::{Time, self};\n// use crate::state::State;\npub struct Orbit;\n",
    "core/src/state.rs": "use crate::Orbit;\npub struct State;\n",
    "core/src/time.rs": 'pub struct Time;\nconst A: &str = "crate::State";\n#[cfg(test)]\nmod tests { use crate::State; }\n',
    "python/libration/__init__.py": "from .orbit import Orbit\n",
    "python/libration/_core.pyi": "class Orbit: ...\n",
    "python/libration/orbit.py": "from . import _core, time\nfrom .series import Fourier\n",
    "python/libration/series/__init__.py": "from .fourier import Fourier\n",
    "python/libration/series/fourier.py": "from ..time import Time\nfrom ..state import State\n",
    "python/libration/state.py": "import numpy\n",
    "python/libration/time.py": "from numpy import orbit\n",
    "bench/run.py": "import page\n",
    "bench/page.py": "import numpy as run\n",
    "lab/src/page.ts": "import { html } from 'lit-html'\nimport { table } from './views'\n",
    "lab/src/views/index.ts": "import type { Column } from '../columns'\nexport const page = (): string => './page'\n",
    "lab/src/columns.ts": "export interface Column {}\n",
}


def laid(root, **changes):
    for name, text in (GOOD | changes).items():
        (root / name).parent.mkdir(parents=True, exist_ok=True)
        (root / name).write_text(text)
    return circles.findings(root)


def test_a_tree_without_circles_passes(tmp_path):
    assert laid(tmp_path) == []


@pytest.mark.parametrize(
    ("file", "text", "said"),
    [
        ("core/src/time.rs", "use crate::orbit::Orbit;\n", "2 files"),
        ("core/src/time.rs", "use super::{a, orbit::{b, Orbit as O}};\n", "orbit.rs"),
        ("core/src/time.rs", "use crate::Orbit;\n", "2 files"),
        ("core/src/time.rs", "fn f() -> f64 {\n    crate::Orbit::new().g()\n}\n", "2 files"),
        ("core/src/time.rs", "use crate::State;\n", "3 files"),
        ("core/src/time.rs", 'const A: u8 = 1;\nuse crate::B;\n#[path = "x.rs"]\nmod y;\n', None),
        ("core/src/lib.rs", GOOD["core/src/lib.rs"] + "fn f() { orbit::g() }\nstruct Own;\n", None),
        ("python/libration/time.py", "from .orbit import Orbit\n", "3 files"),
        ("python/libration/time.py", "from . import orbit\n", "orbit.py"),
        ("python/libration/time.py", "import libration.orbit\n", "orbit.py"),
        ("python/libration/time.py", "from libration import Orbit\n", "orbit.py"),
        ("python/libration/time.py", "from . import name\n", "__init__.py"),
        ("python/libration/time.py", "def f():\n    from .series import Fourier\n", "2 files"),
        ("python/libration/time.py", "if TYPE_CHECKING:\n    from .orbit import Orbit\n", "3 files"),
        ("python/libration/time.py", "importlib.import_module('.orbit', 'libration')\n", "3 files"),
        ("bench/page.py", "def f():\n    import run\n", "bench: 2 files"),
        ("bench/page.py", "from run import f\n", "bench: 2 files"),
        ("lab/src/columns.ts", "import type { Page } from './page'\n", "lab: 3 files"),
        ("lab/src/columns.ts", "import {\n  a,\n  b,\n} from './views/index.js'\n", "lab: 2 files"),
        ("lab/src/columns.ts", "const later = () => import('./page')\n", "lab: 3 files"),
        ("lab/src/columns.ts", "import './page.css'\nimport Worker from './work?worker&inline'\n", None),
    ],
)
def test_a_circle_is_found(file, text, said, tmp_path):
    found = laid(tmp_path, **{file: text})
    assert any(said in line for line in found) if said else found == [], found


def test_a_module_that_uses_the_files_that_use_it(tmp_path):
    made = {"core/src/lanes/mod.rs": '#[path = "x86.rs"]\nmod host;\nfn f() { host::g() }\n'}
    assert laid(tmp_path, **made, **{"core/src/lanes/x86.rs": "fn g() {}\n"}) == []
    found = laid(tmp_path, **made, **{"core/src/lanes/x86.rs": "use super::f;\n"})
    assert found[1:] == ["    lanes/mod.rs uses lanes/x86.rs", "    lanes/x86.rs uses lanes/mod.rs"]
