"""What is looked at of a shared library before the system loads it: from a broken one it does not come back.

To load a library is to run it: of a stranger's that is no more than running any program of theirs. What is
refused here is what would end this process without a word, or was built for another machine.
"""

import struct
import sys
from pathlib import Path

_KIND = 18
"""Bytes of an ELF header before the machine; of them six say class and order."""


def refuse_unloadable(content: bytes) -> None:
    """See that a file is a whole shared library for this machine, where those are ELF files.

    Raises:
        ValueError: it is not.
    """
    if sys.platform != "linux":
        return
    with Path(sys.executable).open("rb") as file:
        own = file.read(_KIND + 2)
    if content[:4] != own[:4]:
        raise ValueError("it is no shared library")
    if content[4:6] != own[4:6] or content[_KIND : _KIND + 2] != own[_KIND:]:
        raise ValueError("it was compiled for another processor")
    if content[4:6] != b"\x02\x01":
        return  # not of 64 bits, little-endian: left to the system
    if len(content) < 64 or content[16:18] != b"\x03\x00":
        raise ValueError("it is no shared library")
    programs, sections = struct.unpack_from("<QQ", content, 32)
    size, count, section_size, section_count = struct.unpack_from("<HHHH", content, 54)
    if size != 56 or max(programs + size * count, sections + section_size * section_count) > len(content):
        raise ValueError("it was cut short")
    for row in range(count):
        offset, _, _, length = struct.unpack_from("<QQQQ", content, programs + size * row + 8)
        if offset + length > len(content):
            raise ValueError("it was cut short")
