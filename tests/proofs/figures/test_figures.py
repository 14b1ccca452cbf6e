"""The figures: what each caption says, on the plotted arrays; the same bytes on every build."""

import math
import re
import warnings
from importlib.util import find_spec
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest
from cases import cases
from tresym.proofs import figures
from tresym.proofs.figures import (
    curves,
    defect_map,
    euler_angles,
    flip_curves,
    flip_portrait,
    handle_curves,
    handle_portrait,
    momentum_sphere,
    racket_flip,
    racket_frame,
    shape_map,
    symmetric_flips,
)
from tresym.proofs.figures import flip_map as flip_map_figure

from tresym.commands import main
from tresym.racket.body import named_body
from tresym.racket.flip import flip_angle, flip_defect
from tresym.racket.floats.flipmap import flip_map
from tresym.racket.motion.attitude import attitude
from tresym.reals.numbers.exact import InputError

SAVED = Path(__file__).resolve().parents[3] / "docs" / "generated" / "figures"
STR = ("1517/121", "55/874")
A, B = 1517 / 121, 55 / 874


def defect(a, b, gamma=0):
    """ε(γ), certified, as a float."""
    return float(flip_defect(a, b, gamma, 16).defect)


# Fig. 1


def test_the_handle_is_along_e1_and_the_head_in_the_plane_of_e1_and_e2():
    data = racket_frame.data()
    assert np.ptp(data.racket.handle[:, 0]) > 1
    assert not data.racket.handle[:, 1:].any()
    assert not data.racket.rim[:, 2].any()
    assert np.allclose(data.racket.rim[0], data.racket.rim[-1])
    assert np.array_equal(data.axes, np.eye(3))


# Fig. 2


def test_phi_is_from_x_to_the_shadow_of_the_handle():
    data = euler_angles.data()
    first = data.frame[0]
    assert math.atan2(first[1], first[0]) == pytest.approx(data.phi, abs=1e-15)
    assert math.acos(first[2]) == pytest.approx(data.theta, abs=1e-15)


def test_the_line_of_nodes_is_level_and_psi_turns_it_to_e3_about_the_handle():
    data = euler_angles.data()
    first, second, third = data.frame
    assert np.allclose(data.frame @ data.frame.T, np.eye(3), atol=1e-15)
    assert np.allclose(np.cross(first, second), third, atol=1e-15)
    assert data.nodes[2] == 0
    assert abs(data.nodes @ first) < 1e-15
    turn = math.atan2(np.cross(data.nodes, third) @ first, data.nodes @ third)
    assert turn == pytest.approx(data.psi, abs=1e-15)


# Fig. 3


@pytest.fixture(scope="module")
def sphere():
    return momentum_sphere.data()


def test_the_solution_is_on_both_surfaces(sphere):
    for radii, pair in zip(sphere.radii, sphere.meetings, strict=True):
        for on in pair:
            assert np.allclose((on.momentum**2).sum(axis=1), 1, atol=1e-14)
            assert np.allclose((on.momentum**2 / radii**2).sum(axis=1), 1, atol=1e-14)


def test_the_left_ellipsoid_is_oscillating_and_the_right_one_rotating(sphere):
    """The middle radius √(2I₂E) against M = 1, and the sphere between the least and the most."""
    assert sphere.radii[0, 1] < 1 < sphere.radii[1, 1]
    assert (sphere.radii[:, 0] < 1).all()
    assert (sphere.radii[:, 2] > 1).all()
    assert [pair[0].gamma < 0 for pair in sphere.meetings] == [True, False]


def test_the_motion_stays_on_the_drawn_curves(sphere):
    a, b = sphere.a, sphere.b
    for on in sphere.orbits[::2]:
        psi, rate = curves.flip_plane(on.momentum, a, b)
        moved = attitude(a, b, psi[10], rate[10], 7.0, 41).momentum()
        nearest = np.linalg.norm(moved[:, None] - on.momentum, axis=2).min(axis=1)
        assert nearest.max() < 0.02
        assert np.allclose(a * moved[:, 0] ** 2 - b * moved[:, 2] ** 2, on.gamma, atol=1e-13)


