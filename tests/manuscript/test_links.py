"""Of what kind a link is, and that nothing but a claim is called false."""

from pathlib import Path

import pytest
from cases import cases
from manuscripts import read, statuses

NO_CLAIMS = {
    r"\[ E = mc^2 \]": "DEFINED",
    r"\[ f(x) = x^2 + 1 \]": "DEFINED",
    r"\[ v = \frac{dx}{dt} \]": "DEFINED",
    r"\[ g = 9.81\,\mathrm{m/s^2} \]": "DEFINED",
    r"\[ x_\pm = 1 \]": "DEFINED DEFINED",
    r"\[ y' + 2xy = x, \qquad y(0) = 1 \] \[ y(x) = x^2 \]": "EQUATION EQUATION UNDECIDED",
    r"With $\Delta > 0$ \[ z = \Delta x \]": "UNREAD",
    r"\[ x = \frac{-b \pm \sqrt{b^2-4ac}}{2a} \]": "DEFINED DEFINED",
    r"\[ y(x) = C_1 e^x + C_2 e^{-x} \]": "ASSUMED",
    r"\[ m\ddot x = -kx \]": "EQUATION",
    r"\[ \frac{dy}{dx} = -y \]": "EQUATION",
    r"\[ \frac{d\theta}{d\phi} = -b\sin\theta\sin\psi \]": "EQUATION",
    r"\[ y'' + y = 0 \]": "EQUATION",
    r"\[ \tan x = x \]": "EQUATION",
    r"\[ x^3 + y^3 = 3xy \]": "EQUATION",
    r"\[ x^2 = 4 \implies x = 2 \]": "EQUATION DEFINED",
    r"\[ x^2 - 2x = 0, \quad x(x - 2) = 0 \]": "EQUATION PROVED",
    r"\[ \cos^2 t = 1 - \sin^2 t \Rightarrow \sin t = \sqrt{1-\cos^2 t} \]": "PROVED EQUATION",
    r"\[ n_1\sin\theta_1 = n_2\sin\theta_2 \]": "EQUATION",
    r"\[ T = 2\pi\sqrt{\ell/g} \] and then \[ T = 3 m a \]": "DEFINED DEFINED",
    r"\[ F = ma = -kx \]": "DEFINED EQUATION",
    r"\[ 0 < k < 1, \quad a > 0 \]": "ASSUMED ASSUMED ASSUMED",
    r"\[ \epsilon \ll 1 \]": "ASSUMED",
    r"Suppose that \[ a^2 + b^2 = c^2. \]": "ASSUMED",
    r"\[ \vec F = m\vec a \]": "UNREAD",
    r"\[ e^{i\pi} = -1 \]": "PROVED PROVED",
    r"\[ \sin\theta \approx \theta \]": "UNREAD",
    r"\[ \sin\theta(1 + x) = y \]": "UNREAD",
    r"\[ r = a(1 - e\cos E), \quad e^{x} = b \]": "DEFINED UNREAD",
    r"\[ f(x) = f(-x) \]": "EQUATION",
    r"\[ \tan x = x, \quad x > 0 \]": "EQUATION",
    r"\[ N = 1,000 \]": "UNREAD",
    r"\[ E = \text{const} \]": "UNREAD",
    r"\[ \int x\,dx = \frac{x^2}{2} + C, \quad E = t + \text{const} \]": "PROVED UNREAD",
    r"\[ \frac{dJ}{d\alpha}(0) = 0 \]": "UNREAD",
    r"\[ \text{For all } x: \quad \cos 2x = \sin x \]": "EQUATION",
    r"\[ 2x^2 > \pm x^2 \]": "UNREAD",
    r"\[ x = 1, 2 \]": "UNREAD",
    r"\[ n = 0, 1, 2, \ldots \]": "ASSUMED",
    r"\begin{align} x &= a & y &= b \\ -z &= c & -w &= 2d \end{align}": (
        "DEFINED DEFINED EQUATION EQUATION"
    ),
    r"\begin{eqnarray} x &=& a \\ y &=& b \\ &=& c \end{eqnarray}": "DEFINED DEFINED EQUATION",
    r"\[ \begin{array}{rclrcl} x &=& a & y &=& b \end{array} \]": "DEFINED DEFINED",
    r"\[ 1\,\mathrm{eV} = 1.602\times 10^{-19}\,\mathrm{J} \]": "UNREAD",
    r"\[ E = 1\,\mathrm{eV} = 1.602\times 10^{-19}\,\mathrm{J} \]": "UNREAD UNREAD",
    r"The cases $a = b$ and $c = d$ are left out. \[ c^2 = d^2 \]": "EQUATION",
}


@pytest.mark.parametrize("text", NO_CLAIMS)
def test_what_is_no_claim_is_never_called_false(text: str, tmp_path: Path) -> None:
    assert " ".join(row.status for row in read(tmp_path, text)) == NO_CLAIMS[text]


