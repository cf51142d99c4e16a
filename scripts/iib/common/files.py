"""Files that others may read while they are written."""

import os


def write_atomically(path, text):
    """A reader sees the old text or the new, never half of it."""
    temporary = path.with_name(path.name + ".part")
    temporary.write_text(text)
    os.replace(temporary, path)
