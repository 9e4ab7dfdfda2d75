"""Writes the vectors of the elliptic functions and integrals, fourteen files.

Run: python elliptic_vectors.py [FILE ...] (a minute for all). Four files are by mpmath (elliptic.py), ten in balls (family.py).
"""

import argparse

import elliptic
import elliptic_inputs
import exact
import family
import family_inputs

SOURCES = {
    **dict.fromkeys(elliptic.FILES, (elliptic, elliptic_inputs)),
    **dict.fromkeys(family.FILES, (family, family_inputs)),
}


def main():
    options = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    options.add_argument("files", nargs="*", metavar="FILE", help=f"{', '.join(SOURCES)}; without names all of them")
    chosen = options.parse_args().files
    if unknown := sorted(set(chosen) - set(SOURCES)):
        raise SystemExit(f"reference: {unknown[0]}: must be one of {', '.join(SOURCES)}")
    for name in chosen or SOURCES:
        values, inputs = SOURCES[name]
        header, row = values.FILES[name]
        exact.write(name, header, map(row, inputs.rows(name)))


if __name__ == "__main__":
    main()
