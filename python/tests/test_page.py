"""The page of the lab in the package: what is packed comes out as it was built."""

import base64
import gzip
import lzma
import subprocess
import sys
from pathlib import Path

import pytest

from libration import _page

PACK = Path(__file__).parents[2] / "packages/pack_page.py"
CORE, FONT, STYLE = b"\0asm" + bytes(range(256)) * 9, b"wOF2" + bytes(range(100, 0, -1)), "body { margin: 0 }"


def address(kind: str, content: bytes) -> str:
    return f"data:{kind};base64,{base64.b64encode(content).decode()}"


def unpacked(page: str) -> str:
    """The style and the script of an offline page, read as its own script reads them."""
    letters = page.split('id="packed">')[1].split("</script>")[0]
    count = int(page.split("subarray(0, ")[1].split(")")[0])
    assert "<" not in letters
    assert len(letters) % 11 == 0
    groups = [letters[at : at + 11] for at in range(0, len(letters), 11)]
    read = bytearray()
    for group in groups:
        number = 0
        for letter in group:
            number = number * 94 + ord(letter) - (32 if ord(letter) < 60 else 33)
        read += number.to_bytes(9)
    return gzip.decompress(bytes(read[:count])).decode()


@pytest.fixture
def built(tmp_path: Path) -> Path:
    """A page as Vite builds it: files, one that has two of them inside in one text, and a module that has one."""
    folder = tmp_path / "dist"
    (folder / "assets").mkdir(parents=True)
    (folder / "assets/core.wasm").write_bytes(CORE)
    (folder / "assets/sans.woff2").write_bytes(FONT)
    core = address("application/gzip", gzip.compress(CORE, 9, mtime=0))
    elsewhere = address("application/gzip", gzip.compress(b"of no file", 9))
    inner = f"{STYLE} {address('font/woff2', FONT)}\0run('{core}', '{elsewhere}', 'θ')"
    packed = gzip.compress(inner.encode(), 9)
    (folder / "offline.html").write_text(
        f'<p>θ</p><script id="packed">{_page.letters(packed)}</script><script>a.subarray(0, {len(packed)})</script>',
        encoding="utf-8",
    )
    (folder / "widget.js").write_text(f"const core = '{core}'\nconst kind = 'data:application/gzip;base64,'")
    return folder


def test_what_is_packed_comes_out_whole(built: Path, tmp_path: Path) -> None:
    archive, folder = tmp_path / "page.tar.xz", tmp_path / "out"
    subprocess.run([sys.executable, PACK, built, archive], check=True)
    _page.unpack(archive, folder)
    assert sorted(each.relative_to(folder).as_posix() for each in folder.rglob("*.*")) == [
        "assets/core.wasm",
        "assets/sans.woff2",
        "offline.html",
        "widget.js",
    ]
    assert (folder / "assets/core.wasm").read_bytes() == CORE
    was, now = ((place / "offline.html").read_text(encoding="utf-8") for place in (built, folder))
    wanted = unpacked(was)
    assert STYLE in wanted and unpacked(now) == wanted
    assert now.split("packed")[0] == was.split("packed")[0]
    text = (folder / "widget.js").read_text(encoding="utf-8")
    inside = base64.b64decode(text.split("base64,")[1].split("'")[0])
    assert gzip.decompress(inside) == CORE
    assert text.endswith("const kind = 'data:application/gzip;base64,'")


def test_no_file_stands_twice_in_the_archive(built: Path, tmp_path: Path) -> None:
    archive = tmp_path / "page.tar.xz"
    subprocess.run([sys.executable, PACK, built, archive], check=True)
    held = lzma.decompress(archive.read_bytes())
    assert held.count(CORE) == 1 and held.count(FONT) == 1
    assert base64.b64encode(gzip.compress(CORE, 9, mtime=0)) not in held


@pytest.mark.parametrize("count", [0, 1, 8, 9, 10, 1000])
def test_nine_bytes_are_eleven_letters(count: int) -> None:
    written = _page.letters(bytes([255] * count))
    assert len(written) == -(-count // 9) * 11
    assert set(written) <= {chr(code) for code in range(32, 127)} - {"<"}
