"""The explorer in a real browser: its numbers are the certified ones, and anyone can work it."""

import json
import math
import random
import re
import shutil
from collections.abc import Callable, Iterator
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest
from flint import fmpq
from hangs import HANGS

from tresym.racket.body import NAMED_BODIES, shape
from tresym.racket.flip import defect
from tresym.racket.flip.levels import turning_level
from tresym.racket.formulas import printed
from tresym.racket.motion.attitude import attitude
from tresym.reals.numbers.exact import fraction_text

playwright = pytest.importorskip("playwright.sync_api", reason="Playwright is not installed")

PAGE = Path(__file__).resolve().parents[2] / "docs" / "explorer" / "index.html"
CHROMIUM = shutil.which("chromium") or shutil.which("chromium-browser")

HARD = (
    ("12.5372", "0.0629", "0"),
    ("1e4", "1", "0"),
    ("1e-6", "1e-6", "0"),
    ("1", "1", "-0.999999"),
    ("2.29201", "0.99999", "-0.988653046503"),
    ("12", "0.05", "1e-140"),
    ("0.5", "0.1", "0.49999999999999999999"),
    ("0.5", "0.1", "-0.09999999999999999999"),
    ("82.9327", "0.986241", "1.47940090762e-24"),
    ("1517/121", "55/874", "-7/2013"),
)
"""Levels near the separatrix, γ*, −b and a, and shapes at the ends of their range."""

BAD = (
    ("a", "", "not a number"),
    ("a", "twelve", "not a number"),
    ("a", "1" * 61, "not a number"),
    ("a", "1e999", "not a number"),
    ("a", "1/0", "not a number"),
    ("a", "<b>1</b>", "not a number"),
    ("a", "0", "a = I₂/I₁ − 1 must be"),
    ("a", "-3", "a = I₂/I₁ − 1 must be"),
    ("a", "10001", "a = I₂/I₁ − 1 must be"),
    ("b", "0", "b = 1 − I₂/I₃ must be"),
    ("b", "1.00000000000000000000000001", "b = 1 − I₂/I₃ must be"),
    ("gamma", "NaN", "not a number"),
    ("gamma", "-0.31", "between −b = −0.31 and a = 1.11"),
    ("gamma", "1.11", "between −b = −0.31 and a = 1.11"),
)
"""An input, what is typed there, and what the message says."""

needs_browser = pytest.mark.skipif(
    CHROMIUM is None, reason="no chromium on this machine (apt-get install chromium)"
)

Open = Callable[..., "playwright.Page"]


@pytest.fixture(scope="module")
def browser() -> Iterator["playwright.Browser"]:
    with playwright.sync_playwright() as driver:
        found = driver.chromium.launch(
            executable_path=CHROMIUM, args=["--no-sandbox"], timeout=1000 * HANGS
        )
        yield found
        found.close()


@pytest.fixture
def open_page(browser: "playwright.Browser") -> Iterator[Open]:
    """Opens the explorer; afterwards nothing was said on the console and no network was asked."""
    contexts, heard = [], []

    def opened(fragment: str = "", **look: object) -> "playwright.Page":
        context = browser.new_context(**{"reduced_motion": "reduce", **look})
        context.set_default_timeout(1000 * HANGS)
        context.set_offline(True)
        page = context.new_page()
        page.on("console", lambda message: heard.append(message.text))
        page.on("pageerror", lambda error: heard.append(str(error)))
        page.on("request", lambda request: heard.append(request.url) if outside(request) else None)
        page.goto(PAGE.as_uri() + fragment)
        contexts.append(context)
        return page

    yield opened
    for context in contexts:
        context.close()
    assert heard == []


def outside(request: "playwright.Request") -> bool:
    return not request.url.startswith(("data:", PAGE.parent.as_uri() + "/"))


def type_in(page: "playwright.Page", a: str, b: str, gamma: str) -> None:
    for name, text in (("a", a), ("b", b), ("gamma", gamma)):
        page.fill(f"#{name}", text)


