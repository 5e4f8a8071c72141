#!/usr/bin/python3
"""Makes the pictures of these pages and ../moserhex.png again.

    /usr/bin/python3 Documentation/Theory/make_figures.py BUILD_FOLDER [--only A B ...] [--work FOLDER]

Drives BUILD_FOLDER/Applications/MoserHex/moserhex on its embedded sample, reads the meshes it writes, and computes from
the pages' formulas what the command does not write. Prints every number that the pages quote from here. The same files
give the same bytes. Needs Debian's python3-numpy, python3-matplotlib, python3-pil, python3-vtk9.
"""

import argparse
import subprocess
import sys
import tempfile
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.cm import ScalarMappable
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.colors import Normalize, TwoSlopeNorm
from PIL import Image

import flow_reference as flow
import lattice_files as files
import sphere_reference as sphere

FOLDER = Path(__file__).resolve().parent
SHELLS = 10
PASSES = 4  # of the area flow in the picture of page E
INK = "#222222"
PAPER = "#ffffff"

plt.rcParams.update({"font.size": 9, "font.family": "DejaVu Sans", "axes.edgecolor": INK, "axes.labelcolor": INK,
                     "xtick.color": INK, "ytick.color": INK, "text.color": INK, "axes.titlesize": 9,
                     "svg.hashsalt": "moserhex", "svg.fonttype": "none", "axes.spines.top": False,
                     "axes.spines.right": False})


class Sample:
    """Runs the command once for each mesh that is asked for."""

    def __init__(self, command, folder):
        self.command, self.folder, self.meshes = command, Path(folder), {}
        self.folder.mkdir(parents=True, exist_ok=True)
        if not (self.folder / "prostate.nrrd").exists():
            self.run("sample", str(self.folder))

    def run(self, *arguments):
        subprocess.run([str(self.command), *arguments], check=True, stdout=subprocess.DEVNULL)

    def labelmap(self):
        return files.read_nrrd(self.folder / "prostate.nrrd")

    def mesh(self, stage="moser", method="chan-vese", shells=SHELLS):
        name = f"{stage}-{method}-{shells}.vtu"
        if name not in self.meshes:
            if not (self.folder / name).exists():
                self.run("mesh", str(self.folder / "prostate.nrrd"), str(self.folder / name), "--quiet", "--stage", stage,
                         "--shell-method", method, "--shells", str(shells))
            self.meshes[name] = files.read_mesh(self.folder / name)
        return self.meshes[name]


# ---- drawing ----------------------------------------------------------------------------------------------------

def shell_colours(shells):
    """One colour for each shell, innermost first."""
    return plt.get_cmap("turbo")(np.linspace(0.9, 0.12, shells))[:, :3]


def save(figure, name, dpi=110):
    path = FOLDER / "figures" / name if "/" not in name else FOLDER / name
    path.parent.mkdir(exist_ok=True)
    metadata = {"Date": None} if path.suffix == ".svg" else {"Software": None}
    figure.savefig(path, dpi=dpi, facecolor=PAPER, metadata=metadata)
    plt.close(figure)
    if path.suffix == ".png":  # 255 colours are enough and a third of the size
        Image.open(path).convert("RGB").quantize(255, Image.MAXCOVERAGE, dither=Image.NONE).save(path, optimize=True)
    print(f"{path.relative_to(FOLDER.parent)}  {path.stat().st_size / 1000:.0f} kB")


def view_basis(towards, up=(0, 0, 1)):
    """Rows: right, up and towards the eye."""
    eye = np.array(towards, float) / np.linalg.norm(towards)
    right = np.cross(up, eye)
    right /= np.linalg.norm(right)
    return np.array([right, np.cross(eye, right), eye])


