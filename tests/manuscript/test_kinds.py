"""What a symbol is: nothing is decided about symbols that are no real numbers."""

from collections.abc import Iterator
from pathlib import Path

import pytest
from hangs import HANGS
from manuscripts import links_of, read

from tresym.commands import main
from tresym.manuscript import links
from tresym.manuscript.classification import Link
from tresym.manuscript.deciding import Row, decided
from tresym.manuscript.instances import instances
from tresym.manuscript.kinds_in_prose import declared
from tresym.reals.language.parsing import as_written
from tresym.reals.numbers.exact import InputError

DATA = Path(__file__).resolve().parents[1] / "data"


def manuscripts(name: str) -> list[str]:
    lines = (DATA / name).read_text(encoding="utf-8").splitlines()
    return [line for line in lines if not line.startswith("#")]


def all_rows(folder: Path, texts: list[str]) -> Iterator[tuple[str, Row]]:
    found = [(text, link) for text in texts for link in links_of(folder, text)]
    rows = decided([link for _, link in found], HANGS, 1)
    return zip((text for text, _ in found), rows, strict=True)


@pytest.mark.slow
def test_nothing_is_decided_where_a_symbol_is_no_real_number(tmp_path: Path) -> None:
    texts = manuscripts("not_real.txt")
    assert len(texts) > 250
    bad = [
        f"{row.status}: {text}"
        for text, row in all_rows(tmp_path, texts)
        if row.status in ("PROVED", "ENCLOSED", "REFUTED")
    ]
    assert bad == []


@pytest.mark.slow
def test_true_elementary_displays_are_still_decided(tmp_path: Path) -> None:
    texts = manuscripts("elementary.txt")
    lost = {
        text
        for text, row in all_rows(tmp_path, texts)
        if row.status not in ("PROVED", "ENCLOSED", "DEFINED")
    }
    assert len(lost) <= 0.03 * len(texts), lost


REASONS = {
    r"for the linear operator $T$ \[ T(uv) = u\,Tv \]": "(line 1: 'linear operator $T$')",
    r"where $A$ is a matrix. \[ A^2 = AA \]": "A is a matrix (line 1: '$A$ is a matrix')",
    r"\[ A^2 = AA \] where $A$ is a matrix": "A is a matrix",
    r"For complex $z$, \[ |z|^2 = z^2 \]": "z is a complex number",
    r"\[ (AB)^T = A^T B^T \]": "A is a matrix (line 1: 'A B ) ^ T",
    r"\[ AB - BA = 0 \]": "as both A B and B A stand there",
    r"\[ \hat x + y = y + \hat x \]": r"hat x is of unknown kind, by its \hat",
    r"The matrices satisfy \[ AB = B + A \]": "A is a matrix ('matrices')",
    r"\[ a \times b = b \times a \]": "may be a vector product",
    r"\[ f * g = g * f \]": "may be a convolution",
    r"\[ \{2x\} = 2\{x\} \]": "may be a fractional part",
    r"\[ [2x] = 2[x] \]": "may be an integer part",
    r"\[ (AB)^{-1} = A^{-1}B^{-1} \]": "may be an inverse matrix or function",
    r"\[ \int_0^1 f\,dx = f \]": "the text does not say whether f is a function of x",
    r"\[ \sum_{i=1}^n \bar x_i = n \bar x_i \]": "whether x_ibar is a function of i",
    r"\[ (f^2)' = 2f \]": "whether f is a function is not said",
    r"Let $w = Az$ for a matrix $A$. \[ w = A z \] \[ w^2 \ge 0 \]": "w is a matrix (line 1",
}


@pytest.mark.parametrize("text", REASONS)
def test_the_reason_is_told_with_its_place(text: str, tmp_path: Path) -> None:
    row = read(tmp_path, text)[-1]
    assert row.status == "UNREAD"
    assert REASONS[text] in row.why


BOTH = {
    r"\[ \Phi(-x) = -\Phi(x) \]": "Phi(-x) == -Phi(x) is REFUTED and -Phi*x == -Phi*x is PROVED",
    r"\[ \sin^{-1}x = 1/\sin x \]": "asin(x) == 1/sin(x) is REFUTED and 1/sin(x) == 1/sin(x) is ",
    r"\[ J_0(2x) \le 2J_0(x) \]": "J0(2*x) <= 2*J0(x) is REFUTED and 2*J0*x <= 2*J0*x is PROVED",
}