def number(page: "playwright.Page", name: str) -> float:
    return float(page.inner_text(f"#{name}").replace("−", "-"))


def certified(a: str, b: str, gamma: str) -> float:
    exact = Fraction(gamma)
    level = fmpq(exact.numerator, exact.denominator)
    return float(defect.solve(*shape(a, b), level, 25).defect)


def assert_close(found: float, a: str, b: str, gamma: str) -> None:
    """1e-12 of ε where it is large, and where it is small as far as γ determines it."""
    true, level = certified(a, b, gamma), float(Fraction(gamma))
    natural = math.hypot(true, math.sqrt(max(level, 0) / float(Fraction(b))))
    scale = abs(true) if abs(true) > 1 else min(1.0, natural)
    assert abs(found - true) <= 1e-12 * scale, (a, b, gamma, found, true)


def decimals(source: random.Random, low: float, high: float, digits: int) -> str:
    return f"{10 ** source.uniform(math.log10(low), math.log10(high)):.{digits}g}"


def starts(count: int) -> list[tuple[str, str, str]]:
    """Seeded shapes and levels: a third below γ*, a third near the separatrix, a third anywhere."""
    source, found = random.Random(1606), []
    while len(found) < count:
        a, b = decimals(source, 1e-3, 1e3, 6), decimals(source, 1e-3, 1, 6)
        p, q = float(a), float(b)
        if len(found) % 3 == 0:
            star = turning_level(*shape(a, b), 10)
            if star is None or star > -1e-100:
                continue
            lowest = float(star)
            gamma = lowest - (q + lowest) * source.uniform(0.001, 0.999)
        elif len(found) % 3 == 1:
            gamma = source.choice((-1, 1)) * min(p, q) * 10 ** source.uniform(-30, -1)
        else:
            gamma = source.uniform(-q, p)
        text = f"{gamma:.12g}"
        if -Fraction(b) < Fraction(text) < Fraction(a):
            found.append((a, b, text))
    return found


def test_the_bodies_are_those_of_the_package() -> None:
    pattern = r'<script type="application/json" id="bodies">(.*?)</script>'
    block = re.search(pattern, PAGE.read_text(encoding="utf-8"), re.DOTALL)
    assert block is not None
    rows = json.loads(block[1])
    assert [row["name"] for row in rows] == list(NAMED_BODIES)
    for row in rows:
        body = NAMED_BODIES[row["name"]]
        assert (row["title"].replace("’", "'"), row["source"]) == (body.title, body.source)
        assert shape(row["a"], row["b"]) == body.shape


def test_the_page_asks_for_nothing_that_is_not_beside_it() -> None:
    for file in PAGE.parent.iterdir():
        text = file.read_text(encoding="utf-8").replace("http://www.w3.org/2000/svg", "")
        assert "://" not in text
        assert "import(" not in text


@needs_browser
@pytest.mark.slow
def test_two_hundred_typed_levels_agree_with_the_certified_defect(open_page: Open) -> None:
    page = open_page()
    for start in starts(200):
        type_in(page, *start)
        assert_close(number(page, "defect"), *start)
    assert page.inner_text("#message") == ""


@needs_browser
def test_hard_levels_agree_too(open_page: Open) -> None:
    page = open_page()
    for start in HARD:
        type_in(page, *start)
        assert_close(number(page, "defect"), *start)
        flip = math.pi - 2 * certified(*start)
        assert abs(number(page, "flip") - flip) <= 1e-12 * max(1, abs(flip))