def draw_solid(axes, polygons, colours, basis, shade=0.55, line=0.25, edge=(0, 0, 0, 0.55)):
    """Outward polygons (m x 4 x 3 or m x 3 x 3), far ones first; light comes from the eye's upper left."""
    projected = polygons @ basis.T
    normal = np.cross(projected[:, 2] - projected[:, 0], projected[:, -1] - projected[:, 1]
                      if projected.shape[1] == 4 else projected[:, 2] - projected[:, 1])
    normal /= np.maximum(np.linalg.norm(normal, axis=1, keepdims=True), 1e-12)
    light = np.array([-0.35, 0.5, 0.8]) / np.linalg.norm([-0.35, 0.5, 0.8])
    visible = normal[:, 2] > 0
    order = np.argsort(projected[visible, :, 2].mean(1), kind="stable")
    bright = (1 - shade) + shade * np.clip(normal[visible] @ light, 0, 1)
    rgb = np.clip(colours[visible] * bright[:, None], 0, 1)[order]
    axes.add_collection(PolyCollection(projected[visible][order][:, :, :2], facecolors=rgb, edgecolors=edge,
                                       linewidths=line))
    fit(axes, projected[:, :, :2].reshape(-1, 2))


def fit(axes, points, margin=0.03):
    low, high = points.min(0), points.max(0)
    pad = margin * (high - low).max()
    axes.set_xlim(low[0] - pad, high[0] + pad)
    axes.set_ylim(low[1] - pad, high[1] + pad)
    axes.set_aspect("equal")
    axes.axis("off")


def draw_slice(axes, mesh, values, colours, plane, line=0.35):
    """Cells cut by a plane (origin, right, up), coloured by values[cell] through `colours`."""
    origin, right, up = plane
    polygons, index = files.cut_cells(mesh, origin, np.cross(right, up))
    flat = [np.column_stack([(p - origin) @ right, (p - origin) @ up]) for p in polygons]
    axes.add_collection(PolyCollection(flat, facecolors=colours(files.at(values, index)), edgecolors=(0, 0, 0, 0.75),
                                       linewidths=line))
    fit(axes, np.concatenate(flat))


def organ_centre(mesh):
    """Two millimetres beside the centroid: the lattice's own middle planes would be cut lengthwise."""
    return mesh.nodes.reshape(-1, 3).mean(0) + 2.0


def coronal(mesh):
    """Seen from the front: the patient's left on the right."""
    return organ_centre(mesh), np.array([1.0, 0, 0]), np.array([0, 0, 1.0])


def sagittal(mesh):
    return organ_centre(mesh), np.array([0, 1.0, 0]), np.array([0, 0, 1.0])


def by_shell(mesh):
    palette = shell_colours(mesh.shells)
    return files.cell_shells(mesh.n), lambda shell: palette[shell - 1]


def bar(figure, axes, mapping, label, ticks=None):
    colourbar = figure.colorbar(mapping, ax=axes, shrink=0.75, pad=0.02, ticks=ticks)
    colourbar.set_label(label)
    colourbar.outline.set_linewidth(0.5)
    return colourbar


# ---- the pages' pictures ----------------------------------------------------------------------------------------

def figure_a(sample):
    label, mesh = sample.labelmap(), sample.mesh("initial")
    inside = np.argwhere(label.inside)
    step = np.linalg.norm(label.axes, axis=0)
    unit = label.axes / step
    middle = np.round(inside.mean(0)).astype(int)
    figure, panels = plt.subplots(1, 2, figsize=(8.4, 3.7), constrained_layout=True)
    vertices, triangles = files.triangulated_shell(mesh, mesh.shells)
    for axes, (across, title) in zip(panels, ((0, "across the slices"), (2, "within a slice"))):
        first, second = [a for a in range(3) if a != across]
        index = [slice(None)] * 3
        index[across] = middle[across]
        mask = label.inside[tuple(index)]
        boxes = []
        for a, b in np.argwhere(mask):
            x, y = a * step[first], b * step[second]
            hx, hy = step[first] / 2, step[second] / 2
            boxes.append([(x - hx, y - hy), (x + hx, y - hy), (x + hx, y + hy), (x - hx, y + hy)])
        axes.add_collection(PolyCollection(boxes, facecolors="#bcd0e6", edgecolors="#7f9fc2", linewidths=0.25))
        origin = label.origin + label.axes[:, across] * middle[across]
        segments = files.cut_surface(vertices, triangles, origin, unit[:, across])
        flat = np.stack([(segments - origin) @ unit[:, first], (segments - origin) @ unit[:, second]], -1)
        axes.add_collection(LineCollection(flat, colors="#b3261e", linewidths=1.6))
        fit(axes, np.array(boxes).reshape(-1, 2))
        axes.set_title(title)
    save(figure, "A-conditioning.png")


