"""The paper's central chain, formula by formula: each proved, each wrong variant refuted.

Transcribed from the paper's displays with the conditions they are stated under; ``f`` is the
integrand dφ/dψ, ``T`` the auxiliary of the stable form of the exact equation for ε₀.
"""

import pytest
from cases import cases

from tresym.reals.decisions.identity import decide
from tresym.reals.domain.conditions import Given
from tresym.reals.language.parsing import parse
from tresym.reals.verdict import Verdict

CHAIN = {
    "momentum length": (
        "(M*cos(theta))^2+(M*sin(theta)*cos(psi))^2+(M*sin(theta)*sin(psi))^2",
        "M^2",
        "",
    ),
    "gamma from energy": (
        (
            "2*I2*((M*cos(theta))^2/I1+(M*sin(theta)*cos(psi))^2/I2+(M*sin(theta)*sin(psi))^2"
            "/I3)/2/M^2-1"
        ),
        "(I2/I1-1)-sin(theta)^2*((I2/I1-1)+(1-I2/I3)*sin(psi)^2)",
        "0 < I1, I1 < I2, I2 < I3, M > 0",
    ),
    "phi dot": (
        "M*(sin(psi)^2/I3+cos(psi)^2/I2)",
        "M/I2*(1-(1-I2/I3)*sin(psi)^2)",
        "0 < I1, I1 < I2, I2 < I3, M > 0",
    ),
    "psi dot": (
        "M*(1/I1-sin(psi)^2/I3-cos(psi)^2/I2)*cos(theta)",
        "M/I2*((I2/I1-1)+(1-I2/I3)*sin(psi)^2)*cos(theta)",
        "0 < I1, I1 < I2, I2 < I3, M > 0",
    ),
    "dtheta/dphi": (
        "M*(1/I3-1/I2)*sin(theta)*sin(psi)*cos(psi)/(M*(sin(psi)^2/I3+cos(psi)^2/I2))",
        "-(1-I2/I3)*sin(theta)*sin(psi)*cos(psi)/(1-(1-I2/I3)*sin(psi)^2)",
        "0 < I1, I1 < I2, I2 < I3, M > 0",
    ),
    "gamma conserved": (
        (
            "diff(a-sin(theta)^2*(a+b*sin(psi)^2),theta)*(-b*sin(theta)*sin(psi)*cos(psi)/(1-"
            "b*sin(psi)^2))+diff(a-sin(theta)^2*(a+b*sin(psi)^2),psi)*((a+b*sin(psi)^2)*cos(t"
            "heta)/(1-b*sin(psi)^2))"
        ),
        "0",
        "a > 0, 0 < b <= 1",
    ),
    "a minus gamma": (
        "a-(a-sin(theta)^2*(a+b*sin(psi)^2))",
        "sin(theta)^2*(a+b*sin(psi)^2)",
        "a > 0, 0 < b <= 1",
    ),
    "gamma plus b": (
        "(a-sin(theta)^2*(a+b*sin(psi)^2))+b",
        "a*cos(theta)^2+b*(cos(theta)^2*sin(psi)^2+cos(psi)^2)",
        "a > 0, 0 < b <= 1",
    ),
    "cos theta": (
        "sqrt(((a-sin(theta)^2*(a+b*sin(psi)^2))+b*sin(psi)^2)/(a+b*sin(psi)^2))",
        "cos(theta)",
        "a > 0, 0 < b <= 1, 0 < theta, theta < pi/2",
    ),
    "dpsi/dphi": (
        "(a+b*sin(psi)^2)*sqrt((gamma+b*sin(psi)^2)/(a+b*sin(psi)^2))/(1-b*sin(psi)^2)",
        "sqrt(a+b*sin(psi)^2)*sqrt(gamma+b*sin(psi)^2)/(1-b*sin(psi)^2)",
        "a > 0, 0 < b <= 1, 0 < gamma",
    ),
    "integrand": (
        "1/(sqrt(a+b*sin(psi)^2)*sqrt(gamma+b*sin(psi)^2)/(1-b*sin(psi)^2))",
        "(1-b*sin(psi)^2)/(sqrt(a+b*sin(psi)^2)*sqrt(gamma+b*sin(psi)^2))",
        "a > 0, 0 < b <= 1, gamma > 0",
    ),
    "sin cos from gamma": (
        (
            "sqrt((a-sin(theta)^2*(a+b*sin(psi)^2)+b-(a+b)*cos(theta)^2)*(a*cos(theta)^2-(a-s"
            "in(theta)^2*(a+b*sin(psi)^2))))/(b*sin(theta)^2)"
        ),
        "abs(sin(psi)*cos(psi))",
        "a > 0, 0 < b <= 1",
    ),
    "dtheta denominator": (
        "(a-sin(theta)^2*(a+b*sin(psi)^2))+1-(a+1)*cos(theta)^2",
        "sin(theta)^2*(1-b*sin(psi)^2)",
        "a > 0, 0 < b <= 1",
    ),
    "turning point": (
        "b*sin(asin(sqrt(-gamma/b)))^2",
        "-gamma",
        "0 < b <= 1, gamma < 0, gamma + b > 0",
    ),
    "theta min": (
        "a-sin(acos(sqrt((gamma+b)/(a+b))))^2*(a+b)",
        "gamma",
        "a > 0, 0 < b <= 1, gamma < a, gamma + b > 0",
    ),
    "theta max": (
        "a-sin(acos(sqrt(gamma/a)))^2*a",
        "gamma",
        "a > 0, 0 < b <= 1, 0 < gamma, gamma < a",
    ),
    "substitution x: 1-x^2": (
        "1-(sqrt(b/(a+b))*cos(psi))^2",
        "(a+b*sin(psi)^2)/(a+b)",
        "a > 0, 0 < b <= 1",
    ),
    "substitution x: sin^2": (
        "1-(a+b)/b*(sqrt(b/(a+b))*cos(psi))^2",
        "sin(psi)^2",
        "a > 0, 0 < b <= 1",
    ),
    "substitution dx": (
        "diff(sqrt(b/(a+b))*cos(psi),psi)",
        "-sqrt(b/(a+b))*sin(psi)",
        "a > 0, 0 < b <= 1",
    ),
    "integral in x": (
        (
            "(1/((1-(a+b)/b*(sqrt(b/(a+b))*cos(psi))^2)*sqrt(1-(sqrt(b/(a+b))*cos(psi))^2)) -"
            " b/sqrt(1-(sqrt(b/(a+b))*cos(psi))^2))*diff(sqrt(b/(a+b))*cos(psi),psi)/b*(-1)"
        ),
        "(1-b*sin(psi)^2)/(sqrt(a+b*sin(psi)^2)*sqrt(b)*sin(psi))*1",
        "a > 0, 0 < b <= 1, 0 < psi, psi < pi",
    ),
    "antiderivative in x": (
        "diff(sqrt(b/a)*atanh(sqrt(a/b)*x/sqrt(1-x^2)) - b*asin(x),x)",
        "1/((1-(a+b)/b*x^2)*sqrt(1-x^2)) - b/sqrt(1-x^2)",
        "a > 0, 0 < b <= 1",
    ),
    "x0 identity": (
        "sqrt(a/b)*(sqrt(b/(a+b))*cos(epsilon))/sqrt(1-(sqrt(b/(a+b))*cos(epsilon))^2)",
        "cos(epsilon)/sqrt(1+b/a*sin(epsilon)^2)",
        "a > 0, 0 < b <= 1, 0 < epsilon, epsilon < pi/2",
    ),
    "arctanh as log": (
        "atanh(u)",
        "1/2*log((1+u)/(1-u))",
        "",
    ),
    "exponential equation left": (
        "exp(-2*atanh(cos(epsilon)/sqrt(1+b/a*sin(epsilon)^2)))",
        "(sqrt(1+b/a*sin(epsilon)^2)-cos(epsilon))/(sqrt(1+b/a*sin(epsilon)^2)+cos(epsilon))",
        "a > 0, 0 < b <= 1, 0 < epsilon, epsilon < pi/2",
    ),
    "sinh atanh": (
        "sinh(atanh(u))",
        "u/sqrt(1-u^2)",
        "",
    ),
    "cosh atanh": (
        "cosh(atanh(u))",
        "1/sqrt(1-u^2)",
        "",
    ),
    "stable form": (
        "1/sinh(atanh(cos(epsilon)/sqrt(1+b/a*sin(epsilon)^2)))",
        "sqrt((a+b)/a)*tan(epsilon)",
        "a > 0, 0 < b <= 1, 0 < epsilon, epsilon < pi/2",
    ),
    "cos from T": (
        "cos(atan(sqrt(a/(a+b))/sinh(T)))",
        "tanh(T)*sqrt((a+b)/a)*sqrt(a)/sqrt(a+b*tanh(T)^2)",
        "a > 0, 0 < b <= 1, T > 0",
    ),
    "asin to atan": (
        "asin(sqrt(b/(a+b))*c)",
        "atan(sqrt(b/a)*(c/sqrt(1+b/a*(1-c^2))))",
        "a > 0, 0 < b <= 1, 0 < c < 1",
    ),
    "map contraction": (
        "diff(sqrt(a*b)*(pi+atan(sqrt(b/a)*tanh(T))),T)",
        "b/(cosh(T)^2+b/a*sinh(T)^2)",
        "a > 0, 0 < b <= 1",
    ),
    "contraction at root": (
        "b*sin(atan(sqrt(a/(a+b))/sinh(T)))^2",
        "b*1/(1+(a+b)/a*sinh(T)^2)",
        "a > 0, 0 < b <= 1, T > 0",
    ),
    "mu": (
        "sqrt(b/(a+b))",
        "(1/sqrt(a*b))*b/sqrt(1+(1/sqrt(a*b))^2*b^2)",
        "a > 0, 0 < b <= 1",
    ),
    "one minus mu^2": (
        "sqrt(1-(sqrt(b/(a+b)))^2)",
        "sqrt(a/(a+b))",
        "a > 0, 0 < b <= 1",
    ),
    "df/dgamma general": (
        "diff((1-b*sin(psi)^2)/(sqrt(a+b*sin(psi)^2)*sqrt(gamma+b*sin(psi)^2)),gamma)",
        "-1/2*(1-b*sin(psi)^2)/(sqrt(a+b*sin(psi)^2)*(gamma+b*sin(psi)^2)**(3/2))",
        "a > 0, 0 < b <= 1",
    ),
    "appendix antiderivative": (
        (
            "diff((a-b-2*a*b)/(4*(a*b)**(3/2))*log((sqrt(a)*cos(psi)+sqrt(a+b*sin(psi)^2))/si"
            "n(psi)) + 1/4*sqrt(a+b*sin(psi)^2)*cos(psi)/(b**(3/2)*a*sin(psi)^2),psi)"
        ),
        "-1/(2*b**(3/2))*(1-b*sin(psi)^2)/(sqrt(a+b*sin(psi)^2)*sin(psi)^3)",
        "a > 0, 0 < b <= 1, 0 < psi, psi < pi",
    ),
    "deps/dF": (
        "-1/((1-b*sin(epsilon)^2)/(sqrt(a+b*sin(epsilon)^2)*sqrt(b*sin(epsilon)^2)))",
        "-sqrt(b)*sin(epsilon)*sqrt(a+b*sin(epsilon)^2)/(1-b*sin(epsilon)^2)",
        "a > 0, 0 < b <= 1, 0 < epsilon, epsilon < pi/2",
    ),
    "symmetry of f": (
        "(1-b*sin((pi-psi))^2)/(sqrt(a+b*sin((pi-psi))^2)*sqrt(gamma+b*sin((pi-psi))^2))",
        "(1-b*sin(psi)^2)/(sqrt(a+b*sin(psi)^2)*sqrt(gamma+b*sin(psi)^2))",
        "a > 0, 0 < b <= 1, gamma>0",
    ),
    "eps* limit form": (
        "exp(-sqrt(a*b)*b/sqrt(a*b)/sqrt(1+b/a))",
        "exp(-b/sqrt(1+b/a))",
        "a > 0, 0 < b <= 1",
    ),
    "leading series": (
        "diff(1/4*(1+b/a)*epsilon^2,epsilon,2)",
        "1/2*(1+b/a)",
        "a > 0, 0 < b <= 1",
    ),
    "half angle form": (
        "exp(-pi)",
        "tan(atan(exp(-pi)))",
        "",
    ),
    "floor tan": (
        "2*tan(atan(exp(-pi)))/(1-tan(atan(exp(-pi)))^2)",
        "1/sinh(pi)",
        "",
    ),
    "pythagoras momentum": (
        "cos(theta)^2+sin(theta)^2*cos(psi)^2+sin(theta)^2*sin(psi)^2",
        "1",
        "",
    ),
    "euler energy conserved": (
        "M1/I1*(-(1/I2-1/I3)*M2*M3)+M2/I2*((1/I1-1/I3)*M1*M3)+M3/I3*(-(1/I1-1/I2)*M1*M2)",
        "0",
        "",
    ),
    "euler momentum conserved": (
        "M1*(-(1/I2-1/I3)*M2*M3)+M2*((1/I1-1/I3)*M1*M3)+M3*(-(1/I1-1/I2)*M1*M2)",
        "0",
        "",
    ),
}
"""name: (left, right, given)."""

