"""Starts JupyterLab in an empty folder with one empty notebook, and runs the story of the widget in Chromium.

python lab/tests/widget/run.py [PICTURE]     by an interpreter that has jupyterlab, anywidget and libration
"""

import json
import os
import secrets
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from urllib.request import urlopen

HERE = Path(__file__).resolve().parent
LAB = HERE.parents[1]
EMPTY = {
    "cells": [
        {"cell_type": "code", "id": "first", "execution_count": None, "metadata": {}, "outputs": [], "source": ""}
    ],
    "metadata": {"kernelspec": {"display_name": "Python 3", "language": "python", "name": "python3"}},
    "nbformat": 4,
    "nbformat_minor": 5,
}
# All cells stay in the page, and nobody asks for news.
SETTINGS = {
    "notebook-extension/tracker": {"windowingMode": "none"},
    "apputils-extension/notification": {"fetchNews": "false", "checkForUpdates": False},
}


def free_port() -> int:
    """A port that no one listens at."""
    import socket

    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


def answers(address: str) -> bool:
    """Whether a server answers."""
    try:
        with urlopen(address, timeout=5):
            return True
    except OSError:
        return False


def main() -> int:
    """The exit code of the story."""
    port, token = free_port(), secrets.token_hex(16)
    with tempfile.TemporaryDirectory() as folder:
        Path(folder, "pendulum.ipynb").write_text(json.dumps(EMPTY), encoding="utf-8")
        for name, values in SETTINGS.items():
            file = Path(folder, "settings", "@jupyterlab", f"{name}.jupyterlab-settings")
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(json.dumps(values), encoding="utf-8")
        words = ["-m", "jupyterlab", "--no-browser", "--allow-root", "--ip=127.0.0.1", f"--port={port}"]
        words += [f"--IdentityProvider.token={token}", f"--ServerApp.root_dir={folder}"]
        own = {f"JUPYTER_{name}_DIR": str(Path(folder, name.lower())) for name in ("CONFIG", "RUNTIME")}
        own["JUPYTERLAB_SETTINGS_DIR"] = str(Path(folder, "settings"))
        server = subprocess.Popen([sys.executable, *words], cwd=folder, env=os.environ | own | {"HOME": folder})
        try:
            while not answers(f"http://127.0.0.1:{port}/api?token={token}"):
                if server.poll() is not None:
                    return 1
                time.sleep(0.5)
            story = os.environ | {"JUPYTER": f"http://127.0.0.1:{port}/?token={token}"}
            if len(sys.argv) > 1:
                story["PICTURE"] = str(Path(sys.argv[1]).resolve())
            return subprocess.run(["npx", "playwright", "test", "--config", str(HERE)], cwd=LAB, env=story).returncode
        finally:
            server.terminate()
            server.wait()


if __name__ == "__main__":
    sys.exit(main())
