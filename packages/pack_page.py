"""Packs the built page into the archive that the package carries: what two files have inside stands in it once.

python packages/pack_page.py lab/dist python/libration/page.tar.xz
"""

import base64
import gzip
import importlib.util
import io
import lzma
import re
import sys
import tarfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
place = importlib.util.spec_from_file_location("page", ROOT / "python/libration/_page.py")
page = importlib.util.module_from_spec(place)
place.loader.exec_module(page)

PACKED = re.compile(r'(?<=id="packed">)[^<]*(?=</script>)')
COUNT = re.compile(r"(?<=subarray\(0, )\d+(?=\))")
INSIDE = re.compile(r"data:(application/gzip|font/woff2);base64,([A-Za-z0-9+/]+=*)")


def bytes_of(letters: str, count: int) -> bytes:
    """What `letters` of the package has written."""
    digit = {chr(code): place for place, code in enumerate(page.ALPHABET)}
    read = bytearray()
    for at in range(0, len(letters), page.LETTERS):
        value = 0
        for letter in letters[at : at + page.LETTERS]:
            value = value * len(digit) + digit[letter]
        read += value.to_bytes(page.BYTES)
    return bytes(read[:count])


def named(text: str, files: dict[str, bytes]) -> str:
    """A text with the names of files in the place of those that stand beside it; others stay."""
    names = {content: name for name, content in files.items()}

    def name_of(found: re.Match[str]) -> str:
        zipped = found[1] == "application/gzip"
        content = base64.b64decode(found[2])
        name = names.get(gzip.decompress(content) if zipped else content)
        return f"\ue000{'gzip' if zipped else 'font'}:{name}\ue001" if name else found[0]

    return INSIDE.sub(name_of, text)


def loose(text: str, files: dict[str, bytes]) -> str:
    """A text of the page as the archive has it."""
    assert not re.search("[\ue000-\ue004]", text), "a mark of the archive stands in the page"
    if not (packed := PACKED.search(text)):
        return named(text, files)
    [count] = COUNT.findall(text)
    inner = gzip.decompress(bytes_of(packed[0], int(count))).decode()
    script = COUNT.sub(page.COUNT, text[packed.end() :])
    return f"{text[: packed.start()]}\ue002{named(inner, files)}\ue003{script}"


def main(built: str, archive: str) -> int:
    folder = Path(built)
    files = {
        each.relative_to(folder).as_posix(): each.read_bytes() for each in sorted(folder.rglob("*")) if each.is_file()
    }
    held = io.BytesIO()
    with tarfile.open(fileobj=held, mode="w", format=tarfile.USTAR_FORMAT) as tar:
        # Like beside like.
        for name in sorted(files, key=lambda each: (Path(each).suffix, each)):
            text = name in ("offline.html", "widget.js")
            content = loose(files[name].decode(), files).encode() if text else files[name]
            about = tarfile.TarInfo(name)
            about.size = len(content)
            tar.addfile(about, io.BytesIO(content))
    Path(archive).write_bytes(lzma.compress(held.getvalue(), preset=9 | lzma.PRESET_EXTREME))
    again = page.files(Path(archive))
    assert again.keys() == files.keys()
    for name, content in files.items():
        assert again[name] == content or loose(again[name].decode(), files) == loose(content.decode(), files), name
    return 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