@pytest.mark.parametrize("text", BOTH)
def test_of_two_readings_both_are_decided(text: str, tmp_path: Path) -> None:
    (row,) = read(tmp_path, text)
    assert row.status == "UNREAD"
    assert f"two readings remain: {BOTH[text]}" in row.why


def test_two_readings_that_agree_have_their_status(tmp_path: Path) -> None:
    (row,) = read(tmp_path, r"\[ V(2r) + V(3r) = V(3r) + V(2r) \]")
    assert row.status == "PROVED"
    assert "in both readings of the formula" in row.why


def test_words_say_which_reading_is_meant(tmp_path: Path) -> None:
    words = r"The inverse sine has the derivative "
    (row,) = read(tmp_path, words + r"\[ \frac{d}{dx}\sin^{-1}x = \frac{1}{\sqrt{1-x^2}} \]")
    assert row.status == "PROVED"
    (row,) = read(tmp_path, words + r"\[ \sin^{-1}x = \frac{1}{\sin x} \]")
    assert row.status != "PROVED"


SEQUENCES = {
    r"\[ \sum_{k=1}^n (a_{k+1} - a_k) = a_{n+1} - a_1 \]": "PROVED",
    r"\[ \sum_{k=1}^n (a_k + c b_k) = \sum_{k=1}^n a_k + c\sum_{k=1}^n b_k \]": "PROVED",
    r"\[ \sum_{k=1}^n a_{k+1} = \sum_{k=2}^{n+1} a_k \]": "PROVED",
    r"\[ \sum_{k=0}^n a_k = a_0 + \sum_{k=1}^n a_k \]": "PROVED",
    r"\[ (x_n - x_{n+1})^2 = x_n^2 - 2x_n x_{n+1} + x_{n+1}^2 \]": "PROVED",
    r"\[ \sum_{k=1}^n (a_{k+1} - a_k) = a_n - a_1 \]": "EQUATION",
    r"\[ \sum_{k=1}^n a_k b_k = \sum_{k=1}^n a_k \sum_{k=1}^n b_k \]": "EQUATION",
}


@pytest.mark.parametrize("text", SEQUENCES)
def test_terms_of_an_unknown_sequence(text: str, tmp_path: Path) -> None:
    (row,) = read(tmp_path, text)
    assert row.status == SEQUENCES[text]


def test_a_note_settles_kinds_and_conditions(tmp_path: Path) -> None:
    text = r"""Let $A$ be a matrix. \[ (A + 1)^2 = A^2 + 2A + 1 \]
% tresym: let A \hat p real, L operator, s > 0
\[ (A + 1)^2 = A^2 + 2A + 1 \] \[ \hat p + \hat p = 2\hat p \] \[ |s| = s \]
\[ A(2x) = 2Ax \] \[ L + L = 2L \]"""
    found = [row.status for row in read(tmp_path, text)]
    assert found == ["UNREAD", "PROVED", "PROVED", "PROVED", "DEFINED", "UNREAD"]


@pytest.mark.parametrize("note", ["let A", "let A blob", "let A > >"])
def test_a_note_that_is_not_understood_is_refused(note: str, tmp_path: Path) -> None:
    with pytest.raises(InputError, match="line 1"):
        read(tmp_path, f"% tresym: {note}\n\\[ x = x \\]")


def test_a_section_may_speak_of_numbers_again(tmp_path: Path) -> None:
    claim = r"\[ (A + 1)^2 = A^2 + 2A + 1 \]"
    text = rf"\section{{A}} Let $A$ be a matrix. {claim} \section{{B}} %s {claim}"
    assert [row.status for row in read(tmp_path, text % "")] == ["UNREAD"] * 2
    found = [row.status for row in read(tmp_path, text % "Let $A$ be a real number.")]
    assert found == ["UNREAD", "PROVED"]


