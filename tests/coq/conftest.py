"""What the tests of Coq share: the compiled lemmas, which take minutes."""

import pytest

from tresym.coq import coqtop


@pytest.fixture(scope="session", autouse=True)
def compiled_once(tmp_path_factory: pytest.TempPathFactory) -> None:
    """Keep compiled lemmas where the other processes of this run find them."""
    folder = tmp_path_factory.getbasetemp()
    shared = folder.parent if "popen-gw" in folder.name else folder
    coqtop.cache_folder = lambda: shared
