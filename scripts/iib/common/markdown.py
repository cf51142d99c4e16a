"""Tables in Markdown, and the parts of a document that commands write."""


def heading(names, left=None):
    """Two lines. left: names of the columns of text; only the first unless told."""
    left = names[:1] if left is None else left
    rules = "|".join("---" if name in left else "---:" for name in names)
    return [row(names), f"|{rules}|"]


def row(cells):
    return "| " + " | ".join(str(cell) for cell in cells) + " |"


def table(names, rows, left=None):
    return "\n".join([*heading(names, left), *map(row, rows)])


def with_part(text, part, body):
    """The text with another body between `<!-- part -->` and `<!-- end of part -->`.

    The text around them is written by hand.
    """
    begin, end = f"<!-- {part} -->", f"<!-- end of {part} -->"
    head, tail = text.split(begin)[0], text.split(end)[1]
    return f"{head}{begin}\n{body}\n{end}{tail}"


def write_part(path, part, body):
    path.write_text(with_part(path.read_text(), part, body))
    print(f"wrote {path}")