def neighbour_gaps(mesh):
    """Distance of every node of shell k to the triangles of shell k-1's nodes, as the layer's mean: rows by k."""
    shell = files.shell_of_node(mesh.n)
    rows = []
    for k in range(2, mesh.shells + 1):
        index = np.argwhere(shell == k)
        low, high = mesh.shells - (k - 1), mesh.shells + (k - 1) - 1
        rows.append(np.linalg.norm(files.at(mesh.nodes, index) - files.at(mesh.nodes, index.clip(low, high)), axis=1))
    return rows


def figure_b(sample):
    methods = (("chan-vese", "coupled Chan-Vese front"), ("eikonal", "eikonal front"), ("snapshots", "plain snapshots"))
    figure, panels = plt.subplots(2, 3, figsize=(9.0, 5.6), constrained_layout=True,
                                  gridspec_kw={"height_ratios": [1.25, 1]})
    largest = 0.0
    for column, (method, title) in enumerate(methods):
        mesh = sample.mesh("initial", method)
        draw_slice(panels[0, column], mesh, *by_shell(mesh), coronal(mesh), line=0.3)
        panels[0, column].set_title(title)
        gaps = neighbour_gaps(mesh)
        mean = np.mean([g.mean() for g in gaps])
        relative = [g / mean for g in gaps]
        variance = flow.volume_variance(mesh.nodes)
        print(f"B: {method}: smallest node gap {min(g.min() for g in relative):.3f}, largest "
              f"{max(g.max() for g in relative):.2f} of the mean; volume variance after stage G {variance:.3g}")
        axes = panels[1, column]
        parts = axes.violinplot(relative, range(2, mesh.shells + 1), widths=0.85, showextrema=True)
        for body, colour in zip(parts["bodies"], shell_colours(mesh.shells)[1:]):
            body.set(facecolor=colour, alpha=0.85)
        for name in ("cmins", "cmaxes", "cbars"):
            parts[name].set(color=INK, linewidth=0.6)
        axes.set_xlabel("shell k")
        largest = max(largest, max(g.max() for g in relative))
    panels[1, 0].set_ylabel("distance of nodes to shell k-1,\nover the mean of all")
    for axes in panels[1]:
        axes.set_ylim(0, 1.05 * largest)
        axes.axhline(1, color=INK, linewidth=0.4)
    save(figure, "B-shells.png")


KUHN = [[0, 1, 3, 7], [0, 1, 5, 7], [0, 2, 3, 7], [0, 2, 6, 7], [0, 4, 5, 7], [0, 4, 6, 7]]


def marching_tetrahedra(values, spacing, level=0.0):
    """The piecewise linear level set on the Kuhn complex, as loose triangles m x 3 x 3 (orientation as it comes)."""
    n = np.array(values.shape) - 1
    base = np.stack(np.meshgrid(*[np.arange(m) for m in n], indexing="ij"), -1).reshape(-1, 3)
    corner = np.array([[c & 1, c >> 1 & 1, c >> 2] for c in range(8)])
    triangles = []
    for tetrahedron in KUHN:
        node = base[:, None, :] + corner[tetrahedron][None]
        f = files.at(values, node) - level
        inside = f < 0
        for count in (1, 2, 3):
            pick = inside.sum(1) == count
            if not pick.any():
                continue
            order = np.argsort(~inside[pick], axis=1, kind="stable")
            p = np.take_along_axis(node[pick], order[:, :, None], 1).astype(float)
            v = np.take_along_axis(f[pick], order, 1)

            def cross(a, b):
                weight = (v[:, a] / (v[:, a] - v[:, b]))[:, None]
                return (1 - weight) * p[:, a] + weight * p[:, b]

            if count == 1:
                triangles.append(np.stack([cross(0, 1), cross(0, 2), cross(0, 3)], 1))
            elif count == 3:
                triangles.append(np.stack([cross(0, 3), cross(1, 3), cross(2, 3)], 1))
            else:
                a, b, c, d = cross(0, 2), cross(0, 3), cross(1, 3), cross(1, 2)
                triangles += [np.stack([a, b, c], 1), np.stack([a, c, d], 1)]
    return np.concatenate(triangles) * spacing


