"""`libration lab`: serves the page that comes with the package, and opens it in the browser.

To this machine alone: the server listens on the loopback address and gives the files of one folder. The page needs no
more than files (docs/decisions/0023-the-page.md); Ctrl-C ends it.
"""

import webbrowser
from http import HTTPStatus
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from typing import Any

from libration.cli.language import told
from libration.cli.parser import Flag, Options, Refusal, Value, command, refusal

HOST = "127.0.0.1"
#: Put here by `make page`; a wheel has it.
PAGE = Path(__file__).parent.parent / "page"
DESCRIPTION = """\
Opens the lab in the browser: the exact pendulum to drag, beside the formulas and numerical methods people use, with
their errors. Nothing leaves this machine, and no network is needed. Ctrl-C ends it."""


class Handler(SimpleHTTPRequestHandler):
    """The files of one folder, and nothing else: no listing, no link that leads out of it."""

    def send_head(self) -> Any:
        """The head of a file, or 404 for what is not in the folder."""
        asked = Path(self.translate_path(self.path)).resolve()
        folder = Path(self.directory).resolve()
        inside = asked.is_relative_to(folder)
        if inside and asked.is_dir():
            inside = (asked / "index.html").is_file()
        if not inside:
            self.send_error(HTTPStatus.NOT_FOUND)
            return None
        return super().send_head()

    def end_headers(self) -> None:
        """With the promise that a type is what it says; the page itself is asked for again at each visit."""
        self.send_header("X-Content-Type-Options", "nosniff")
        self.send_header("Cache-Control", "no-cache")
        super().end_headers()

    def log_message(self, *_: object) -> None:
        """Nothing: the terminal keeps the address."""


# What a browser needs to know of them, whatever the tables of this machine say.
Handler.extensions_map = {
    **SimpleHTTPRequestHandler.extensions_map,
    ".js": "text/javascript",
    ".wasm": "application/wasm",
    ".woff2": "font/woff2",
}


def server(folder: Path, port: int) -> ThreadingHTTPServer:
    """A server of the folder at a port of this machine; 0 is any that is free."""

    def handler(*arguments: Any) -> Handler:
        return Handler(*arguments, directory=str(folder))

    return ThreadingHTTPServer((HOST, port), handler)


class LabOptions(Options):
    """The options of `libration lab`."""

    port: str | None
    no_browser: bool


def port_of(text: str | None) -> int:
    """The port asked for; 0 if none was."""
    if text is None:
        return 0
    if not text.isascii() or not text.isdigit() or not 1 <= int(text) <= 65535:
        raise refusal("--port", text, "must be a whole number from 1 to 65535")
    return int(text)


def run(options: LabOptions) -> None:
    """Serve the page until Ctrl-C."""
    port = port_of(options.port)
    if not (PAGE / "index.html").is_file():
        raise Refusal("the page is not part of this installation; a wheel has it, and `make page` in a clone builds it")
    try:
        serving = server(PAGE, port)
    except OSError as error:
        raise Refusal(f"--port {port}: {error.strerror or error}; leave it out for a free one") from error
    with serving:
        address = f"http://{HOST}:{serving.server_address[1]}/"
        print(told(f"The lab is at {address} (Ctrl-C ends it)"), flush=True)
        if not options.no_browser:
            webbrowser.open(address)
        serving.serve_forever()


COMMAND = command(
    "lab",
    DESCRIPTION,
    run,
    LabOptions,
    short="open the lab in the browser: the exact pendulum beside formulas and numerical methods",
    parameters=[
        Value("--port", "N", "the port to serve at; by default one that is free", "serving"),
        Flag("--no-browser", "print the address and open nothing", "serving"),
    ],
    usage=["libration lab", "[options]"],
    topics=[],
    examples=["libration lab", "libration lab --no-browser --port 8765"],
)
