"""Jobs of CalculiX, and the tables that it prints into .dat files, for the samples beside this file."""

import re

from tile_picture import BadFile, text_of

RUN_AGAIN = "run ccx again"
# Files that are included in each other.
MOST_INCLUDED = 20


def job_lines(path, remedy, above=()):
    """Yields the lines of a job and of the files that it *INCLUDEs, each with its place."""
    above = (path.resolve(), *above)
    for k, line in enumerate(text_of(path, remedy).splitlines(), 1):
        place = f"{path}:{k}"
        included = re.match(r"\*INCLUDE\s*,\s*INPUT\s*=\s*(.*?)\s*$", line, re.I)
        if included is None:
            yield place, line
            continue
        name = path.parent / included[1].strip('"')
        if name.resolve() in above or len(above) == MOST_INCLUDED:
            raise BadFile(place, f"{name} includes itself", remedy)
        if not name.is_file():
            raise BadFile(place, f"there is no file {name} to include", "put it into the folder of the job")
        yield from job_lines(name, remedy, above)


def tables_of(path, titles, remedy):
    """Returns the rows of the tables whose titles begin with one of `titles`, each with its place, by title and time."""
    text = text_of(path, remedy)
    if text and not text.endswith("\n"):
        raise BadFile(path, "it ends in the middle of a line", RUN_AGAIN)
    tables, rows = {title: {} for title in titles}, None
    for k, line in enumerate(text.splitlines(), 1):
        title = re.match(r" (\w+) .* time\s+(\S+)", line)
        if title:
            rows = tables[title[1]].setdefault(title[2], []) if title[1] in tables else None
        elif line.strip() and not re.match(r"\s*-?\d", line):
            rows = None
        elif line.strip() and rows is not None:
            rows.append((f"{path}:{k}", line.split()))
    return {title: list(by_time.values()) for title, by_time in tables.items()}