def figure_c(_):
    h, size = 0.125, 27
    axis = (np.arange(size) - size // 2) * h + 0.031
    x, y, z = np.meshgrid(axis, axis, axis, indexing="ij")
    values = np.sqrt(x**2 / 1.44 + y**2 + z**2 / 1.21) - 1
    triangles = marching_tetrahedra(values, h)
    centre = triangles.reshape(-1, 3).mean(0)
    outward = np.einsum("fi,fi->f", np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0]),
                        triangles.mean(1) - centre)
    triangles[outward < 0] = triangles[outward < 0][:, ::-1]
    angle = sphere.corner_angles(triangles.reshape(-1, 3), np.arange(3 * len(triangles)).reshape(-1, 3)).min(1)
    print(f"C: marching tetrahedra of an ellipsoid: {len(triangles)} triangles, smallest angle {angle.min():.2f} degrees, "
          f"{100 * (angle < 20).mean():.0f} % below 20 degrees")
    figure, (left, right) = plt.subplots(1, 2, figsize=(8.4, 3.6), constrained_layout=True,
                                         gridspec_kw={"width_ratios": [1, 1.15]})
    norm, cmap = Normalize(0, 60), plt.get_cmap("RdYlBu")
    draw_solid(left, triangles, cmap(norm(angle))[:, :3], view_basis((0.8, -0.6, 0.5)), shade=0.25, line=0.15)
    bar(figure, left, ScalarMappable(norm, cmap), "smallest angle [degrees]")
    right.hist(angle, np.arange(0, 61, 2), color="#7f9fc2", edgecolor=PAPER, linewidth=0.4)
    right.axvline(20, color="#b3261e", linewidth=1)
    right.text(0.5, 1.02, "slivers", transform=right.get_xaxis_transform(), color="#b3261e")
    right.set(xlabel="smallest angle of a triangle [degrees]", ylabel="triangles", xlim=(0, 60))
    save(figure, "C-surfaces.png")


def sphere_stages(sample, cache={}):
    """A shell of the sample and its maps, by the pages' formulas: conformal, centred, after Moser passes, barrier."""
    if not cache:
        x, t = files.triangulated_shell(sample.mesh("initial", shells=8), 8)
        removed = sphere.triangle_towards(x, t, np.array([0, 0, 1.0]))
        conformal, residual = sphere.conformal_map(x, t, removed)
        misprinted, misprint = sphere.conformal_map(x, t, removed, +1.0)
        angles = sphere.corner_angles(x, t)
        errors = [np.abs(sphere.corner_angles(s, t) - angles).mean() for s in (conformal, misprinted)]
        print(f"D: residuals of D x = a, D y = b: {residual[0]:.0e}, {residual[1]:.0e}, mean angle error {errors[0]:.2f} "
              f"degrees; with b_C = +1/|C-E|: {misprint[0]:.0e}, {misprint[1]:.0e}, {errors[1]:.2f} degrees")
        conformal = sphere.body_frame(x, t, conformal)
        centred = sphere.body_frame(x, t, sphere.moebius_centred(x, t, conformal))
        area = sphere.vertex_shares(t, sphere.triangle_areas(x, t), len(x))
        moser, history = centred, [sphere.area_rms(x, t, centred)]
        for _ in range(PASSES):
            share = sphere.vertex_shares(t, sphere.solid_angles(moser, t), len(x))
            moser = sphere.moser_pass(t, moser, area / share)
            history.append(sphere.area_rms(x, t, moser))
        barrier = sphere.body_frame(x, t, sphere.barrier_map(x, t, centred))
        print("E: area ratio rms: conformal {:.2f}, centred {:.3f}, Moser passes {}, barrier {:.4f}".format(
            sphere.area_rms(x, t, conformal), history[0], " ".join(f"{h:.3f}" for h in history[1:]),
            sphere.area_rms(x, t, barrier)))
        cache.update(x=x, t=t, conformal=conformal, centred=centred, moser=moser, barrier=barrier, history=history)
    return cache


