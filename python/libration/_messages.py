"""What is said of a wrong argument: its name, its value, what is allowed, and what to write instead.

Nothing here runs before a call: `explained` looks at the arguments of a function only once the function has refused
them. What it finds nothing wrong with keeps the error it has.
"""

import inspect
from collections.abc import Callable, Iterator
from difflib import get_close_matches
from functools import wraps
from typing import Any, TypeVar, cast

import numpy as np

from ._advice import advice, element_kind, has_units
from ._scalars import shown
from ._units import plain_call

Function = TypeVar("Function", bound=Callable[..., Any])

# What other libraries and books call an argument, and what it is called here, the first that the function has.
ARGUMENTS: dict[str, tuple[str, ...]] = {
    "g": ("gravity",),
    "G": ("gravity",),
    "l": ("length",),
    "L": ("length",),
    "x": ("u",),
    "time": ("t",),
    "times": ("t",),
    "w0": ("omega0",),
    "w": ("omega0",),
    "omega": ("omega0",),
    "omega_0": ("omega0",),
    "frequency": ("omega0",),
    "angle": ("theta0", "theta"),
    "theta_0": ("theta0",),
    "phi0": ("theta0",),
    "amplitude": ("theta0", "theta_max"),
    "theta_dot": ("velocity0", "velocity"),
    "thetadot0": ("velocity0",),
    "v0": ("velocity0",),
    "speed": ("velocity0", "velocity"),
    "alpha": ("p",),
    "beta": ("q",),
    "gamma": ("s",),
    "delta": ("p",),
    "m1": ("mc",),
    "modulus": ("k",),
    "parameter": ("m",),
}
# What SciPy and others call a function of this package.
FUNCTIONS = {
    "ellipj": "jacobi",
    "ellipk": "complete_k",
    "ellipkm1": "complete_k(mc=...)",
    "ellipe": "complete_e",
    "ellippi": "complete_pi",
    "ellipkinc": "incomplete_f",
    "ellipeinc": "incomplete_e",
    "ellipf": "incomplete_f",
    "ellipfun": "jacobi",
    "elliprc": "carlson_rc",
    "elliprd": "carlson_rd",
    "elliprf": "carlson_rf",
    "elliprj": "carlson_rj",
    "jtheta": "theta1",
    "degrees": "Pendulum.degrees",
    "compare": "approx.compare",
    "plot_period": "plot.plot_period",
    "plot_motion": "plot.plot_motion",
}
# What Python and NumPy raise for an argument that they do not take.
REFUSALS = (TypeError, ValueError, OverflowError)
# The arguments that are no numbers.
OTHERS = {
    "self",
    "cls",
    "out",
    "where",
    "form",
    "formula",
    "name",
    "pendulum",
    "kick",
    "record",
    "scheme",
    "distribution",
}
OTHERS |= {"states", "histogram", "mean", "chunks"}
COMPLEX = {"jacobi_complex", *"sn cn dn ns nc nd sc cs sd ds cd dc".split()}
PARAMETER = {"m": "the parameter", "mc": "its complement 1 - m", "k": "the modulus", "q": "the nome"}


def explained(function: Function) -> Function:
    """A function whose refusals of an argument say what to write instead."""

    @wraps(function)
    def call(*arguments: Any, **keywords: Any) -> Any:
        try:
            return function(*arguments, **keywords)
        except REFUSALS as error:
            return refuse(error, function, arguments, keywords)

    return cast(Function, call)


def refuse(
    error: Exception, function: Callable[..., Any], arguments: tuple[Any, ...], keywords: dict[str, Any] | None = None
) -> Any:
    """Raise what explains the error of a call, or the error itself; quantities with units are taken as numbers first."""
    try:
        call = plain_call(function, arguments, keywords or {})
    except ValueError as wrong:
        raise type(error)(str(wrong)) from None
    if call is not None:
        return function(*call[0], **call[1])
    found = _explanation(error, inspect.unwrap(function), arguments, keywords or {})
    if found is None:
        raise error
    raise found from None


