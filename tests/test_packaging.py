"""Wheel, sdist → wheel and editable installs verify from any folder, under one import name."""

import json
import os
import subprocess
import sys
import tarfile
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parent.parent

pytestmark = pytest.mark.slow


def run(*command: str, cwd: Path, path: Path | None = None) -> str:
    environment = {**os.environ}
    if path is not None:
        environment["PYTHONPATH"] = str(path)
    done = subprocess.run(command, cwd=cwd, env=environment, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


def build(source: Path, kind: str, into: Path) -> Path:
    run(sys.executable, "-m", "hatchling", "build", "-t", kind, "-d", str(into), cwd=source)
    return next(into.glob("*.whl" if kind == "wheel" else "*.tar.gz"))


def unpack(wheel: Path, into: Path) -> Path:
    pip = (sys.executable, "-m", "pip", "install", "--quiet", "--no-deps", "--no-index")
    run(*pip, "--target", str(into), str(wheel), cwd=into.parent)
    return into


@pytest.fixture(scope="module", params=["editable", "wheel", "sdist to wheel"])
def installed(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The folder to put first on the path."""
    folder = tmp_path_factory.mktemp("install")
    if request.param == "editable":
        return ROOT
    source = ROOT
    if request.param == "sdist to wheel":
        with tarfile.open(build(ROOT, "sdist", folder)) as archive:
            archive.extractall(folder / "source", filter="data")
        source = next((folder / "source").iterdir())
    return unpack(build(source, "wheel", folder), folder / "site")


def test_verify_runs_from_any_folder(installed: Path, tmp_path: Path) -> None:
    where = run(
        sys.executable, "-c", "import tresym; print(tresym.__file__)", cwd=tmp_path, path=installed
    )
    assert Path(where.strip()).is_relative_to(installed)
    printed = run(
        sys.executable, "-m", "tresym", "verify", "eq_gamma", "--json", cwd=tmp_path, path=installed
    )
    claims = json.loads(printed)["claims"]
    assert {c["verdict"] for c in claims} == {"PROVED", "DEFINED", "ASSUMED"}
    assert [c["label"] for c in claims if c["requested"]] == ["eq_gamma"]


def test_the_proofs_have_one_import_name(installed: Path, tmp_path: Path) -> None:
    code = "import tresym.proofs, sys; print('proofs' in sys.modules)"
    assert run(sys.executable, "-c", code, cwd=tmp_path, path=installed).strip() == "False"


def test_what_only_developers_run_is_not_in_the_wheel(installed: Path, tmp_path: Path) -> None:
    environment = {**os.environ, "PYTHONPATH": str(installed)}
    for words in (["bench", "turn"], ["verify", "--mutants", "eq_gamma"]):
        if installed == ROOT:
            continue
        done = subprocess.run(
            [sys.executable, "-m", "tresym", *words],
            cwd=tmp_path,
            env=environment,
            capture_output=True,
            text=True,
        )
        assert done.returncode == 2
        assert "runs only in a source checkout" in done.stderr
        assert done.stderr.count("\n") == 1
    assert (installed / "tresym" / "dev").exists() is (installed == ROOT)
    assert "bench" in run(sys.executable, "-m", "tresym", "--help", cwd=tmp_path, path=installed)
