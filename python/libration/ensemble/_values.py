"""The numbers that a bucket is asked for."""

import math
from typing import Any

import numpy as np

from .._dispatch import numbers


def inside(theta_max: Any) -> Any:
    """Turning angles of librations; others are NaN."""
    angles = np.ma.filled(numbers(theta_max), np.nan)
    return np.where(np.abs(angles) < math.pi, angles, np.nan)[()]


def real_numbers(values: Any) -> Any:
    """Real numbers; arrays of xarray keep their names."""
    return values if hasattr(values, "dims") else numbers(values)