CLAIMS = {
    r"\[ y = 2 \label{a} \] \[ y = x^2 \label{b} \]"
    "\n% tresym: from b\n"
    r"\[ \frac{d}{dx}(xy) = y \]": ("DEFINED DEFINED REFUTED"),
    r"\[ y = x^2 \] \[ \frac{d}{dx}(xy) = 3x^2 \] \[ \frac{d}{dx}(xy) = y \]": (
        "DEFINED PROVED REFUTED"
    ),
    r"\[ y = x^2 \] \[ \int_0^1 xy\,dx = \frac{1}{4} = \int_0^1 xy^2\,dx \]": (
        "DEFINED PROVED REFUTED"
    ),
    r"\[ w = xv, \quad v = x^2 \] \[ \frac{dw}{dx} = 3x^2 \]": "DEFINED DEFINED PROVED",
    r"\[ z' = z \] \[ \frac{d}{dx}(xz) = z \]": "EQUATION UNREAD",
    r"\[ \frac{dz}{dx} = z \] \[ \frac{d}{dx}(xz) = z \]": "EQUATION UNREAD",
    r"\[ \sin(u\pm v) = \sin u\cos v \pm \cos u\sin v \]": "PROVED PROVED",
    r"\[ \sin\frac{z}{2} = \pm\left(\frac{1-\cos z}{2}\right)^{1/2} \]": "PROVED",
    r"\[ \ln(xy) = \ln x + \ln y, \quad x > 0,\ y > 0 \]": "PROVED",
    r"\[ \ln x^2 = 2\ln x \qquad (x > 0) \]": "PROVED",
    r"\[ \sqrt{x^2} = x \text{ for all } x < 0 \]": "REFUTED",
    r"\[ \sqrt{x^2} = x \quad \forall x < 0 \]": "REFUTED",
    r"\[ \sqrt{x^2} = -x \text{ for } x < 0 \]": "PROVED",
    r"\[ \sin x < \frac{x}{2} \text{ for } x > 0 \]": "REFUTED",
    r"Let $x < 0$. \[ \sqrt{x^2} = -x \]": "PROVED",
    r"\section{A} Let $x < 0$. \section{B} \[ \sqrt{x^2} = -x \]": "PROVED",
    r"Let $x > 0$. For all real $x$ \[ e^{|x|} = e^x \]": "REFUTED",
    r"Let $x > 0$. \section{B} Let $x$ be real. \[ \sqrt{x^2} = x \]": "EQUATION",
    r"Let $x > 0$. For every real number $x$, \[ \sinh x > 0 \]": "REFUTED",
    r"For $x>0$ and $n$ a positive integer \[ \cos 2\pi x = 1 \]": "EQUATION",
    r"If $x$ is an integer, then \[ \cos 2\pi x = 1 \] Later \[ \cos 2\pi x = 1 \]": (
        "PROVED EQUATION"
    ),
    r"Let $x$ and $y$ be integers. \[ \cos 2\pi x = \cos 2\pi y \]": "PROVED",
    r"For $n$ a positive integer \[ \cos 2\pi n = 1 \]": "PROVED",
    r"\[ x^2 \geq 0, \qquad \cosh x \leq \tfrac12 \]": "PROVED UNDECIDED",
    r"\[ f(x) = x^2 \] \[ f'(x) = 2x = x + x \]": "DEFINED PROVED PROVED",
    r"\[ f(x) = x^2 \] \[ f(2x) = 4 f(x) \]": "DEFINED PROVED",
    r"\[ r = \sqrt{1-b^2}= \sqrt{1-v^2}, \quad b = v \]": "DEFINED PROVED DEFINED",
    r"with $b = v^2$ we have \[ \sqrt{b} = |v| \]": "PROVED",
    r"\[ y = \sin 2x = 2\sin x \cos x = \sin x\cos x \]": "DEFINED PROVED REFUTED",
    r"For all $x$ \[ \cos 2x = \cos^2 x + \sin^2 x \]": "REFUTED",
    r"\[ \sin\frac{\pi}{6} = \frac{\sqrt{3}}{2} \]": "REFUTED",
    r"\[ \pi = 3.1416 \] \[ \pi = 3.1417 \]": "ENCLOSED REFUTED",
    r"\[ \pi = 3.14159\,26\ldots \] \[ 3.14159\,26 = \pi \]": "ENCLOSED ENCLOSED",
    r"\[ \int x\cos x\,dx = x\sin x+\cos x + C \]": "PROVED",
    r"\[ \int x\cos x\,dx = x\sin x-\cos x + C \]": "REFUTED",
    r"\[ \int x\cos x\,dx = x\sin x+\cos x + \text{const.} \]": "PROVED",
    r"\[ \int x\cos x\,dx = x\sin x-\cos x + \text{const} \]": "REFUTED",
    r"Let $a = p + q$. \[ (p + q)^2 = p^2 + 2pq + q^2, \qquad a \le p^2 + q \]": "PROVED UNREAD",
    r"\[ \sin x = x - \frac{x^3}{3!} + O(x^5) \]": "ENCLOSED",
    r"% tresym: claim" "\n" r"\[ \tan x = x \]": "REFUTED",
    r"% tresym: solve" "\n" r"\[ \sin^2 x + \cos^2 x = 1 \]": "EQUATION",
    r"% tresym: define" "\n" r"\[ P = 2x = x + x \]": "DEFINED PROVED",
    r"\[ c = 2s \label{a} \]" "\n% tresym: from a\n" r"\[ c^2 = 4s^2 \]": "DEFINED PROVED",
    r"\[ c = 2s \label{a} \]" "\n% tresym: from a\n" r"\[ c^2 = 2s^2 \]": "DEFINED REFUTED",
    r"\newcommand\half[1]{\frac{#1}{2}} \[ \half{x} + \half x = x \]": "PROVED",
    r"\begin{align} a + b &= b \\ &\quad + a \end{align}": "PROVED",
    r"Let $u = \cos x$. \[ \int\sin x\cos^2 x\,dx = -\int u^2\,du = -\frac{u^3}{3} + C \]": (
        "PROVED PROVED"
    ),
    r"Let $u = \cos x$. \[ \int\sin x\cos^2 x\,dx = \int u^2\,du = \frac{u^3}{2} + C \]": (
        "REFUTED REFUTED"
    ),
    r"Let $u = \cos x$. \section{B} \[ \int\sin x\cos^2 x\,dx = \int u^2\,du \]": "EQUATION",
    r"Let $u = \sin x$. Letting $u = \sin 2x$, we have \[ 1 - u^2 = \cos^2 2x \]": "PROVED",
    r"\[ x = at^2 \] Using the identity of sines, we find \[ x = bt^2 \]": "DEFINED DEFINED",
    r"If $m$ is odd, then $m = 2k+1$. \[ (x^2)^k x = x^{2k+1} = x^m \]": "PROVED PROVED",
    r"If $m$ is odd, then $m = 2k+1$. \[ x^{2k} = x^m \]": "EQUATION",
    r"for every integer $n$ \[ \sin(n\pi) = 0 \]": "PROVED",
    r"If $x > 0$, then \[ x^2 = 3x - 2 \] gives two values.": "EQUATION",
    r"If $x > 0$, then \[ x^2 = 3x - 2 \] for $x < 9$.": "REFUTED",
    r"for every half-integer $n$ \[ \sin(n\pi) = 0 \]": "REFUTED",
    r"For non-integer $n$, \[ \sin(n\pi) = 0 \]": "EQUATION",
    r"For $n$ that is not an integer $n$, \[ \sin(n\pi) = 0 \]": "EQUATION",
    r"For all $x$ except $x = 1$, \[ (x-1)^2 > 0 \]": "PROVED",
    r"Unless $q < 0$, \[ |q| = q \]": "PROVED",
    r"It fails for $x > 0$: \[ |x| = x \]": "EQUATION",
    r"Let $x > 0$. We drop the condition $x > 0$. \[ |x| = x \]": "EQUATION",
    r"Here $x > 1$ is not needed. \[ |x| = x \]": "EQUATION",
    r"For $x > 1$ or $y > 1$ \[ |x|\,|y| = xy \]": "EQUATION",
    r"For $x > 1$ and $y > 1$ \[ |x|\,|y| = xy \]": "PROVED",
    r"Provided that $a$ is nonnegative, \[ |a| = a \]": "PROVED",
    r"For nonzero $b$, \[ b^2 > 0 \]": "PROVED",
    r"If $p$ and $q$ are positive, then \[ |p| + |q| = p + q \]": "PROVED",
    r"Let $a$ be a positive constant. \[ |a| = a \]": "PROVED",
    r"For $h$ non-positive, \[ |h| = -h \]": "PROVED",
    r"Except for positive $k$, \[ |k| = -k \]": "PROVED",
    r"For $b$ not necessarily positive, \[ |b| = b \]": "EQUATION",
    r"If $s$ is not positive, then \[ |s| = s \]": "EQUATION",
    r"If $r$ is positive or zero, then \[ r/r = |r|/r \]": "UNDECIDED",
    r"This fails for negative $v$: \[ |v| = -v \]": "EQUATION",
    r"Let $x$ be real and $y$ positive. \[ |x| = x \]": "EQUATION",
    r"Let $x$ and neither $m$ nor $n$ be positive. \[ |n| = n \]": "EQUATION",
    r"If $z$ is positive if and only if $w$ is, then \[ |z| = z \]": "EQUATION",
    r"For every $u$ that is not negative, \[ |u| = u \]": "EQUATION",
    r"For all $u$ outside the unit interval, \[ u^2 \geq u \]": "UNDECIDED",
    r"For all real numbers $u$, \[ u^2 \geq u \]": "REFUTED",
    r"Without loss of generality let $x > 0$. \[ |x| = x \]": "PROVED",
    r"Throughout $m$ and $n$ are integers. \[ \sin(m\pi + n\pi) = 0 \]": "PROVED",
    r"\[ \sin n\pi = 0, \quad \cos 2n\pi = 1, \qquad n \in \mathbb{Z} \]": "PROVED PROVED",
    r"\[ x^n x = x^6, \quad x > 0,\ n = 5 \]": "PROVED",
    r"\[ x^n x = x^7, \quad x > 0,\ n = 5 \]": "EQUATION",
    r"\[ \sin 2x = 2\sin x \quad \text{(small angles)} \]": "EQUATION",
    r"\begin{align} \int 2x\,dx &= \int x + x\,dx \\ \intertext{and so, with $a = 3$,}"
    r" &= x^2 + C \end{align}": "PROVED PROVED",
    "% tresym: claim\n% tresym: as x -> 0\n" r"\[ \sin x = x + x^2 - O(x^3) \]": "REFUTED",
    r"\[ \operatorname{sech} x = 2e^{-x}(1 + O(e^{-2x})), \quad x\to\infty \]": "ENCLOSED",
    r"\[ \text{for } x > 0:\quad \sqrt{x^2} = x \]": "PROVED",
    r"\[ \underbrace{x^{\frac{4}{2}}}_{u^{\text{as}}} = x\cdot x \]": "PROVED",
    r"\[ \left\{\begin{aligned} |x| &= \sqrt{x^2} \\ 2x &= x + x\end{aligned}\right. \]": (
        "PROVED PROVED"
    ),
}


