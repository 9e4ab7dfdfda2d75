"""The page of the lab as the package carries it: one archive, in which nothing stands twice.

Two of its files have others inside, compressed and as text: the offline page and the drawing of notebooks. The archive, written by
packages/pack_page.py, has the name of the file in that place; here the text is made anew. `make page` builds it, a wheel has it.
"""

import base64
import gzip
import re
import tarfile
from pathlib import Path

ARCHIVE = Path(__file__).with_name("page.tar.xz")
#: A file that is inside another one: how it is written there, and its name.
INSIDE = re.compile("\ue000(gzip|font):([^\ue001]+)\ue001")
#: What of the offline page is compressed as one text; and how many bytes that is, which its script says.
PACKED, COUNT = re.compile("\ue002([^\ue003]*)\ue003"), "\ue004"
#: How a file is named in a text that has it inside.
ADDRESS = {"gzip": "data:application/gzip;base64,", "font": "data:font/woff2;base64,"}
#: Nine bytes are eleven letters: the printable ones without `<`, so that there is no mark of HTML among them.
BYTES, LETTERS = 9, 11
ALPHABET = bytes(code for code in range(32, 127) if code != ord("<"))


def letters(packed: bytes) -> str:
    """Bytes as letters of the alphabet, as lab/bundle/one-file.ts writes them."""
    padded = packed + bytes(-len(packed) % BYTES)
    written = bytearray()
    for at in range(0, len(padded), BYTES):
        rest, group = int.from_bytes(padded[at : at + BYTES]), bytearray()
        for _ in range(LETTERS):
            rest, digit = divmod(rest, len(ALPHABET))
            group.append(ALPHABET[digit])
        written += group[::-1]
    return written.decode("ascii")


def whole(text: str, files: dict[str, bytes]) -> str:
    """A text of the archive with the files in it."""

    def inside(found: re.Match[str]) -> str:
        kind, name = found.groups()
        given = gzip.compress(files[name], 9, mtime=0) if kind == "gzip" else files[name]
        return ADDRESS[kind] + base64.b64encode(given).decode("ascii")

    text = INSIDE.sub(inside, text)
    if not (part := PACKED.search(text)):
        return text
    packed = gzip.compress(part[1].encode(), 9, mtime=0)
    before, after = text[: part.start()], text[part.end() :]
    return before + letters(packed) + after.replace(COUNT, str(len(packed)))


def files(archive: Path) -> dict[str, bytes]:
    """Every file of the page, by its name in the folder of the page."""
    with tarfile.open(archive, "r:xz") as opened:
        held = {each.name: part.read() for each in opened if (part := opened.extractfile(each))}
    for name in ("offline.html", "widget.js"):
        if name in held:
            held[name] = whole(held[name].decode(), held).encode()
    return held


def unpack(archive: Path, folder: Path) -> None:
    """Write the files of the page into a folder."""
    for name, content in files(archive).items():
        place = folder / name
        place.parent.mkdir(parents=True, exist_ok=True)
        place.write_bytes(content)