def _explanation(
    error: Exception, function: Callable[..., Any], arguments: tuple[Any, ...], keywords: dict[str, Any]
) -> Exception | None:
    signature = inspect.signature(function)
    name = _called(function, arguments)
    try:
        given = signature.bind(*arguments, **keywords).arguments
    except TypeError:
        return TypeError(f"{name}() {_misplaced(signature, arguments, keywords)}")
    numbers = {each: value for each, value in _single(signature, given) if each not in OTHERS}
    if isinstance(error, TypeError | OverflowError):
        for each, value in numbers.items():
            if _beyond_doubles(value):
                return ValueError(f"{each} = an integer beyond the doubles: must be finite")
            if reason := _not_real(name, each, value):
                return TypeError(f"{each} = {shown(value)}: {reason}")
        return _about_out(given.get("out"), error)
    if "broadcast" in str(error):
        return _about_shapes(numbers, given)
    if "inhomogeneous" in str(error):
        for each, value in numbers.items():
            if isinstance(value, list | tuple) and (reason := _not_real(name, each, value)):
                return ValueError(f"{each} = {shown(value)}: {reason}")
    return _about_out(given.get("out"), error)


def _called(function: Callable[..., Any], arguments: tuple[Any, ...]) -> str:
    """The name of a function as its caller knows it: a class makes objects, and its methods are those of its bases."""
    if "." not in function.__qualname__ or not arguments:
        return function.__name__
    owner = arguments[0] if isinstance(arguments[0], type) else type(arguments[0])
    return owner.__name__ if function.__name__ == "__new__" else f"{owner.__name__}.{function.__name__}"


def _single(signature: inspect.Signature, given: dict[str, Any]) -> Iterator[tuple[str, Any]]:
    """The arguments by name; those of a ``*name`` one by one."""
    for each, value in given.items():
        if signature.parameters[each].kind is inspect.Parameter.VAR_POSITIONAL:
            yield from ((f"{each}[{place}]", part) for place, part in enumerate(value))
        elif value is not None or signature.parameters[each].default is not None:
            yield each, value


def _misplaced(signature: inspect.Signature, arguments: tuple[Any, ...], keywords: dict[str, Any]) -> str:
    """What is wrong with a call whose arguments do not fit the signature."""
    own = [each for each in signature.parameters.values() if each.name not in ("self", "cls")]
    taken = [each.name for each in own]
    for keyword in keywords:
        if keyword not in taken:
            return f"got an unexpected keyword argument {keyword!r}: {_nearest(keyword, taken)}"
    positional = [each.name for each in own if each.kind is not inspect.Parameter.KEYWORD_ONLY]
    named = [each.name for each in own if each.kind is inspect.Parameter.KEYWORD_ONLY]
    count = len(arguments) - (len(signature.parameters) - len(own))
    if count > len(positional):
        by_position = f"takes {', '.join(positional) or 'nothing'} by position"
        if "mc" in named:
            words = ", ".join(f"{each}= ({PARAMETER[each]})" for each in named if each in PARAMETER)
            return f"{by_position} and one of {words} by name"
        by_name = f" and {', '.join(f'{each}=' for each in named)} by name" if named else ""
        return f"{by_position}{by_name}; {count} are given by position"
    twice = [each for each in positional[:count] if each in keywords]
    if twice:
        return f"got {twice[0]} by position and by name"
    empty = inspect.Parameter.empty
    missing = [each.name for each in own if each.default is empty and each.name not in keywords]
    missing = [each for each in missing if each not in positional[:count]]
    return (
        f"needs {' and '.join(f'{each}=' if each in named else each for each in missing)}; it takes {', '.join(taken)}"
    )


def _nearest(name: str, known: list[str]) -> str:
    """The name that is meant, or all there are."""
    meant = next((each for each in ARGUMENTS.get(name, ()) if each in known), None)
    # A letter or two are near to everything short.
    near = get_close_matches(name, [each for each in known if len(each) > 2], n=1) if len(name) > 2 else []
    if meant or near:
        return f"did you mean {meant or near[0]}?"
    return f"it takes {', '.join(known)}"


def no_member(module: str, name: str) -> AttributeError:
    """The error of a name that a module does not have, with what it is called here; Python itself adds the nearest."""
    meant = FUNCTIONS.get(name)
    return AttributeError(
        f"module {module!r} has no attribute {name!r}" + (f": did you mean {meant}?" if meant else "")
    )


