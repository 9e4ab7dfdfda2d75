#!/bin/sh
# The interpreters of this machine that a wheel is tried on: CPython 3.11 and later, one of each version.
for version in 3.11 3.12 3.13 3.14 3.15; do
  for each in "python$version" "$HOME"/.pyenv/versions/"$version".*/bin/python3; do
    "$each" -c 'import venv' 2>/dev/null && { command -v "$each"; break; }
  done
done
