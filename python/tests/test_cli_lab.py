"""`libration lab`: one folder, to this machine alone, until Ctrl-C."""

import signal
import subprocess
import sys
import threading
import urllib.error
import urllib.request
from collections.abc import Iterator
from pathlib import Path

import pytest

from libration.cli import lab, main


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    page = tmp_path / "page"
    (page / "assets").mkdir(parents=True)
    (page / "index.html").write_text("<title>lab</title>")
    (page / "assets" / "core.wasm").write_bytes(b"\0asm")
    (tmp_path / "secret.txt").write_text("not for the page")
    (page / "way-out.txt").symlink_to(tmp_path / "secret.txt")
    return page


@pytest.fixture
def address(folder: Path) -> Iterator[str]:
    with lab.server(folder, 0) as serving:
        thread = threading.Thread(target=serving.serve_forever, daemon=True)
        thread.start()
        yield f"http://{serving.server_address[0]}:{serving.server_address[1]}"
        serving.shutdown()
        thread.join()


def status(address: str) -> int:
    try:
        with urllib.request.urlopen(address) as answer:
            return int(answer.status)
    except urllib.error.HTTPError as error:
        return error.code


def test_the_page_and_its_files_are_given_with_their_types(address: str) -> None:
    with urllib.request.urlopen(address + "/") as answer:
        assert answer.read() == b"<title>lab</title>"
    with urllib.request.urlopen(address + "/assets/core.wasm") as answer:
        assert answer.headers["Content-Type"] == "application/wasm"
        assert answer.headers["X-Content-Type-Options"] == "nosniff"


@pytest.mark.parametrize(
    "path",
    ["/../secret.txt", "/%2e%2e/secret.txt", "/assets/..%2f..%2fsecret.txt", "/way-out.txt", "/assets/", "/nothing"],
)
def test_nothing_else_is(address: str, path: str) -> None:
    assert status(address + path) == 404


def test_it_listens_to_this_machine_alone(folder: Path) -> None:
    with lab.server(folder, 0) as serving:
        assert serving.server_address[0] == "127.0.0.1"


@pytest.mark.parametrize("port", ["0", "-1", "65536", "80a", "1.5", ""])
def test_a_port_that_is_none_is_refused(port: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["lab", f"--port={port}"]) == 2
    assert "--port" in capsys.readouterr().err


def test_without_the_page_it_says_where_it_is(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(lab, "PAGE", tmp_path)
    assert main(["lab", "--no-browser"]) == 2
    assert "make page" in capsys.readouterr().err


def test_a_port_in_use_is_refused(
    folder: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(lab, "PAGE", folder)
    with lab.server(folder, 0) as serving:
        assert main(["lab", "--no-browser", "--port", str(serving.server_address[1])]) == 2
    assert "leave it out for a free one" in capsys.readouterr().err


@pytest.mark.posix
def test_ctrl_c_ends_it(folder: Path) -> None:
    program = f"""
import sys
from pathlib import Path
from libration.cli import lab, main
lab.PAGE = Path({str(folder)!r})
sys.exit(main(["lab", "--no-browser"]))
"""
    with subprocess.Popen([sys.executable, "-c", program], stdout=subprocess.PIPE, text=True) as child:
        assert child.stdout is not None
        line = child.stdout.readline()
        assert line.startswith("The lab is at http://127.0.0.1:")
        assert status(line.split()[4]) == 200
        child.send_signal(signal.SIGINT)
        assert child.wait(timeout=60) == 130
