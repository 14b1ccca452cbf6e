"""``tresym derive``: the article with its figures, slides, a notebook, or single derivations."""

from __future__ import annotations

import argparse
import os
import sys
from collections.abc import Iterator
from concurrent.futures import Future
from contextlib import contextmanager
from importlib.util import find_spec
from typing import TYPE_CHECKING

from tresym.commands import claims_file
from tresym.commands.claims_file import is_file_of_claims
from tresym.commands.parser import UNEXPECTED, Commands, add_options, deliver
from tresym.output import check_replaceable, make_folder, write_bytes
from tresym.reals.numbers.exact import InputError

if TYPE_CHECKING:
    from tresym.ledger.verification import Report

STYLES = ("article", "beamer", "markdown", "jupyter", "html", "site")


def add(commands: Commands) -> None:
    """Add `tresym derive` to the command line."""
    parser = commands.add_parser(
        "derive",
        help="the article with its figures, slides, a notebook, or single derivations to paste",
        description=(
            "Without labels, write the article about the paper, in LaTeX. With labels, write the "
            "derivation of each named claim, to paste into your own text. With a file of claims "
            "as the first argument, write the document of this file, or the derivations of its "
            "named claims."
        ),
        epilog="With -o article.tex the figures are written to the folder article-figures. They "
        "need matplotlib: pip install 'tresym[docs]'. "
        "Exit status: 1, without output, if a requested claim is refuted.",
    )
    parser.add_argument(
        "labels",
        nargs="*",
        metavar="[FILE.tresym] LABEL",
        help="claims of the file, or of the racket paper, such as eq_gamma",
    )
    parser.add_argument(
        "--style",
        choices=STYLES,
        default="article",
        help="LaTeX (the default), slides, Markdown, a notebook that computes the numbers; for a "
        "file of claims also an HTML page, or a site with a page for each claim in the folder PATH",
    )
    parser.add_argument(
        "-o", dest="path", metavar="PATH", help="write to a file instead of standard output"
    )
    parser.add_argument(
        "--figures",
        action=argparse.BooleanOptionalAction,
        help="include the figures, as files beside PATH (default: if PATH is given)",
    )
    where = parser.add_mutually_exclusive_group()
    add_options(
        where,
        ("--ledger", "also write every claim with its proof, to PATH-ledger.tex"),
        ("--appendix", "write every claim with its proof as an appendix of the article"),
    )
    parser.add_argument(
        "--refuted",
        action="store_true",
        help="also print refuted claims, marked as such, with the correct statement",
    )


def run(args: argparse.Namespace) -> int:
    """Run the command and return its exit status."""
    if is_file_of_claims(args.labels):
        if args.ledger or args.appendix:
            raise InputError("derive: --ledger and --appendix are for the racket paper")
        return claims_file.derive(
            args.labels[0],
            args.labels[1:],
            style=args.style,
            target=args.path,
            refuted=args.refuted,
            figures=args.figures,
            force=args.force,
        )
    if args.style in ("html", "site"):
        raise InputError(
            f"derive: --style {args.style} is for a file of claims: tresym derive FILE.tresym "
            f"--style {args.style}"
        )
    _check(args)
    return _pieces(args) if args.labels else _document(args)


def _check(args: argparse.Namespace) -> None:
    """Raise InputError if options do not fit together."""
    whole = args.ledger or args.appendix
    if args.labels and (whole or args.figures):
        raise InputError("derive: --figures, --ledger and --appendix take no labels")
    if not _is_file(args.path) and (args.ledger or args.figures):
        raise InputError("derive: --figures and --ledger write further files: give -o PATH")
    if whole and args.style != "article":
        raise InputError("derive: --ledger and --appendix are for --style article")
    if args.figures and args.style == "jupyter":
        raise InputError("derive: the cells of a notebook draw its figures; leave out --figures")


def _is_file(path: str | None) -> bool:
    """Return whether output goes to a file, beside which others can be written."""
    return path is not None and (os.path.isfile(path) or not os.path.exists(path))


def _pieces(args: argparse.Namespace) -> int:
    """Write the derivations of the requested claims."""
    from tresym.ledger.verification import verify
    from tresym.reals.processes import cores
    from tresym.report.pages import derivation, fragments

    report = verify(args.labels, workers=cores())
    asked = list({row.claim: row for row in map(report.__getitem__, args.labels)}.values())
    refused = () if args.refuted else derivation.refused(asked)
    if refused:
        print("\n".join(refused), file=sys.stderr)
        return UNEXPECTED
    deliver(fragments.written(asked, args.style), args.path)
    return 0 if report.as_expected else UNEXPECTED


def _document(args: argparse.Namespace) -> int:
    """Write the article, slides or notebook, and the files that belong to it."""
    from tresym.report.pages import documents_about as documents

    beside = os.path.splitext(args.path or "")[0]
    with_figures = args.figures is not False and _is_file(args.path)
    names = documents.figures_of(args.style) if with_figures else ()
    kind = "svg" if args.style == "markdown" else "pdf"
    figures = {name: os.path.join(f"{beside}-figures", f"{name}.{kind}") for name in names}
    ledger = f"{beside}-ledger.tex"
    check_replaceable([*figures.values(), *([ledger] if args.ledger else [])], args.force)
    with _drawing(figures, kind) as drawn:
        report = _verified(args)
        where = "document" if args.ledger else "appendix" if args.appendix else ""
        folder = f"{os.path.basename(beside)}-figures" if figures else ""
        text = documents.written(report, args.style, where, folder)
        pictures = {path: one.result() for path, one in drawn.items()}
    if pictures:
        make_folder(f"{beside}-figures")
    for path, picture in pictures.items():
        write_bytes(path, picture)
    if args.ledger:
        deliver(documents.ledger(report), ledger)
    deliver(text, args.path)
    return 0 if report.as_expected else UNEXPECTED


def _verified(args: argparse.Namespace) -> Report:
    """Verify the claims that the document names; all, if it includes the ledger."""
    from tresym.ledger.verification import verify
    from tresym.reals.processes import cores
    from tresym.report.pages import documents_about as documents

    whole = args.ledger or args.appendix
    return verify(() if whole else documents.labels(args.style), workers=cores())


@contextmanager
def _drawing(figures: dict[str, str], kind: str) -> Iterator[dict[str, Future[bytes]]]:
    """Draw figures in another process, and yield the futures of the pictures by path."""
    if not figures:
        yield {}
        return
    from tresym.ledger.paper import racket
    from tresym.reals.processes import Processes

    if find_spec("matplotlib") is None:
        raise InputError(
            "derive: figures need matplotlib (pip install 'tresym[docs]'); "
            "--no-figures omits the figures"
        )
    with Processes(1) as processes:
        yield {
            path: processes.submit(racket().figures().printed, name, kind)
            for name, path in figures.items()
        }