EYE = (0.55, -0.75, 0.35)  # from the patient's left front, a little above


def draw_ratio(axes, points, triangles, ratio, norm, cmap):
    draw_solid(axes, points[triangles], cmap(norm(np.log2(ratio)))[:, :3], view_basis(EYE), shade=0.12, line=0.25)


def figure_d(sample):
    maps = sphere_stages(sample)
    x, t = maps["x"], maps["t"]
    figure, panels = plt.subplots(1, 3, figsize=(9.0, 3.1), constrained_layout=True)
    norm, cmap = TwoSlopeNorm(0, -2, 2), plt.get_cmap("RdBu_r")
    draw_solid(panels[0], x[t], np.tile([0.82, 0.84, 0.88], (len(t), 1)), view_basis(EYE), line=0.25)
    panels[0].set_title("shell N (boundary of the lattice, N = 8)")
    for axes, name, title in ((panels[1], "conformal", "D x = a, D y = b, projected"),
                              (panels[2], "centred", "after Moebius centring")):
        draw_ratio(axes, maps[name], t, sphere.area_ratios(x, t, maps[name]), norm, cmap)
        axes.set_title(title)
    colourbar = bar(figure, panels, ScalarMappable(norm, cmap), "solid angle / target", [-2, -1, 0, 1, 2])
    colourbar.ax.set_yticklabels(["1/4", "1/2", "1", "2", "4"])
    save(figure, "D-conformal.png")


def closed_form_errors(a=0.5):
    """One pass of the flow for mu = 1 + a z on icospheres, against (E3)."""
    rows = []
    for level in (2, 3, 4):
        x, t = sphere.icosphere(level)
        z = sphere.moser_pass(t, x, 1 + a * x[:, 2])[:, 2]
        rows.append((len(x), x[:, 2], z, np.sqrt(np.mean((z - x[:, 2] - a * (x[:, 2] ** 2 - 1) / 2) ** 2))))
    return rows


def figure_e(sample):
    maps = sphere_stages(sample)
    x, t = maps["x"], maps["t"]
    figure, panels = plt.subplots(1, 4, figsize=(11.4, 2.9), constrained_layout=True,
                                  gridspec_kw={"width_ratios": [1, 1, 1, 1.25]})
    norm, cmap = TwoSlopeNorm(0, -1, 1), plt.get_cmap("RdBu_r")
    for axes, name, title in ((panels[0], "centred", "conformal, centred"), (panels[1], "moser", f"{PASSES} passes of Moser's flow"),
                              (panels[2], "barrier", "minimiser of the barrier")):
        ratio = sphere.area_ratios(x, t, maps[name])
        draw_ratio(axes, maps[name], t, ratio, norm, cmap)
        axes.set_title(f"{title}\nrms {sphere.area_rms(x, t, maps[name]):.2g}")
    colourbar = bar(figure, panels[:3], ScalarMappable(norm, cmap), "solid angle / target", [-1, 0, 1])
    colourbar.ax.set_yticklabels(["1/2", "1", "2"])
    rows = closed_form_errors()
    errors = [row[3] for row in rows]
    print("E: mu = 1 + z/2, rms error of z' on icospheres of {} vertices: {}".format(
        ", ".join(str(row[0]) for row in rows), ", ".join(f"{e:.1e}" for e in errors)))
    axes, curve = panels[3], np.linspace(-1, 1, 201)
    axes.plot(rows[1][1], rows[1][2] - rows[1][1], ".", markersize=2.5, color="#b3261e", label=f"flow, {rows[1][0]} vertices")
    axes.plot(curve, 0.25 * (curve**2 - 1), color=INK, linewidth=1, label="(E3), a = 1/2")
    axes.set(xlabel="z", ylabel="z' - z", title="closed form")
    axes.legend(frameon=False, loc="upper center", fontsize=8)
    save(figure, "E-area.png")


