"""The explorer in a real browser: its numbers are the certified ones, and anyone can work it."""

import json
import math
import os
import random
import re
import shutil
from collections.abc import Callable, Iterator
from fractions import Fraction
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest
from cases import cases
from flint import fmpq
from hangs import HANGS

from tresym.racket.angle import Angle, parse_angle
from tresym.racket.body import NAMED_BODIES, Body, shape
from tresym.racket.flip import defect
from tresym.racket.flip.levels import turning_level
from tresym.racket.formulas import printed
from tresym.racket.motion.attitude import attitude
from tresym.racket.motion.trajectory import Start, travel
from tresym.reals.numbers.exact import fraction_text

playwright = pytest.importorskip("playwright.sync_api", reason="Playwright is not installed")

PAGE = Path(__file__).resolve().parents[2] / "docs" / "explorer" / "index.html"
CHROMIUM = shutil.which("chromium") or shutil.which("chromium-browser")

HARD = tuple(cases(__file__, "HARD"))
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

THROWS = tuple(cases(__file__, "THROWS"))
"""Shape and start (ψ₀, dψ/dφ): within the eyes of the separatrix and outside, either way round."""

SCENES = {
    "opening": {"space"},
    "throw": {"space"},
    "portrait-scene": {"space", "portrait"},
    "defect-scene": {"space", "levels"},
    "body-scene": {"space", "map"},
    "bench": {"space", "portrait", "map", "sphere"},
}
"""What is on the stage in each scene, where there is room."""

PICTURES = ("space", "portrait", "levels", "map", "sphere")

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

    def opened(fragment: str = "#body=str", **look: object) -> "playwright.Page":
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
    return not request.url.startswith(("data:", "blob:", PAGE.parent.as_uri() + "/"))


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
        assert Body(*row["moments"]).shape == body.shape if "moments" in row else True


def test_the_page_asks_for_nothing_that_is_not_beside_it() -> None:
    files = [*PAGE.parent.iterdir()]
    assert sum(os.path.getsize(file) for file in files) < 300_000
    for file in files:
        text = file.read_text(encoding="utf-8").replace("http://www.w3.org/2000/svg", "")
        assert not re.search(r"://|import\(|fetch\(|XMLHttpRequest|@import", text)


@needs_browser
@pytest.mark.slow
def test_thirty_typed_levels_agree_with_the_certified_defect(open_page: Open) -> None:
    page = open_page()
    for start in starts(30):
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
@pytest.mark.slow
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


def throw(page: "playwright.Page", start: tuple[str, str, str, str]) -> None:
    for name, text in zip(("a", "b", "psi0", "rate"), start, strict=True):
        page.fill(f"#{name}", text)
    assert page.inner_text("#message") == ""


@needs_browser
@pytest.mark.slow
def test_throws_from_a_start_agree_with_the_certified_flip(open_page: Open) -> None:
    page = open_page()
    for start in THROWS:
        throw(page, start)
        a, b, psi, rate = (fmpq(x.numerator, x.denominator) for x in map(Fraction, start))
        true = travel(shape(a, b), Start(Angle(fmpq(0), psi), rate=rate), parse_angle("2*pi"), 20)
        found = page.evaluate("poseAt(shown.motion, 1).psi - poseAt(shown.motion, 0).psi")
        assert found == pytest.approx(float(true.turn), abs=1e-11), start
        assert page.evaluate("poseAt(shown.motion, 1).theta") == pytest.approx(
            float(true.theta), abs=1e-11
        )
        assert number(page, "flip") == pytest.approx(found, abs=1e-8)
        assert page.inner_text("#command").endswith(f"--psi0={start[2]} --rate={start[3]}")


