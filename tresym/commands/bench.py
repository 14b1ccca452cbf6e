"""``tresym bench``: run workloads, show the results as they come, and save them."""

from __future__ import annotations

import argparse
import json
import sys
import time
from collections.abc import Sequence
from typing import TYPE_CHECKING

from tresym.commands.parser import INTERRUPTED, Commands, add_output, in_a_checkout
from tresym.reals.numbers.exact import InputError, quoted

if TYPE_CHECKING:
    from tresym.dev.bench.run import Keep, Measurement, Tables, Timing


def add(commands: Commands) -> None:
    """Add `tresym bench` to the command line."""
    try:
        from tresym.dev.bench.names import WORKLOADS
    except ModuleNotFoundError:
        WORKLOADS = {"none": "tresym is not running from a source checkout"}
    width = max(map(len, WORKLOADS))
    parser = commands.add_parser(
        "bench",
        help="time tresym against other tools",
        description=(
            "Time the workloads with each tool in turn. Compare only times of the same run."
        ),
        epilog="\n".join(
            ["workloads (default: all):"]
            + [f"  {name:<{width}}  {says}" for name, says in WORKLOADS.items()]
            + [
                "",
                "After Ctrl-C, the measurements made so far are shown, and "
                "with --save they are stored.",
            ]
        ),
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("workloads", nargs="*", metavar="WORKLOAD", help="see below")
    parser.add_argument("--save", action="store_true", help="store the result in docs/measurements")
    add_output(parser)


def run(args: argparse.Namespace) -> int:
    """Run the command and return its exit status."""
    with in_a_checkout("bench"):
        import tresym.dev.bench.workloads  # noqa: F401
    return run_all(args.workloads, args.save, args.json, args.path)


def run_all(names: Sequence[str], save: bool, as_json: bool, path: str | None) -> int:
    """Run the workloads, all unless some are named, and return the exit status.

    Raises:
        InputError: an unknown name, or ``save`` without a checkout.
    """
    from tresym.dev.bench import workloads
    from tresym.dev.bench.names import WORKLOADS

    chosen = list(dict.fromkeys(names or WORKLOADS))
    for name in chosen:
        if name not in WORKLOADS:
            raise InputError(
                f"workload: {quoted(name)} is unknown; the workloads are {', '.join(WORKLOADS)}"
            )
    home = workloads.folder() if save else None
    done: list[Measurement] = []
    for name in chosen:
        kept = None if home is None else workloads.keeper(name, home)
        measurement = workloads.measure(name, _progress(name, kept))
        _status("")
        done.append(measurement)
        if home is not None:
            print(f"saved {workloads.save(measurement, home)}", file=sys.stderr)
        if not (as_json or path):
            print(workloads.measurement_text(measurement), flush=True)
        if not measurement.complete:
            break
    if as_json or path:
        _print_all(done, as_json, path)
    return 0 if all(m.complete for m in done) else INTERRUPTED


def _print_all(done: list[Measurement], as_json: bool, path: str | None) -> None:
    from tresym.dev.bench import workloads
    from tresym.output import write_text

    if as_json:
        text = json.dumps([m.as_json() for m in done], ensure_ascii=False, indent=1) + "\n"
    else:
        text = "\n".join(workloads.measurement_text(m) for m in done)
    if path is None:
        print(text, end="")
    else:
        write_text(path, text)


def _progress(name: str, kept: Keep | None) -> Keep:
    """Return a function that stores the samples, and shows progress on a terminal."""
    began = time.monotonic()

    def keep(timings: list[Timing], tables: Tables | None = None) -> None:
        if kept is not None:
            kept(timings, tables)
        who = timings[-1].contender.method if timings else "no times"
        samples = sum(len(t.seconds) for t in timings) or sum(
            len(rows) for rows in (tables or {}).values()
        )
        seconds = time.monotonic() - began
        _status(f"{name}: {len(timings)} contenders, {samples} samples, {seconds:.0f} s: {who}")

    return keep


def _status(text: str) -> None:
    """Show one line on a terminal, in place of the last one."""
    if sys.stderr is not None and sys.stderr.isatty():
        print(f"\r\x1b[K{text[:100]}", end="", file=sys.stderr, flush=True)
