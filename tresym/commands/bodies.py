"""The options that name a rigid body, for the commands of the racket."""

from __future__ import annotations

import argparse
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from tresym.racket.body import Shape


def named_bodies() -> tuple[str, ...]:
    """Return the names of the bodies of the paper."""
    from tresym.racket.body import NAMED_BODIES

    return tuple(NAMED_BODIES)


def add_body(parser: argparse.ArgumentParser, *, required: bool) -> None:
    """Add the three options that name a body: --body, --inertia and --shape."""
    body = parser.add_mutually_exclusive_group(required=required)
    body.add_argument("--body", metavar="NAME", help="a body of the paper, such as str or book")
    body.add_argument(
        "--inertia", nargs=3, metavar=("I1", "I2", "I3"), help="moments, smallest first"
    )
    body.add_argument("--shape", nargs=2, metavar=("A", "B"), help="a = I2/I1 - 1, b = 1 - I2/I3")


def body_of(args: argparse.Namespace) -> tuple[Shape, str]:
    """Return the shape that the options name, and a title with its source."""
    from tresym.racket import body

    if args.body is not None:
        named = body.named_body(args.body)
        return named.shape, f"{named.title}, {named.source}"
    if args.inertia is not None:
        return body.shape_of_moments(*args.inertia), "body with the given moments"
    return body.shape(*args.shape), "body of the given shape"