@needs_browser
def test_the_attitude_is_that_of_the_package(open_page: Open) -> None:
    page = open_page()
    for start in THROWS[:4]:
        throw(page, start)
        a, b, psi, rate = (float(Fraction(x)) for x in start)
        for share in (0.2, 0.9, 2.3):
            there, axes = page.evaluate(
                "share => { const at = poseAt(shown.motion, share), from = poseAt(shown.motion, 0);"
                " for (const x of ['phi', 'time']) at[x] -= from[x];"
                " const { first, second, third } = axesOf(at);"
                " return [at, [second, third, first]]; }",
                share,
            )
            last = attitude(a, b, psi, rate, there["phi"], 2)
            assert there["psi"] == pytest.approx(last.psi[-1], abs=1e-10)
            assert there["theta"] == pytest.approx(last.theta[-1], abs=1e-10)
            assert there["time"] == pytest.approx(last.time[-1], abs=1e-10)
            assert np.abs(np.array(axes).T - last.rotations()[-1]).max() < 1e-10


@needs_browser
@pytest.mark.slow
def test_the_momentum_obeys_eulers_equations(open_page: Open) -> None:
    """Integrated by steps in Python, which know nothing of the closed form."""
    from scipy.integrate import solve_ivp

    page = open_page()
    for start in THROWS[:4]:
        throw(page, start)
        a, b = (float(Fraction(x)) for x in start[:2])
        times, momenta = page.evaluate(
            "() => { const shares = [0, 0.3, 1, 2, 3], from = poseAt(shown.motion, 0).time;"
            " const poses = shares.map((x) => poseAt(shown.motion, x));"
            " return [poses.map((at) => at.time - from),"
            " poses.map((at) => momentumAt(at.psi, Math.cos(at.theta)))]; }"
        )
        inverse = np.array([1 + a, 1, 1 - b])

        def euler(_: float, m: np.ndarray, inverse: np.ndarray = inverse) -> np.ndarray:
            return np.cross(m, inverse * m)

        span = (0, times[-1])
        steps = solve_ivp(euler, span, momenta[0], "DOP853", times, rtol=1e-12, atol=1e-13)
        assert np.abs(steps.y.T - np.array(momenta)).max() < 1e-7
        energy = (np.array(momenta) ** 2 * inverse).sum(axis=1)
        assert np.abs(energy - energy[0]).max() < 1e-13 * (1 + a)


