"""``sailnet completion``: what bash and zsh need to complete commands, options and their choices."""

import argparse
from collections.abc import Iterable

from sailnet.cli.arguments import Commands

SCRIPT = """\
if [ -n "${{ZSH_VERSION:-}}" ]; then autoload -U +X bashcompinit && bashcompinit; fi
_sailnet() {{
    local words=""
    case "${{COMP_WORDS[1]}}" in
{options}
    esac
    case "${{COMP_WORDS[1]}} ${{COMP_WORDS[COMP_CWORD-1]}}" in
{choices}
    esac
    [ "$COMP_CWORD" -gt 1 ] || words="{commands}"
    COMPREPLY=($(compgen -W "$words" -- "${{COMP_WORDS[COMP_CWORD]}}"))
}}
complete -o default -F _sailnet sailnet"""


def add(commands: Commands) -> None:
    """Add the command."""
    about = "Print what bash or zsh needs to complete commands, options and choices."
    example = 'example: eval "$(sailnet completion)"'
    completion = commands.add_parser("completion", help=about, description=about, epilog=example)
    completion.set_defaults(run=run)


def run(_options: argparse.Namespace) -> int:
    """Print the script."""
    from sailnet.cli.command_line import parser, sub_commands
    from sailnet.cli.stage import STAGES
    from sailnet.workers.stages import parser_of

    named = {**sub_commands(parser()), **{name: parser_of(one) for name, (one, _) in STAGES.items()}}
    cases, choices = [], []
    for name, one in named.items():
        cases.append(_case(name, one._option_string_actions))
        for action in one._actions:
            if known := _known(action):
                choices += [_case(f'"{name} {option}"', known) for option in action.option_strings]
    print(SCRIPT.format(options="\n".join(cases), choices="\n".join(choices), commands=" ".join(named)))
    return 0


def _case(pattern: str, words: Iterable[object]) -> str:
    return f'    {pattern}) words="{" ".join(map(str, words))}" ;;'


def _known(action: argparse.Action) -> Iterable[object]:
    from sailnet.campaign.plan import ready_campaigns
    from sailnet.mission.mission import shipped_missions

    named = {"mission": shipped_missions, "campaign": ready_campaigns}
    return named[action.dest]() if action.dest in named else action.choices or ()
