"""``tresym completion``: print what a shell needs to complete command lines."""

from __future__ import annotations

import argparse

from tresym.commands.parser import Commands, deliver

LABELLED = ("verify", "derive", "export")
"""Commands whose arguments are labels of claims."""

_SCRIPT = """\
_tresym() {{
  local word="${{COMP_WORDS[COMP_CWORD]}}" before="${{COMP_WORDS[COMP_CWORD-1]}}" words=""
  if [ "$COMP_CWORD" -eq 1 ]; then
    words="{commands}"
  elif [ "$before" = --body ]; then
    words="{bodies}"
  else
    case "${{COMP_WORDS[1]}}" in
{cases}
    esac
  fi
  COMPREPLY=($(compgen -W "$words" -- "$word"))
}}
complete -o default -F _tresym tresym
"""
_ZSH = "autoload -Uz compinit bashcompinit && compinit && bashcompinit\n"


def add(commands: Commands) -> None:
    """Add `tresym completion` to the command line."""
    parser = commands.add_parser(
        "completion",
        help="print a completion script for bash or zsh",
        description="Print a script that completes commands, options, labels and names.",
        epilog="For bash: tresym completion bash >> ~/.bashrc",
    )
    parser.add_argument("shell", choices=("bash", "zsh"), help="the shell that reads the script")


def run(args: argparse.Namespace) -> int:
    """Run the command and return its exit status."""
    from tresym.commands import build_parser
    from tresym.commands.bodies import named_bodies
    from tresym.ledger.paper import racket
    from tresym.report.charts import CHARTS

    names = {
        "table": [*racket().tables().TABLES],
        "figure": [*racket().figures().FIGURES],
        "chart": [*CHARTS],
    }
    labels = [*(claim.label for claim in racket().all_claims()), *racket().labels_by_alias]
    names |= dict.fromkeys(LABELLED, labels)
    found = _parsers(build_parser())
    cases = "\n".join(
        f'      {name}) words="{" ".join([*_options(parser), *names.get(name, [])])}";;'
        for name, parser in found.items()
    )
    script = _SCRIPT.format(commands=" ".join(found), bodies=" ".join(named_bodies()), cases=cases)
    deliver((_ZSH if args.shell == "zsh" else "") + script, None)
    return 0


def _parsers(parser: argparse.ArgumentParser) -> dict[str, argparse.ArgumentParser]:
    (found,) = (a for a in parser._actions if isinstance(a, argparse._SubParsersAction))
    return dict(found.choices)


def _options(parser: argparse.ArgumentParser) -> list[str]:
    return [name for name in parser._option_string_actions if name.startswith("--")]