@pytest.mark.parametrize("text", CLAIMS)
def test_a_claim_is_decided_under_what_is_said_of_it(text: str, tmp_path: Path) -> None:
    assert " ".join(row.status for row in read(tmp_path, text)) == CLAIMS[text]


def test_a_number_is_not_put_in_for_a_symbol(tmp_path: Path) -> None:
    """Else what holds for one value would pass for all."""
    found = read(tmp_path, r"\[ a = 2 \] \[ a^2 = 4 \] \[ y = a^2 = 2a \]")
    assert [row.status for row in found] == ["DEFINED", "EQUATION", "DEFINED", "REFUTED"]


def test_a_condition_that_is_not_read_lets_nothing_pass(tmp_path: Path) -> None:
    (row,) = read(tmp_path, r"\[ x + x = 2x \text{ for } x \in \mathbb{Q} \]")
    assert row.status == "UNREAD"
    assert "condition" in row.why


@pytest.mark.parametrize(
    ("tex", "status", "said"),
    [
        (r"\sin(n+\tfrac12)\pi = \cos n\pi \quad (n \in \mathbb{Z})", "UNREAD", "(n + 1/2)*pi"),
        (r"\tan^{-1} x + \tan^{-1}\frac1x = \frac{\pi}{2} \qquad (x > 0)", "UNREAD", "atan(x)"),
        (r"\tan^{-1} x + \tan^{-1}\frac1x = \frac{\pi}{3} \qquad (x > 0)", "UNREAD", ""),
        (r"\coth^2 x - \operatorname{csch}^2 x = 1\;(x\neq0)", "PROVED", "x != 0"),
        (r"\int\frac{dx}{x\ln x} = \ln|\ln x| \qquad (x>0,\ x\neq1)", "PROVED", "x != 1"),
        (r"\sin x\,\csc x = 1 \qquad (x\neq0,\pm\pi,\pm2\pi,\ldots)", "PROVED", "sin(x) != 0"),
        (
            r"\cos x\sec x = 1,\quad x \ne \pm\tfrac{\pi}{2},\pm\tfrac{3\pi}{2},\ldots",
            "PROVED",
            "cos",
        ),
        (r"\cos x\,\sec x = 1 \qquad x \ne (n+\tfrac12)\pi", "PROVED", "cos(x) != 0"),
        (r"\sin(\pi x)\csc(\pi x) = 1,\qquad x\notin\mathbb{Z}", "PROVED", "sin(pi*x) != 0"),
        (r"(\tanh x)' = \operatorname{sech}^2 x", "PROVED", "diff(tanh(x), x)"),
        (r"\cos 60^\circ = \tfrac12", "PROVED", "cos(pi/3)"),
        (r"\cos 60^\circ = \tfrac13", "REFUTED", "cos(pi/3)"),
        (r"e^x = 1 + x + \frac{x^2}{2!} + \cdots", "PROVED", "1 + x + x**2/2 + ..."),
        (r"1 + 2 + \cdots + n = \frac{n(n+1)}{2}", "PROVED", "sum(k, k, 1, n)"),
    ],
)
def test_how_handbooks_print(tmp_path: Path, tex: str, status: str, said: str) -> None:
    (row,) = read(tmp_path, rf"\[ {tex} \]")
    assert row.status == status
    assert said in row.link.read_as