def figure_f(_):
    shell, pieces = 6, 2 * 6 - 1
    n = 2 * shell
    quads = files.shell_quads(n, shell)
    corners = (2.0 * quads - (n - 1)) / (n - 1)
    figure, panels = plt.subplots(1, 3, figsize=(9.0, 3.1), constrained_layout=True)
    face = np.repeat([[0.91, 0.72, 0.42], [0.55, 0.75, 0.65], [0.55, 0.68, 0.86]], 2 * pieces**2, axis=0)
    draw_solid(panels[0], corners, face, view_basis(EYE), line=0.4)
    panels[0].set_title(f"cube shell {shell}: {len(quads)} quadrilaterals")
    for axes, title, mapping in ((panels[1], "central projection", sphere.normalised),
                                 (panels[2], "equal areas (F2)", sphere.cube_to_sphere)):
        points = mapping(corners.reshape(-1, 3)).reshape(-1, 4, 3)
        index = np.arange(4 * len(quads)).reshape(-1, 4)
        angle = (sphere.solid_angles(points.reshape(-1, 3), index[:, [0, 1, 2]])
                 + sphere.solid_angles(points.reshape(-1, 3), index[:, [0, 2, 3]]))
        ratio = angle / angle.mean()
        print(f"F: {title}: solid angle / mean of the quadrilaterals from {ratio.min():.4f} to {ratio.max():.4f}")
        draw_solid(axes, points, face, view_basis(EYE), line=0.4)
        axes.set_title(f"{title}\nsolid angle / mean {ratio.min():.2f} to {ratio.max():.2f}")
    save(figure, "F-cube-shells.png")


def figure_g(sample):
    mesh = sample.mesh("initial")
    figure, panels = plt.subplots(1, 2, figsize=(8.4, 3.9), constrained_layout=True)
    for axes, plane, title in ((panels[0], coronal(mesh), "coronal"), (panels[1], sagittal(mesh), "sagittal")):
        draw_slice(axes, mesh, *by_shell(mesh), plane)
        axes.set_title(title)
    save(figure, "G-initial.png")


def figure_h(sample):
    figure, panels = plt.subplots(1, 2, figsize=(8.8, 4.0), constrained_layout=True)
    norm, cmap = TwoSlopeNorm(0.4, -0.2, 1.0), plt.get_cmap("RdYlBu")
    for axes, stage, title in ((panels[0], "initial", "initial map"), (panels[1], "smoothed", "smoothed")):
        mesh = sample.mesh(stage)
        jacobian = files.scaled_jacobians(mesh)
        draw_slice(axes, mesh, jacobian, lambda v: cmap(norm(v)), coronal(mesh))
        axes.set_title(f"{title}\nsmallest {jacobian.min():.2f}, median {np.median(jacobian):.2f}")
    bar(figure, panels, ScalarMappable(norm, cmap), "scaled Jacobian")
    save(figure, "H-smoothing.png")


