"""Complex arguments and results of ufuncs that know real numbers only: a pair of operands for each."""

from typing import Any

import numpy as np

from .._labels import like
from .._scalars import shown

COUNTS = {1: "an array", 3: "a tuple of three arrays"}


class Joined:
    """The ufunc of real parts as one of complex results, with what `dispatch.apply` asks of a ufunc."""

    def __init__(self, ufunc: np.ufunc) -> None:
        self.ufunc = ufunc
        self.nout = ufunc.nout // 2
        self.types = ("ddd->" + self.nout * "D",)

    def __call__(self, *operands: Any, out: Any = None, where: Any = True) -> Any:
        if out is None:
            found = self.ufunc(*operands, where=where)
            whole = tuple(_join(*found[2 * i : 2 * i + 2]) for i in range(self.nout))
            return whole if self.nout > 1 else whole[0]
        wholes = out if isinstance(out, tuple) else (out,)
        if [getattr(each, "dtype", None) for each in wholes] != self.nout * [np.complex128]:
            raise TypeError(f"out = {shown(out)}: must be {COUNTS[self.nout]} of complex128")
        self.ufunc(*operands, out=tuple(part for whole in wholes for part in (whole.real, whole.imag)), where=where)
        return out


def is_complex(u: Any) -> bool:
    """Whether an argument is of complex numbers."""
    return type(u) is not float and bool(np.iscomplexobj(u))


def parts(u: Any) -> tuple[Any, Any]:
    """Real and imaginary part, with the labels of the whole."""
    if hasattr(u, "real"):
        return u.real, u.imag
    values = np.asarray(u)
    return like(u, values.real), like(u, values.imag)


def _join(re: Any, im: Any) -> Any:
    """re + 1j im without arithmetic, which would make an infinity NaN."""
    whole = np.empty(np.shape(re), np.complex128)
    whole.real, whole.imag = re, im
    return like(re, whole) if whole.ndim else whole[()]