def test_what_is_not_all_written_is_put_in_nowhere(tmp_path: Path) -> None:
    rows = read(tmp_path, r"\[ g = 1 + x + \cdots \] \[ g^2 = 1 + 2x + \cdots \]")
    assert rows[0].status == "DEFINED"
    assert "with g =" not in rows[1].why


@pytest.mark.parametrize(
    ("text", "status"),
    [
        (r"For $x>0$, \[ \ln(2x) = \ln x \]", "REFUTED"),
        (r"If $a$ and $b$ are positive, then \[ \ln\frac{a}{b} = \ln b - \ln a \] ", "REFUTED"),
        (r"If $a>0$ and $b>0$, then \[ \ln\frac{a}{b} = \ln b - \ln a \] ", "REFUTED"),
        (r"\[ \sin(u \pm v) = \sin u\cos v \mp \cos u\sin v \]", "REFUTED"),
        (r"\[ \tan x = 2x \]", "EQUATION"),
        (r"\[ e^x = 1 + x + \frac{x^2}{3} + \cdots \]", "REFUTED"),
        (r"\[ e^x = \sum_{n=1}^\infty \frac{x^n}{n!} \]", "REFUTED"),
        (r"\[ x = 1 + y + y^2 + \cdots \]", "DEFINED"),
        (r"\[ 1 + x + x^2 + \cdots = 3 \]", "EQUATION"),
        (r"The roots, for $x>0$, are those of \[ \tan x = 2x \]", "EQUATION"),
        (r"For $x>0$ the condition at the wall reads \[ \tan x = 2x \]", "EQUATION"),
        (r"For $x>0$, \[ k\tan x = 2x \]", "EQUATION"),
        (r"For $t>0$, \[ \dot x = 2 x \]", "EQUATION"),
    ],
)
def test_when_an_equality_is_claimed_of_all_values(tmp_path: Path, text: str, status: str) -> None:
    assert {row.status for row in read(tmp_path, text)} == {status}


