"""A limit on processor time: it is kept, lifted after the block, and the outer one holds."""

import gc
import signal
import threading
import time
import weakref
from contextlib import suppress

import mpmath
import pytest
from flint import ctx
from hangs import HANGS

from tresym.reals.numbers.arithmetic import ball_precision, decided, mp_precision
from tresym.reals.resource_limits import TimeUp, collecting_seldom, stage, stages, time_limit


def test_the_limit_is_lifted_after_the_block() -> None:
    def forever() -> None:
        with time_limit(0.02):
            while True:
                pass

    with pytest.raises(TimeUp):
        forever()
    with time_limit(30):
        sum(range(1000))


def test_within_a_limit_the_outer_one_holds() -> None:
    def forever() -> None:
        with time_limit(0.02), time_limit(0.001, KeyError):
            while True:
                pass

    with pytest.raises(TimeUp):
        forever()


@pytest.mark.slow
def test_the_limit_leaves_no_precision_behind() -> None:
    """The exception never comes while a precision is set or restored.

    Without that it leaves a precision, or the lock of precision, behind in a third of the rounds.
    """

    def forever() -> None:
        with time_limit(0.0005):
            while True:
                with ball_precision(301), mp_precision(77):
                    pass

    before = ctx.prec, mpmath.mp.prec
    for _ in range(25):
        with pytest.raises(TimeUp):
            forever()
        assert (ctx.prec, mpmath.mp.prec) == before
    free = threading.Thread(target=decided, args=(lambda: 1,))  # another thread gets the lock
    free.start()
    free.join(HANGS)
    assert not free.is_alive()


def test_a_limit_that_ends_with_the_block_is_not_raised_behind_it() -> None:
    for _ in range(300):
        with suppress(TimeUp), time_limit(0.0002):
            sum(range(3000))
    assert signal.getsignal(signal.SIGPROF) == signal.SIG_DFL
    assert signal.getitimer(signal.ITIMER_PROF)[0] == 0


def test_of_many_stages_the_first_and_the_last_are_shown() -> None:
    with stage("sums"), stage("integrals"), stage("equality"), stage("closed form"):
        assert stages() == "sums: equality: closed form"
    assert stages() == ""


def test_memory_is_searched_as_before_behind_it() -> None:
    before = gc.get_threshold()
    with collecting_seldom(20_000):
        assert gc.get_threshold()[0] == max(20_000, before[0])
        with collecting_seldom(1_000):
            assert gc.get_threshold()[0] == max(20_000, before[0])
    assert gc.get_threshold() == before


def test_what_is_never_searched_stays_so() -> None:
    before = gc.get_threshold()
    try:
        gc.set_threshold(0)
        with collecting_seldom(20_000):
            assert gc.get_threshold()[0] == 0
    finally:
        gc.set_threshold(*before)


def _busy(seconds: float) -> None:
    end = time.process_time() + seconds
    while time.process_time() < end:
        pass


def test_a_limit_waits_for_a_callback_in_which_it_would_be_lost() -> None:
    class Thing:
        pass

    def work() -> None:
        thing = Thing()
        weakref.finalize(thing, _busy, 0.1)
        del thing
        _busy(60)

    with pytest.raises(TimeUp), time_limit(0.02):
        work()
