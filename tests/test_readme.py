"""README shows what its commands print."""

import pytest
from readme import BLOCK, README, printed

TEXT = README.read_text(encoding="utf-8")
BLOCKS = BLOCK.findall(TEXT)


def test_readme_shows_commands_with_their_output() -> None:
    assert len(BLOCKS) >= 5


@pytest.mark.parametrize(("command", "output"), BLOCKS)
@pytest.mark.slow
def test_a_command_of_readme_prints_what_is_shown(command: str, output: str) -> None:
    assert printed(command, output) == output
