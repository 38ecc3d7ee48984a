"""Types of the public names; the docstrings are those of the modules."""

import os
from typing import Any, Callable, Dict, List, Mapping, NamedTuple, Optional, Sequence, Tuple, Union, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

_Doubles = NDArray[np.float64]
_Integers = NDArray[np.int32]
_Records = NDArray[np.void]
_Path = Union[str, bytes, os.PathLike[str], os.PathLike[bytes]]
_Triple = Tuple[float, float, float]
_Density = Union[_Path, Callable[[_Doubles, _Doubles], Any]]
_Watch = Callable[[Progress], object]
_Shape = Tuple[Any, ...]  # ("circle", tag, x, y, r), or an ellipse or polygon
_Constants = Union[str, os.PathLike[str], Mapping[str, ArrayLike]]

__version__: str

def version() -> str: ...

class Error(Exception): ...
class Cancelled(Error): ...
class ArgumentError(Error, ValueError): ...
class DensityError(Error, ValueError): ...
class GeometryError(Error, ValueError): ...
class LimitError(Error, MemoryError): ...
class OutputError(Error, OSError): ...

class Progress(NamedTuple):
    iteration: int
    evaluations: int
    energy: float
    energy_bound: float
    residual: float
    rms_residual: float
    phase: str
    fraction: float
    phase_text: str

class Statistics(NamedTuple):
    energy: float
    energy_bound: float
    residual: float
    rms_residual: float
    seconds_build: float
    seconds_optimize: float
    valences: _Integers
    n_hexagons: int
    stop: str
    n_sites: int
    iterations: int
    evaluations: int
    n_threads: int
    n_mirrors: int
    area_error: float
    newton_steps: int
    dropped: _Integers

class TorusMesh:
    kind: str
    lattice: _Doubles
    vertices: _Doubles
    face_begin: _Integers
    corner_vertex: _Integers
    corner_offset: _Integers
    opposite: _Integers
    site: _Integers
    site_points: Optional[_Doubles]
    def __init__(self, handle: Any, view: Any) -> None: ...

class Tile:
    kind: str
    outline: str
    lattice: _Doubles
    points: _Doubles
    face_begin: _Integers
    corners: _Integers
    face_site: Optional[_Integers]
    site_points: Optional[_Doubles]
    vertex_site: Optional[_Integers]
    vertex_orbit: _Integers
    vertex_offset: _Integers
    seam: _Records
    wall_edges: _Records
    holes: List[str]
    def __init__(self, handle: Any, view: Any) -> None: ...
    def polygons(self) -> List[_Doubles]: ...
    def plot(self, axes: Any = None) -> Any: ...
    def _repr_svg_(self) -> Optional[str]: ...

class Result:
    lattice: _Doubles
    sites: _Doubles
    weights: Optional[_Doubles]
    phases: Optional[_Integers]
    phase_names: Tuple[str, ...]
    inclusions: Tuple[_Shape, ...]
    orbits: Optional[_Integers]
    orientations: Optional[_Doubles]
    def __init__(self, handle: Any, n_domains: int = 1) -> None: ...
    @property
    def statistics(self) -> Statistics: ...
    @property
    def minimum(self) -> Optional[bool]: ...
    @property
    def cells(self) -> _Records: ...
    def mesh(self, kind: str = "voronoi") -> TorusMesh: ...
    def tile(self, kind: str = "voronoi", outline: str = "whole") -> Tile: ...
    def write(
        self,
        path: Optional[_Path],
        kind: str = "voronoi",
        outline: str = "whole",
        *,
        report: Optional[_Path] = None,
        replace: bool = False,
        gltf_nodes: str = "default",
        float32: bool = False,
        pixels: int = 0,
        cut_width: float = 0.0,
        element: str = "CPE",
        job: str = "none",
        progress: Optional[_Watch] = None,
        colour: str = "default",
        background: str = "none",
        voxels: Sequence[int] = (0, 0),
        thickness: float = 0.0,
        materials: Optional[_Constants] = None,
        coriolis: Tuple[float, float] = (0.0, 0.0),
        **fields: float,
    ) -> None: ...
    def plot(self, kind: str = "voronoi", outline: str = "whole", axes: Any = None) -> Any: ...
    def _repr_svg_(self) -> Optional[str]: ...

class SpaceTile:
    lattice: _Doubles
    points: _Doubles
    point_orbit: _Integers
    point_offset: _Integers
    face_begin: _Integers
    face_points: _Integers
    n_inner_faces: int
    owner: _Integers
    neighbour: _Integers
    partner: _Integers
    partner_offset: _Integers
    volumes: _Doubles
    site_points: _Doubles
    def __init__(self, handle: Any, view: Any) -> None: ...
    def polygons(self) -> List[_Doubles]: ...

