"""The LaTeX reader: what it reads, what it refuses, and that it reads what SymPy writes."""

import pytest
from flint import arb
from hypothesis import given
from hypothesis import strategies as st
from sympy import I, latex, nan, zoo

from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.language.binders import at, derivative, integral, limit, order
from tresym.reals.language.expression import (
    FUNCTIONS,
    PI,
    Expr,
    apply,
    number,
    opened,
    power,
    sqrt,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.language.latex import read_expression, read_latex
from tresym.reals.language.latex_author import Author
from tresym.reals.language.parsing import as_written
from tresym.reals.language.to_sympy import to_sympy
from tresym.reals.language.typesetting import to_latex
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import InputError

EXPRESSIONS = {
    r"\bar x+\hat{\theta}_0-\tilde{y_1}": "x_bar + theta0hat - y1tilde",
    r"\mathcal{E}x^*": "E_mathcal*x_star",
    r"{1 \over x+1}": "1/(x + 1)",
    r"\int^1_0 x\,dx": "integral(x, x, 0, 1)",
    r"\biggl(\cfrac{x}{2}\biggr)": "x/2",
    r"\int x\cos x\,dx+1": "integral(x*cos(x), x) + 1",
    r"\sum_{k=1}^n k^2+n": "sum(k**2, k, 1, n) + n",
    r"\prod_{k=2}^{n}\frac{k}{k-1}": "product(k/(k - 1), k, 2, n)",
    r"\binom{n}{2}-\frac{x^3}{3!}": "n*(n - 1)/2 - x**3/6",
    r"|xy|-|x||y|": "abs(x*y) - abs(x)*abs(y)",
    r"a+b": "a + b",
    r"-a+b": "-a + b",
    r"a-(b-c)": "a - (b - c)",
    r"-2\pi b": "-2*pi*b",
    r"ab": "a*b",
    r"a\cdot b\times c": "a*b*c",
    r"2^{10}": "2**10",
    r"x^2y": "x**2*y",
    r"-x^2": "-x**2",
    r"x^{-2}": "x**(-2)",
    r"b^{3/2}": "b**(3/2)",
    r"\frac12": "1/2",
    r"\frac ab": "a/b",
    r"\frac{a+1}{b-1}": "(a + 1)/(b - 1)",
    r"\frac{1}{2}\left(1+\frac{b}{a}\right)": "1/2*(1 + b/a)",
    r"\sqrt{a+b\sin^2\psi}": "sqrt(a + b*sin(psi)**2)",
    r"\sqrt[3]{x}": "cbrt(x)",
    r"\sin\theta(a+b)": "sin(theta)*(a + b)",
    r"\sin\psi\cos\psi": "sin(psi)*cos(psi)",
    r"\sin 2x": "sin(2*x)",
    r"\sin(2x)": "sin(2*x)",
    r"\cos\frac{x}{2}": "cos(x/2)",
    r"\arcsin [\sqrt{\frac{|\gamma|}{b}}]": "asin(sqrt(abs(gamma)/b))",
    r"\operatorname{artanh}(x)": "atanh(x)",
    r"\textrm{arctanh}(x)": "atanh(x)",
    r"\ln[(1+u)/(1-u)]": "log((1 + u)/(1 - u))",
    r"e^{-\sqrt{ab}\pi}": "exp(-sqrt(a*b)*pi)",
    r"e x": "E*x",
    r"\left|x-1\right|+|y|": "abs(x - 1) + abs(y)",
    r"\psi_0+\epsilon_{0}+M_{1f}": "psi0 + epsilon0 + M1f",
    r"\theta_{\min}-\psi_f": "theta_min - psi_f",
    r"\Delta\psi": "Delta_psi",
    r"\lambda E": "lambda_*E_",
    r"\dot{\theta}+\dot\phi": "dtheta_dt + dphi_dt",
    r"\frac{d\psi}{d\phi}+d\psi/d\phi": "dpsi_dphi + dpsi_dphi",
    r"\frac{\partial F}{\partial\gamma}": "partialF_partialgamma",
    r"\frac{d}{dx}\sin(x)": "diff(sin(x), x)",
    r"\frac{d^2}{dx^2}\sin(x)+1": "diff(sin(x), x, 2) + 1",
    r"\frac{\partial^{3}}{\partial\psi^{3}}\psi^4": "diff(psi**4, psi, 3)",
    r"1.09\times 10^{-2}": "0.0109",
    r"0.1150\textrm{ rad}": "0.1150",
    r"f(a,b)+\epsilon(\gamma)+g(x)": "f + epsilon + g",
    r"\left.\frac{d\epsilon}{d\gamma}\right|_{\gamma=0}": "at(depsilon_dgamma, gamma, 0)",
    r"\Delta\psi|_{\Delta\phi=2\pi}": "at(Delta_psi, Delta_phi, 2*pi)",
    r"\left[\frac{x^2}{2}\right]_{0}^{b}": "at(x**2/2, x, b) - at(x**2/2, x, 0)",
    r"\int_0^{\pi}\sin x\,dx": "integral(sin(x), x, 0, pi)",
    r"2\int_a^b f(x)\mathrm{d}x+c": "2*integral(f, x, a, b) + c",
    r"\int_0^1\frac{dx}{1-x^2}-b\frac{dx}{x}-c": "integral(1/(1 - x**2) - b*(1/x), x, 0, 1) - c",
    r"O(\gamma^2)+o\left(\frac1x\right)": "O(gamma**2) + o(1/x)",
    r"x % a comment": "x",
    r"\frac{du}{d\lambda}(0,0,0)": "at(du_dlambda, p1, 0, p2, 0, p3, 0)",
}

REFUSED = {
    r"3\,000": "two numbers side by side",
    r"\frac{d^2}{dx^3}x": "a derivative of higher order is written",
    r"\frac{d^2y}{dx^2}": "a derivative of a symbol is not known",
    r"1/2x": "what is below the slash",
    r"x^12": "of several digits TeX takes one",
    r"\foo{x}": "this is not read",
    r"\vec{M}": "this is not read",
    r"(a+b": "ends where more is expected",
    r"(a+b]": "is not closed",
    r"|a+b": "ends where more is expected",
    r"a+": "an operation or the end is expected",
    r"a+(": "ends where more is expected",
    r"a = b": "an operation or the end is expected",
    r"\frac{}{b}": "empty numerator",
    r"x_{a+b}": "the subscript",
    "{" * 100 + "x" + "}" * 100: "nested deeper",
    "x" * 10_001: "beyond the limit",
    "": "ends where more is expected",
}

AUTHORS_REFUSED = {
    r"f(2x)": "not known",
    r"[xy]_0^1": "needs its variable",
    r"\int_0^1 f": "differential",
}

# What print means, as our text says it.
ARGUMENTS = {
    # the product that follows a function's name is its argument
    r"\sin\frac{1}{2}x": "sin(1/2*x)",
    r"\cos\frac{3}{2}\pi": "cos(3/2*pi)",
    r"\tan\tfrac12\theta": "tan(1/2*theta)",
    r"\tan^2\tfrac{1}{2}\theta": "tan(1/2*theta)**2",
    r"\sin\sqrt{2}x": "sin(sqrt(2)*x)",
    r"\cos\sqrt{\lambda}x": "cos(sqrt(lambda_)*x)",
    r"\sin\sqrt{k/m}\,": "sin(sqrt(k/m))",
    r"\sin n\pi": "sin(n*pi)",
    r"\sin 2n\pi x": "sin(2*n*pi*x)",
    r"\cos n\theta\cos m\theta": "cos(n*theta)*cos(m*theta)",
    r"\cosh\frac{1}{2}(x-y)": "cosh(1/2*(x - y))",
    r"\sin\tfrac12(\alpha+\beta)": "sin(1/2*(alpha + beta))",
    r"2\sin\tfrac{1}{2}(A+B)\cos\tfrac{1}{2}(A-B)": "2*sin(1/2*(A + B))*cos(1/2*(A - B))",
    r"\sin 2(x+y)": "sin(2*(x + y))",
    r"\cos 2\left(x+y\right)": "cos(2*(x + y))",
    r"\sin\pi(x+1)": "sin(pi*(x + 1))",
    r"\cos 2\pi\left(x-\frac12\right)": "cos(2*pi*(x - 1/2))",
    r"\sin ab": "sin(a*b)",
    r"\sin x y": "sin(x*y)",
    r"\cos\omega t": "cos(omega*t)",
    r"A\cos\omega_0 t+B\sin\omega_0 t": "A*cos(omega0*t) + B*sin(omega0*t)",
    r"\sin\alpha\beta\gamma": "sin(alpha*beta*gamma)",
    r"\cos\frac{n\pi}{L}x": "cos(n*pi/L*x)",
    r"\cos\frac{n\pi x}{L}": "cos(n*pi*x/L)",
    r"\sin\frac{\pi}{2}\frac{x}{L}": "sin(pi/2*(x/L))",
    r"\sin\frac\pi4 x": "sin(pi/4*x)",
    r"\sin\frac{\pi}{4}\cos x": "sin(pi/4)*cos(x)",
    r"\ln 2\cdot\ln 3": "log(2)*log(3)",
    r"\cos x\ln x": "cos(x)*log(x)",
    r"\sin\arctan x": "sin(atan(x))",
    r"\sin x^2": "sin(x**2)",
    r"\sin x^2y": "sin(x**2*y)",
    r"\log x^2": "log(x**2)",
    r"\ln x^{n}": "log(x**n)",
    r"\ln 2x": "log(2*x)",
    r"\ln 2e^x": "log(2*exp(x))",
    r"\ln e^x": "log(exp(x))",
    r"\ln 1": "log(1)",
    r"\cos 0+\tan\frac{\pi}{4}": "cos(0) + tan(pi/4)",
    r"\arctan\frac{y}{x}": "atan(y/x)",
    r"\operatorname{arsinh}\frac{1}{x}": "asinh(1/x)",
    r"\exp x": "exp(x)",
    r"\sin\lambda x": "sin(lambda_*x)",
    r"\sin\Delta\psi": "sin(Delta_psi)",
    r"\sin 3\sqrt{x}y": "sin(3*sqrt(x)*y)",
    # up to the next function, sign, relation or closing bracket
    r"\sin x\cos x": "sin(x)*cos(x)",
    r"\sin x\,\cos y\,\tan z": "sin(x)*cos(y)*tan(z)",
    r"\sin x\cdot\cos x": "sin(x)*cos(x)",
    r"\sin x\times\cos x": "sin(x)*cos(x)",
    r"\sin x/\cos x": "sin(x)/cos(x)",
    r"\ln x/\ln 2": "log(x)/log(2)",
    r"\sin ax\cos bx": "sin(a*x)*cos(b*x)",
    r"\sin x\ln x": "sin(x)*log(x)",
    r"\sin^2\theta\cos\theta": "sin(theta)**2*cos(theta)",
    r"\sin^2 2x+\cos^{2}2x": "sin(2*x)**2 + cos(2*x)**2",
    r"\sin x^2\cos x": "sin(x**2)*cos(x)",
    r"\sinh x\cosh y+\cosh x\sinh y": "sinh(x)*cosh(y) + cosh(x)*sinh(y)",
    r"\sin x+y": "sin(x) + y",
    r"(\sin x)y": "sin(x)*y",
    r"\frac{\sin x}{x}": "sin(x)/x",
    r"\sqrt{\sin x}y": "sqrt(sin(x))*y",
    r"|\sin x|": "abs(sin(x))",
    r"x\sin x": "x*sin(x)",
    r"a/\sin x": "a/sin(x)",
    r"2\,\sin x": "2*sin(x)",
    r"e^{-x}\sin x": "exp(-x)*sin(x)",
    r"\ln\tan\frac{x}{2}": "log(tan(x/2))",
    r"\ln\ln x": "log(log(x))",
    r"\sin\cos x y": "sin(cos(x*y))",
    r"-\ln\cos x": "-log(cos(x))",
    # a bracket right after the name is the whole argument
    r"\sin(x)y": "sin(x)*y",
    r"\sin\left(x\right)y": "sin(x)*y",
    r"\sin\bigl(2x\bigr)y": "sin(2*x)*y",
    r"\sin[2x]y": "sin(2*x)*y",
    r"\sin^2(x)y": "sin(x)**2*y",
    r"\sin^{2}\left(\frac{x}{2}\right)y": "sin(x/2)**2*y",
    r"\sin(x)(1+x)": "sin(x)*(1 + x)",
    r"\sin(x)/2": "sin(x)/2",
    r"\sin(x+1)/2": "sin(x + 1)/2",
    r"\ln(1+x)/(1-x)": "log(1 + x)/(1 - x)",
    r"\sin(x)^2+\cos(x)^2": "sin(x)**2 + cos(x)**2",
    r"\sin(x+y)\cos(x-y)": "sin(x + y)*cos(x - y)",
    r"\sin(x+y)\cdot z": "sin(x + y)*z",
    r"\cos(\omega t+\phi)e^{-\gamma t}": "cos(omega*t + phi)*exp(-gamma*t)",
    r"\cos(\omega t+\phi)\sqrt{x}": "cos(omega*t + phi)*sqrt(x)",
    r"\exp(a+b)x": "exp(a + b)*x",
    r"\exp(-x^2)y": "exp(-x**2)*y",
    r"\exp\left\{-\frac{x^2}{2}\right\}": "exp(-x**2/2)",
    r"\ln|x|": "log(abs(x))",
    r"\ln\left|\sec x+\tan x\right|+C": "log(abs(sec(x) + tan(x))) + C",
    r"\sin{x}\cos{y}": "sin(x)*cos(y)",
    r"\log{\left(x+1\right)}^{2}": "log(x + 1)**2",
    r"\sin{\left(x+1\right)}y": "sin(x + 1)*y",
    r"\arctan(x)/x": "atan(x)/x",
    r"\ln(2)x": "log(2)*x",
    r"{\sin^{2}}z": "sin(z)**2",
    r"{\cos}^2 z": "cos(z)**2",
    r"\sin^{-2}x": "sin(x)**(-2)",
    r"\log_2 8": "log(8, 2)",
    r"\log_{10}x+\log_2(x+1)": "log(x, 10) + log(x + 1, 2)",
    r"\operatorname{sech}x\operatorname{csch}x": "sech(x)*csch(x)",
    r"\operatorname{sgn}(x)": "sign(x)",
    r"\operatorname{arccot}x": "acot(x)",
    r"\exp{-x}": "exp(-x)",
    r"\sin{\frac{x}{2}}": "sin(x/2)",
    r"\sin{2x}\cos{x}": "sin(2*x)*cos(x)",
    # d/dx takes the product that follows
    r"\frac{d}{dx}x^2\sin x": "diff(x**2*sin(x), x)",
    r"\frac{d}{dx} x^2\,\sin x+1": "diff(x**2*sin(x), x) + 1",
    r"\frac{d}{dx}\sin(x)\cos(x)": "diff(sin(x)*cos(x), x)",
    r"\frac{d}{dx}e^{ax}\sin bx": "diff(exp(a*x)*sin(b*x), x)",
    r"\frac{d}{dx}\left[x\sin x\right]": "diff((x*sin(x)), x)",
    r"\frac{d}{dx}(x^2+1)^3": "diff((x**2 + 1)**3, x)",
    r"\frac{d}{dx}(x^2)y": "diff((x**2)*y, x)",
    r"\frac{d}{dx}x^2/2": "diff(x**2/2, x)",
    r"x\frac{d}{dx}x^2": "x*diff(x**2, x)",
    r"\frac{d}{dx}\frac{d}{dx}x^3": "diff(diff(x**3, x), x)",
    r"\frac{d^2}{dx^2}x^2\sin x": "diff(x**2*sin(x), x, 2)",
    r"\frac{d}{dt}\cos\omega t": "diff(cos(omega*t), t)",
    r"\frac{d}{d\lambda}\lambda^2": "diff(lambda_**2, lambda_)",
    r"\frac{d^2}{d\lambda^2}\lambda^3": "diff(lambda_**3, lambda_, 2)",
    r"\frac{\partial}{\partial x}x y": "diff(x*y, x)",
    r"\frac{\partial}{\partial x}y^2": "diff(y**2, x)",
    r"\frac{d}{dx}5": "diff(5, x)",
    r"\frac{\partial^2}{\partial x^2}x^3y": "diff(x**3*y, x, 2)",
    r"\frac{\mathrm{d}}{\mathrm{d}x}\sin x": "diff(sin(x), x)",
    r"\frac{\mathrm d}{\mathrm dx}\sin x": "diff(sin(x), x)",
    r"\frac d{dx}x^2": "diff(x**2, x)",
    r"\frac{d\sin x}{dx}": "diff(sin(x), x)",
    r"\frac{d(x^2+1)}{dx}y": "diff((x**2 + 1), x)*y",
    r"\left(\frac{d}{dx}x^2\right)\sin x": "diff(x**2, x)*sin(x)",
    # products
    r"x(x+1)": "x*(x + 1)",
    r"a(b+c)": "a*(b + c)",
    r"(x)(y)": "x*y",
    r"x{\left(y+1\right)}": "x*(y + 1)",
    r"{\sin x}\cos y+{x}{y}": "sin(x)*cos(y) + x*y",
    r"2(x)+2(x+1)": "2*x + 2*(x + 1)",
    r"\pi(x+1)": "pi*(x + 1)",
    r"x^2(y+1)": "x**2*(y + 1)",
    r"x\cdot(0)": "x*0",
    r"V\left(\frac{a}{r}\right)^{12}": "V*(a/r)**12",
    r"2\frac{x}{3}": "2*(x/3)",
    r"ad-bc": "a*d - b*c",
    r"\frac{d^2}{4}+\frac{d}{2}": "d**2/4 + d/2",
    r"i_1+x_i": "i1 + x_i",
    r"\mathrm{e}^x+\mathrm e^{2}": "exp(x) + exp(2)",
    r"a^2\cdot 10^3": "a**2*10**3",
    r"\frac{x}{2}\cdot 10^3": "x/2*10**3",
    r"{ab}c+{x}^2+{{x+1}}": "(a*b)*c + x**2 + (x + 1)",
    r"e^{(x)}": "exp(x)",
    r"x^{(n+1)}": "x**(n + 1)",
    r"\lvert x\rvert\lvert y\rvert": "abs(x)*abs(y)",
    r"\left\lvert x\right\rvert": "abs(x)",
    # odd roots are real for every real number
    r"\sqrt[3]{x^3}": "cbrt(x**3)",
    r"\sqrt[3]{x}^2": "cbrt(x)**2",
    r"\sqrt[5]{x}": "sign(x)*abs(x)**(1/5)",
    r"1/\sqrt[5]{x}": "1/(sign(x)*abs(x)**(1/5))",
    r"\sqrt[5]{32}": "32**(1/5)",
    r"\sqrt[4]{x}": "x**(1/4)",
    r"\sqrt[n]{x}": "x**(1/n)",
    r"\sqrt[3/2]{x}": "x**(1/(3/2))",
}

MIXED = r"2\frac12"
TWO_READINGS = {
    r"\sin x/2": ("sin(x/2)", "sin(x)/2"),
    r"\tan\theta/2": ("tan(theta/2)", "tan(theta)/2"),
    r"\sin\pi/6": ("sin(pi/6)", "sin(pi)/6"),
    r"\cos 2\theta/3": ("cos(2*theta/3)", "cos(2*theta)/3"),
    r"\arctan y/x": ("atan(y/x)", "atan(y)/x"),
    r"\ln x/x": ("log(x/x)", "log(x)/x"),
    r"\ln\left|x\right|/x": ("log(abs(x)/x)", "log(abs(x))/x"),
    r"\sin x\cdot y": ("sin(x*y)", "sin(x)*y"),
    r"\sin x * y": ("sin(x*y)", "sin(x)*y"),
    r"\cos 2\times 3": ("cos(2*3)", "cos(2)*3"),
    r"\ln x\,y": ("log(x*y)", "log(x)*y"),
    r"\ln 2\,x": ("log(2*x)", "log(2)*x"),
    r"\sin\omega~t": ("sin(omega*t)", "sin(omega)*t"),
    r"\sin x2": ("sin(x*2)", "sin(x)*2"),
    r"\sin\theta(1+\cos\theta)": ("sin(theta*(1 + cos(theta)))", "sin(theta)*(1 + cos(theta))"),
    r"\sin^2\theta(a+b)": ("sin(theta*(a + b))**2", "sin(theta)**2*(a + b)"),
    r"\sin k(x-ct)": ("sin(k*(x - c*t))", "sin(k)*(x - c*t)"),
    r"\cos\omega\left(t-t_0\right)": ("cos(omega*(t - t0))", "cos(omega)*(t - t0)"),
    r"\sin\frac{x}{2}\frac{y}{3}": ("sin(x/2*(y/3))", "sin(x/2)*(y/3)"),
    r"\cos\theta\frac{a}{b}": ("cos(theta*(a/b))", "cos(theta)*(a/b)"),
    r"\sin\theta\sqrt{1-k^2}": ("sin(theta*sqrt(1 - k**2))", "sin(theta)*sqrt(1 - k**2)"),
    r"\sin x e^{-x}": ("sin(x*exp(-x))", "sin(x)*exp(-x)"),
    r"\ln xe^x": ("log(x*exp(x))", "log(x)*exp(x)"),
    r"\sin(n+1)x": ("sin((n + 1)*x)", "sin(n + 1)*x"),
    r"\sin\left(n+\frac12\right)x": ("sin((n + 1/2)*x)", "sin(n + 1/2)*x"),
    r"\cos(\omega_1-\omega_2)t": ("cos((omega1 - omega2)*t)", "cos(omega1 - omega2)*t"),
    r"\sin(2n+1)\frac{\pi}{2}": ("sin((2*n + 1)*(pi/2))", "sin(2*n + 1)*(pi/2)"),
    r"\sin (x+1)(x-1)": ("sin((x + 1)*(x - 1))", "sin(x + 1)*(x - 1)"),
    r"\log(1+x)(1-x)": ("log((1 + x)*(1 - x))", "log(1 + x)*(1 - x)"),
    r"\sin^3(x+y)z": ("sin((x + y)*z)**3", "sin(x + y)**3*z"),
    r"\sin(x+1)^2": ("sin((x + 1)**2)", "sin(x + 1)**2"),
    r"\ln\left(1+x\right)^3": ("log((1 + x)**3)", "log(1 + x)**3"),
    r"\sin(2x)^2": ("sin((2*x)**2)", "sin(2*x)**2"),
    r"\sin^2(x)^3": ("sin(x**3)**2", "(sin(x)**2)**3"),
    r"\ln|x|^2": ("log(abs(x)**2)", "log(abs(x))**2"),
    r"\ln|x|y": ("log(abs(x)*y)", "log(abs(x))*y"),
    r"\sin{x}y": ("sin(x*y)", "sin(x)*y"),
    r"\sin{x}^2": ("sin(x**2)", "sin(x)**2"),
    r"\sin{x}/2": ("sin(x/2)", "sin(x)/2"),
    r"\ln\sin x\cos x": ("log(sin(x)*cos(x))", "log(sin(x))*cos(x)"),
    r"\tanh\frac{1}{2}\ln x": ("tanh(1/2*log(x))", "tanh(1/2)*log(x)"),
    r"\sin 2\arctan x": ("sin(2*atan(x))", "sin(2)*atan(x)"),
    r"\cos n\arccos x": ("cos(n*acos(x))", "cos(n)*acos(x)"),
    r"\ln 2\sin x": ("log(2*sin(x))", "log(2)*sin(x)"),
    r"\cos{n}\arccos{x}": ("cos(n*acos(x))", "cos(n)*acos(x)"),
    r"\sin{x+y}": ("sin(x + y)", "sin(x) + y"),
    r"\sin{x\cos y}": ("sin(x*cos(y))", "sin(x)*cos(y)"),
    r"\sin^2{x+y}": ("sin(x + y)**2", "sin(x)**2 + y"),
    r"\ln\sqrt{x}\sqrt{y}": ("log(sqrt(x)*sqrt(y))", "log(sqrt(x))*sqrt(y)"),
    r"\sin^{-1}x": ("asin(x)", "1/sin(x)"),
    r"\tanh^{-1}(x)": ("atanh(x)", "1/tanh(x)"),
    r"\tan^{-1}\frac{y}{x}": ("atan(y/x)", "1/tan(y/x)"),
    r"\log^{-1}x": ("exp(x)", "1/log(x)"),
    r"\frac{d}{dx}(x^2+1)(x-1)": (
        "diff((x**2 + 1)*(x - 1), x)",
        "diff((x**2 + 1), x)*(x - 1)",
    ),
    r"\frac{d}{dx}\left[x^2\right]\sin x": ("diff((x**2)*sin(x), x)", "diff((x**2), x)*sin(x)"),
    r"\frac{d}{dx}x^2\cdot x": ("diff(x**2*x, x)", "diff(x**2, x)*x"),
    r"\frac{d}{dx}x^2\cdot\sin x": ("diff(x**2*sin(x), x)", "diff(x**2, x)*sin(x)"),
    r"\frac{d}{dx}x^2/x": ("diff(x**2/x, x)", "diff(x**2, x)/x"),
    r"\frac{d}{dx}x\frac{d}{dx}x^3": ("diff(x*diff(x**3, x), x)", "diff(x, x)*diff(x**3, x)"),
    r"\frac{d^2}{dx^2}(x^2)(x+1)": (
        "diff((x**2)*(x + 1), x, 2)",
        "diff((x**2), x, 2)*(x + 1)",
    ),
    r"\frac{\partial}{\partial x}(x y)\cos x": ("diff((x*y)*cos(x), x)", "diff((x*y), x)*cos(x)"),
    MIXED: ("2 + 1/2", "2*(1/2)"),
    r"x(0)": ("x*0", "x_1 for the value of a function x"),
    r"x(t)": ("x*t", "x_1 for the value of a function x"),
    r"x\left(y\right)": ("x*y", "x_1 for the value of a function x"),
    r"x{\left(0 \right)}": ("x*0", "x_1 for the value of a function x"),
    r"f{\left(x \right)}": ("f*x", "f_1 for the value of a function f"),
    r"{x}(0)": ("x*0", "x_1 for the value of a function x"),
    r"2x(0)": ("x*0", "x_1 for the value of a function x"),
    r"y(-1)": ("y*(-1)", "y_1 for the value of a function y"),
    r"y(\frac{\pi}{2})": ("y*(pi/2)", "y_1 for the value of a function y"),
    r"y(2x)": ("y*(2*x)", "y_1 for the value of a function y"),
    r"y(\sin t)": ("y*sin(t)", "y_1 for the value of a function y"),
    r"\psi_0(t)": ("psi0*t", "psi0_1 for the value of a function psi0"),
    r"x^2(y)": ("x**2*y", "x_1 for the value of a function x"),
    r"f(x+1)": ("f*(x + 1)", "f_1 for the value of a function f"),
}

NO_VARIABLES = {
    r"f(x,y)": "a function that is not known",
    r"\frac{dy}{dx}": r"write \frac{d}{dx}",
    r"\frac{d y}{d x}": r"write \frac{d}{dx}",
    r"\frac{\mathrm{d}y}{\mathrm{d}x}": r"write \frac{d}{dx}",
    r"\frac{\partial y}{\partial x}": r"write \frac{d}{dx}",
    r"\frac{\partial^2 f}{\partial x\partial y}": "a derivative of higher order is written",
    r"\frac{d^2x}{dt^2}": "a derivative of a symbol is not known",
    r"dy/dx": r"write \frac{d}{dx}",
    r"d/dx x^2": r"write \frac{d}{dx}",
    r"\mathrm{d}z": "a differential",
    r"x\,dx": "a differential",
    r"\sin\theta\,d\theta": "a differential",
    r"\frac{dx}{2}": "a differential",
    r"\dot x": r"write \frac{d}{dt}",
    r"\ddot{x}+x": r"write \frac{d}{dt}",
    r"\sin\theta\dot\theta": r"write \frac{d}{dt}",
    r"x'": r"write \frac{d}{dt}",
    r"f'(x)": r"write \frac{d}{dt}",
    r"y^{\prime\prime}": r"write \frac{d}{dt}",
    r"e^{i\pi}": "variables are real",
    r"e^{ix}": "variables are real",
    r"\cos x+i\sin x": "variables are real",
    r"\mathrm{i}": "variables are real",
    r"2j": "variables are real",
    r"\imath": "variables are real",
    r"\int_0^1 f": "differential",
    r"\max x": r"write \max(x, y)",
    r"\max(x)": r"write \max(x, y)",
    r"\lim x": "is expected",
    r"\lim_{x=0} x": r"a limit is written",
    r"\frac{d^{11}}{dx^{11}} x": "goes from 1 to 10",
    r"[xy]_0^1": "needs its variable",
    r"\sqrt[-3]{x}": "negative index",
    r"x^{(2)}": "counts derivatives",
    r"\sin^{(n)}x": "counts derivatives",
    r"x_12": "several digits",
    r"x^a^b": "one exponent",
    r"e^x^2": "one exponent",
    r"\sqrt12": "TeX takes one",
    r"\frac123": "TeX takes one",
    r"\sqrt\sin x": "TeX takes the name",
    r"x^\sin y": "TeX takes the name",
    r"2{x+1}": "braces do not print",
    r"{x+1}y": "braces do not print",
    r"-{a+b}": "braces do not print",
    r"x{-y}": "braces do not print",
    r"x{+y}": "braces do not print",
    r"{\sin x}y": "braces do not print",
    r"{\sin x}^2": "braces do not print",
    r"{x\cos y}/2": "braces do not print",
    r"{\frac{d}{dx}x^2}\,x": "braces do not print",
    r"{d}x": "a differential",
    r"d{x}": "a differential",
    r"\frac{d}{dx}y": r"write \frac{d}{dx} (…) with what it stands for",
    r"\frac{d}{dx}\sin y": r"write \frac{d}{dx} (…) with what it stands for",
    r"\frac{dy^2}{dx}": r"write \frac{d}{dx} (…) with what it stands for",
    r"\frac{d^2}{dx^2}y": r"write \frac{d}{dx} (…) with what it stands for",
    r"{xy}^2": "braces do not print",
    r"a/{bc}": "braces do not print",
    r"{a/b}c": "braces do not print",
    r"\exp{-x+y}": "braces do not print",
    r"\frac{d}{dx}{x^2+1}": "braces do not print",
    r"sin(x)": r"write \sin",
    r"2theta": r"write \theta",
}

DISPLAYS = {
    r"M_1=I_1\Omega_1,\quad M_2=I_2\Omega_2. \label{eq}": [
        "M1 == I1*Omega1",
        "M2 == I2*Omega2",
    ],
    r"a:=b\equiv c": ["a == b == c"],
    r"0\leq b\leq 1,\; -b\le\gamma<a": ["0 <= b <= 1", "-b <= gamma < a"],
    r"x\in[\pi-1,\pi+1)": ["pi - 1 <= x < pi + 1"],
    r"a=b\Rightarrow c=-d": ["a == b", "c == -d"],
    r"x\to+\infty": ["x -> oo"],
    r"\theta_0\simeq\frac{\pi}{2}, a\gg 1": ["theta0 ~ pi/2", "a >> 1"],
    r"\begin{array}{ll} & \dot{q}=p, \\[2pt] & \dot{p}=-q. \end{array}": [
        "dq_dt == p",
        "dp_dt == -q",
    ],
    r"\begin{aligned} x &= y \\ &= z \end{aligned}": ["x == y == z"],
    r"\epsilon_0^2+hot=1": ["epsilon0**2 + hot == 1"],
}


@pytest.mark.parametrize("source", EXPRESSIONS)
def test_expressions(source: str) -> None:
    assert read_expression(source, Author()) == as_written(EXPRESSIONS[source])


@pytest.mark.parametrize("source", REFUSED)
def test_what_is_not_read_is_refused_in_one_line(source: str) -> None:
    with pytest.raises(InputError) as caught:
        read_expression(source)
    assert REFUSED[source] in str(caught.value)
    assert str(caught.value).startswith("LaTeX: ")
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize("source", AUTHORS_REFUSED)
def test_what_an_author_must_complete(source: str) -> None:
    with pytest.raises(InputError, match=AUTHORS_REFUSED[source]):
        read_expression(source, Author())


@pytest.mark.parametrize("source", ARGUMENTS)
def test_what_print_means(source: str) -> None:
    assert read_expression(source) == as_written(ARGUMENTS[source])


@pytest.mark.parametrize("source", TWO_READINGS)
def test_where_two_readings_remain_both_are_written_out(source: str) -> None:
    first, second = TWO_READINGS[source]
    with pytest.raises(InputError) as caught:
        read_expression(source)
    one = as_written(first)
    other = second if " for the value " in second else as_written(second)
    assert one != other
    if source != MIXED:
        first, second = str(one), str(other)
    assert f"two readings remain: write {first} or {second}, near " in str(caught.value)


@pytest.mark.parametrize("source", NO_VARIABLES)
def test_what_is_no_real_variable_is_refused_with_what_to_write(source: str) -> None:
    with pytest.raises(InputError) as caught:
        read_expression(source)
    assert NO_VARIABLES[source] in str(caught.value)


@pytest.mark.parametrize("source", DISPLAYS)
def test_displays(source: str) -> None:
    assert [str(chain) for chain in read_latex(source, Author())] == DISPLAYS[source]


def test_an_author_whose_claims_are_compared_is_read_the_shorter_way() -> None:
    assert str(read_expression(r"\sin\theta(a+b)", Author())) == "sin(theta)*(a + b)"
    assert str(read_expression(r"\sin\theta\dot\phi", Author())) == "sin(theta)*dphi_dt"
    with pytest.raises(InputError, match="two readings remain"):
        read_expression(r"\sin x/2", Author())


def test_a_line_may_end_in_a_line_break() -> None:
    assert [str(chain) for chain in read_latex(r"\sin x = y \\ ")] == ["sin(x) == y"]


def test_headings_of_columns_become_conditions() -> None:
    source = r"""\begin{array}{ll}
        \textrm{For }c>0: & \quad \textrm{For }c<0: \\
        x=\sqrt{c} & y=\sqrt{-c} \\ z=c & z=-c \end{array}"""
    chains = read_latex(source)
    assert [(str(c), str(c.condition)) for c in chains] == [
        ("x == sqrt(c)", "c > 0"),
        ("y == sqrt(-c)", "c < 0"),
        ("z == c", "c > 0"),
        ("z == -c", "c < 0"),
    ]


@pytest.mark.parametrize(
    "source",
    [r"a+b", r"\begin{matrix} a \end{matrix}", r"a=b \begin{array} c \end{array}", r"a=", r"=b"],
)
def test_displays_that_are_no_statement(source: str) -> None:
    with pytest.raises(InputError, match="LaTeX: "):
        read_latex(source)


PLAIN_NAMES = {"a": "a", "x": "x", "psi": r"\psi", "x0": "x_0", "M12": "M_{12}"}
WRITTEN_NAMES = {**PLAIN_NAMES, "lambda_": r"\lambda"}
WRITTEN = {"log": r"\ln", "asin": r"\arcsin", "acos": r"\arccos", "atan": r"\arctan"} | {
    name: rf"\operatorname{{{name}}}"
    for name in ("asinh", "acosh", "atanh", "sech", "csch", "sign")
}


def written(e: Expr) -> str:
    """A tree in LaTeX, with all the brackets and signs that there can be."""
    parts = (
        [] if e.op in ("number", "symbol") else [written(arg) for arg in e.args if not arg.loose]
    )
    within = [rf"\left({part}\right)" for part in parts]
    match e.op:
        case "number":
            return rf"\frac{{{e.args[0].p}}}{{{e.args[0].q}}}" if e.args[0].q != 1 else str(e)
        case "symbol":
            return WRITTEN_NAMES.get(e.args[0]) or "{}_{{{}}}".format(*e.args[0].split("_"))
        case "pi":
            return r"\pi"
        case "+":
            return "+".join(within)
        case "*":
            return r"\cdot ".join(within)
        case "^":
            return f"{within[0]}^{{{parts[1]}}}"
        case "exp":
            return f"e^{{{parts[0]}}}"
        case "abs":
            return rf"\left|{parts[0]}\right|"
        case "cbrt":
            return rf"\sqrt[3]{{{parts[0]}}}"
        case "O" | "o":
            return e.op + within[0]
    if not e.names:
        return WRITTEN.get(e.op, "\\" + e.op) + within[0]
    (name,), inside = opened(e)
    if name not in WRITTEN_NAMES:
        inside = substitute(inside, {name: symbol(f"u_b{e.size}")})
    x, body, points = WRITTEN_NAMES.get(name, f"u_{{b{e.size}}}"), written(inside), parts[-2:]
    match e.op:
        case "integral":
            return rf"\int_{{{points[0]}}}^{{{points[1]}}}\left({body}\right)\,d{x}"
        case "limit":
            side = {1: "^+", -1: "^{-}", 0: ""}[int(e.args[2].args[0].p)]
            return rf"\lim_{{{x}\to {within[-2]}{side}}}\left({body}\right)"
        case "derivative":
            body = rf"\frac{{\partial}}{{\partial {x}}}\left({body}\right)"
    return rf"\left.{body}\right|_{{{x}={parts[-1]}}}"


@pytest.mark.parametrize(
    "source",
    [
        r"\sqrt" * 1600 + "x",
        r"\sin" * 2000 + "x",
        "|" * 5000,
        r"\left|" * 1500,
        r"\left." * 1500,
        r"\frac" * 1900,
        r"\frac{d}{dx}" * 800 + "x",
        r"\lim_{x\to0}" * 700 + "x",
        r"\int_0^1" * 1000 + "x",
        r"\pm" * 3000 + "x",
        "{" * 10**5,
        "}" * 10**4,
        "\\",
        "\\" * 4999,
        r"\begin{array}" + "&" * 9000 + r"\end{array}",
        r"\text{" * 900,
        r"\text{for}" * 900,
        r"\forall" * 900,
        r"\sqrt[" + "9" * 5000 + "]{x}",
        "9" * 9000 + "^{" + "9" * 900 + "}",
        "10^{" + "9" * 5000 + "}",
        r"\left",
        r"\frac{a}",
        r"\lim_{x",
    ],
    ids=range(24),
)
def test_hostile_latex_is_one_line(source: str) -> None:
    for read in (read_expression, read_latex):
        with pytest.raises(InputError) as caught:
            read(source)
        assert "\n" not in str(caught.value)
        assert len(str(caught.value)) < 400


SYMBOLS = st.sampled_from(sorted(WRITTEN_NAMES)).map(symbol)
NUMBERS = st.fractions(min_value=-9, max_value=9, max_denominator=7).map(number)


NAMES = ["sin", "cos", "tan", "exp", "log", "asin", "atan", "sinh", "cosh", "tanh", "abs", "asinh"]


def _larger(inner: st.SearchStrategy[Expr]) -> st.SearchStrategy[Expr]:
    pairs = st.tuples(inner, inner)
    return st.one_of(
        pairs.map(lambda p: p[0] + p[1]),
        pairs.map(lambda p: p[0] - p[1]),
        pairs.map(lambda p: p[0] * p[1]),
        st.tuples(inner, SYMBOLS).map(lambda p: p[0] / p[1]),
        st.tuples(inner, st.integers(2, 5)).map(lambda p: power(p[0], number(p[1]))),
        inner.map(sqrt),
        st.tuples(st.sampled_from(NAMES), SYMBOLS | inner).map(lambda p: _apply(*p)),
    )


def _larger_with_binders(inner: st.SearchStrategy[Expr]) -> st.SearchStrategy[Expr]:
    names = st.sampled_from(sorted(WRITTEN_NAMES))
    ends = st.tuples(inner, names, inner)
    return st.one_of(
        _larger(inner),
        st.tuples(st.sampled_from(sorted(FUNCTIONS - {"cbrt"})), inner).map(lambda p: apply(*p)),
        SYMBOLS.map(lambda x: apply("cbrt", x)),
        st.tuples(inner, SYMBOLS | NUMBERS).map(lambda p: p[0] ** p[1]),
        ends.map(lambda p: derivative(*p)),
        ends.map(lambda p: at(p[0], {p[1]: p[2]}) if p[1] in symbols(p[0]) else p[0]),
        st.tuples(ends, st.sampled_from([-1, 0, 1])).map(lambda p: limit(*p[0], p[1])),
        st.tuples(ends, inner).map(lambda p: integral(*p[0], p[1])),
        st.tuples(st.sampled_from("Oo"), inner).map(lambda p: order(*p)),
    )


@given(st.recursive(SYMBOLS | NUMBERS | st.just(PI), _larger_with_binders, max_leaves=8))
def test_a_tree_written_in_latex_is_read_back(tree: Expr) -> None:
    assert read_expression(written(tree)) == tree


def _apply(name: str, argument: Expr) -> Expr:
    return argument if argument.op == "number" else apply(name, argument)


PLAIN = st.sampled_from(sorted(PLAIN_NAMES)).map(symbol)
EXPRESSION_TREES = st.recursive(PLAIN | NUMBERS, _larger, max_leaves=12)


@given(EXPRESSION_TREES)
def test_what_is_typeset_is_read_back(tree: Expr) -> None:
    ((_, _, read),) = read_latex(to_latex([(PI, "==", tree)]))[0].links
    _same_values(tree, read)


@given(EXPRESSION_TREES)
def test_what_sympy_writes_is_read_back(tree: Expr) -> None:
    written = to_sympy(tree)
    if written.is_real is False or written.has(zoo, nan, I):
        return
    read = read_expression(latex(written, ln_notation=True))
    _same_values(tree, read)


def _same_values(tree: Expr, read: Expr) -> None:
    for point in Given().points(symbols(tree) | symbols(read), 6):
        with ball_precision(256):
            at = {name: arb(value) for name, value in point.items()}
            first, second = evaluate(tree, at), evaluate(read, at)
        if first.is_finite() and second.is_finite():
            assert (first - second).contains(0)


@pytest.mark.parametrize(
    ("source", "ends"),
    [("x(1+", ")"), (r"\sin{", "}"), (r"\frac{d}{dx}(x+", ")"), ("{", "}"), (r"\ln(x+", ")")],
)
def test_nesting_does_not_multiply_the_reading(source: str, ends: str) -> None:
    assert read_expression(55 * source + "x" + 55 * ends)


@pytest.mark.parametrize("source", [r"\sin " + 9_900 * "x", r"\ln " + 3_000 * "(2)", 3_000 * "(2)"])
def test_a_long_product_is_read(source: str) -> None:
    assert read_expression(source)


TOKENS = (
    r"a b x 2 + - = / ^ _ ( ) [ ] { } | , . & \\ d e : f O \frac \sqrt \int \sin \psi \dot \in "
    r"\left( \right) \left. \right| \begin{array} \end{array} \partial \Delta \text{for}"
)
PIECES = st.sampled_from(TOKENS.split())


@given(st.lists(PIECES, max_size=20).map(" ".join))
def test_any_tokens_are_read_or_refused(source: str) -> None:
    for read in (read_expression, read_latex):
        try:
            read(source)
        except InputError:
            continue


@given(st.text(max_size=60))
def test_any_text_is_read_or_refused(source: str) -> None:
    for read in (read_expression, read_latex):
        try:
            read(source)
        except InputError:
            continue
