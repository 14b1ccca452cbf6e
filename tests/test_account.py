"""The account of methods: each that it names is there, and can be switched off and observed."""

import subprocess
import sys
from pathlib import Path

import account
from methods import METHODS, REASONS

from tresym.reals.verdict import Verdict

SWITCHED_OFF = """
import account
from tresym.reals.decisions.dispatch import decide_claim

account.replaced("reals.decisions.integral_rules.decide_by_leibniz", account.off)
account.replaced("reals.signs.concavity.sign_by_concavity", account.off)
used = set()
for name in ("reals.signs.taylor.sign_by_taylor", "reals.decisions.identity._prove"):
    account.replaced(name, account.observed(name, used))
print(decide_claim("diff(integral(exp(a*x), x, 0, 1), a) == integral(x*exp(a*x), x, 0, 1)").verdict)
print(decide_claim("sin(x)**2 + cos(x)**2 == 1").verdict, *used)
"""


def test_each_method_is_there_and_has_a_way_to_find_nothing() -> None:
    for name in METHODS:
        function = account._function(name)
        assert function.__closure__ is None, name
        assert getattr(account.nothing(function), "verdict", None) in (None, Verdict.UNDECIDED)


def test_no_method_is_named_twice_and_reasons_are_of_methods() -> None:
    assert len(METHODS) == len({*METHODS})
    assert all(any(name.startswith(start) for name in METHODS) for start in REASONS)


def test_what_is_switched_off_finds_nothing_and_what_finds_something_is_noted() -> None:
    done = subprocess.run(
        [sys.executable, "-c", SWITCHED_OFF],
        cwd=Path(account.__file__).parent,
        capture_output=True,
        text=True,
        check=True,
    )
    assert done.stdout.splitlines() == [
        "Verdict.UNDECIDED",
        "Verdict.PROVED reals.decisions.identity._prove",
    ]
