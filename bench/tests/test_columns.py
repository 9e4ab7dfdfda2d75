"""The columns that are timed are answered, and alike by both where a peer has the function."""

import numpy as np
import pytest
from measurement.columns import columns

COLUMNS = {column.work: column for column in columns(500)}


def first(answer) -> np.ndarray:
    return np.asarray(answer if isinstance(answer, np.ndarray) else answer[0])


@pytest.mark.parametrize("work", COLUMNS)
def test_a_timed_column_is_finite(work):
    assert np.isfinite(first(COLUMNS[work].call())).all()


# The other peers are of a package that the tests do without.
@pytest.mark.parametrize("work", [work for work, column in COLUMNS.items() if column.peer.startswith("SciPy")])
def test_a_timed_column_is_the_one_of_its_peer(work):
    column = COLUMNS[work]
    np.testing.assert_allclose(first(column.call()), first(column.theirs()), rtol=1e-9, atol=1e-12)
