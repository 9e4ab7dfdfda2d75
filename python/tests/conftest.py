"""What only POSIX has is tested where there is POSIX: forks, links, groups of processes, named pipes, a shell's redirections.

Whole files by name, single tests by the mark `posix`; everything else is the same on every system.
"""

import os

import pytest

FILES = ("test_cli_completion.py", "test_cli_streams.py", "test_ensemble_runs.py", "test_interrupts.py")
collect_ignore = [] if os.name == "posix" else list(FILES)


def pytest_configure(config):
    config.addinivalue_line("markers", "posix: of what only POSIX has")


def pytest_collection_modifyitems(config, items):
    if os.name != "posix":
        items[:] = [each for each in items if each.get_closest_marker("posix") is None]


@pytest.fixture(autouse=True)
def english(monkeypatch):
    """What the tests read is English, whatever the system speaks."""
    monkeypatch.setenv("LC_ALL", "C.UTF-8")