def test_the_separatrix_is_where_the_unstable_point_is_and_no_other(sphere):
    plus, unstable, minus = sphere.equilibria
    for on in sphere.separatrices:
        depth = sphere.a * on.momentum[:, 0] ** 2 - sphere.b * on.momentum[:, 2] ** 2
        assert np.abs(depth).max() < 1e-15
        assert np.linalg.norm(on.momentum - unstable, axis=1).min() < 1e-12
        for stable in (plus, minus):
            assert np.linalg.norm(on.momentum - stable, axis=1).min() > 0.4
    kinds = {on.gamma > 0 for on in sphere.orbits}
    assert kinds == {True, False}


def test_rotating_orbits_go_round_e1_and_oscillating_ones_round_e3(sphere):
    for on in sphere.orbits:
        axis, others = (0, [1, 2]) if on.gamma > 0 else (2, [0, 1])
        assert np.ptp(np.sign(on.momentum[:, axis])) == 0
        turn = np.unwrap(np.arctan2(*on.momentum[:, others].T))
        assert abs(turn[-1] - turn[0]) == pytest.approx(2 * math.pi)


def test_the_angles_on_the_sphere_are_those_of_the_momentum(sphere):
    first, second, third = sphere.momentum
    assert math.acos(first) == pytest.approx(sphere.theta)
    assert math.atan2(third, -second) == pytest.approx(sphere.psi)


def _depth(inverse, eye, places):
    """How far towards the eye a surface is seen at places on the paper; −∞ beside it."""
    beside = places[:, :1] * eye.right + places[:, 1:] * eye.up
    square = float(inverse @ eye.towards**2)
    half = (beside * inverse) @ eye.towards / square
    rest = half**2 - ((beside**2) @ inverse - 1) / square
    return np.where(rest >= 0, np.sqrt(np.maximum(rest, 0)) - half, -np.inf)


@pytest.mark.parametrize("panel", [0, 1])
def test_the_surface_that_is_set_last_is_the_one_in_front(sphere, panel):
    """Against rays from the eye: the greys of the sphere are lighter than the ellipsoid's."""
    from matplotlib.patches import Polygon

    drawn = momentum_sphere.draw(sphere).axes[panel]
    places = np.random.default_rng(5).uniform(-1.4, 1.4, (4000, 2))
    lightness = np.ones(len(places))
    for part in (x for x in drawn.patches if isinstance(x, Polygon)):
        within = part.get_path().contains_points(places)
        if part.get_clip_path() is not None:
            cap = part.get_clip_path().get_fully_transformed_path()
            within &= cap.contains_points(drawn.transData.transform(places))
        lightness[within] = part.get_facecolor()[0]
    eye, radii = momentum_sphere.EYE, sphere.radii[panel]
    depths = [_depth(inverse, eye, places) for inverse in (np.ones(3), radii**-2)]
    expected = np.where(np.maximum(*depths) == -np.inf, 2, np.argmax(depths, axis=0))
    kinds = np.where(lightness == 1, 2, np.where(lightness > 0.57, 0, 1))
    assert np.mean(kinds != expected) < 0.004  # what lies on an outline
    assert len(set(expected)) == 3


@pytest.mark.parametrize(
    "name", ["flip-portrait", pytest.param("flip-map", marks=pytest.mark.night)]
)
def test_the_words_of_a_narrow_picture_stand_within_it_and_apart(name, monkeypatch):
    from tresym.report.figures import style

    drawn = []
    monkeypatch.setattr(style, "svg_text", lambda figure, title: drawn.append(figure) or "")
    figures.picture(name, body=(1.0, 0.2), width=90)
    assert len(list(style._words(drawn[0]))) > 3
    boxes = [x.get_window_extent() for x in style._words(drawn[0]) if x.get_text()]
    assert style._apart(boxes, drawn[0].bbox)


@pytest.mark.night
def test_a_strip_of_a_column_has_letters_of_a_caption():
    from tresym.report.figures import style

    with style.looks():
        strip = racket_flip.strip(racket_flip.data())
        share = 90 / 25.4 / strip.get_figwidth()
        strip.set_size_inches(strip.get_size_inches() * share)
        style.fit_words(strip, share)
        words = [word for word in style._words(strip) if word.get_text()]
        assert [word.get_text() for word in words[:3]] == ["φ = 0", "π/4", "π/2"]
        assert min(word.get_fontsize() for word in words) > 7


# For an article


PRINTED = [
    pytest.param(name, marks=pytest.mark.night if n % 2 else ())
    for n, name in enumerate(figures.FIGURES)
]
"""Every second in each run, and all of them every night."""


