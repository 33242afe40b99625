"""Files as HDF5 is given them, instead of paths: it hears of no full disk, and locks nobody out."""

import io
import os
from typing import Any


class Pinned(io.RawIOBase):
    """A file that stays what it was when it was opened, whatever is renamed to its path.

    HDF5 opens no path, and so locks none: others may write and rename as they like. Every read says where, so
    that processes forked from this one do not move its place in the file.

    Args:
        descriptor: of the file, open for reading; closed with this object.
    """

    def __init__(self, descriptor: int) -> None:
        self._descriptor, self._place = descriptor, 0
        self._found = self._stamp()

    @property
    def size(self) -> int:
        """Bytes it had when it was opened."""
        return self._found[0]

    def changed(self) -> bool:
        """Whether something was written into the file itself since it was opened."""
        return self._stamp() != self._found

    def readable(self) -> bool:
        """It is."""
        return True

    def seekable(self) -> bool:
        """It is."""
        return True

    def seek(self, offset: int, whence: int = os.SEEK_SET, /) -> int:
        """Go to a place in the file."""
        origin = {os.SEEK_SET: 0, os.SEEK_CUR: self._place, os.SEEK_END: self.size}[whence]
        self._place = origin + offset
        return self._place

    def tell(self) -> int:
        """The place in the file."""
        return self._place

    def readinto(self, buffer: Any, /) -> int:
        """Fill a buffer from here, as far as there is something."""
        count = os.preadv(self._descriptor, [buffer], self._place)
        self._place += count
        return count

    def close(self) -> None:
        """Give the file back."""
        if not self.closed:
            os.close(self._descriptor)
        super().close()

    def _stamp(self) -> tuple[int, int]:
        found = os.fstat(self._descriptor)
        return found.st_size, found.st_mtime_ns


class Lenient(io.RawIOBase):
    """A file to write, which tells its user of errors, and HDF5 of none: that would end the process.

    From the first error on nothing is written any more, and the file is worth nothing.

    Args:
        file: open for reading and writing, without a buffer; closed by whoever opened it.
    """

    def __init__(self, file: io.FileIO) -> None:
        self._file = file
        self._error: OSError | None = None

    def check(self) -> None:
        """See that all was written.

        Raises:
            OSError: the first that there was.
        """
        if self._error is not None:
            raise self._error

    def readable(self) -> bool:
        """It is."""
        return True

    def writable(self) -> bool:
        """It is, or seems so."""
        return True

    def seekable(self) -> bool:
        """It is."""
        return True

    def seek(self, offset: int, whence: int = os.SEEK_SET, /) -> int:
        """Go to a place in the file."""
        return self._file.seek(offset, whence)

    def tell(self) -> int:
        """The place in the file."""
        return self._file.tell()

    def readinto(self, buffer: Any, /) -> int | None:
        """Fill a buffer from here, as far as there is something."""
        return self._file.readinto(buffer)

    def write(self, data: Any, /) -> int:
        """Write all of it, unless there was an error."""
        left = memoryview(data).cast("B")
        try:
            while len(left) and self._error is None:  # a disk may take a part, and refuse the rest
                left = left[self._file.write(left) :]
        except OSError as error:
            self._error = error
        return memoryview(data).nbytes

    def truncate(self, size: int | None = None, /) -> int:
        """Make it as long as said, unless there was an error."""
        try:
            if self._error is None:
                self._file.truncate(size)
        except OSError as error:
            self._error = error
        return self.tell() if size is None else size
