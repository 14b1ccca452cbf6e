"""What is committed is the same on every processor: no byte hangs on the last bit of a float.

Where a processor has wider registers, numpy and OpenBLAS take other code for sines and products,
and what comes out differs in the last bits. Here these bits are changed, by settings and by hand.
"""

import math
import os
import platform
import subprocess
import sys
from collections.abc import Iterable
from typing import Any

import numpy as np
import pytest
from chunks import DEEP
from hangs import HANGS
from tresym.proofs import figures
from tresym.proofs.tables import TABLES, table, written

from tresym.report import charts
from tresym.report.figures.grid import coordinate, on_grid, shown
from tresym.report.pages import documents

pytest.importorskip("matplotlib")

ULPS = 8
"""By how many units in the last place a function of numpy or of C may be off here; few are by 4."""

SHAKEN = {
    np: "sin cos tan arcsin arccos arctan arctan2 sinh cosh tanh arcsinh arccosh arctanh exp expm1 "
    "log log1p log2 log10 power hypot cbrt dot matmul inner einsum",
    math: "sin cos tan asin acos atan atan2 sinh cosh tanh asinh acosh atanh exp expm1 log log1p "
    "log2 log10 pow hypot dist",
    np.linalg: "norm",
}


class Shaken:
    """A function with other last bits: always the same ones of the same value, as in a machine."""

    def __init__(self, function: Any, seed: int) -> None:
        self.function, self.seed = function, seed

    def __getattr__(self, name: str) -> Any:
        return getattr(self.function, name)

    def __call__(self, *args: Any, **options: Any) -> Any:
        found = self.function(*args, **options)
        exact = np.asarray(found)
        if exact.dtype != np.float64:
            return found
        bits = np.atleast_1d(exact).copy().view(np.uint64)
        mixed = (bits ^ np.uint64(self.seed)) * np.uint64(0x9E3779B97F4A7C15)  # the top bits mix
        share = (mixed >> np.uint64(11)).astype(float) / 2.0**52 - 1
        with np.errstate(all="ignore"):
            other = exact * (1 + ULPS * 2.0**-52 * share.reshape(exact.shape))
        if np.abs(exact).max(initial=0) <= 1:
            other = np.clip(other, -1, 1)  # no sine is beyond 1
        if options.get("out") is not None:
            found[...] = other
            return found
        return other if isinstance(found, np.ndarray) else type(found)(other)


