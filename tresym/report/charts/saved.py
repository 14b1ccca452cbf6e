"""Find saved measurements, in a checkout or in the installed package."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import tresym
from tresym.reals.numbers.exact import InputError

MOST_BYTES = 50_000_000


def home() -> Path:
    """Return the folder of the saved measurements, whether or not it exists."""
    package = Path(tresym.__file__).resolve().parent
    shipped = package / "measurements"
    return shipped if shipped.is_dir() else package.parent / "docs" / "measurements"


def load(workload: str, source: str | None = None) -> dict[str, Any]:
    """Return the saved measurement of a workload, or the one in the file ``source``.

    Raises:
        InputError: there is none, or it is a measurement of another workload.
    """
    path = home() / f"{workload}.json" if source is None else Path(source)
    try:
        with path.open("rb") as file:  # a device says nothing of its size
            read = file.read(MOST_BYTES + 1)
        if len(read) > MOST_BYTES:
            raise InputError(f"{path.name}: too large for a measurement")
        data = json.loads(read)
    except RecursionError:
        raise InputError(f"{path.name}: is nested too deeply for a measurement") from None
    except InputError:
        raise
    except OSError as error:
        hint = "" if source else f"; measure it: tresym bench {workload} --save"
        raise InputError(f"{path.name}: cannot be read ({error.strerror}){hint}") from None
    except ValueError:
        raise InputError(f"{path.name}: is not JSON") from None
    if not isinstance(data, dict) or data.get("workload") != workload:
        raise InputError(f"{path.name}: is not a measurement of the workload {workload}")
    return data