def figure_i(sample):
    before, after = sample.mesh("smoothed"), sample.mesh("moser")
    figure, panels = plt.subplots(1, 3, figsize=(10.2, 3.3), constrained_layout=True,
                                  gridspec_kw={"width_ratios": [1, 1, 1.1]})
    norm, cmap = TwoSlopeNorm(0, -1, 1), plt.get_cmap("RdBu_r")
    for axes, mesh, title in ((panels[0], before, "before the flow"), (panels[1], after, "after it")):
        draw_slice(axes, mesh, mesh.ratio, lambda v: cmap(norm(np.log2(np.maximum(v, 1e-3)))), coronal(mesh))
        axes.set_title(f"{title}\nvariance {flow.volume_variance(mesh.nodes):.2g}")
    colourbar = bar(figure, panels[:2], ScalarMappable(norm, cmap), "cell volume / mean", [-1, 0, 1])
    colourbar.ax.set_yticklabels(["1/2", "1", "2"])
    axes = panels[2]
    for held, label, colour in ((True, "boundary held (the paper)", "#b3261e"), (False, "boundary sliding", "#2b5c94")):
        nodes, history = before.nodes, [flow.volume_variance(before.nodes)]
        for _ in range(6):
            nodes = flow.flow_pass(nodes, held)
            history.append(flow.volume_variance(nodes))
        print(f"I: {label}, flow alone, variance per pass: " + " ".join(f"{h:.2e}" for h in history))
        axes.semilogy(history, "o-", markersize=3.5, linewidth=1.2, color=colour, label=label)
    axes.axhline(flow.volume_variance(after.nodes), color=INK, linewidth=0.8, linestyle="--", label="moserhex, --stage moser")
    axes.set(xlabel="pass", ylabel="volume variance", title="the flow alone, numpy")
    axes.legend(frameon=False, fontsize=8)
    save(figure, "I-flow.png")


def figure_j(sample):
    figure, panels = plt.subplots(2, 2, figsize=(8.8, 7.4), constrained_layout=True)
    volumes, shapes = TwoSlopeNorm(0, -1, 1), TwoSlopeNorm(0.4, -0.2, 1.0)
    for row, (stage, title) in zip(panels.T, (("moser", "stage I"), ("exact", "stage J, fast way"))):
        mesh = sample.mesh(stage)
        jacobian = files.scaled_jacobians(mesh)
        variance = flow.volume_variance(mesh.nodes)
        print(f"J: {title}: variance {variance:.3g}, concave {100 * np.mean(jacobian <= 0):.2f} %, "
              f"scaled Jacobian smallest {jacobian.min():.3f}, median {np.median(jacobian):.3f}")
        draw_slice(row[0], mesh, mesh.ratio, lambda v: plt.get_cmap("RdBu_r")(volumes(np.log2(np.maximum(v, 1e-3)) * 5)),
                   coronal(mesh))
        row[0].set_title(f"{title}\nvolume variance {variance:.2g}")
        draw_slice(row[1], mesh, jacobian, lambda v: plt.get_cmap("RdYlBu")(shapes(v)), coronal(mesh))
        row[1].set_title(f"scaled Jacobian: smallest {jacobian.min():.2f}, median {np.median(jacobian):.2f}")
    colourbar = bar(figure, panels[0], ScalarMappable(volumes, "RdBu_r"), "cell volume / mean", [-1, 0, 1])
    colourbar.ax.set_yticklabels([f"{2 ** power:.2f}" for power in (-0.2, 0, 0.2)])
    bar(figure, panels[1], ScalarMappable(shapes, "RdYlBu"), "scaled Jacobian")
    save(figure, "J-equalise.png")


def figure_k(sample):
    figure, (left, right) = plt.subplots(1, 2, figsize=(8.8, 3.2), constrained_layout=True)
    for stage, label, colour in (("initial", "initial map", "#e0a93b"), ("smoothed", "smoothed", "#4d9a7a"),
                                 ("moser", "after the flow", "#2b5c94"), ("exact", "exact", "#b3261e")):
        mesh = sample.mesh(stage)
        jacobian = files.scaled_jacobians(mesh)
        concave = 100 * np.mean(jacobian <= 0)
        print(f"K: {label}: variance {flow.volume_variance(mesh.nodes):.3g}, concave {concave:.2f} %, "
              f"scaled Jacobian smallest {jacobian.min():.3f}, median {np.median(jacobian):.3f}")
        for axes, values, bins in ((left, mesh.ratio, np.linspace(0, 2, 81)), (right, jacobian, np.linspace(-0.2, 1, 61))):
            axes.hist(values.ravel().clip(bins[0], bins[-1]), bins, histtype="step", color=colour, label=label, linewidth=1.3)
    left.set(xlabel="cell volume / mean", ylabel="cells", yscale="log")
    right.set(xlabel="scaled Jacobian (vtkMeshQuality)")
    right.legend(frameon=False, loc="upper left")
    save(figure, "K-quality.svg")


