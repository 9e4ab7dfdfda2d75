"""Salas 2019: its figures, its numerical claims and its errata."""

from ._claims import CLAIMS
from ._errata import ERRATA as ERRATA_OF_FORMS
from ._errata_periods import ERRATA as ERRATA_OF_PERIODS
from ._figures import PICTURES

ERRATA = ERRATA_OF_FORMS + ERRATA_OF_PERIODS

__all__ = ["CLAIMS", "ERRATA", "PICTURES"]
