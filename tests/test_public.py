"""What a user of the package has at hand: names, bodies, and values that show themselves."""

import doctest
import html.parser
import importlib
import inspect
from collections.abc import Iterator
from functools import cached_property
from typing import Any

import pytest
from flint import arb

import tresym
from tresym.ledger.claim import (
    Claim,
)
from tresym.ledger.verification import Report, Row
from tresym.racket.body import Body, shape
from tresym.racket.result import Flip, Journey
from tresym.reals.decisions.answer import Answer
from tresym.reals.numbers.arithmetic import ball_precision


def test_every_public_name_is_there_and_listed() -> None:
    assert set(tresym.__all__) <= set(dir(tresym))
    assert all(getattr(tresym, name) is not None for name in tresym.__all__)
    with pytest.raises(AttributeError, match="nonsense"):
        _ = tresym.nonsense


def test_a_body_stands_for_its_shape() -> None:
    racket = tresym.Body(1210, 16380, 17480)
    book = tresym.bodies["book"]
    for body, same in ((racket, racket.shape), (book, book.shape), (shape("1", "1/2"), (1, "1/2"))):
        expected = tresym.flip_defect(*same, digits=20)
        assert repr(tresym.flip_defect(body, digits=20)) == repr(expected)
        start = tresym.flip_angle(body, psi0="1", theta0="2", digits=20)
        assert repr(start) == repr(tresym.flip_angle(*same, "1", theta0="2", digits=20))
    for alone in ("1", 2, (1, 2)):
        with pytest.raises(tresym.InputError, match="or a body"):
            tresym.flip_defect(alone)
    with pytest.raises(tresym.InputError, match="has its b in it"):
        tresym.flip_defect(racket, "1/2")


def test_a_flip_has_its_defect_in_degrees_and_the_papers_estimate() -> None:
    found = tresym.flip_defect(tresym.bodies["str"], digits=30)
    with ball_precision(200):
        assert found.degrees.overlaps(found.defect * 180 / arb.pi())
        assert found.degrees.rel_accuracy_bits() > 90
        assert abs(found.paper / found.defect - arb("1.000723")) < arb("1e-6")
    assert tresym.flip_defect("1", "1/10", "1/100").paper is None


def _documented() -> Iterator[tuple[str, Any]]:
    """What a user meets: each public name, and each member of a value that it gives."""
    yield "tresym", tresym
    for name in tresym.__all__:
        if inspect.isroutine(found := getattr(tresym, name)) or inspect.isclass(found):
            yield name, found
    for cls in (Answer, Body, Claim, Flip, Journey, Report, Row):
        yield cls.__name__, cls
        for name, member in vars(cls).items():
            told = inspect.isfunction(member) or isinstance(member, property | cached_property)
            if told and not name.startswith("_"):
                yield f"{cls.__name__}.{name}", member


DOCUMENTED = dict(_documented())


@pytest.mark.parametrize("name", DOCUMENTED)
def test_every_public_name_has_an_example_that_does_what_it_says(name: str) -> None:
    text = inspect.getdoc(DOCUMENTED[name]) or ""
    module = inspect.getmodule(getattr(DOCUMENTED[name], "fget", DOCUMENTED[name]))
    example = doctest.DocTestParser().get_doctest(text, dict(vars(module or tresym)), name, None, 0)
    assert example.examples
    said: list[str] = []
    flags = doctest.ELLIPSIS | doctest.IGNORE_EXCEPTION_DETAIL
    doctest.DocTestRunner(optionflags=flags).run(example, out=said.append)
    assert not said, "".join(said)


VALUES = {
    "flip": lambda: tresym.flip_defect("1", "1/10", digits=30),
    "large flip": lambda: tresym.flip_defect("1e-2000", "1", digits=2000),
    "journey": lambda: tresym.flip_angle("1", "1/10", "1", theta0="2"),
    "body": lambda: tresym.Body(1, 2, 3),
    "answer": lambda: tresym.check("x**2 + 1 > 0", "x < 5"),
    "refuted": lambda: tresym.check("sin(x) == cos(x)"),
    "report": lambda: tresym.verify("eq_gamma"),
    "named body": lambda: tresym.bodies["str"],
    "row": lambda: tresym.verify("eq_gamma")["eq_gamma"],
    "claim": lambda: tresym.verify("eq_gamma")["eq_gamma"].claim,
}


class Balanced(html.parser.HTMLParser):
    """Ends each tag that it begins, the last one first."""

    def __init__(self) -> None:
        super().__init__()
        self.open: list[str] = []

    def handle_starttag(self, tag: str, attrs: object) -> None:
        self.open.append(tag)

    def handle_endtag(self, tag: str) -> None:
        assert self.open.pop() == tag


@pytest.mark.parametrize("name", VALUES)
def test_a_value_is_shown_in_one_line_as_a_table_and_as_a_formula(name: str) -> None:
    value = VALUES[name]()
    line = repr(value)
    assert line.startswith(f"{type(value).__name__}(")
    assert "\n" not in line
    assert len(line) < 300
    reader = Balanced()
    reader.feed(value._repr_html_())
    assert not reader.open
    latex = value._repr_latex_()
    assert latex[0] == latex[-1] == "$"
    assert latex.count("{") == latex.count("}")


def test_thirty_digits_are_shown_where_thirty_are_asked_for() -> None:
    assert "0.637399255115037799823754932331 ± " in repr(tresym.flip_defect("1", "1/10", digits=30))


def test_a_claim_that_a_report_lacks_is_a_key_error_that_says_so() -> None:
    report = tresym.verify("eq_gamma")
    assert report["eq_gamma"].as_expected
    with pytest.raises(KeyError, match="did you mean eq_gamma"):
        report["eq_gama"]


@pytest.mark.parametrize("name", ["tests", "docs", "pyproject"])
def test_nothing_beside_the_package_but_the_proofs_is_in_it(name: str) -> None:
    assert importlib.import_module("tresym.proofs").__name__ == "tresym.proofs"
    with pytest.raises(ModuleNotFoundError):
        importlib.import_module(f"tresym.{name}")
