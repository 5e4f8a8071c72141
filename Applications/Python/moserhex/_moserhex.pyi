"""Compiled part of the package, not for direct use."""

from typing import Any, Callable

import numpy

__version__: str

class Error(RuntimeError):
    code: str

class Mesh:
    nodes_per_side: int
    padding_layers: int
    space: str
    warnings: list[str]
    report: str
    def points(self) -> numpy.ndarray: ...
    def cells(self) -> numpy.ndarray: ...
    def quality(self, threads: int) -> str: ...
    def cube_coordinates(self, points: Any, threads: int) -> numpy.ndarray: ...
    def positions(self, cube_coordinates: Any) -> numpy.ndarray: ...
    def write(self, path: str) -> None: ...

def mesh(
    labels: Any,
    affine: Any,
    label: int | None,
    space: str,
    shells: int,
    padding: int,
    stage: str,
    way: str,
    frame: str,
    shell_method: str,
    topology: str,
    max_repair: float,
    density: Any,
    density_affine: Any,
    template: Mesh | None,
    align: str,
    landmarks: Any,
    template_landmarks: Any,
    image: Any,
    image_affine: Any,
    template_image: Any,
    template_image_affine: Any,
    local_growth: bool,
    threads: int,
    allow_partial: bool,
    progress: Callable[[float], Any] | None,
) -> Mesh: ...
def read(path: str, space: str, sandbox: bool) -> Mesh: ...
def read_labels(
    path: str, space: str, threshold: float | None, segment: str | None, sandbox: bool
) -> tuple[numpy.ndarray, numpy.ndarray, list[str]]: ...
def agreement(
    labelmaps: list[tuple[Any, Any]], space: str, disputed: float, smoothing: float
) -> tuple[numpy.ndarray, numpy.ndarray]: ...
def cell_means(
    mesh: Mesh,
    values: Any,
    affine: Any,
    boxes: int,
    order: int,
    interpolation: str,
    outside: float,
    rotate: bool,
    threads: int,
) -> numpy.ndarray: ...
def node_samples(
    mesh: Mesh, values: Any, affine: Any, interpolation: str, outside: float, rotate: bool, threads: int
) -> numpy.ndarray: ...
def cell_volumes(mesh: Mesh, boxes: int, threads: int) -> numpy.ndarray: ...
def grid_samples(
    mesh: Mesh,
    values: Any,
    affine: Any,
    shape: Any,
    sampling: str,
    interpolation: str,
    background: float,
    rotate: bool,
    threads: int,
) -> numpy.ndarray: ...
def grid_masses(
    mesh: Mesh, masses: Any, affine: Any, shape: Any, background: float, threads: int
) -> tuple[numpy.ndarray, numpy.ndarray]: ...
def compare(baseline: Mesh, follow_up: Mesh, align: str, threads: int) -> dict[str, Any]: ...
def procrustes(
    shapes: Any, align: str, tolerance: float, steps: int, threads: int
) -> tuple[numpy.ndarray, numpy.ndarray, numpy.ndarray, float, float, bool]: ...
def exact_mean(
    points: Any,
    space: str,
    nodes_per_side: int,
    padding_layers: int,
    threads: int,
    progress: Callable[[float], Any] | None,
) -> Mesh: ...
def fit_shapes(
    shapes: Any, modes: int, variance: float, threads: int
) -> tuple[numpy.ndarray, numpy.ndarray, numpy.ndarray, float, numpy.ndarray]: ...
def scores_of(mean: Any, modes: Any, shape: Any) -> numpy.ndarray: ...
def reconstruct(mean: Any, modes: Any, scores: Any) -> numpy.ndarray: ...
def group_columns(groups: Any, count: int) -> numpy.ndarray: ...
def permutation_test(
    values: Any,
    components: int,
    effect: Any,
    nuisance: Any,
    permutations: int,
    seed: int,
    threads: int,
) -> dict[str, Any]: ...