@pytest.mark.parametrize("name", PRINTED)
@pytest.mark.slow
def test_a_figure_for_an_article_has_the_fonts_of_latex_and_room_for_its_words(name, monkeypatch):
    style = pytest.importorskip("tresym.report.figures.style")
    pytest.importorskip("matplotlib")
    saved = style.bitmap_or_page

    def checked(figure, *rest):
        assert round(figure.get_figwidth() * 25.4) == figures.PRINTED_MM[name] <= 146
        assert style.stands(figure, style.scale_words(figure, 1.0), 1.0)
        return saved(figure, *rest)

    monkeypatch.setattr(style, "bitmap_or_page", checked)
    with warnings.catch_warnings():
        warnings.simplefilter("error")  # a character that the font lacks
        page = figures.printed(name)
    fonts = {found.lower() for found in re.findall(rb"/BaseFont /(?:[A-Z]{6}\+)?(\w+)", page)}
    assert fonts <= {b"cmr10", b"cmmi10", b"cmsy10", b"cmex10"}
    assert fonts or name in ("racket-frame", "euler-angles")  # whose words are outlines
    assert name != "flip-curves" or page == figures.printed(name)


def test_formulas_in_the_words_of_a_figure_are_set_as_formulas():
    style = pytest.importorskip("tresym.report.figures.style")
    found = {
        "rotating, γ > 0": r"rotating, $\gamma  > 0$",
        "−π/2": r"$-\pi /2$",
        "ψ (rad)": r"$\psi $ (rad)",
        "from ψ = ε to π − ε": r"from $\psi  = \epsilon $ to $\pi  - \epsilon $",
        "the rectangle": "the rectangle",
        r"$\varepsilon_0$ (rad)": r"$\epsilon_0$ (rad)",
    }
    assert {words: style.with_formulas(words) for words in found} == found


def _grey(colour):
    from matplotlib.colors import to_rgb

    return float(np.dot(to_rgb(colour), (0.299, 0.587, 0.114)))


def test_in_grey_the_colours_of_areas_keep_their_order():
    matplotlib = pytest.importorskip("matplotlib")
    style = pytest.importorskip("tresym.report.figures.style")
    for name in ("cividis", style._PRINTED["image.cmap"]):
        greys = [_grey(c) for c in matplotlib.colormaps[name](np.linspace(0, 1, 33))]
        assert np.all(np.diff(greys) > 0.005)
    dashes = [look["linestyle"] for _, look in style.ORBITS]
    assert len(set(dashes)) == 3


# Fig. 4


@pytest.fixture(scope="module")
def portrait():
    return flip_portrait.data()


def test_every_line_of_the_flip_portrait_has_its_gamma(portrait):
    a, b = portrait.a, portrait.b
    for on in (*portrait.oscillating, *portrait.rotating, portrait.separatrix):
        square = b * np.sin(on.psi) ** 2
        found = on.rate**2 * (1 - square) ** 2 / (a + square) - square
        assert np.allclose(found, on.gamma, atol=1e-14)


def test_two_unstable_points_are_on_the_separatrix_and_a_half_turn_apart(portrait):
    line = portrait.separatrix
    assert line.psi[-1] - line.psi[0] == math.pi
    assert np.abs(line.rate[[0, -1]]).max() < 1e-15
    assert (line.rate[1:-1] > 0).all()


def test_oscillations_turn_where_the_paper_says_and_are_narrower_than_a_half_turn(portrait):
    for on in portrait.oscillating:
        least = math.asin(math.sqrt(-on.gamma / portrait.b))
        assert on.psi.min() == pytest.approx(least, abs=1e-12)
        assert on.psi.max() == pytest.approx(math.pi - least, abs=1e-12)
        assert np.ptp(on.psi) < math.pi
        assert on.rate.min() < 0 < on.rate.max()
    assert all((on.rate > 0).all() for on in portrait.rotating)


def test_the_flow_moves_along_the_lines_of_the_flip_portrait(portrait):
    on = portrait.rotating[2]
    turn = flip_map(portrait.a, portrait.b, on.psi[20], on.rate[20], 0.3)
    step = flip_map(portrait.a, portrait.b, on.psi[20], on.rate[20], [0.3 - 1e-6, 0.3 + 1e-6])
    there = np.interp(on.psi[20] + turn, on.psi, on.rate)
    assert (step[1] - step[0]) / 2e-6 == pytest.approx(there, rel=1e-4)