@pytest.mark.parametrize(
    ("words", "kinds"),
    [
        (r"the operator $L$", {"L": "an operator"}),
        (r"Let $A$ and $B$ be invertible matrices.", {"A": "a matrix", "B": "a matrix"}),
        (r"the matrix $A$ and the vector $v$", {"A": "a matrix", "v": "a vector"}),
        (r"where $Q$ is the orthogonal matrix of", {"Q": "a matrix"}),
        (r"the matrix norm $a$, the vector component $b$", {}),
        (r"Let $x$ be an eigenvalue of the matrix $A$", {"A": "a matrix"}),
        (r"We set $x = 3$.", {}),
        (r"the set $S$", {"S": "a set"}),
        (r"complex numbers $z$ and $w$", {"z": "a complex number", "w": "a complex number"}),
        (r"constants $a$ and $b$", {"a": "a real number", "b": "a real number"}),
        (r"$k$, $m$ are integers", {"k": "an integer", "m": "an integer"}),
        (r"$A$ is not a matrix", {}),
    ],
)
def test_what_words_declare(words: str, kinds: dict[str, str]) -> None:
    found = {tex: one.kind for one in declared(words) for tex in one.formulas}
    assert found == kinds


VARIED = (
    ("sum(a_k, k, 1, n)", "n*a_k"),
    ("limit(a_k/k, k, oo)", "0"),
    ("integral(f, x, 0, 1)", "f"),
    ("diff(x*f, x)", "f"),
    ("sum((X_i - mu)**2, i, 1, n)", "n*(X_i - mu)**2"),
)