@needs_browser
def test_moments_make_the_shape(open_page: Open) -> None:
    page = open_page()
    for name, text in (("I1", "886"), ("I2", "16336"), ("I3", "18270.5")):
        page.fill(f"#{name}", text)
    body = Body("886", "16336", "18270.5").shape
    assert (page.input_value("#a"), page.input_value("#b")) == tuple(map(fraction_text, body))
    texts = tuple(map(fraction_text, body))
    assert_close(number(page, "defect0"), *texts, "0")
    assert page.inner_text("#command") == "tresym flip --inertia 886 16336 18270.5 --gamma=0"
    sides = page.evaluate("sidesOf(level())")
    assert sides[2] == 0  # I₃ > I₁ + I₂: a phantom
    page.fill("#I3", "17000")
    x, y, z = (side**2 for side in page.evaluate("sidesOf(level())"))
    assert (x + z) / (y + z) == pytest.approx(16336 / 886)
    assert (x + y) / (x + z) == pytest.approx(17000 / 16336)
    page.fill("#I3", "18270.5")
    for name, text, says in (("I2", "3", "I₂ must be more"), ("I1", "0", "must be positive")):
        good = page.input_value(f"#{name}")
        page.fill(f"#{name}", text)
        assert says in page.inner_text("#message")
        page.fill(f"#{name}", good)
    for slider, key in (("I1", "Home"), ("I1", "End"), ("I3", "End"), ("I2", "Home")):
        page.focus(f"#{slider}-slider")
        page.keyboard.press(key)
        assert page.inner_text("#message") == ""
    page.select_option("#body", "str")
    assert [page.input_value(f"#I{i}") for i in (1, 2, 3)] == ["1210", "16380", "17480"]


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
@pytest.mark.slow
def test_the_keyboard_is_enough(open_page: Open) -> None:
    page = open_page()
    reached = []
    for _ in range(75):
        page.keyboard.press("Tab")
        reached.append(page.evaluate("document.activeElement.id"))
    order = ["space", "sphere", "portrait", "map", "play", "moment"]
    assert [x for x in reached if x in order][:6] == order
    fields = ["a", "b", "I1", "I2", "I3", "gamma", "psi0", "rate"]
    wanted = {"body", *fields, *(f"{x}-slider" for x in fields), "tempo", "once", "upright"}
    assert wanted | {"copy-command", "copy-link", "save-png", "save-svg"} <= set(reached)
    for slider in fields:
        page.focus(f"#{slider}-slider")
        before = page.inner_text("#flip")
        page.keyboard.press("ArrowRight")
        page.keyboard.press("PageUp")
        assert page.inner_text("#flip") != before, slider
        assert page.inner_text("#message") == ""
    for picture, watched in (("portrait", "psi0"), ("map", "a")):
        page.focus(f"#{picture}")
        before = page.input_value(f"#{watched}")
        page.keyboard.press("ArrowRight")
        page.keyboard.press("Shift+ArrowUp")
        assert page.input_value(f"#{watched}") != before
        assert page.inner_text("#message") == ""
    page.select_option("#body", "str")
    page.focus("#to-turning")
    page.keyboard.press("Enter")
    assert float(page.input_value("#gamma")) == pytest.approx(
        page.evaluate("shown.turning"), rel=1e-5
    )
    page.focus("#to-separatrix")
    page.keyboard.press("Space")
    assert page.input_value("#gamma") == "0"
    page.focus("#moment")
    page.keyboard.press("End")
    page.wait_for_function("byId('moment').ariaValueText === 'handle turned by 360°'")
    page.focus("#space")
    page.keyboard.press("Home")
    yaw = page.evaluate("shown.eyes.space.yaw")
    page.keyboard.press("ArrowLeft")
    assert page.evaluate("shown.eyes.space.yaw") != yaw
    page.keyboard.press("Home")
    assert page.evaluate("shown.eyes.space.yaw") == yaw
    page.keyboard.press("Space")
    assert page.inner_text("#play") == "Pause"


def drag(page: "playwright.Page", name: str, start: list[float], end: list[float]) -> None:
    """From one point of a chart to another, in its own units."""
    box = page.locator(f"#{name}").bounding_box()
    assert box is not None
    frame = {
        "portrait": "portraitFrame(VIEWS.portrait, level())",
        "levels": "levelsFrame(VIEWS.levels, level(), shown.turning)",
        "map": "mapFrame(VIEWS.map)",
    }[name]
    spots = [page.evaluate(f"point => placed({frame}, point)", point) for point in (start, end)]
    (x, y), (u, v) = spots
    page.mouse.move(box["x"] + x, box["y"] + y)
    page.mouse.down()
    page.mouse.move(box["x"] + (x + u) / 2, box["y"] + (y + v) / 2)
    page.mouse.move(box["x"] + u, box["y"] + v)
    page.mouse.up()


