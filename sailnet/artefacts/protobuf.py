"""Messages of protocol buffers, field by field: enough to look into a file before a library loads it."""

from collections.abc import Mapping

Fields = dict[int, list[int | bytes]]
"""Values of a message by the number of their field: whole numbers, and bytes of all else."""

_VARINT, _EIGHT, _BYTES, _FOUR = 0, 1, 2, 5


def fields_of(message: bytes, what: str, known: Mapping[int, bool]) -> Fields:
    """The fields of a message.

    Args:
        message: its bytes.
        what: it is called, for messages.
        known: numbers of the fields that it may have, and whether each may come more than once.

    Raises:
        ValueError: it ends too soon, or holds a field that it may not.
    """
    found: Fields = {number: [] for number in known}
    at = 0
    while at < len(message):
        key, at = _varint(message, at)
        number, kind = key >> 3, key & 7
        if number not in known:
            raise ValueError(f"{what} holds field {number}, which none of sailnet's does")
        value: int | bytes
        if kind == _VARINT:
            value, at = _varint(message, at)
        elif kind in (_EIGHT, _FOUR, _BYTES):
            size, at = _varint(message, at) if kind == _BYTES else ({_EIGHT: 8, _FOUR: 4}[kind], at)
            value, at = message[at : at + size], at + size
            if at > len(message):
                raise ValueError(f"{what} ends too soon")
        else:
            raise ValueError(f"{what} is no message of protocol buffers")
        if found[number] and not known[number]:
            raise ValueError(f"{what} says field {number} twice")
        found[number].append(value)
    return found


def integers(values: list[int | bytes]) -> list[int]:
    """Signed whole numbers of a repeated field, packed or not.

    Raises:
        ValueError: they are none.
    """
    numbers: list[int] = []
    for value in values:
        if isinstance(value, int):
            numbers.append(value)
            continue
        at = 0
        while at < len(value):
            number, at = _varint(value, at)
            numbers.append(number)
    return [number - (1 << 64) if number >> 63 else number for number in numbers]


def message_of(fields: Fields, number: int) -> bytes:
    """The bytes of a field that comes once; none where it is left out.

    Raises:
        ValueError: it is a number.
    """
    value = fields[number][0] if fields[number] else b""
    if isinstance(value, int):
        raise ValueError(f"field {number} is {value}, not bytes")
    return value


def messages_of(fields: Fields, number: int) -> list[bytes]:
    """The bytes of a field that may come again and again.

    Raises:
        ValueError: one is a number.
    """
    return [message_of({number: [value]}, number) for value in fields[number]]


def _varint(message: bytes, at: int) -> tuple[int, int]:
    """A whole number of up to 64 bits that begins here, and where the next thing does."""
    value = 0
    for place in range(10):
        if at + place >= len(message):
            raise ValueError("a message ends too soon")
        byte = message[at + place]
        value |= (byte & 0x7F) << (7 * place)
        if not byte & 0x80:
            if value >> 64:
                break
            return value, at + place + 1
    raise ValueError("a message holds a number of more than 64 bits")