@needs_browser
def test_every_body_shows_its_numbers(open_page: Open) -> None:
    page = open_page()
    for name, body in NAMED_BODIES.items():
        page.select_option("#body", name)
        page.fill("#gamma", "0")
        a, b = (float(x.p) / float(x.q) for x in body.shape)
        texts = tuple(fraction_text(x) for x in body.shape)
        assert_close(number(page, "defect0"), *texts, "0")
        formula = printed.asymptotic_defect(a, b, np)
        assert number(page, "printed") == pytest.approx(formula, rel=1e-5)
        off = 100 * (formula / certified(*texts, "0") - 1)
        shown = page.inner_text("#printed-error").replace("−", "-").removesuffix(" %")
        assert float(shown) == pytest.approx(off, rel=0.06)
        assert page.inner_text("#realizable").startswith("✓" if body.shape.realizable else "✗")
        star = turning_level(*body.shape, 20)
        assert page.evaluate("shown.turning") == pytest.approx(float(star), rel=1e-12)
        page.click("#to-perfect")
        assert abs(certified(*texts, page.input_value("#gamma"))) < 1e-5
        page.click("#to-separatrix")
        assert page.inner_text("#command") == f"tresym flip --body {name} --gamma=0"
        page.fill("#gamma", "-0.001")
        line = printed.linear_defect(formula, b, -0.001)
        assert number(page, "line") == pytest.approx(line, rel=1e-5)


@needs_browser
def test_realizable_is_decided_exactly(open_page: Open) -> None:
    page = open_page()
    type_in(page, "1", "1/3", "0")
    assert page.inner_text("#realizable").startswith("✓ yes")
    page.fill("#b", "0.33333333333333333333333333333333334")
    assert page.inner_text("#realizable").startswith("✗ no")


@needs_browser
def test_the_attitude_is_that_of_the_package(open_page: Open) -> None:
    page = open_page("#a=1.11&b=0.31&gamma=0.02")
    a, b, gamma = 1.11, 0.31, 0.02
    rate = math.sqrt((a + b) * (gamma + b)) / (1 - b)
    for share in (-1, -0.37, 0.2, 0.9):
        there, axes = page.evaluate(
            "share => { const at = attitudeAt(shown.orbit, share * shown.end);"
            " const { first, second, third } = axesOf(at); return [at, [second, third, first]]; }",
            share,
        )
        last = attitude(a, b, math.pi / 2, rate, there["phi"], 2)
        assert there["psi"] == pytest.approx(last.psi[-1], abs=1e-11)
        assert there["theta"] == pytest.approx(last.theta[-1], abs=1e-11)
        assert there["time"] == pytest.approx(last.time[-1], abs=1e-11)
        assert np.abs(np.array(axes).T - last.rotations()[-1]).max() < 1e-11


@needs_browser
def test_bad_input_gets_one_clear_line(open_page: Open) -> None:
    page = open_page("#body=book&gamma=0.05")
    before = page.inner_text("#defect")
    for name, text, says in BAD:
        good = page.input_value(f"#{name}")
        page.fill(f"#{name}", text)
        message = page.inner_text("#message")
        assert says in message
        assert "\n" not in message
        assert page.get_attribute(f"#{name}", "aria-invalid") == "true"
        assert page.locator("[aria-invalid]").count() == 1
        assert page.inner_text("#defect") == before
        page.fill(f"#{name}", good)
        assert page.inner_text("#message") == ""
        assert page.locator("[aria-invalid]").count() == 0


@needs_browser
def test_the_keyboard_is_enough(open_page: Open) -> None:
    page = open_page()
    reached = []
    for _ in range(12):
        page.keyboard.press("Tab")
        reached.append(page.evaluate("document.activeElement.id"))
    order = ["body", "a", "a-slider", "b", "b-slider", "gamma", "gamma-slider"]
    assert reached[:11] == [*order, "to-separatrix", "to-perfect", "to-turning", "play"]
    for slider in ("a-slider", "b-slider", "gamma-slider"):
        page.focus(f"#{slider}")
        before = page.inner_text("#defect")
        page.keyboard.press("ArrowRight")
        page.keyboard.press("PageUp")
        assert page.inner_text("#defect") != before
        assert page.inner_text("#message") == ""
    page.focus("#to-turning")
    page.keyboard.press("Enter")
    assert float(page.input_value("#gamma")) == pytest.approx(page.evaluate("shown.turning"))
    page.focus("#to-separatrix")
    page.keyboard.press("Space")
    assert page.input_value("#gamma") == "0"
    page.focus("#moment")
    page.keyboard.press("End")
    assert page.inner_text("#turned") == "360°"
    page.keyboard.press("Home")
    assert page.inner_text("#turned") == "0°"
    page.focus("#body")
    page.keyboard.press("Home")
    page.keyboard.press("ArrowDown")
    assert page.input_value("#a") == "12.5372"


