"""Jobs of CalculiX, and the tables that it prints into .dat files, for the samples beside this file."""

import math
import os
import re

from tile_picture import BadFile, text_of

RUN_AGAIN = "run ccx again"
# Files that are included in each other.
MOST_INCLUDED = 20
# CalculiX prints volumes in 7 digits; the area of a small element far from the origin loses some of them.
VOLUME_ERROR = 1e-3
# A copy of a folder may give the job a later time than its results, seconds.
LATEST_COPY = 2


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


def included_files(path, remedy):
    """Returns a job and the files that it *INCLUDEs."""
    names = {place.rpartition(":")[0] for place, _ in job_lines(path, remedy)}
    return [path, *sorted(names - {str(path)})]


def require_volumes(data, volumes, job, areas):
    """Refuses the volumes of elements that ccx printed for another mesh than that of the job, in the plane of thickness 1.

    Both are by element; elements that only one of them has do not count.
    """
    mean = sum(areas.values()) / max(len(areas), 1)
    for element, area in areas.items():
        volume = volumes.get(element, area)
        if not math.isclose(volume, area, rel_tol=VOLUME_ERROR, abs_tol=VOLUME_ERROR * VOLUME_ERROR * mean):
            raise BadFile(data, f"element {element} has the volume {volume:.7g}, and in {job} {area:.7g}, so ccx ran on "
                                "another mesh", f"run ccx {job.stem} again")


def require_newer(data, job, files):
    """Refuses results that are older than a file of the job."""
    for path in files:
        if os.path.getmtime(data) < os.path.getmtime(path) - LATEST_COPY:
            raise BadFile(data, f"it is older than {path}", f"run ccx {job.stem} again, or if the job is the same touch {data}")


def triangle_area(a, b, c):
    return ((b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1])) / 2


def wedge_volume(a, b, c, d, *_):
    """Returns the volume of a wedge over the triangle a b c, with d above a."""
    return triangle_area(a, b, c) * (d[2] - a[2])


def tetrahedron_volume(a, b, c, d):
    (ux, uy, uz), (vx, vy, vz), (wx, wy, wz) = ([q - p for p, q in zip(a, end)] for end in (b, c, d))
    return (ux * (vy * wz - vz * wy) - uy * (vx * wz - vz * wx) + uz * (vx * wy - vy * wx)) / 6
