"""Many meshes of one organ: their mean, how they vary, how groups differ."""

from __future__ import annotations

import dataclasses
from typing import Any, Callable, List, Optional, Sequence, Union

import numpy

from . import _moserhex
from ._mesh import Array, Mesh

Shapes = Union[Array, Sequence[Mesh]]


@dataclasses.dataclass(frozen=True)
class Procrustes:
    """Shapes of S subjects with P points each, brought onto their mean.

    mean       (P, 3) mean of the aligned shapes [mm]
    aligned    (S, P, 3) [mm]
    matrices   (S, 4, 4) of every subject onto the mean
    size       mean centroid size, sqrt(sum |p - centroid|^2), of the subjects as they are [mm]
    deviation  root mean square distance of aligned points to the mean's [mm]
    converged  the mean no longer moved
    """

    mean: numpy.ndarray
    aligned: numpy.ndarray
    matrices: numpy.ndarray
    size: float
    deviation: float
    converged: bool


@dataclasses.dataclass(frozen=True)
class ShapeModel:
    """Shapes as a mean and K directions of change: shape = mean + sum of scores times modes.

    mean            (P, 3) [mm]
    modes           (K, P, 3), orthonormal [1]
    variances       (K,) of the subjects' scores, descending [mm^2]
    total_variance  of all modes, also those not kept [mm^2]
    scores          (S, K) of the subjects [mm]
    """

    mean: numpy.ndarray
    modes: numpy.ndarray
    variances: numpy.ndarray
    total_variance: float
    scores: numpy.ndarray

    def scores_of(self, shape: Array) -> numpy.ndarray:
        """(K,) scores [mm] of a shape, (P, 3), aligned as the model's subjects were."""
        return _moserhex.scores_of(self.mean, self.modes, shape)

    def reconstruct(self, scores: Array) -> numpy.ndarray:
        """(P, 3) [mm], the shape of these scores; missing ones at the end are 0.

        `sqrt(variances[m])` is one standard deviation of mode m.
        """
        return _moserhex.reconstruct(self.mean, self.modes, scores)


@dataclasses.dataclass(frozen=True)
class PermutationTest:
    """One entry for each of L places.

    slope                    (L, q) group 1 less group 0, or change per unit of the covariate [unit of the values];
                             (L, h, q) where the effect has h columns
    pillai_trace             (L,) in [0, min(q, h)] [1]
    statistic                (L,) of one column Hotelling's T^2, of one component, too, t^2 [1]
    p                        (L,) of the place alone
    p_family_wise            (L,) corrected for the search over all places
    q_false_discovery        (L,) smallest false discovery rate at which the place counts
    partial_correlation      (L,) in [0, 1], of one number and one effect with the slope's sign; its square is the partial
                             eta squared
    standardised_difference  (L,) of two groups Cohen's d with its sign, of vectors Mahalanobis' D; else None
    permutations             made, the subjects' own order among them
    is_exact                 they are all that there are, and there is no nuisance: p are exact
    smallest_possible_p      below it no p and no p_family_wise can be with these orders
    nuisance_left_out        columns of the nuisance that are constant, or follow from those before them
    degrees_of_freedom       subjects less the rank of constant, nuisance and effect
    """

    slope: numpy.ndarray
    pillai_trace: numpy.ndarray
    statistic: numpy.ndarray
    p: numpy.ndarray
    p_family_wise: numpy.ndarray
    q_false_discovery: numpy.ndarray
    partial_correlation: numpy.ndarray
    standardised_difference: Optional[numpy.ndarray]
    permutations: int
    is_exact: bool
    smallest_possible_p: float
    nuisance_left_out: List[int]
    degrees_of_freedom: int


def procrustes(
    shapes: Shapes, *, align: str = "rigid", tolerance: float = 1e-10, steps: int = 100, threads: int = 0
) -> Procrustes:
    """Bring shapes onto their mean, generalised Procrustes analysis.

    shapes     (S, P, 3) [mm], or meshes of as many nodes, taken in the space of the first
    align      "rigid", "similarity" (and sizes made equal), or "none"
    tolerance  done when the mean moves by less, over its centroid size; at most `steps` times

    Raises Error: E_PRECONDITION, E_DIMENSION, E_USAGE.
    """
    return Procrustes(*_moserhex.procrustes(_points_of(shapes), align, tolerance, steps, threads))