@needs_browser
def test_sliders_stay_within_what_is_possible(open_page: Open) -> None:
    page = open_page()
    for gamma_end, a_end in (("Home", "Home"), ("End", "Home"), ("Home", "End"), ("End", "End")):
        for slider, key in (("gamma", gamma_end), ("a", a_end), ("b", "Home"), ("b", "End")):
            page.focus(f"#{slider}-slider")
            page.keyboard.press(key)
            assert page.inner_text("#message") == ""
            start = tuple(page.input_value(f"#{name}") for name in ("a", "b", "gamma"))
            assert_close(number(page, "defect"), *start)


@needs_browser
@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_nothing_is_wider_than_a_telephone(open_page: Open, scheme: str) -> None:
    page = open_page(viewport={"width": 390, "height": 844}, color_scheme=scheme)
    for start in (("1517/121", "55/874", "0"), ("1e3", "0.9", "-0.3"), ("1e-6", "1e-6", "9e-7")):
        type_in(page, *start)
        assert page.evaluate("document.documentElement.scrollWidth") <= 390
    sizes = "[...document.querySelectorAll('button, input, select')].map((x) => x.offsetHeight)"
    assert min(page.evaluate(sizes)) >= 24


@needs_browser
def test_the_animation_advances_and_can_be_held(open_page: Open) -> None:
    page = open_page("#body=str&gamma=0.001", reduced_motion="no-preference")
    assert page.inner_text("#play") == "Pause"
    drawn = page.get_attribute("#scene .outlines", "d")
    page.wait_for_function("parseInt(document.getElementById('turned').textContent) > 20")
    assert page.get_attribute("#scene .outlines", "d") != drawn
    page.click("#play")
    assert page.inner_text("#play") == "Play"
    held = page.get_attribute("#scene .outlines", "d")
    page.evaluate("new Promise((next) => setTimeout(next, 150))")
    assert page.get_attribute("#scene .outlines", "d") == held


@needs_browser
def test_who_wants_less_motion_gets_none_unasked(open_page: Open) -> None:
    page = open_page()
    page.evaluate("new Promise((next) => setTimeout(next, 150))")
    assert page.inner_text("#play") == "Play"
    assert page.inner_text("#turned") == "0°"
    page.click("#play")
    page.wait_for_function("parseInt(document.getElementById('turned').textContent) > 5")


@needs_browser
def test_a_choice_can_be_sent_as_an_address(open_page: Open) -> None:
    page = open_page()
    page.select_option("#body", "racket-3")
    page.fill("#gamma", "-0.002")
    page.wait_for_function("location.hash.includes('gamma=-0.002')")
    again = open_page("#" + page.evaluate("location.hash").removeprefix("#"))
    assert again.input_value("#body") == "racket-3"
    assert again.inner_text("#defect") == page.inner_text("#defect")
    page.fill("#a", "14.9")
    assert page.input_value("#body") == ""
    assert "--shape 14.9 0.12" in page.inner_text("#command")


@needs_browser
def test_every_control_has_a_name_and_every_picture_words(open_page: Open) -> None:
    page = open_page("#body=book&gamma=-0.1")
    unnamed = page.evaluate(
        "[...document.querySelectorAll('button, input, select')].filter((x) => "
        "!(x.labels?.length || x.ariaLabel || x.textContent.trim())).map((x) => x.id)"
    )
    assert unnamed == []
    page.wait_for_function("document.getElementById('chart-text').textContent !== ''")
    for picture in ("scene", "portrait", "chart"):
        assert page.text_content(f"#{picture}-title")
        assert page.text_content(f"#{picture}-text")