@needs_browser
@pytest.mark.slow
def test_pictures_can_be_dragged(open_page: Open) -> None:
    page = open_page("#body=book&gamma=0")
    drag(page, "portrait", [0.1, 0.2], [1.0, -0.3])
    assert float(page.input_value("#psi0")) == pytest.approx(1.0, abs=0.02)
    assert float(page.input_value("#rate")) == pytest.approx(-0.3, abs=0.02)
    assert "--psi0=" in page.inner_text("#command")
    drag(page, "map", [0.1, -1], [math.log10(4), math.log10(0.05)])
    assert float(page.input_value("#a")) == pytest.approx(4, rel=0.02)
    assert float(page.input_value("#b")) == pytest.approx(0.05, rel=0.02)
    assert page.inner_text("#realizable").startswith("✓")
    page.click("#pictures [data-picture=levels]")
    page.click("#to-separatrix")
    drag(page, "levels", [0.0, 10.0], [0.002, 5.0])
    assert float(page.input_value("#gamma")) == pytest.approx(0.002, abs=0.0005)
    assert page.inner_text("#command").endswith(f"--gamma={page.input_value('#gamma')}")
    # Beyond every rim, what is shown stays possible, and in sight.
    for name, far in (("portrait", [9.0, 90.0]), ("levels", [-9.0, 0.0]), ("levels", [9.0, 0.0])):
        drag(page, name, [0.0, 0.0], far)
        assert page.inner_text("#message") == ""
        if name == "portrait":
            crest, reach = page.evaluate(
                "[rateAt(level(), Math.PI / 2), portraitFrame(VIEWS.portrait, level()).along[1]]"
            )
            assert crest < reach < 1.8 * crest
    eye = page.evaluate("({ ...shown.eyes.sphere })")
    page.mouse.move(1100, 120)
    page.mouse.down()
    page.mouse.move(1130, 150)
    page.mouse.up()
    assert page.evaluate("shown.eyes.sphere.yaw") == pytest.approx(eye["yaw"] - 0.24)


DRAWN = """names => names.filter((name) => {
  const { canvas } = VIEWS[name];
  if (!canvas.width) return true;
  const copy = Object.assign(document.createElement("canvas"), { width: 200, height: 200 });
  const to = copy.getContext("2d", { willReadFrequently: true });
  to.drawImage(canvas, 0, 0, 200, 200);
  const { data } = to.getImageData(0, 0, 200, 200);
  return new Set(new Uint32Array(data.buffer)).size < 30;
})"""


@needs_browser
@pytest.mark.parametrize("width", [1280, 390])
@pytest.mark.slow
def test_the_story_sets_the_stage(open_page: Open, width: int) -> None:
    page = open_page("", viewport={"width": width, "height": 800 if width > 400 else 844})
    for name, pictures in SCENES.items():
        page.evaluate("id => document.getElementById(id).scrollIntoView()", name)
        page.wait_for_function("name => byId('stage').dataset.scene === name", arg=name)
        page.evaluate("new Promise((next) => requestAnimationFrame(() => setTimeout(next, 30)))")
        seen = [x for x in PICTURES if page.locator(f"#{x}").is_visible()]
        assert set(seen) == pictures if width > 400 or len(pictures) < 3 else len(seen) == 2
        assert page.evaluate(DRAWN, seen) == []
        # The stage stays in sight.
        assert page.evaluate("byId('stage').getBoundingClientRect().top") == 0
        assert page.evaluate("document.documentElement.scrollWidth") <= width
    assert page.evaluate("location.hash") == ""
    page.evaluate("byId('portrait-scene').scrollIntoView()")
    page.wait_for_function("byId('stage').dataset.scene === 'portrait-scene'")
    page.click("[data-level=rolls]")
    assert page.text_content("[data-live=kind]").startswith("rotating")
    # Whoever works the form stays at the bench, wherever the page stands.
    page.fill("#a", "3")
    page.evaluate("scrollTo(0, byId('bench').offsetTop - 0.9 * innerHeight)")
    page.evaluate("new Promise((next) => requestAnimationFrame(() => setTimeout(next, 30)))")
    assert (page.evaluate("scene.name"), page.input_value("#a")) == ("bench", "3")
    page.evaluate("document.activeElement.blur()")
    page.locator("#steps a[href='#body-scene']").dispatch_event("click")
    page.wait_for_function("byId('stage').dataset.scene === 'body-scene'")
    for name, says in (("racket-1", "no rigid body has it"), ("str", "a rigid body can have it")):
        page.click(f"[data-body={name}]")
        assert page.text_content("[data-live=verdict]").endswith(says)
    assert page.get_attribute("#steps a[href='#body-scene']", "aria-current") == "step"


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
    page.wait_for_function("shown.share > 0.05")
    page.click("#play")
    assert page.inner_text("#play") == "Play"
    frames = "requestAnimationFrame(() => requestAnimationFrame(next))"
    page.evaluate(f"new Promise((next) => {frames})")
    held = page.evaluate("VIEWS.space.canvas.toDataURL()")
    page.evaluate("new Promise((next) => setTimeout(next, 100))")
    assert page.evaluate("VIEWS.space.canvas.toDataURL()") == held
    page.check("#once")
    page.evaluate("shown.share = 0.999; setPlaying(true)")
    page.wait_for_function("shown.rest > 0")
    assert page.evaluate("shown.share") == 1