SYMBOLS = {
    r"\[ x_\pm = a \pm b \] \[ x_+x_- = a^2 - b^2 \]": "PROVED",
    r"\[ x_\pm = a \pm b \] \[ x_+x_- = a^2 + b^2 \]": "EQUATION",
    r"\[ t_* = \frac1a \] \[ 1 + t_* = \frac{a + 1}{a} \]": "PROVED",
    r"\[ \Delta e^{-b\Delta} = \frac{\Delta}{e^{b\Delta}} \]": "PROVED",
    r"\[ \Delta e^{b\Delta} = e^{b\Delta} \]": "EQUATION",
    r"\[ f(x) = \ln x \] \[ f'(x) = \frac1x > 0 \]": "PROVED",
    r"\[ f(x) = x^3 - x \] \[ f'(x) = 3x^2 - 1 > 0 \]": "UNDECIDED",
}
"""What stands last, and its status: each kind with a falsehood beside it."""


@pytest.mark.parametrize("text", SYMBOLS)
def test_symbols_with_signs_below_and_what_a_chain_begins_with(tmp_path: Path, text: str) -> None:
    assert read(tmp_path, text)[-1].status == SYMBOLS[text]


def test_integers_from_a_number_on(tmp_path: Path) -> None:
    (row,) = read(tmp_path, r"\[ n^2 > 3n \qquad \text{for integers } n \ge 4 \]")
    assert (row.status, "n integer, n >= 4" in row.link.read_as) == ("PROVED", True)
    (row,) = read(tmp_path, r"\[ n^2 > 3n \qquad \text{for integers } n \ge 3 \]")
    assert row.status == "REFUTED"


DEFINED_BEFORE = r"Let $z < 0$. Put \[ R(z) = \frac{1}{1-z}, \quad Q(z) = \frac{2+z}{2-z}. \]"


@pytest.mark.parametrize(
    ("text", "statuses"),
    [
        (r"Then \[ 0 < R(z) < 1, \qquad |Q(z)| < 1. \]", "PROVED PROVED PROVED"),
        (r"It follows that \[ R(z) < 0. \]", "UNDECIDED"),
        (r"We have \[ |Q(z)| < 1/2 \] and so \[ Q(z) < 1/2. \]", "UNDECIDED UNDECIDED"),
        (r"Here \[ R(z) < 0 \]", "ASSUMED"),
        (r"Here \[ R(z) < 2 \]", "PROVED"),
    ],
)
def test_a_bound_of_what_is_defined_is_asked(text: str, statuses: str, tmp_path: Path) -> None:
    rows = read(tmp_path, f"{DEFINED_BEFORE} {text}")
    assert " ".join(row.status for row in rows[2:]) == statuses


def test_the_definition_of_a_function_is_no_condition(tmp_path: Path) -> None:
    (row,) = read(tmp_path, r"We have, with $\chi(x) = x^3$, \[ \chi(2x) = 8\chi(x). \]")
    assert (row.status, row.link.read_as) == ("PROVED", "(2*x)**3 == 8*x**3")


IN_A_PROOF = r"""Let $h(x) = x$. \begin{proof} Let $h(x) = x^2 + 1$. Put $c = x^4$. Let $0 < y < 1$.
  Then \[ h(x) \ge 1, \quad y^2 < y. \] \end{proof} """


@pytest.mark.parametrize(
    ("text", "found"),
    cases(__file__, "what_is_said_in_a_proof_ends_with_it"),
)
def test_what_is_said_in_a_proof_ends_with_it(text: str, found: str, tmp_path: Path) -> None:
    *within, row = read(tmp_path, IN_A_PROOF + text)
    assert [row.status for row in within] == ["PROVED"] * 2
    assert f"{row.status} {row.link.read_as}" == found


@pytest.mark.parametrize(
    ("text", "found"),
    [
        (r"v^2 \ge v, \quad v \ge 1 \text{ or } v \le 0", "PROVED v >= 1, PROVED v <= 0"),
        (r"v^2 > v, \quad v > 1 \text{ or } v > 0", "PROVED v > 1, REFUTED v > 0"),
        (
            r"\sqrt{x^2} = x \quad \text{if } x > 1 \text{ or } x < -1",
            "PROVED x > 1, EQUATION x < -1",
        ),
        (r"y < xy, x > 1 \text{ or } x > 2, y > 0", "PROVED x > 1, y > 0, PROVED x > 2, y > 0"),
        (r"\sin^2 x + \cos^2 x = 1 \text{ or } \sin x > 0", "PROVED , UNDECIDED "),
    ],
)
def test_of_a_choice_of_conditions_each_is_asked(text: str, found: str, tmp_path: Path) -> None:
    rows = read(tmp_path, rf"We have \[ {text}. \]")
    assert ", ".join(f"{r.status} {r.link.read_as.partition(' given ')[2]}" for r in rows) == found


