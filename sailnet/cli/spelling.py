"""What was probably meant by a misspelt command or option, and letters where a terminal has only some."""

import argparse
import codecs
import io
import re
import unicodedata
from collections.abc import Sequence
from typing import IO, Any, NoReturn

from sailnet.errors import did_you_mean

PLAIN = {"°": " deg", "–": "-", "−": "-", "±": "+-", "²": "^2", "µ": "mu", "λ": "lambda"}
"""What stands for letters that ASCII has not; Greek ones have their own names, but for Unicode's lamda."""

CODEC = "sailnet.plain"

LONGEST_USAGE = 6
"""Lines of options before an error, which would be looked for in vain below more of them."""


EXAMPLE = "example: "


class _OneExampleALine(argparse.HelpFormatter):
    def _fill_text(self, text: str, width: int, indent: str) -> str:
        if not text.startswith(EXAMPLE):
            return super()._fill_text(text, width, indent)
        return text.replace("; ", "\n" + " " * len(EXAMPLE))


class HelpfulParser(argparse.ArgumentParser):
    """Refuses with the name of what was probably meant; its sub-commands do likewise.

    An epilog of examples, one after the other behind semicolons, has each whole on a line.
    """

    def __init__(self, *args: Any, **given: Any) -> None:
        super().__init__(*args, **{"formatter_class": _OneExampleALine, **given})

    def parse_known_args(self, args=None, namespace=None):  # type: ignore[no-untyped-def]
        """Of all arguments: what is not known is refused here, where the options of a sub-command are."""
        found, unknown = super().parse_known_args(args, namespace)
        if unknown:
            self.error(f"unrecognized arguments: {' '.join(unknown)}{self._meant(unknown)}")
        return found, unknown

    def error(self, message: str) -> NoReturn:
        """End with status 2."""
        wrong = re.search(r"invalid choice: '(.*)' \(choose from (.*)\)", message)
        known = [] if wrong is None else re.findall(r"'(.*?)'", wrong[2])
        message += "" if wrong is None else did_you_mean(wrong[1], known)
        self.exit(2, f"{self._short_usage()}{self.prog}: error: {message}\n")

    def _short_usage(self) -> str:
        whole = self.format_usage()
        if whole.count("\n") <= LONGEST_USAGE:
            return whole
        taken = self._get_formatter()
        taken.add_usage(None, self._get_positional_actions(), [])
        return f"{taken.format_help().rstrip()} [OPTIONS]; {self.prog} --help has them\n"

    def _meant(self, unknown: Sequence[str]) -> str:
        option = unknown[0].partition("=")[0]
        return did_you_mean(option, self._option_string_actions) if option.startswith("--") else ""


def in_letters_it_has(stream: IO[str]) -> None:
    """Let a stream write words for the letters that its encoding has not, rather than fail."""
    if isinstance(stream, io.TextIOWrapper):
        codecs.register_error(CODEC, _spelt)
        stream.reconfigure(errors=CODEC)


def _spelt(error: UnicodeError) -> tuple[str, int]:
    assert isinstance(error, UnicodeEncodeError)
    return "".join(map(_plain, error.object[error.start : error.end])), error.end


def _plain(letter: str) -> str:
    greek = re.fullmatch(r"GREEK (?:SMALL|CAPITAL) LETTER (\w+)", unicodedata.name(letter, ""))
    return PLAIN.get(letter) or (greek[1].lower() if greek else "?")