def mean_mesh(
    meshes: Sequence[Mesh],
    *,
    align: str = "rigid",
    threads: int = 0,
    progress: Optional[Callable[[float], Any]] = None,
) -> Mesh:
    """Mean of meshes, itself of equal volumes: what `moserhex atlas` calls mean.

    The nodes' mean after `procrustes`, moved as little as makes all cells equal. What of that was not reached is in its
    `warnings`. `progress` as in `mesh`; Ctrl-C ends the work.

    Raises Error: E_PRECONDITION, E_USAGE.
    """
    points = procrustes(meshes, align=align, threads=threads).mean
    first = meshes[0]
    return Mesh(
        _moserhex.exact_mean(points, first.space, first.nodes_per_side, first.padding_layers, threads, progress)
    )


def fit_shapes(
    shapes: Shapes, *, modes: Optional[int] = None, variance: float = 1.0, threads: int = 0
) -> ShapeModel:
    """Principal components of shapes that are aligned already, such as `procrustes(...).aligned`.

    shapes    (S, P, 3) [mm], S >= 2, or meshes
    modes     most to keep; None: all
    variance  so many modes as hold this part of the total variance, in (0, 1]

    Raises Error: E_PRECONDITION, E_DIMENSION, E_USAGE.
    """
    if modes is not None and modes < 1:
        modes = -1  # 0 means all to the library
    return ShapeModel(*_moserhex.fit_shapes(_points_of(shapes), modes or 0, variance, threads))


def group_columns(groups: Array) -> Array:
    """The effect of k groups for `permutation_test`, (S, k - 1): column g is 1 for the subjects of group g + 1, else 0.

    groups  (S,) words or numbers, none missing (None, NaN, "NA"); group 0 is the first of them in order

    Raises Error: E_PRECONDITION, E_DIMENSION.
    """
    for number, group in enumerate(numpy.ravel(numpy.asarray(groups, dtype=object))):
        if group is None or group != group or str(group).lower() in ("", "n/a", "na", "nan", "null", "."):
            raise _precondition(f"the group of subject {number} is missing: leave the subject out")
    names, numbers = numpy.unique(groups, return_inverse=True)
    return _moserhex.group_columns(numbers.reshape(numpy.shape(groups)), len(names))


def permutation_test(
    values: Shapes,
    effect: Array,
    *,
    nuisance: Optional[Array] = None,
    permutations: int = 10000,
    seed: int = 1,
    threads: int = 0,
) -> PermutationTest:
    """Does an effect explain the subjects' numbers, at every place, beyond a constant and nuisance covariates?

    values        (S, L): one number a place; or (S, L, q), q up to 3, such as aligned shapes; or meshes
    effect        (S,): 0 and 1 for two groups, or a covariate; (S, h): columns tested together, as of `group_columns`
    nuisance      (S, Z): what else explains the numbers, for example age and volume
    permutations  by Freedman and Lane; all there are, when these are not more
    seed          the same numbers give the same result

    Raises Error: E_PRECONDITION, E_DIMENSION, E_USAGE.
    """
    table = numpy.asarray(_points_of(values))
    components = table.shape[2] if table.ndim == 3 else 1
    if table.ndim == 3:
        table = table.reshape(table.shape[0], -1)
    columns = numpy.asarray(effect)
    if columns.ndim == 1:
        columns = columns[:, None]
    if nuisance is None:
        nuisance = numpy.zeros((columns.shape[0] if columns.ndim else 0, 0))
    result = _moserhex.permutation_test(table, components, columns, nuisance, permutations, seed, threads)
    if numpy.ndim(effect) == 2:
        result["slope"] = result["slope"].reshape(-1, columns.shape[1], components)
    return PermutationTest(**result)


def _precondition(message: str) -> Exception:
    error = _moserhex.Error(message)
    error.code = "E_PRECONDITION"
    return error


def _points_of(shapes: Shapes) -> Array:
    """The nodes of meshes in the space of the first, (S, P, 3); anything else as it is."""
    if isinstance(shapes, numpy.ndarray) or len(shapes) == 0 or not all(isinstance(one, Mesh) for one in shapes):
        return shapes
    first = shapes[0]
    for number, mesh in enumerate(shapes):
        if (mesh.nodes_per_side, mesh.padding_layers) != (first.nodes_per_side, first.padding_layers):
            raise _precondition(f"mesh {number} of {len(shapes)}: other nodes than mesh 0, mesh all alike")
    flip = numpy.array([-1.0, -1.0, 1.0])
    return numpy.stack([mesh.points if mesh.space == first.space else mesh.points * flip for mesh in shapes])
