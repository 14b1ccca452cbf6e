"""``tresym new``: write a commented example of a file of claims, to start a paper of your own."""

from __future__ import annotations

import argparse

from tresym.commands.claims_file import example_path
from tresym.commands.parser import Commands
from tresym.output import write_text

EXAMPLE = """\
# The pendulum for small amplitudes
% A file of claims: tresym verify %(name)s decides every claim in it. Lines that begin with %% are
% comments. A line in no other form is prose, and is printed in the documents.

% Variables and their conditions, which hold for every claim below that is about them:
a real; given 0 < a < 1
t real

% A definition: T(a) is an abbreviation for the right side.
T(a) := 1 + a**2/16

## Bounds
% A claim is a label, a colon, and a statement as for tresym check.
Replacing the sine by its argument costs at most a cubic term.
above: sin(a) < a
below: sin(a) > a - a**3/6

% A number as it is printed: T(1/2) rounds to these digits.
value: T(a) ~= 1.0156 at a == 1/2

## Expansions
% An order needs a limit process, here a -> 0 from above.
series: sin(a) == a - a**3/6 + O(a**5) as a -> 0+

% A chain is a derivation; an indented line continues the line above.
double: sin(2*t) == 2*sin(t)*cos(t)
  == 2*tan(t)*cos(t)**2

% A statement that is known to be false may stand here too, with its source.
misprint: sin(a) > a - a**3/7 expect refuted

% A table of the errors of a claim, and a chart of them.
table series: at a == 1/10, 1/100, 1/1000; digits 20
chart series
"""


def add(commands: Commands) -> None:
    """Add `tresym new` to the command line."""
    parser = commands.add_parser(
        "new",
        help="write an example of a file of claims, to start a paper of your own",
        description="Write a commented example to PATH.tresym; verify it with tresym verify.",
    )
    parser.add_argument("name", metavar="PATH", help="the file to write; .tresym is added")


def run(args: argparse.Namespace) -> int:
    """Run the command and return its exit status."""
    path = example_path(args.name)
    write_text(path, EXAMPLE.replace("%(name)s", path).replace("%%", "%"))
    print(f"{path}: written; verify it with: tresym verify {path}")
    return 0