# Fig. 5


def test_oscillating_lines_cross_the_middle_of_the_theta_portrait_and_rotating_ones_do_not():
    for on in handle_portrait.data().curves:
        crosses = on.theta.min() < math.pi / 2 < on.theta.max()
        assert crosses == (on.gamma < 0)


def test_theta_has_the_printed_bounds():
    data = handle_portrait.data()
    for on in data.curves:
        cosines = np.sqrt([(on.gamma + data.b) / (data.a + data.b), max(on.gamma, 0) / data.a])
        least, most = np.arccos(cosines)
        if on.gamma < 0:
            most = math.pi - least
        low, high = sorted([on.theta.min(), on.theta.max()])
        if low > math.pi / 2:
            low, high = math.pi - high, math.pi - low
        assert [low, high] == pytest.approx([least, most], abs=1e-3)


def test_stable_and_unstable_points_are_one_point_of_the_theta_portrait():
    data = handle_portrait.data()
    equilibria = np.array([[0.0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]])
    theta, rate = curves.handle_plane(equilibria, data.a, data.b)
    assert np.allclose(theta, math.pi / 2)
    assert np.allclose(rate, 0)
    for line in data.separatrix:
        assert np.hypot(line.theta - math.pi / 2, line.rate).min() < 1e-12


def test_the_rate_of_theta_is_its_derivative():
    data = handle_portrait.data()
    motion = attitude(data.a, data.b, 1.0, 0.1, 2 * math.pi, 20001)
    theta, rate = curves.handle_plane(motion.momentum(), data.a, data.b)
    assert np.allclose(np.gradient(theta, motion.phi)[1:-1], rate[1:-1], atol=1e-6)


# Fig. 6


def test_the_handle_stays_between_the_lines_and_comes_to_both():
    below, above = handle_curves.data()
    assert below.gamma < 0 < above.gamma
    for motion in (below, above):
        least, most = motion.bounds
        assert least - 1e-12 <= motion.theta.min() < least + 1e-3
        assert most - 1e-3 < motion.theta.max() <= most + 1e-12
        assert np.allclose(np.linalg.norm(motion.handle, axis=1), 1, atol=1e-14)
    assert (above.handle[:, 2] > 0).all()
    assert below.handle[:, 2].min() < 0 < below.handle[:, 2].max()


# Fig. 7


def test_symmetric_curves_take_one_turn_from_epsilon_to_pi_less_epsilon():
    for flip in symmetric_flips.data().flips:
        assert np.ptp(flip.phi) == 2 * math.pi
        assert flip.psi[0] + flip.psi[-1] == pytest.approx(math.pi, abs=1e-13)
        assert flip.psi[0] == pytest.approx(defect(*STR, str(flip.gamma)), abs=1e-9)


def test_the_exact_flip_begins_at_the_unstable_angle():
    flips = {flip.gamma: flip for flip in symmetric_flips.data().flips}
    assert abs(flips[0.0032037].psi[0]) < 1e-5
    assert flips[0.0].psi[0] == pytest.approx(defect(*STR), abs=1e-12)


# Fig. 8


@pytest.fixture(scope="module")
def maps():
    return defect_map.data()


def test_the_exact_map_is_certified_at_a_few_points(maps):
    for row, column in ((0, 3), (20, 90), (64, 0), (64, 50), (100, 60), (128, 5)):
        shape = (repr(float(maps.a[column])), repr(maps.b))
        gamma = repr(float(maps.gamma[row]))
        assert maps.exact[row, column] == pytest.approx(defect(*shape, gamma), abs=1e-8)
    middle = maps.gamma == 0
    assert np.allclose(maps.exact[middle], maps.defect0, atol=1e-12)
    assert np.array_equal(maps.linear[middle][0], maps.defect0)


def zero(values, gamma, level=0.0):
    """γ where each column, which falls with γ, comes through ``level``."""
    return np.array([np.interp(-level, -column, gamma) for column in values.T])


def test_for_small_epsilon0_the_exact_flip_is_close_to_the_separatrix(maps):
    linear, exact = zero(maps.linear, maps.gamma), zero(maps.exact, maps.gamma)
    inside = 4 * maps.b * maps.defect0**2 < 0.07
    assert np.allclose(linear[inside], 4 * maps.b * maps.defect0[inside] ** 2, atol=1e-12)
    assert (np.diff(exact[inside]) > 0).all()
    assert exact[0] < 3e-4
    assert np.allclose(exact[inside], linear[inside], rtol=0.12)


