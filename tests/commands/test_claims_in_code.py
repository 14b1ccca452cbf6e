"""Claims in the comments of programs: found with their lines, and judged."""

from pathlib import Path

import pytest

from tresym.commands import main
from tresym.commands.check import read_tasks
from tresym.reals.numbers.exact import InputError

PYTHON = '''"""Sines.

# tresym: 1 < 0
"""
# tresym: abs(sin(x) - (x - x**3/6)) <= 1/100 on 0 <= x <= 1
def sine(x):
    text = "# tresym: 2 < 1"
    return x - x**3 / 6  # tresym: abs(sin(x) - (x - x**3/6)) <= 1/1000 on 0 <= x <= 1

# an ordinary comment
'''
C = """/* tresym: exp(x) >= 1 + x */
#include <math.h>
/**
 * tresym: x**2 >= 0
 */
double f(double x) { return x / 2; } ///< tresym: sqrt(x) <= 1 on 0 <= x <= 2
// a comment
int n = 7 % 2; //tresym: 1 < 2
"""


@pytest.mark.parametrize(
    ("name", "text", "lines"),
    [
        ("sines.py", PYTHON, [5, 8]),
        ("f.c", C, [1, 4, 6, 8]),
        ("f.GLSL", "// tresym: 1 < 2\nfloat a;\n", [1]),
        ("f.jl", "f(x) = x # tresym: x <= x\r\n\r\n## tresym: 1 < 2", [1, 3]),
        ("f.m", "x = 1; % tresym: 1 < 2\n%% tresym: 2 < 3\n", [1, 2]),
        ("f.f90", "x = 1 ! tresym: 1 < 2\n", [1]),
        ("f.rs", "/// Tresym: 1 < 2\nfn f() {}\n", [1]),
    ],
)
def test_lines_of_claims(tmp_path: Path, name: str, text: str, lines: list[int]) -> None:
    path = tmp_path / name
    path.write_text(text)
    assert [task.line for task in read_tasks(str(path), "", None)] == lines


@pytest.mark.parametrize(
    ("name", "text", "said"),
    [
        ("a.py", "x = 1\n1 < 2\n", "write it in a comment: # tresym: CLAIM"),
        ("a.py", 'x = "# tresym: 1 < 2"\n', "contains no claim"),
        ("a.py", "# tresym: 1 < 2\nx = '''\n", "not Python"),
        ("a.c", "# tresym: 1 < 2\n", "// tresym: CLAIM"),
        ("a.c", "x;\n// tresym:\n", "line 2: write a claim"),
        ("a.sh", "# tresym: 1 < 2 # tresym: 2 < 1\n", "line 1: write one claim"),
        ("a.c", "/* tresym: 1 < 2 */ /* tresym: 2 < 1 */\n", "line 1: write one claim"),
        ("a.c", "/* tresym: x > 0\n   given x < 0 */\n", "line 1: end the comment"),
    ],
)
def test_what_is_refused(tmp_path: Path, name: str, text: str, said: str) -> None:
    path = tmp_path / name
    path.write_text(text)
    with pytest.raises(InputError, match=said):
        list(read_tasks(str(path), "", None))


def test_a_false_claim_in_a_comment(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    # The maximum of |sin(x) - x + x**3/6| on [0, 1] is 0.00814 at x = 1.
    path = tmp_path / "sines.py"
    path.write_text(PYTHON)
    assert main(["check", "-f", str(path), "--no-suggest", "--no-cache"]) == 1
    shown = capsys.readouterr()
    assert "2 claims" in shown.err
    assert "1 REFUTED" in shown.err
    after = shown.out[shown.out.index("REFUTED") :]
    assert after.split("line", 1)[1].split()[0] == "8"
