"""Processes that tests start: their signals are the system's own, whatever `nohup` or a shell's `&` has made of ours."""

import signal
import subprocess

OWN = (signal.SIGHUP, signal.SIGINT, signal.SIGQUIT, signal.SIGTERM, signal.SIGPIPE)


def default_signals():
    """What every started process runs first: a signal that is ignored would be so in the child too."""
    for number in OWN:
        signal.signal(number, signal.SIG_DFL)


def run(words, **options):
    """`subprocess.run` with signals of its own; ten minutes are a hang on any machine."""
    return subprocess.run(words, **{"timeout": 600, "preexec_fn": default_signals} | options)


def start(words, **options):
    """`subprocess.Popen` with signals of its own."""
    return subprocess.Popen(words, preexec_fn=default_signals, **options)
