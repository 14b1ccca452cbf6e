"""Tables of definite integrals, series and products whose values are quoted theorems.

A row holds for all values of its parameters a and b that satisfy its conditions. Numbers refer to
I. S. Gradshteyn and I. M. Ryzhik, *Table of Integrals, Series, and Products*, 7th edition (GR), and
to the *NIST Digital Library of Mathematical Functions* (DLMF); the tests compare each integral with
quadrature, each series and product with partial sums, and prove each power series.
"""

from __future__ import annotations

from typing import NamedTuple

from tresym.reals.functions.table import TABLE


class Theorem(NamedTuple):
    """The integral over t of ``body``, or its sum or product over n, is ``value``."""

    body: str
    value: str
    given: str
    source: str


TABLES = {
    "integral 0 oo": (
        Theorem("sin(a*t)/t", "pi/2", "a > 0", "GR 3.721.1"),
        Theorem("sin(a*t)**2/t**2", "pi*a/2", "a > 0", "GR 3.821.9"),
        Theorem("(1 - cos(a*t))/t**2", "pi*a/2", "a > 0", "GR 3.782.2"),
        Theorem("cos(a*t)/(t**2 + b**2)", "pi*exp(-a*b)/(2*b)", "a >= 0, b > 0", "GR 3.723.2"),
        Theorem("t*sin(a*t)/(t**2 + b**2)", "pi*exp(-a*b)/2", "a > 0, b > 0", "GR 3.723.3"),
        Theorem("exp(-a*t**2)", "sqrt(pi/a)/2", "a > 0", "GR 3.321.3"),
        Theorem("t**2*exp(-a*t**2)", "sqrt(pi/a)/(4*a)", "a > 0", "GR 3.461.2"),
        Theorem("exp(-a*t**2)*cos(b*t)", "sqrt(pi/a)*exp(-b**2/(4*a))/2", "a > 0", "GR 3.896.4"),
        Theorem("exp(-a*t)/sqrt(t)", "sqrt(pi/a)", "a > 0", "GR 3.361.2"),
        Theorem("sin(a*t**2)", "sqrt(pi/(2*a))/2", "a > 0", "GR 3.691.1"),
        Theorem("cos(a*t**2)", "sqrt(pi/(2*a))/2", "a > 0", "GR 3.691.1"),
        Theorem("exp(-a*t)*sin(b*t)/t", "atan(b/a)", "a > 0", "GR 3.941.1"),
        Theorem("(exp(-a*t) - exp(-b*t))/t", "log(b/a)", "a > 0, b > 0", "GR 3.434.2"),
        Theorem("(cos(a*t) - cos(b*t))/t", "log(b/a)", "a > 0, b > 0", "GR 3.784.1"),
        Theorem("t/sinh(a*t)", "pi**2/(4*a**2)", "a > 0", "GR 3.521.1"),
        Theorem("t/(exp(a*t) - 1)", "pi**2/(6*a**2)", "a > 0", "GR 3.411.1"),
        Theorem("t/(exp(a*t) + 1)", "pi**2/(12*a**2)", "a > 0", "GR 3.411.3"),
        Theorem("t**3/(exp(a*t) - 1)", "pi**4/(15*a**4)", "a > 0", "GR 3.411.1"),
        Theorem("t**3/(exp(a*t) + 1)", "7*pi**4/(120*a**4)", "a > 0", "GR 3.411.3"),
        Theorem("log(1 - exp(-a*t))", "-pi**2/(6*a)", "a > 0", "GR 4.223.2"),
        Theorem("log(1 + exp(-a*t))", "pi**2/(12*a)", "a > 0", "GR 4.223.1"),
        Theorem("sin(a*t)/sinh(b*t)", "pi*tanh(pi*a/(2*b))/(2*b)", "b > 0", "GR 3.981.1"),
        Theorem("cos(a*t)/cosh(b*t)", "pi*sech(pi*a/(2*b))/(2*b)", "b > 0", "GR 3.981.3"),
        Theorem("log(t)/(t**2 + b**2)", "pi*log(b)/(2*b)", "b > 0", "GR 4.231.8"),
        Theorem("t**(a - 1)/(1 + t)", "pi*csc(pi*a)", "0 < a, a < 1", "GR 3.222.2"),
        Theorem("1/(1 + t**a)", "pi/a*csc(pi/a)", "a > 1", "GR 3.241.2"),
        Theorem("log(1 + a**2/t**2)", "pi*a", "a > 0", "GR 4.222.1"),
        Theorem("t**(a - 1)*exp(-b*t)", "gamma(a)/b**a", "a > 0, b > 0", "DLMF 5.9.1"),
        Theorem("t**(a - 1)/(exp(t) - 1)", "gamma(a)*zeta(a)", "a > 1", "DLMF 25.5.1"),
        Theorem("exp(-a*t)/(t + b)", "exp(a*b)*expint(1, a*b)", "a > 0, b > 0", "DLMF 6.2.2"),
        Theorem("exp(-a*cosh(t))", "besselk(0, a)", "a > 0", "DLMF 10.32.9"),
        Theorem("exp(-t)*log(t)", "-EulerGamma", "", "DLMF 5.9.16"),
        Theorem("exp(-a*t)*besselj(0, b*t)", "1/sqrt(a**2 + b**2)", "a > 0", "DLMF 10.22.49"),
        Theorem("besselj(a, b*t)", "1/b", "a > -1, b > 0", "DLMF 10.22.41"),
        Theorem(
            "t**(a - 1)*besselk(b, t)",
            "2**(a - 2)*gamma((a - b)/2)*gamma((a + b)/2)",
            "a > b, a > -b",
            "DLMF 10.43.19",
        ),
        Theorem("besselj(0, b*t)", "1/b", "b > 0", "DLMF 10.22.41"),
        Theorem("besselk(0, b*t)", "pi/(2*b)", "b > 0", "DLMF 10.43.19"),
        Theorem("airyai(t)", "1/3", "", "DLMF 9.10.11"),
        Theorem("t**(a - 1)*erfc(t)", "gamma((a + 1)/2)/(a*sqrt(pi))", "a > 0", "DLMF 7.2.2"),
        Theorem("t**(a - 1)*expint(1, t)", "gamma(a)/a", "a > 0", "DLMF 8.19.2"),
        Theorem("t**(a - 1)*sin(t)", "gamma(a)*sin(pi*a/2)", "0 < a, a < 1", "DLMF 5.9.7"),
        Theorem("t**(a - 1)*cos(t)", "gamma(a)*cos(pi*a/2)", "0 < a, a < 1", "DLMF 5.9.6"),
        Theorem(
            "t**(a - 1)/(exp(t) + 1)", "gamma(a)*zeta(a)*(1 - 2**(1 - a))", "a > 1", "DLMF 25.5.3"
        ),
        Theorem(
            "t**(a - 1)/(1 + t)**(a + b)",
            "gamma(a)*gamma(b)/gamma(a + b)",
            "a > 0, b > 0",
            "DLMF 5.12.3",
        ),
    ),
    "integral 0 1": (
        Theorem("log(t)/(1 - t)", "-pi**2/6", "", "GR 4.231.2"),
        Theorem("log(t)/(1 + t)", "-pi**2/12", "", "GR 4.231.1"),
        Theorem("log(t)/(1 - t**2)", "-pi**2/8", "", "GR 4.231.13"),
        Theorem("t*log(t)/(1 - t**2)", "-pi**2/24", "", "GR 4.231.14"),
        Theorem("log(t)/sqrt(1 - t**2)", "-pi*log(2)/2", "", "GR 4.241.7"),
        Theorem("log(1 + t)/t", "pi**2/12", "", "GR 4.291.1"),
        Theorem("log(1 - t)/t", "-pi**2/6", "", "GR 4.291.2"),
        Theorem("log(1 + t)/(1 + t**2)", "pi*log(2)/8", "", "GR 4.291.8"),
        Theorem("log((1 + t)/(1 - t))/t", "pi**2/4", "", "GR 4.291.1 and 4.291.2"),
        Theorem("log(t)*log(1 - t)", "2 - pi**2/6", "", "GR 4.221.1"),
        Theorem("log(t)*log(1 + t)", "2 - 2*log(2) - pi**2/12", "", "GR 4.221.2"),
        Theorem("asin(t)/t", "pi*log(2)/2", "", "GR 4.521.1"),
        Theorem("(t**a - t**b)/log(t)", "log((a + 1)/(b + 1))", "a > -1, b > -1", "GR 4.267.8"),
        Theorem(
            "t**(a - 1)*(1 - t)**(b - 1)",
            "gamma(a)*gamma(b)/gamma(a + b)",
            "a > 0, b > 0",
            "DLMF 5.12.1",
        ),
        Theorem("log(t)/(1 + t**2)", "-Catalan", "", "GR 4.231.12"),
        Theorem("atan(t)/t", "Catalan", "", "GR 4.531.1"),
        Theorem("log(log(1/t))", "-EulerGamma", "", "DLMF 5.9.16"),
        Theorem("log(1/t)**(a - 1)", "gamma(a)", "a > 0", "DLMF 5.2.1"),
        Theorem("elliptic_k(t**2)", "2*Catalan", "", "GR 6.141.1"),
        Theorem("elliptic_e(t**2)", "Catalan + 1/2", "", "GR 6.148.1"),
        Theorem("log(1 - a*t)/t", "-polylog(2, a)", "a < 1", "DLMF 25.12.2"),
        Theorem("1/sqrt((1 - t**2)*(1 - a*t**2))", "elliptic_k(a)", "a < 1", "DLMF 19.2.8"),
    ),
    "integral 0 pi/2": (
        Theorem("log(sin(t))", "-pi*log(2)/2", "", "GR 4.224.3"),
        Theorem("log(cos(t))", "-pi*log(2)/2", "", "GR 4.224.6"),
        Theorem("log(tan(t))", "0", "", "GR 4.224.3 and 4.224.6"),
        Theorem("log(2*sin(t))", "0", "", "GR 4.224.3"),
        Theorem("log(2*cos(t))", "0", "", "GR 4.224.6"),
        Theorem("t*cot(t)", "pi*log(2)/2", "", "GR 3.747.7"),
        Theorem("t**2/sin(t)**2", "pi*log(2)", "", "GR 3.837.1"),
        Theorem("1/(a**2*cos(t)**2 + b**2*sin(t)**2)", "pi/(2*a*b)", "a > 0, b > 0", "GR 3.642.1"),
        Theorem("sqrt(tan(t))", "pi/sqrt(2)", "", "GR 3.622.1"),
        Theorem("1/sqrt(1 - a*sin(t)**2)", "elliptic_k(a)", "a < 1", "DLMF 19.2.8"),
        Theorem("cos(a*sin(t))", "pi*besselj(0, a)/2", "", "DLMF 10.9.1"),
        Theorem("cos(a*cos(t))", "pi*besselj(0, a)/2", "", "DLMF 10.9.1"),
        Theorem("sqrt(1 - a*sin(t)**2)", "elliptic_e(a)", "a < 1", "DLMF 19.2.8"),
        Theorem(
            "sin(t)**a", "sqrt(pi)*gamma((a + 1)/2)/(2*gamma(a/2 + 1))", "a > -1", "DLMF 5.12.2"
        ),
    ),
    "integral 0 pi": (
        Theorem("cos(a*sin(t))", "pi*besselj(0, a)", "", "DLMF 10.9.1"),
        Theorem("exp(a*cos(t))", "pi*besseli(0, a)", "", "DLMF 10.32.1"),
        Theorem("cos(a*cos(t))", "pi*besselj(0, a)", "", "DLMF 10.9.1"),
        Theorem("log(sin(t))", "-pi*log(2)", "", "GR 4.224.3"),
        Theorem("t*sin(t)/(1 + cos(t)**2)", "pi**2/4", "", "GR 3.79"),
        Theorem("t*log(sin(t))", "-pi**2*log(2)/2", "", "GR 4.322.1"),
        Theorem("1/(a + b*cos(t))", "pi/sqrt(a**2 - b**2)", "a > 0, a > abs(b)", "GR 3.613.1"),
        Theorem(
            "1/(a + b*cos(t))**2", "pi*a/(a**2 - b**2)**(3/2)", "a > abs(b), a > 0", "GR 3.661.4"
        ),
        Theorem(
            *("log(a + b*cos(t))", "pi*log((a + sqrt(a**2 - b**2))/2)"),
            *("a > 0, a > abs(b)", "GR 4.224.9"),
        ),
        Theorem("log(1 - 2*a*cos(t) + a**2)", "0", "-1 < a, a < 1", "GR 4.224.14"),
        Theorem("log(1 - 2*a*cos(t) + a**2)", "2*pi*log(a)", "a > 1", "GR 4.224.14"),
    ),
    "integral 0 2*pi": (
        Theorem("1/(a + b*cos(t))", "2*pi/sqrt(a**2 - b**2)", "a > 0, a > abs(b)", "GR 3.613.1"),
        Theorem("1/(a + b*sin(t))", "2*pi/sqrt(a**2 - b**2)", "a > 0, a > abs(b)", "GR 3.613.1"),
    ),
    "integral 0 pi/4": (Theorem("log(1 + tan(t))", "pi*log(2)/8", "", "GR 4.227.9"),),
    "sum 1 oo": (
        Theorem("1/n**a", "zeta(a)", "a > 1", "DLMF 25.2.1"),
        Theorem("(-1)**n/(2*n - 1)**2", "-Catalan", "", "DLMF 25.11.40"),
        Theorem("(-1)**n/n**a", "(2**(1 - a) - 1)*zeta(a)", "a > 1", "DLMF 25.2.3"),
        Theorem("1/n**2", "pi**2/6", "", "DLMF 25.6.1"),
        Theorem("1/n**4", "pi**4/90", "", "DLMF 25.6.1"),
        Theorem("1/n**6", "pi**6/945", "", "DLMF 25.6.1"),
        Theorem("1/n**8", "pi**8/9450", "", "DLMF 25.6.2"),
        Theorem("(-1)**n/n**2", "-pi**2/12", "", "DLMF 25.2.3 and 25.6.1"),
        Theorem("(-1)**n/n**4", "-7*pi**4/720", "", "DLMF 25.2.3 and 25.6.1"),
        Theorem("(-1)**n/n**6", "-31*pi**6/30240", "", "DLMF 25.2.3 and 25.6.1"),
        Theorem("(-1)**n/n**8", "-127*pi**8/1209600", "", "DLMF 25.2.3 and 25.6.2"),
        Theorem("1/(2*n - 1)**2", "pi**2/8", "", "DLMF 25.2.2 and 25.6.1"),
        Theorem("1/(2*n - 1)**4", "pi**4/96", "", "DLMF 25.2.2 and 25.6.1"),
        Theorem("1/(2*n - 1)**6", "pi**6/960", "", "DLMF 25.2.2 and 25.6.1"),
        Theorem("1/(2*n - 1)**8", "17*pi**8/161280", "", "DLMF 25.2.2 and 25.6.2"),
        Theorem("(-1)**n/(2*n - 1)", "-pi/4", "", "DLMF 24.8.5"),
        Theorem("(-1)**n/(2*n - 1)**3", "-pi**3/32", "", "DLMF 24.8.5"),
        Theorem("(-1)**n/(2*n - 1)**5", "-5*pi**5/1536", "", "DLMF 24.8.5"),
        Theorem("(-1)**n/(2*n - 1)**7", "-61*pi**7/184320", "", "DLMF 24.8.5"),
        # at a = 0 the value is the limit, since the sums converge locally uniformly
        Theorem("1/(n**2 - a**2)", "(1 - pi*a*cot(pi*a))/(2*a**2)", "", "DLMF 4.22.3"),
        Theorem("(-1)**n/(n**2 - a**2)", "(1 - pi*a*csc(pi*a))/(2*a**2)", "", "DLMF 4.22.5"),
        Theorem("1/(n**2 + a**2)", "(pi*a*coth(pi*a) - 1)/(2*a**2)", "", "DLMF 4.36.3"),
        Theorem("(-1)**n/(n**2 + a**2)", "(pi*a*csch(pi*a) - 1)/(2*a**2)", "", "DLMF 4.36.5"),
        Theorem("1/((2*n - 1)**2 - a**2)", "pi*tan(pi*a/2)/(4*a)", "", "DLMF 4.22.3 and 4.21.27"),
        Theorem("1/((2*n - 1)**2 + a**2)", "pi*tanh(pi*a/2)/(4*a)", "", "DLMF 4.36.3 and 4.35.26"),
        Theorem(
            *("(-1)**n*(2*n - 1)/((2*n - 1)**2 - a**2)", "-pi*sec(pi*a/2)/4"),
            *("", "DLMF 4.22.5 at pi/2 - z"),
        ),
        Theorem(
            *("(-1)**n*(2*n - 1)/((2*n - 1)**2 + a**2)", "-pi*sech(pi*a/2)/4"),
            *("", "DLMF 4.22.5 at pi/2 - i z"),
        ),
    ),
    "sum -oo oo": (Theorem("1/(a*n + b)**2", "(pi/a*csc(pi*b/a))**2", "", "DLMF 4.22.4"),),
    "product 1 oo": (
        Theorem("1 - a**2/n**2", "sin(pi*a)/(pi*a)", "", "DLMF 4.22.1"),
        Theorem("1 - a**2/(2*n - 1)**2", "cos(pi*a/2)", "", "DLMF 4.22.2"),
        Theorem("1 + a**2/n**2", "sinh(pi*a)/(pi*a)", "", "DLMF 4.36.1"),
        Theorem("1 + a**2/(2*n - 1)**2", "cosh(pi*a/2)", "", "DLMF 4.36.2"),
        Theorem("cos(a/2**n)", "sin(a)/a", "", "Vieta's product, DLMF 4.21.27 again and again"),
    ),
    "product 0 a - 1": (
        Theorem("sin(b + n*pi/a)", "sin(a*b)/2**(a - 1)", "a >= 1", "DLMF 4.21.35"),
    ),
    "product 1 a - 1": (Theorem("sin(n*pi/a)", "a/2**(a - 1)", "a >= 1", "DLMF 4.21.35 at z = 0"),),
}
"""The theorems by the range of t or n."""

POWER_SERIES = (
    *((row.power_series, f"{row.name}(y)") for row in TABLE.values() if row.power_series),
    ("y**(k + 1)/(k + 1)", "-log(1 - y)"),
    ("4**k*factorial(k)**2*2*y**(2*k + 2)/factorial(2*k + 2)", "asin(y)**2"),
    ("y**k", "1/(1 - y)"),
    ("(k + 1)*y**k", "1/(1 - y)**2"),
    ("(k + 1)**2*y**k", "(1 + y)/(1 - y)**3"),
    ("factorial(2*k)*y**k/(4**k*factorial(k)**2)", "1/sqrt(1 - y)"),
)
"""The terms for k = 0, 1, …, and the sum for small y."""