# ---- the README's picture ---------------------------------------------------------------------------------------

def figure_title(sample):
    label, mesh = sample.labelmap(), sample.mesh("exact")
    basis = view_basis(EYE)
    figure = plt.figure(figsize=(12, 5))
    first = figure.add_axes([0.005, 0.03, 0.29, 0.84])
    second = figure.add_axes([0.335, 0.03, 0.31, 0.84])
    third = figure.add_axes([0.675, 0.03, 0.32, 0.84])
    draw_labelmap(first, label, basis)
    n, palette = mesh.n, shell_colours(mesh.shells)
    middle = mesh.shells - 1
    whole = np.ones((n - 1,) * 3, bool)
    opened = whole.copy()
    opened[middle + 1:, :middle, :] = False  # the quarter at the left front
    for axes, kept in ((second, whole), (third, opened)):
        quads, cells = files.exposed_faces(n, kept)
        colours = palette[files.at(files.cell_shells(n), cells) - 1]
        draw_solid(axes, files.at(mesh.nodes, quads), colours, basis, shade=0.4, line=0.45)
    for axes in (first, third):
        axes.set_xlim(second.get_xlim())
        axes.set_ylim(second.get_ylim())
    cells = (n - 1) ** 3
    for x, text in ((0.15, "labelmap"), (0.49, f"{cells} hexahedra, one lattice (i, j, k)"),
                    (0.835, "inside: one colour for each shell")):
        figure.text(x, 0.925, text, ha="center", fontsize=14)
    for x in (0.313, 0.66):
        figure.text(x, 0.45, "\u2192", ha="center", va="center", fontsize=26, color="#666666")
    save(figure, "../moserhex.png", dpi=100)


def draw_labelmap(axes, label, basis):
    """The label's voxels, slice by slice, as thin plates."""
    mask = np.pad(label.inside, 1)
    pieces = []
    for axis in range(3):
        for side in (0, 1):
            neighbour = np.roll(mask, 1 - 2 * side, axis)
            index = np.argwhere(mask & ~neighbour) - 1.0
            corners = np.array([(-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5)])[:: 1 if side else -1]
            quad = np.repeat(index[:, None, :], 4, 1)
            quad[:, :, axis] += side - 0.5
            quad[:, :, (axis + 1) % 3] += corners[:, 0]
            quad[:, :, (axis + 2) % 3] += corners[:, 1]
            pieces.append(quad)
    quads = np.concatenate(pieces) @ label.axes.T + label.origin
    if np.linalg.det(label.axes) < 0:
        quads = quads[:, ::-1]
    colours = np.tile([0.74, 0.79, 0.86], (len(quads), 1))
    draw_solid(axes, quads, colours, basis, shade=0.75, line=0.1, edge="face")


FIGURES = {"A": figure_a, "B": figure_b, "C": figure_c, "D": figure_d, "E": figure_e, "F": figure_f, "G": figure_g,
           "H": figure_h, "I": figure_i, "J": figure_j, "K": figure_k, "title": figure_title}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", help="build folder with Applications/MoserHex/moserhex")
    parser.add_argument("--only", nargs="+", choices=list(FIGURES), default=list(FIGURES))
    parser.add_argument("--work", help="keeps the command's files here; those that exist are not made again")
    options = parser.parse_args()
    command = Path(options.build) / "Applications" / "MoserHex" / "moserhex"
    with tempfile.TemporaryDirectory() as temporary:
        sample = Sample(command, options.work or temporary)
        for name in options.only:
            FIGURES[name](sample)


if __name__ == "__main__":
    sys.exit(main())