ROWS = {
    r"\begin{align} \sqrt{x^2} &= x, \\ \ln(x^2) &= 2\ln x, & x &> 0 \end{align}": (
        "UNDECIDED sqrt(x**2) == x, PROVED log(x**2) == 2*log(x) given x > 0"
    ),
    r"\begin{align} \sqrt{x^2} &= x, & x &> 0, \\ |x| &= x \end{align}": (
        "PROVED sqrt(x**2) == x given x > 0, REFUTED abs(x) == x"
    ),
    r"\begin{align} |x| &= x \\ x^2 &\ge 0 \end{align}": ("REFUTED abs(x) == x, PROVED x**2 >= 0"),
    r"\[ \begin{aligned} |x| &= x \\ \sqrt{x^2} &= x \end{aligned} \qquad \text{for } x > 0 \]": (
        "PROVED abs(x) == x given x > 0, PROVED sqrt(x**2) == x given x > 0"
    ),
    r"\begin{align} |x| &= x, \\ \sqrt{x^2} &= x, \\ && x &> 0 \end{align}": (
        "PROVED abs(x) == x given x > 0, PROVED sqrt(x**2) == x given x > 0"
    ),
    r"\[ |x| = x, \quad \sqrt{x^2} = x, \quad x > 0 \]": (
        "PROVED abs(x) == x given x > 0, PROVED sqrt(x**2) == x given x > 0"
    ),
    r"\[ |x| = x \text{ for } x > 0, \qquad \sqrt{v^2} = |v| \]": (
        "PROVED abs(x) == x given x > 0, PROVED sqrt(v**2) == abs(v)"
    ),
    r"\[ |x| = x \text{ for } x > 0, \quad \sqrt{x^2} = 2x - x \]": (
        "PROVED abs(x) == x given x > 0, REFUTED sqrt(x**2) == 2*x - x"
    ),
    r"\[ x^2 = x \quad \text{for all } x \]": "REFUTED x**2 == x",
    r"\[ v \ge 0, \quad v \ge 1 \text{ or } v \le 0 \] and so \[ |v - 1| = v - 1 \]": (
        "UNDECIDED v >= 0, UNREAD v >= 1, UNREAD v <= 0, EQUATION abs(v - 1) == v - 1"
    ),
}


@pytest.mark.parametrize("text", ROWS)
def test_a_condition_is_of_its_own_row(text: str, tmp_path: Path) -> None:
    rows = read(tmp_path, f"For all real $x$ and $v$, {text}")
    assert ", ".join(f"{row.status} {row.link.read_as}" for row in rows) == ROWS[text]


@pytest.mark.parametrize(
    ("text", "found"),
    cases(__file__, "what_is_claimed_is_not_assumed"),
)
def test_what_is_claimed_is_not_assumed(text: str, found: str, tmp_path: Path) -> None:
    rows = read(tmp_path, text)
    assert ", ".join(f"{row.status} {row.link.read_as.split(' given')[0]}" for row in rows) == found


def test_what_a_theorem_defines_ends_with_it_and_its_proof(tmp_path: Path) -> None:
    lemma = r"\section{A} \begin{lemma} Let $w(x) = x^2 + 1$. Then \[ w(x) > 0 \] \end{lemma} "
    claim = r"For all real $x$, \[ w(x) \ge 1 \]"
    proof = rf"{lemma} \begin{{proof}} {claim} \end{{proof}}"
    assert [row.status for row in read(tmp_path, proof)] == ["PROVED"] * 2
    rows = read(tmp_path, proof + claim)
    assert [row.status for row in rows] == ["PROVED", "PROVED", "UNDECIDED"]
    again = rf"{lemma} Let $w(x) = x^2 + 2$. \section{{B}} {claim}"
    assert [row.status for row in read(tmp_path, again)] == ["PROVED"] * 2