@needs_browser
def test_who_wants_less_motion_gets_none_unasked(open_page: Open) -> None:
    page = open_page("")
    page.evaluate("byId('defect-scene').scrollIntoView()")
    page.wait_for_function("byId('stage').dataset.scene === 'defect-scene'")
    page.evaluate("new Promise((next) => setTimeout(next, 100))")
    assert page.inner_text("#play") == "Play"
    assert page.evaluate("[shown.share, shown.eyes.space.yaw]") == [0, -50 * math.pi / 180]
    page.click("#play")
    page.wait_for_function("shown.share > 0.01")


@needs_browser
@pytest.mark.slow
def test_a_choice_can_be_sent_as_an_address(open_page: Open) -> None:
    page = open_page()
    page.select_option("#body", "racket-3")
    page.fill("#gamma", "-0.002")
    page.wait_for_function("location.hash.includes('gamma=-0.002')")
    again = open_page(page.evaluate("location.hash"))
    assert again.input_value("#body") == "racket-3"
    assert again.inner_text("#defect") == page.inner_text("#defect")
    page.fill("#a", "14,9")
    assert page.input_value("#body") == ""
    assert "--shape 14.9 0.12" in page.inner_text("#command")
    page.fill("#I1", "62")
    page.fill("#psi0", "0.2")
    page.fill("#rate", "-0.5")
    page.check("#upright")
    page.wait_for_function("location.hash.includes('upright')")
    again = open_page(page.evaluate("location.hash"))
    for name in ("#command", "#flip", "#defect0"):
        assert again.inner_text(name) == page.inner_text(name)
    assert again.is_checked("#upright")


@needs_browser
@pytest.mark.night
def test_pictures_and_words_can_be_kept(open_page: Open) -> None:
    page = open_page("#body=str&gamma=0.001", accept_downloads=True)
    for name in PICTURES:
        page.select_option("#picture", name)
        with page.expect_download() as saved:
            page.click("#save-svg")
        root = ElementTree.parse(saved.value.path()).getroot()
        assert (root.tag, root.get("width")) == ("{http://www.w3.org/2000/svg}svg", "960")
        assert len(list(root.iter())) > 30
        assert "NaN" not in Path(saved.value.path()).read_text(encoding="utf-8")
    with page.expect_download() as saved:
        page.click("#save-png")
    assert saved.value.suggested_filename == "racket-sphere.png"
    data = Path(saved.value.path()).read_bytes()
    assert data[:8] == b"\x89PNG\r\n\x1a\n"
    assert int.from_bytes(data[16:20], "big") == 1920
    for button, what in (("#copy-command", "command copied"), ("#copy-link", "link copied")):
        page.click(button)
        page.wait_for_function("what => byId('kept').textContent === what", arg=what)


@needs_browser
def test_every_control_has_a_name_and_every_picture_words(open_page: Open) -> None:
    page = open_page("#body=book&gamma=-0.1")
    unnamed = page.evaluate(
        "[...document.querySelectorAll('button, input, select, canvas')].filter((x) => "
        "!(x.labels?.length || x.ariaLabel || x.textContent.trim())).map((x) => x.id)"
    )
    assert unnamed == []
    for picture in PICTURES:
        assert page.text_content(f"#{picture}-text")