def test_a_larger_epsilon0_has_a_larger_range_of_gamma(maps):
    small = maps.defect0 < 0.3
    for values in (maps.exact, maps.linear):
        levels = (-defect_map.TOLERANCE, defect_map.TOLERANCE)
        low, high = (zero(values[:, small], maps.gamma, -x) for x in levels)
        assert (np.diff(np.abs(low - high)) > 0).all()


def test_the_linear_map_leaves_the_range_an_oscillation_has(maps):
    below = maps.gamma < 0
    least = np.arcsin(np.sqrt(-maps.gamma[below] / maps.b))[:, None]
    assert (maps.exact[below] >= least).all()
    assert (maps.exact[below] <= math.pi - least).all()
    assert (maps.linear[below] > math.pi - least).any()
    assert (maps.linear[below] < least).any()


# Fig. 9


@pytest.fixture(scope="module")
def panels():
    return {panel.gamma: panel for panel in flip_curves.data()}


def test_six_panels_of_both_kinds(panels):
    assert sorted(np.sign(list(panels))) == [-1, -1, -1, 1, 1, 1]
    for panel in panels.values():
        assert np.isfinite(panel.psi).all()
        if panel.gamma > 0:
            assert (np.diff(panel.psi) > 0).all()
        else:
            assert panel.psi.min() > 0
            assert panel.psi.max() < math.pi
            # From rest the two ends mirror each other; a rate left by rounding is its square root.
            assert np.abs(panel.psi[0] + panel.psi[-1] - math.pi).max() < 1e-13


def test_far_from_the_separatrix_there_is_no_flip_by_the_papers_tolerance(panels):
    for gamma in (-0.03, 0.03):
        flip = np.abs(panels[gamma].psi[:, -1] - panels[gamma].psi[:, 0])
        assert (np.abs(flip - math.pi) > math.pi / 6).all()


def test_close_to_it_every_start_flips_by_about_pi(panels):
    """γ = 0.003 is where the racket's symmetric flip is nearly exact, so every start's is."""
    flip = panels[0.003].psi[:, -1] - panels[0.003].psi[:, 0]
    assert (np.abs(flip - math.pi) < math.pi / 6).all()


# Fig. 10


@pytest.fixture(scope="module")
def whole():
    return flip_map_figure.data()


def test_the_flip_is_symmetric_about_the_unstable_point(whole):
    for part in (whole.whole, whole.zoom):
        assert np.isfinite(part.flip).all()
        assert np.allclose(part.flip, part.flip[::-1, ::-1], rtol=1e-6, atol=1e-9)


def test_the_map_is_certified_at_a_few_starts(whole):
    for row, column in ((3, 5), (130, 170), (200, 300), (119, 90)):
        psi, rate = float(whole.whole.psi[column]), float(whole.whole.rate[row])
        answer = flip_angle(*STR, repr(psi), repr(rate), 16)
        assert whole.whole.flip[row, column] == pytest.approx(abs(float(answer.turn)), abs=1e-9)


def test_the_rectangle_is_around_the_unstable_point_and_inside(whole):
    for values, outer in ((whole.zoom.psi, whole.whole.psi), (whole.zoom.rate, whole.whole.rate)):
        assert outer[0] < values[0] < 0 < values[-1] < outer[-1]
        assert values[0] == -values[-1]


def test_the_separatrix_has_gamma_zero(whole):
    square = B * np.sin(whole.whole.psi) ** 2
    gamma = whole.separatrices[0] ** 2 * (1 - square) ** 2 / (A + square) - square
    assert np.abs(gamma).max() < 1e-14


def test_the_flip_is_small_on_the_way_in_and_not_on_the_way_out(whole):
    """The paper's remark on the separatrix holds on its incoming branch only."""
    psi = np.linspace(0.02, 0.3, 15)
    rate = curves.rate_at(psi, 0.0, A, B)
    incoming, outgoing = (np.abs(flip_map(A, B, psi, sign * rate)) for sign in (-1, 1))
    assert (incoming < psi).all()
    assert (outgoing > math.pi / 3).all()


# Fig. 11


@pytest.fixture(scope="module")
def shapes():
    return shape_map.data()