PHYSICS = {
    r"\[ x_{1,2} = -p \pm \sqrt{p^2-q} \] \[ x_1x_2 = q \]": "PROVED x1*x2 == q",
    r"\[ x_{1,2} = -p \pm \sqrt{p^2-q} \] \[ x_1 - x_2 = -2\sqrt{p^2-q} \]": (
        "EQUATION x1 - x2 == -2*sqrt(p**2 - q)"
    ),
    r"The energy $E = mc^2/w$ and the momentum $p = mv/w$ with $w = \sqrt{1-v^2/c^2}$ satisfy"
    r" \[ E^2 - p^2c^2 = m^2c^4 \]": "PROVED E_**2 - p**2*c**2 == m**2*c**4",
    r"The case $a = 2b$ is left out. \[ a^2 = 4b^2 \]": "EQUATION a**2 == 4*b**2",
    r"The point $a = b$ is left out. \[ a^2 = b^2 \]": "EQUATION a**2 == b**2",
    r"The slope $a = b$ is it. \[ a^2 = b^2 \]": "EQUATION a**2 == b**2",
    r"For $0<a<b$ set \[ w = \sqrt{b^2-a^2} \] Then \[ \frac wb = \sqrt{1-\frac{a^2}{b^2}} \]": (
        "PROVED w/b == sqrt(1 - a**2*b**(-2)) given 0 < a < b"
    ),
    r"For $x>0$ let \[ w(x) = \sqrt{x^2} \] For all $x$ \[ w(x) = x \]": "DEFINED w(x) == x",
    r"For large $x$ \[ \sinh x \approx \tfrac12 e^x \]": ("ENCLOSED sinh(x) ~ exp(x)/2 as x -> oo"),
    r"For small $x$ \[ \sinh x \approx \tfrac12 e^x \]": ("REFUTED sinh(x) ~ exp(x)/2 as x -> 0"),
    r"\[ x' = \frac{x - vt}{\sqrt{1-v^2}}, \qquad t' = \frac{t - vx}{\sqrt{1-v^2}} \]"
    r" \[ t'^2 - x'^2 = t^2 - x^2 \]": "PROVED t_primed**2 - x_primed**2 == t**2 - x**2",
    r"\[ x' = -y, \quad y' = x \] \[ x'^2 + y'^2 = x^2 + y^2 \]": (
        "PROVED x_prime**2 + y_prime**2 == x**2 + y**2"
    ),
    r"\[ \int_0^x t'^2\,dt' = \frac{x^3}{3} \]": (
        "PROVED integral(t_primed**2, t_primed, 0, x) == x**3/3"
    ),
    r"Let $f(x) = x^2$. \[ \int_0^x t'\,dt' = \frac{x^2}{2} \] \[ f'(x) = 2x \]": (
        "PROVED diff(x**2, x) == 2*x"
    ),
    r"\[ (-1)^x = 1 \quad \text{for all } x \text{ even} \]": (
        "PROVED (-1)**(2*x_half) == 1 given x_half integer"
    ),
    r"\[ (-1)^x = 1 \quad \text{for all } x \text{ prime} \]": "UNREAD (-1)**x == 1",
    r"\[ \int_0^1 ax\,dx = \Bigl[\frac{ax^2}{2}\Bigr]_0^1 \]": (
        "PROVED integral(a*x, x, 0, 1) == at(a*x**2/2, x, 1) - at(a*x**2/2, x, 0)"
    ),
    r"\[ \int_0^1 2xe^{x^2}\,dx = \bigl[e^u\bigr]_0^1 = 2e \]": (
        "REFUTED at(exp(u), u, 1) - at(exp(u), u, 0) == 2*E"
    ),
    r"\[ s(t) = 1 - \cos t \] For small $t$ \[ s(t) = \tfrac13t^2 + O(t^4) \]": (
        "UNDECIDED 1 - cos(t) == t**2/3 + O(t**4) as t -> 0"
    ),
    r"\[ a = e^x \] Then \[ a = e^x, \qquad a > 0 \]": "PROVED a > 0",
    r"\[ a = e^x \] Then \[ a = e^x, \qquad a > 1 \]": "UNREAD a > 1",
    r"\[ x^2 \ge 0, \quad e^x \ge 1 + x \]": "PROVED exp(x) >= x + 1",
    r"\[ |a+b| \le |a|+|b|, \quad ||a|-|b|| \le |a-b| \]": (
        "PROVED abs(abs(a) - abs(b)) <= abs(a - b)"
    ),
    r"\[ a/b + b/a \ge 2, \quad ab > 0 \]": "PROVED a/b + b/a >= 2 given a*b > 0",
}
"""What stands last, its status and how it is read."""


@pytest.mark.parametrize("text", PHYSICS)
def test_what_physicists_write(text: str, tmp_path: Path) -> None:
    row = read(tmp_path, text)[-1]
    assert f"{row.status} {row.link.read_as}" == PHYSICS[text]


@pytest.mark.parametrize(
    ("text", "statuses"),
    [
        # on which range x = 3 sin t is taken is not said
        (
            r"Set $x = 3\sin t$. \[ \int \sqrt{9-x^2}\,dx = \int 3\sqrt{9\cos^2 t}\cos t\,dt"
            r" = \int 9\cos^2 t\,dt \]",
            "PROVED UNDECIDED",
        ),
        (
            r"Set $u = \sin t$. \[ \int \cos t\,dt = \int 1\,du = \int 2 du \]",
            "PROVED REFUTED",
        ),
        # one constant is not the other
        (r"\[ \int \frac{dx}{x} = \ln|x| + C = \ln|2x| + C \]", "PROVED UNDECIDED"),
        # a second value, and a word that is not read
        (r"Let $x = 3\sin t$. We use $x = 2\sin t$. \[ 1 + x = 1 + 2\sin t \]", "EQUATION"),
        (r"Let $x = 3\sin t$. We use $x = 2\sin t$. \[ 1 + x = 1 + 3\sin t \]", "EQUATION"),
        (r"Let $x = 3\sin t$. We use $x = 3\sin t$. \[ 1 + x = 1 + 3\sin t \]", "PROVED"),
    ],
)
def test_what_is_left_unsaid_is_no_falsehood(text: str, statuses: str, tmp_path: Path) -> None:
    assert " ".join(row.status for row in read(tmp_path, text)) == statuses