@pytest.fixture
def shaken(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> None:
    import matplotlib.backends.backend_svg  # noqa: F401  (what is loaded now takes the true ones)

    for module, names in SHAKEN.items():
        for name in names.split():
            other = Shaken(getattr(module, name), request.param)
            monkeypatch.setattr(module, name, other)


def by_turns(names: Iterable[str]) -> list[Any]:
    """Every second in each run, and all of them every night."""
    night = pytest.mark.night
    return [pytest.param(name, marks=night if n % 2 else ()) for n, name in enumerate(names)]


def saved(path: str) -> str:
    return shown((documents.folder() / path).read_text(encoding="utf-8"))


@pytest.mark.slow
@pytest.mark.parametrize("shaken", [1, 2] if DEEP else [1], indirect=True)
@pytest.mark.parametrize("name", by_turns(figures.FIGURES))
def test_a_figure_is_the_saved_one_whatever_the_last_bits(shaken: None, name: str) -> None:
    assert shown(figures.svg(name)) == saved(f"figures/{name}.svg")


@pytest.mark.slow
@pytest.mark.parametrize("shaken", [3], indirect=True)
@pytest.mark.parametrize("name", by_turns(charts.CHARTS))
def test_a_chart_is_the_saved_one_whatever_the_last_bits(shaken: None, name: str) -> None:
    assert shown(charts.svg(name)) == saved(f"charts/{name}.svg")


@pytest.mark.slow
@pytest.mark.parametrize("shaken", [4], indirect=True)
@pytest.mark.parametrize("name", by_turns(TABLES))
def test_a_table_is_the_saved_one_whatever_the_last_bits(shaken: None, name: str) -> None:
    found = table(name)
    assert written(found, "markdown") == saved(f"tables/{name}.md")
    assert written(found, "latex") == saved(f"tables/{name}.tex")


@pytest.mark.parametrize("shaken", [1, 2, 3, 4], indirect=True)
def test_the_bits_are_shaken(shaken: None) -> None:
    x = np.linspace(0.1, 1.4, 1000)
    off = np.sin(x) / (np.sin(x / 2) * np.cos(x / 2)) / 2 - 1
    assert 2 < np.abs(off).max() * 2.0**52 < 4 * ULPS
    assert np.array_equal(np.sin(x), np.sin(x))


def settings() -> dict[str, dict[str, str]]:
    """Environments in which numpy and OpenBLAS take other code than by themselves, where they can.

    ``found`` are the sets of instructions that this processor has and numpy has code for.
    """
    found = np.show_config(mode="dicts")["SIMD Extensions"].get("found", [])
    fewer = {
        "none": ("Prescott", found),
        "first": ("Haswell" if "X86_V3" in found or "AVX2" in found else "Nehalem", found[1:]),
    }
    kernel = platform.machine() in ("x86_64", "AMD64")
    return {
        name: ({"NPY_DISABLE_CPU_FEATURES": " ".join(without)} if without else {})
        | ({"OPENBLAS_CORETYPE": core} if kernel else {})
        for name, (core, without) in fewer.items()
    }


STALE = (
    "from tresym.report.pages import documents as d; print(*d.stale(d.drawn()), sep='\\n', end='')"
)


@pytest.mark.night
@pytest.mark.parametrize("registers", ["none", "first"])
def test_the_documents_are_the_same_on_a_lesser_processor(registers: str) -> None:
    """The pictures and tables; nothing else in the documents has been through a float array."""
    setting = settings()[registers]
    if not setting:
        pytest.skip("numpy and OpenBLAS have one code each here")
    run = subprocess.run(
        [sys.executable, "-c", STALE],
        env={**os.environ, **setting},
        capture_output=True,
        text=True,
        check=False,
        timeout=HANGS,
    )
    assert (run.returncode, run.stdout) == (0, ""), (setting, run.stdout, run.stderr)


# The grid


def test_what_is_drawn_at_a_round_place_is_far_from_where_the_last_digit_changes() -> None:
    for n in range(-2000, 2000):
        x = n / 1000
        assert len({coordinate(y) for y in (x - 1e-4, x, x + 1e-4)}) == 1, x
        assert abs(float(coordinate(x)) - x) < 0.0062


def test_zero_has_no_sign() -> None:
    assert [coordinate(x) for x in (0.0, -0.0, -1e-12, 1e-12)] == ["0"] * 4
    assert [coordinate(x, 1) for x in (-12.01, 100.0)] == ["-12", "100"]


def test_points_that_may_be_one_are_one() -> None:
    path = '<path d="M 1 1\nL 2 2.000001\nL 2 2\nL 3 1\nL 1 1.000001\nz\n"/>'
    assert on_grid(path, "") == '<path d="M 1 1\nL 2 2\nL 3 1\nz\n"/>'
    # A line that ends where it began is a dot, and a line that is not closed keeps its end.
    for kept in ('<path d="M 1 1\nL 1 1\n"/>', '<path d="M 1 1\nL 2 2\nL 1 1\n"/>'):
        assert on_grid(kept, "") == kept


def test_names_follow_their_order_and_not_what_was_hashed() -> None:
    def text(name: str) -> str:
        return f'<path id="m{name}" d="M 0 0"/><use xlink:href="#m{name}" x="1" y="2"/>'

    first, second = (on_grid(text(name), "a") for name in ("0123456789", "abcdef0123"))
    assert first == second != on_grid(text("0123456789"), "b")