def test_the_bodies_are_where_the_table_has_them(shapes):
    for point in shapes.bodies:
        body = named_body(point.name).shape
        assert point.defect == pytest.approx(defect(body.a, body.b), abs=1e-14)
        assert 0 < point.a < shape_map.REACH[0]
        assert 0 < point.b < shape_map.REACH[1]
    real = {point.name for point in shapes.bodies if point.realizable}
    assert real == {"str", "book", "ethylene"}


def test_epsilon0_falls_with_a_and_with_b(shapes):
    assert (np.diff(shapes.defect, axis=0) < 0).all()
    assert (np.diff(shapes.defect, axis=1) < 0).all()


def test_no_real_body_comes_below_the_limit(shapes):
    assert shapes.defect[shapes.realizable].min() > shape_map.BEST
    assert shapes.defect.min() < shape_map.BEST


def test_level_curves_are_not_exactly_hyperbolas():
    same_product = shape_map.separatrix_defect(np.array([1.0, 10.0]), np.array([0.3, 0.03]))
    assert same_product[1] - same_product[0] > 0.09


# The animation


def test_the_animation_closes_and_half_way_the_racket_has_flipped():
    data = racket_flip.data()
    half = racket_flip.STEPS // 2
    assert data.phi[half] == pytest.approx(2 * math.pi)
    assert data.psi[[0, half, -1]] == pytest.approx([0, math.pi, 2 * math.pi], abs=1e-9)
    assert np.allclose(data.frames[0], data.frames[-1], atol=1e-8)
    assert np.allclose(data.frames[half], data.frames[0] * [[1], [-1], [-1]], atol=1e-8)
    assert abs(defect(*STR, repr(data.gamma))) < 1e-11
    assert (np.diff(data.time) > 0).all()


def test_every_moment_of_the_animation_has_its_time_and_the_same_commands():
    root = ElementTree.fromstring(racket_flip.draw(racket_flip.data()))
    moving = [node for node in root.iter() if node.tag.endswith("animate")]
    assert len(moving) == 4
    for node in moving:
        times = [float(x) for x in node.get("keyTimes").split(";")]
        values = node.get("values").split(";")
        assert len(times) == len(values) == racket_flip.STEPS + 1
        assert (times[0], times[-1]) == (0, 1)
        assert times == sorted(times)
        assert values[0] == values[-1]
        if node.get("attributeName") == "d":
            assert len({"".join(c for c in value if c.isalpha()) for value in values}) == 1


# As pictures


@pytest.mark.parametrize("name", figures.FIGURES)
def test_a_saved_figure_is_a_picture_that_can_stand_anywhere(name):
    """That it is what is drawn is shown in test_processors.py."""
    text = (SAVED / f"{name}.svg").read_text(encoding="utf-8")
    root = ElementTree.fromstring(text)
    assert root.tag.endswith("svg")
    assert "<title>" in text
    assert "<text" not in text
    assert "<script" not in text
    assert "dc:date" not in text


def test_no_picture_is_saved_that_is_not_a_figure():
    assert {path.stem for path in SAVED.glob("*")} == set(figures.FIGURES)


def test_the_command_lists_the_figures_and_draws_one(capsys, tmp_path):
    assert main(["figure"]) == 0
    listed = capsys.readouterr().out.splitlines()
    assert [line.split()[0] for line in listed] == list(figures.FIGURES)
    assert main(["figure", "racket-flip", "-o", str(tmp_path / "x.svg")]) == 0
    assert (tmp_path / "x.svg").read_text().startswith("<svg")


@pytest.mark.slow
@pytest.mark.parametrize(("ending", "begins"), [("pdf", b"%PDF-"), ("PNG", b"\x89PNG")])
def test_a_figure_for_an_article_or_a_slide(ending, begins, tmp_path):
    pytest.importorskip("matplotlib")
    paths = [tmp_path / f"{i}.{ending}" for i in range(2)]
    for path in paths:
        assert main(["figure", "euler-angles", "-o", str(path)]) == 0
    first, second = (path.read_bytes() for path in paths)
    assert first.startswith(begins)
    assert first == second


@pytest.mark.parametrize(
    ("name", "path", "message"),
    cases(__file__, "a_picture_of_no_such_kind_is_bad_input"),
)
def test_a_picture_of_no_such_kind_is_bad_input(name, path, message, capsys, tmp_path):
    assert main(["figure", name, "-o", str(tmp_path / path)]) == 2
    assert message in capsys.readouterr().err
    assert not list(tmp_path.iterdir())