def test_macros_open_and_close_displays_before_environments(tmp_path: Path) -> None:
    text = r"\documentclass{article}\def\be{\begin{equation}}\newcommand\ee{\end{equation}}"
    text += r"\begin{document} \be 1 + 1 = 2 \ee \begin{proof}\be 2 = 3 - 1 \ee\end{proof}"
    assert [r.status for r in read(tmp_path, text + r"\end{document}")] == ["PROVED"] * 2


DIFFERENTIALS = {
    r"\[ u = x^2 + 3x, \quad du = (2x + 3)\,dx \]": "PROVED",
    r"\[ u = x^2 + 3x, \quad du = (2x + 4)\,dx \]": "UNDECIDED",
    r"\[ u = x^2, \quad du = 2x\,dx = (x + x)\cdot dx \]": "PROVED",
    r"\[ dv = \cos x\,dx \]": "DEFINED",
    r"\[ du = 2x\,dx + 2y\,dy \]": "UNREAD",
    r"\[ du = 2x + 1\,dx \]": "UNREAD",
    r"\[ du = u / dx \]": "UNREAD",
    r"\[ du = 2u\,du \]": "UNREAD",
    r"\[ u = x^2, \quad du = 2x \]": "UNREAD",
    r"The derivatives are \[ f(x) = \sin x, \quad f^{(4)}(x) = \sin x \]": "PROVED",
    r"The derivatives are \[ f(x) = \sin x, \quad f^{(3)}(x) = \cos x \]": "REFUTED",
    r"The iterates and the derivative: \[ f(x) = 2x, \quad f^{(2)}(x) = 4x \]": "UNREAD",
    r"\[ f(x) = 2x, \quad f^{(2)}(x) = 4x \]": "UNREAD",
    r"The derivative is \[ f(x) = 2x, \quad f^{(n)}(x) = 0 \]": "UNREAD",
}


@pytest.mark.parametrize("text", DIFFERENTIALS)
def test_differentials_and_counted_derivatives(text: str, tmp_path: Path) -> None:
    assert read(tmp_path, text)[-1].status == DIFFERENTIALS[text]


def test_an_expression_alone_is_no_link(tmp_path: Path) -> None:
    assert read(tmp_path, r"\[ \int_0^1 x\,dx \] \[ \lim_{x \to 0} \frac{\sin x}{x} \]") == []
    (row,) = read(tmp_path, r"\[ x \frobs y \]")
    assert row.status == "UNREAD"


def test_dots_behind_equalities_are_no_list_of_values(tmp_path: Path) -> None:
    text = r"\[ a = 2b + b = 3b, \quad c = 4b + b = %s b, \quad \ldots \]"
    found = [row.status for row in read(tmp_path, text % 5)]
    assert found == ["DEFINED", "PROVED", "DEFINED", "PROVED"]
    assert read(tmp_path, text % 6)[-1].status == "REFUTED"


def test_an_expansion_with_coefficients_that_are_sought_is_an_equation(tmp_path: Path) -> None:
    text = r"For $\epsilon \to 0$ \[ \sqrt{9+\epsilon} = a_1 + a_2 \sin\epsilon + o(\epsilon) \]"
    (row,) = read(tmp_path, text)
    assert row.status == "EQUATION"
    assert "coefficients a1, a2" in row.why


def test_a_row_that_begins_with_a_sign_goes_on_where_no_relation_stood(tmp_path: Path) -> None:
    text = r"\begin{gather} a (b + c) \\ + d (b + c) = (a + d)(b + c) \end{gather}"
    (row,) = read(tmp_path, text)
    assert row.status == "PROVED"
    assert row.link.read_as.startswith("a*(b + c) + d*(b + c) ==")
    text = r"\begin{gather} 2 a = a + a \\ - a + b = b - a \end{gather}"
    assert [row.link.read_as for row in read(tmp_path, text)] == [
        *("2*a == a + a", "-a + b == b - a")
    ]


def test_markdown_has_displays_inside_dollars(tmp_path: Path) -> None:
    text = r"""Let $$\begin{align}
    (a+b)^2 &= a^2 + 2ab + b^2 \\ &= b^2 + a^2 + ab \end{align}$$ and
    $$ \begin{equation*} 1 + 1 = 3 \end{equation*} $$ Not closed: $$ 1 + 1 = 2
    \begin{align} 2 + 2 &= 4 \end{align}"""
    assert statuses(tmp_path, text) == ["PROVED", "REFUTED", "REFUTED", "UNREAD", "PROVED"]


def test_both_signs_of_another_value_are_unread(tmp_path: Path) -> None:
    """A display that begins with an equality sign goes on from words between, for each sign."""
    text = r"""The integral is
\[ \int x (1 \mp x)\, dx = \frac{x^2}{2} \mp \frac{x^3}{3} + C \]
47. Next, $\int x (2 \mp x)\, dx$ is wanted.
\[ = x^2 \mp \frac{x^3}{3} + C \]"""
    assert statuses(tmp_path, text) == ["PROVED", "PROVED", "UNREAD", "UNREAD"]