def _beyond_doubles(value: Any) -> bool:
    """Whether an argument has a whole number that no double is near to."""
    if not isinstance(value, int | list | tuple) and getattr(getattr(value, "dtype", None), "kind", None) != "O":
        return False
    try:
        np.asarray(value, dtype=float)
    except OverflowError:
        return True
    except (TypeError, ValueError):
        return False
    return False


def _not_real(function: str, name: str, value: Any) -> str:
    """Why an argument is not an array of real numbers; empty if it is one, or nothing is known of it."""
    array = value
    if isinstance(value, list | tuple):
        try:
            array = np.asarray(value)
        except ValueError:
            return "has rows of different lengths: must be one length, NaN where there is nothing"
    kind = element_kind(array)
    complex_too = name == "u" and function in COMPLEX
    if not kind:
        plain = isinstance(array, int | float | range) or (complex_too and isinstance(array, complex))
        known = plain or hasattr(array, "__array__") or hasattr(array, "iloc")
        if text := _column_of_text(array):
            return f"must be real numbers, not {text}"
    else:
        known = kind in ("biuc" if complex_too else "biu") or (kind == "f" and array.dtype.itemsize <= 8)
    if known and not has_units(array):
        return ""
    if name == "u" and np.iscomplexobj(array):
        return "must be real numbers; jacobi_complex takes a complex u"
    numbers = ("complex numbers" if complex_too else "real numbers") + (" without units" if has_units(array) else "")
    other = f", not {array.dtype}" if kind and not known and getattr(value, "ndim", None) else ""
    return f"must be {numbers}{other}{advice(name, array)}"


def _column_of_text(table: Any) -> str:
    """The first column of a table of pandas, or variable of a data set of xarray, that holds no numbers."""
    columns = getattr(table, "data_vars", table) if hasattr(table, "data_vars") or hasattr(table, "columns") else {}
    for column in columns:
        dtype = table[column].dtype
        if element_kind(table[column]) not in "biuf":
            return f"{dtype} in {column!r}"
    return ""


def _about_out(out: Any, error: Exception) -> Exception | None:
    """What is wrong with `out`."""
    if out is None:
        return None
    for each in out if isinstance(out, tuple) else (out,):
        if "ArrayType" in str(error) and each is not None and not hasattr(each, "dtype"):
            return TypeError(f"out = {shown(out)}: must be an array of float64, or a tuple of one for each result")
        if each is not None and "cast" in str(error):
            return TypeError(f"out is an array of {each.dtype}: must be one of float64")
    if "'out'" in str(error):
        given = f"a tuple of {len(out)}" if isinstance(out, tuple) else "one array"
        return type(error)(
            f"out is {given}: must be an array where there is one result, a tuple of one for each result"
        )
    return None


def _about_shapes(numbers: dict[str, Any], given: dict[str, Any]) -> Exception | None:
    """Why arrays do not go together."""
    where = {"where": given["where"]} if np.ndim(given.get("where", True)) else {}
    arrays = {name: value for name, value in (numbers | where).items() if np.ndim(value)}
    if any(hasattr(value, "dims") or hasattr(value, "iloc") for value in arrays.values()):
        # They go together by their labels.
        return None
    shapes = {name: np.shape(value) for name, value in arrays.items()}
    try:
        whole = np.broadcast_shapes(*shapes.values())
    except ValueError:
        listed = ", ".join(f"{name} {shape}" for name, shape in shapes.items())
        hint = ""
        if all(len(shape) == 1 for shape in shapes.values()) and not where:
            first, second = next((a, b) for a in shapes for b in shapes if shapes[a] != shapes[b])
            array = first if hasattr(arrays[first], "dtype") else f"np.array({first})"
            hint = f"; for each {first} with each {second} write {array}[:, None]"
        return ValueError(f"shapes of {listed}: must be equal, or 1 where they differ{hint}")
    out = given.get("out")
    for each in out if isinstance(out, tuple) else (out,):
        if hasattr(each, "shape") and each.shape != whole:
            return ValueError(f"out of shape {each.shape}: must have the shape of the result, {whole}")
    return None