@pytest.mark.parametrize("sides", VARIED)
def test_the_independent_check_lets_symbols_vary(
    sides: tuple[str, str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Were the reader to take a_k for a number, the check would still stop the pass."""
    compared = as_written(sides[0]), "==", as_written(sides[1])
    link = links_of(tmp_path, r"\[ (x + 1)^2 = x^2 + 2x + 1 \]")[0]
    text = " == ".join(sides)
    attempt = link.claims[0]._replace(text=text, sides=compared, under="")
    monkeypatch.setattr(links, "read_links", None)
    (row,) = decided([Link(link.display, 1, compared, claims=(attempt,))], HANGS, 1)
    assert row.status == "UNDECIDED"
    assert "fails with" in row.why


def test_constants_do_not_vary() -> None:
    compared = as_written("integral(f, x, 0, 1)"), "==", as_written("f")
    assert list(instances(compared, frozenset("f"))) == []


def test_the_page_shows_what_each_symbol_was_taken_for(tmp_path: Path) -> None:
    text = r"Let $A$ be a matrix. \[ A + x = x + A \] \[ x + y = y + x \] \[ \Phi(-x) = 1 \]"
    (tmp_path / "m.tex").write_text(text)
    main(["paper", str(tmp_path / "m.tex"), "--html", str(tmp_path / "h")])
    page = (tmp_path / "h" / "index.html").read_text()
    assert "Taken to be real numbers by default: x, y." in page
    assert "<td>A</td><td>a matrix</td><td>line 1: &#x27;$A$ be a matrix&#x27;</td>" in page
    assert "<td>Phi</td><td>a real number or a function</td>" in page


MAPS = {
    r"Let $I$ and $J$ be intervals and $f \colon I \to J$. %s": True,
    r"Let $I,J \subset \R$ be closed intervals, $f \colon I \to J$. %s": True,
    r"For $f \colon [a, b] \to \R$, %s": True,
    r"Let $f \colon \{ x_k : k \geq n \} \to \R$. %s": True,
    r"We have $f([a, b]) \subset f(\R)$. %s": True,
    r"The domain of $f$ is a subset of the line. %s": True,
    r"Let $f \colon \R \to \R^2$. %s": False,
    r"Let $f \colon I \to J$. %s": False,
    r"Let $f \colon I \to H$ on the interval $I$. %s": False,
    r"Here $f$ is a subset of the plane. %s": False,
    r"We have $A \subset f$. %s": False,
}


@pytest.mark.parametrize("words", MAPS)
def test_maps_into_intervals_are_functions(words: str, tmp_path: Path) -> None:
    (row,) = read(tmp_path, words % r"\[ (f(x) + 1)^2 = f(x)^2 + 2f(x) + 1 \]")
    assert row.status == ("PROVED" if MAPS[words] else "UNREAD")


def test_a_colon_in_a_set_is_no_map(tmp_path: Path) -> None:
    sets = r"\[ a = \sup \{ x_k : k \ge n \} = \lim_{n \to \infty} 0 \] "
    (*_, row) = read(tmp_path, sets + r"\[ (x_k + 1)^2 = x_k^2 + 2x_k + 1 \]")
    assert row.status == "PROVED"


def test_an_i_that_numbers_terms_is_not_imaginary(tmp_path: Path) -> None:
    claim = r" \[ \sqrt{x_k^2} = |x_k| \]"
    assert read(tmp_path, r"\[ x_i = \frac{i}{n} \]" + claim)[-1].status == "PROVED"
    assert read(tmp_path, r"\[ x_k = 1 + i y \]" + claim)[-1].status == "UNREAD"


def test_what_words_call_complex_holds_from_their_section_on(tmp_path: Path) -> None:
    claim, words = r"\[ |a|^2 = a^2 \]", r"\section{B} %s The numbers $a$ are complex."
    found = [row.status for row in read(tmp_path, claim + words % claim + r"\section{C}" + claim)]
    assert found == ["PROVED", "UNREAD", "UNREAD"]
    claim = claim.replace("a", "z")
    found = [row.status for row in read(tmp_path, claim + (words % claim).replace("$a$", "$z$"))]
    assert found == ["UNREAD", "UNREAD"]


@pytest.mark.parametrize("text", [r"A^2 + 1 = A^2 + 2 = 7", r"x A = A = x A + 1"])
def test_no_link_of_a_chain_with_a_matrix_is_read_as_one_of_numbers(
    text: str, tmp_path: Path
) -> None:
    found = links_of(tmp_path, rf"Let $A$ be a matrix. For all real $x$ \[ {text} \]")
    assert [link.status for link in found] == ["UNREAD", "UNREAD"]


KIND_OF_DISPLAY = (
    *("PROVED", "PROVED", "UNREAD", "UNREAD"),  # molecules, a plane, a norm of N, a vector r
    *("PROVED", "UNREAD", "UNREAD", "PROVED"),  # r in another section, \hat u, W = … + \hat u, W
    *("PROVED", "PROVED"),  # an inclination i, products in both orders
    *("UNREAD", "UNREAD", "UNREAD", "UNREAD"),  # a matrix, a commutator, complex numbers
)


def test_evidence_counts_for_its_symbol_in_its_section(tmp_path: Path) -> None:
    rows = read(tmp_path, (DATA / "kinds.tex").read_text(encoding="utf-8"))
    assert tuple(row.status for row in rows) == KIND_OF_DISPLAY


@pytest.mark.parametrize(
    ("text", "status"),
    [
        (r"\[ \int_{t_1}^{t_2} \delta L\,dt = 0 \]", "UNREAD"),
        (r"\[ \int_{t_1}^{t_2} \delta q\,dt = \delta q (t_2 - t_1) \]", "UNREAD"),
        (r"\[ \int_0^1 \delta x\,dx = \frac{\delta}{2} \]", "PROVED"),
        (r"\[ \int_0^\delta x\,dx = \frac{\delta^2}{2} \]", "PROVED"),
    ],
)
def test_a_variation_under_an_integral_is_no_product(
    text: str, status: str, tmp_path: Path
) -> None:
    (row,) = read(tmp_path, text)
    assert row.status == status


def test_an_order_is_no_symbol(tmp_path: Path) -> None:
    (link,) = links_of(tmp_path, r"As $x \to 0$, \[ \sin x = x + O(x^3) \]")
    assert [name for name, *_ in link.symbols] == ["x"]


def test_a_value_at_zero_is_no_product(tmp_path: Path) -> None:
    text = r"For real $x$ and $c$, \[ \frac{x(0)}{c} = 0 \] Let $f(t) = 3t$. \[ f(0) + 1 = 1 \]"
    assert [row.status for row in read(tmp_path, text)] == ["UNREAD", "PROVED"]