SUBSTITUTIONS = cases(__file__, "SUBSTITUTIONS")


def mutants() -> list[tuple[str, str, str]]:
    """Right sides with one substitution made in one place."""
    found = []
    for left, right, given in CHAIN.values():
        for old, new in SUBSTITUTIONS:
            if right.count(old) == 0 or (old == "b" and "abs" in right):
                continue
            found.append((left, right.replace(old, new, 1), given))
    return found


@pytest.mark.parametrize("name", CHAIN)
def test_proved(name: str) -> None:
    left, right, given = CHAIN[name]
    decision = decide(parse(left), parse(right), Given.parse(given))
    assert decision.verdict is Verdict.PROVED, decision.why


@pytest.mark.parametrize("name", CHAIN)
def test_off_by_a_small_constant_is_refuted(name: str) -> None:
    left, right, given = CHAIN[name]
    wrong = parse(right) + parse("1/10^60")
    decision = decide(parse(left), wrong, Given.parse(given))
    assert decision.verdict is Verdict.REFUTED, decision.why


def test_mutants_are_refuted() -> None:
    verdicts = {}
    for left, right, given in mutants():
        decision = decide(parse(left), parse(right), Given.parse(given))
        verdicts[left, right] = decision.verdict
    assert Verdict.UNDECIDED not in verdicts.values()
    survivors = [sides for sides, verdict in verdicts.items() if verdict is Verdict.PROVED]
    assert len(verdicts) - len(survivors) >= 60
    assert survivors == TRUE_MUTANTS


TRUE_MUTANTS: list[tuple[str, str]] = []
"""Variants that happen to be true."""
