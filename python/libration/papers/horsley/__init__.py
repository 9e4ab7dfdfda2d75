"""Horsley 2025: its figures, its numerical claims and its errata."""

from ._claims import CLAIMS
from ._errata import ERRATA
from ._figures import PICTURES

__all__ = ["CLAIMS", "ERRATA", "PICTURES"]