BODY = tuple(map(float, curves.shape_of("ethylene")))


def test_the_portrait_of_a_body_of_ones_own_has_its_levels():
    found = flip_portrait.data(BODY)
    a, b = BODY
    assert (found.a, found.b) == BODY
    assert all(-b < curve.gamma < 0 for curve in found.oscillating)
    assert all(0 < curve.gamma < a for curve in found.rotating)
    (panel,) = flip_curves.data(BODY, -0.1)
    assert panel.gamma == -0.1
    assert np.sin(panel.psi[:, 0].min()) ** 2 == pytest.approx(0.1 / b)


def test_a_body_of_ones_own_flips_exactly_in_its_animation():
    found = racket_flip.data(BODY)
    half = len(found.psi) // 2
    assert found.psi[half] == pytest.approx(np.pi, abs=1e-9)
    assert abs(flip_defect(*(str(x) for x in BODY), str(found.gamma)).defect.mid()) < 1e-9
    with pytest.raises(InputError, match="flips by π exactly"):
        racket_flip.data((1e-6, 1e-6))


@pytest.mark.night
def test_the_animation_as_a_picture_that_moves_and_as_a_strip(tmp_path):
    image = pytest.importorskip("PIL.Image")
    paths = [tmp_path / "flip.gif", tmp_path / "strip.png"]
    for path in paths:
        assert main(["figure", "racket-flip", "--body", "ethylene", "-o", str(path)]) == 0
    with image.open(paths[0]) as moving:
        assert moving.n_frames > 80
        assert moving.size == (racket_flip.WIDTH, racket_flip.HEIGHT)
    with image.open(paths[1]) as strip:
        assert strip.size[0] > 4 * strip.size[1]


def test_the_animation_has_the_width_that_is_asked_for(tmp_path):
    image = pytest.importorskip("PIL.Image")
    path = tmp_path / "flip.gif"
    asked = ["--width", "50.8", "--dpi", "100", "-o", str(path)]
    assert main(["figure", "racket-flip", *asked]) == 0
    with image.open(path) as moving:
        assert moving.size == (200, 164)
    found = racket_flip.data()
    assert 'width="38mm" height="31mm"' in racket_flip.draw(found, 38)
    assert f'width="{racket_flip.WIDTH}" height="{racket_flip.HEIGHT}"' in racket_flip.draw(found)


def test_a_film_is_written_or_what_it_needs_is_said(tmp_path, capsys):
    path = tmp_path / "flip.mp4"
    status = main(["figure", "racket-flip", "-o", str(path)])
    if find_spec("imageio_ffmpeg") is None:
        assert status == 2
        assert capsys.readouterr().err.count("\n") == 1
        assert not path.exists()
    else:
        assert status == 0
        assert path.read_bytes()[4:8] == b"ftyp"


def test_a_picture_has_the_width_that_is_asked_for(tmp_path):
    image = pytest.importorskip("PIL.Image")
    path = tmp_path / "portrait.png"
    asked = ["--shape", "1", "1/3", "--width", "127", "--dpi", "100", "-o", str(path)]
    assert main(["figure", "flip-portrait", *asked]) == 0
    with image.open(path) as found:
        assert found.size[0] == 500


@pytest.mark.parametrize(
    ("asked", "message"),
    [
        (["euler-angles", "--body", "str"], "only flip-portrait, flip-map, flip-curves"),
        (["flip-map", "--gamma", "0.01"], "--gamma is an option of flip-curves"),
        (["flip-curves", "--gamma", "0"], "--gamma 0 is the separatrix"),
        (["flip-curves", "--gamma", "99"], "gamma: must be between -b and a"),
        (["flip-curves", "--width", "1e9"], "--width: must be from 40 to 600"),
        (["flip-curves", "--dpi", "1e9"], "--dpi: must be from 20 to 1200"),
        (["racket-flip", "--width", "600", "--dpi", "300", "-o", "x.gif"], "is 100 to 1000 pixels"),
    ],
)
def test_what_a_figure_cannot_be_is_said_in_a_line(asked, message, capsys):
    assert main(["figure", *asked]) == 2
    assert message in capsys.readouterr().err


def test_an_unknown_figure_is_bad_input(capsys):
    assert main(["figure", "nosuch"]) == 2
    assert "known: racket-frame" in capsys.readouterr().err
