"""Tell whose mistake an error is."""

from __future__ import annotations

import errno


def is_utf8(text: str) -> bool:
    """Whether every character of an argument could be read."""
    try:
        text.encode()
    except UnicodeEncodeError:
        return False
    return True


def is_disk_failure(error: Exception) -> bool:
    """Whether it is the disk that failed and not the user who named a wrong file."""
    failures = {errno.ENOSPC, errno.EDQUOT, errno.EFBIG, errno.EROFS, errno.EIO}
    return isinstance(error, OSError) and error.errno in failures