class SpaceResult:
    def __init__(self, handle: Any, known: str) -> None: ...
    @property
    def sites(self) -> _Doubles: ...
    @property
    def weights(self) -> Optional[_Doubles]: ...
    @property
    def phases(self) -> Optional[_Integers]: ...
    @property
    def phase_names(self) -> Tuple[str, ...]: ...
    @property
    def orientations(self) -> Optional[_Doubles]: ...
    @property
    def cells(self) -> _Records: ...
    @property
    def statistics(self) -> Statistics: ...
    @property
    def minimum(self) -> Optional[bool]: ...
    def tile(self) -> SpaceTile: ...
    def write(
        self,
        path: Optional[_Path],
        *,
        mesh: str = "voronoi",
        outline: str = "whole",
        surface: str = "cells",
        report: Optional[_Path] = None,
        replace: bool = False,
        progress: Optional[_Watch] = None,
        voxels: Sequence[int] = (0, 0, 0),
        materials: Optional[_Constants] = None,
        colour: str = "default",
        job: str = "none",
        **fields: float,
    ) -> None: ...

class CheckResult:
    lines: Tuple[str, ...]
    refuted: Tuple[str, ...]
    def __init__(self, verdicts: Sequence[Tuple[str, bool, str]]) -> None: ...
    def __bool__(self) -> bool: ...

class StudyResult:
    name: str
    tables: Dict[str, _Records]
    notes: Dict[str, List[str]]
    pictures: Dict[str, str]
    def __init__(self, handle: Any) -> None: ...
    @property
    def table(self) -> _Records: ...
    @property
    def runs(self) -> _Records: ...
    def _repr_svg_(self) -> Optional[str]: ...

# Three period vectors are known by their tuples; for those in an array call space(), or state the type of the result.
@overload
def mesh(  # type: ignore[misc]
    sites: ArrayLike, lattice: None = None, density: None = None, *, period: _Triple, **options: Any
) -> SpaceResult: ...
@overload
def mesh(  # type: ignore[misc]
    sites: ArrayLike, lattice: Tuple[_Triple, _Triple, _Triple], density: None = None, **options: Any
) -> SpaceResult: ...
@overload
def mesh(
    sites: ArrayLike,
    lattice: Optional[ArrayLike] = None,
    density: Optional[_Density] = None,
    *,
    period: Optional[ArrayLike] = None,
    density_range: Tuple[float, float] = (0, 0),
    origin: Union[str, ArrayLike] = (0, 0),
    repeat: Tuple[int, ...] = (1, 1),
    seed: int = 0,
    start: str = "default",
    solver: str = "default",
    tolerance: float = 1e-6,
    max_iterations: int = -1,
    threads: int = 0,
    grain_order: int = 0,
    grain_size: float = 0.0,
    grain_per_edge: int = 0,
    short_edges: float = 0.0,
    budget: int = 0,
    progress: Optional[_Watch] = None,
    areas: Optional[ArrayLike] = None,
    volumes: Union[None, str, ArrayLike] = None,
    weights: Optional[ArrayLike] = None,
    aspect: Union[float, Tuple[float, float], Tuple[float, ArrayLike]] = 1.0,
    phases: Union[None, str, Mapping[str, float], Sequence[str]] = None,
    orientations: Optional[ArrayLike] = None,
    orientation_weights: Optional[ArrayLike] = None,
    symmetry: Optional[str] = None,
    walls: str = "none",
    wall_cells: str = "whole",
    fixed: Optional[ArrayLike] = None,
    inclusions: Union[None, str, Sequence[_Shape]] = None,
    fibres: Optional[Tuple[float, ...]] = None,
    holes: Union[str, Sequence[str]] = (),
    duplicates: str = "refuse",
    sites_are_centroids: bool = False,
    **fields: float,
) -> Result: ...
def space(
    sites: ArrayLike,
    lattice: Optional[ArrayLike] = None,
    *,
    period: Optional[ArrayLike] = None,
    seed: int = 0,
    start: str = "default",
    solver: str = "default",
    tolerance: float = 1e-6,
    max_iterations: int = -1,
    threads: int = 0,
    short_edges: float = 0.0,
    progress: Optional[_Watch] = None,
    duplicates: str = "refuse",
    **fields: float,
) -> SpaceResult: ...
@overload
def pattern(  # type: ignore[misc]
    sites: int, lattice: None = None, *, period: _Triple, **options: Any
) -> SpaceResult: ...
@overload
def pattern(  # type: ignore[misc]
    sites: int, lattice: Tuple[_Triple, _Triple, _Triple], **options: Any
) -> SpaceResult: ...
@overload
def pattern(
    sites: int, lattice: Optional[ArrayLike] = None, *, period: Optional[ArrayLike] = None, **options: Any
) -> Result: ...
def check(
    path: Union[_Path, Sequence[_Path]],
    *,
    lattice: Optional[ArrayLike] = None,
    period: Optional[ArrayLike] = None,
    tolerance: Optional[float] = None,
    cvt: Optional[float] = None,
    areas: Optional[_Path] = None,
    inclusions: Optional[_Path] = None,
    density: Optional[_Path] = None,
    density_range: Tuple[float, float] = (0, 0),
    progress: Optional[_Watch] = None,
    volumes: Optional[_Path] = None,
) -> CheckResult: ...
def study(
    name: str,
    sites: Union[None, int, Sequence[int], _Integers] = None,
    runs: Optional[int] = None,
    seed: Optional[int] = None,
    *,
    threads: int = 0,
    path: Optional[_Path] = None,
    replace: bool = False,
    progress: Optional[_Watch] = None,
) -> StudyResult: ...
