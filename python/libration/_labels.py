"""What a result is called where arrays carry labels: the name, the units and the words of the result, not of an argument."""

from typing import Any, NamedTuple

import numpy as np


class Result(NamedTuple):
    """One result of a function: its name, its units (None where they are the user's) and its meaning."""

    name: str
    units: str | None
    long_name: str


# Attributes of an xarray argument that say what the argument is; the others say where the data come from and stay.
OF_THE_ARGUMENT = {
    "actual_range",
    "axis",
    "calendar",
    "long_name",
    "positive",
    "standard_name",
    "units",
    "valid_max",
    "valid_min",
    "valid_range",
}


def named(array: Any, result: Result) -> Any:
    """An array of xarray or pandas under the name of a result; tables of pandas keep the names of their columns."""
    if hasattr(array, "data_vars"):
        for variable in array.data_vars.values():
            variable.attrs = described(variable.attrs, result)
        return array
    if hasattr(array, "iloc"):
        labelled = array.ndim == 1
    else:
        # An index of pandas has a name and no dimensions by name; a variable of xarray the reverse.
        labelled = hasattr(array, "name")
        if hasattr(array, "dims"):
            array.attrs = described(array.attrs, result)
    if labelled:
        array.name = result.name
    return array


def described(attributes: Any, result: Result) -> dict[Any, Any]:
    """The attributes of an argument with those of the result in the place of its own."""
    kept = {name: value for name, value in attributes.items() if name not in OF_THE_ARGUMENT}
    units = {} if result.units is None else {"units": result.units}
    return kept | units | {"long_name": result.long_name}


def like(argument: Any, values: np.ndarray) -> Any:
    """New values with the labels of a pandas argument of the same shape; any other argument has none to give."""
    if not hasattr(argument, "iloc"):
        return values
    if argument.ndim == 2:
        return type(argument)(values, index=argument.index, columns=argument.columns)
    return type(argument)(values, index=argument.index)
