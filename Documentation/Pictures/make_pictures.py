#!/usr/bin/python3
"""Makes the pictures of this folder again: what Slicer.md shows of the embedded sample.

    /usr/bin/python3 Documentation/Pictures/make_pictures.py BUILD_FOLDER [--only NAME ...] [--work FOLDER]

Runs BUILD_FOLDER/Applications/MoserHex/moserhex (sample, mesh) and draws its files with VTK. Needs Debian's python3-vtk9, and
xvfb where there is no display. The pictures are drawn by VTK alone: they are not screenshots of 3D Slicer.
"""
import argparse
import os
import shutil
import struct
import subprocess
import sys
import tempfile
import zlib

FOLDER = os.path.dirname(os.path.abspath(__file__))
IN_XVFB = "MOSERHEX_PICTURES_IN_XVFB"


def stop(message):
    sys.exit(f"make_pictures.py: {message}")


try:
    import numpy as np
    import vtk
    from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy

    sys.path.insert(0, os.path.join(os.path.dirname(FOLDER), "Theory"))
    import lattice_files
except ImportError as error:
    stop(f"{error}. Install Debian's python3-vtk9 and run by /usr/bin/python3")

INK = (0.13, 0.13, 0.13)
PAPER = (1.0, 1.0, 1.0)
LABEL = (0.45, 0.62, 0.82)
MESH = (0.96, 0.87, 0.70)
MARKS = ((0.90, 0.05, 0.05), (0.10, 0.25, 0.95), (0.00, 0.45, 0.10), (0.05, 0.05, 0.05), (1.00, 0.90, 0.00))
LARGEST_FILE = 150000
COLOURS = 160


class Sample:
    """The sample's labelmaps and their meshes."""

    def __init__(self, command, folder):
        self.folder = folder
        self.run(command, "sample", folder)
        for name in ("prostate", "prostate_followup"):
            self.run(command, "mesh", self.path(name + ".nrrd"), self.path(name + ".vtu"), "--quiet")

    @staticmethod
    def run(*words):
        subprocess.run(words, check=True, stdout=subprocess.DEVNULL)

    def path(self, name):
        return os.path.join(self.folder, name)

    def mesh(self, name):
        reader = vtk.vtkXMLUnstructuredGridReader()
        reader.SetFileName(self.path(name + ".vtu"))
        reader.Update()
        return reader.GetOutput()

    def label_surface(self, name):
        """The boundary of the label's voxels: squares between voxels of the label and others."""
        label = lattice_files.read_nrrd(self.path(name + ".nrrd"))
        inside = np.pad(label.inside, 1)
        corners = []  # in voxels, four of each square; voxel (i,j,k) reaches half a voxel around its middle
        for axis in range(3):
            squares = np.repeat(np.argwhere(np.diff(inside.astype(np.int8), axis=axis)) - 1.0, 4, axis=0)
            squares[:, axis] += 0.5
            u, v = [other for other in range(3) if other != axis]
            squares[:, u] += np.tile((-0.5, 0.5, 0.5, -0.5), len(squares) // 4)
            squares[:, v] += np.tile((-0.5, -0.5, 0.5, 0.5), len(squares) // 4)
            corners.append(squares)
        points = vtk.vtkPoints()
        points.SetData(numpy_to_vtk(np.concatenate(corners) @ label.axes.T + label.origin, deep=True))
        polygons = vtk.vtkCellArray()
        for first in range(0, points.GetNumberOfPoints(), 4):
            polygons.InsertNextCell(4, range(first, first + 4))
        surface = vtk.vtkPolyData()
        surface.SetPoints(points)
        surface.SetPolys(polygons)
        return surface


def nodes_per_side(mesh):
    return round(mesh.GetNumberOfPoints() ** (1 / 3))


def part(mesh, wanted):
    """Cells whose lattice place (i, j, k), from 0, is wanted."""
    side = nodes_per_side(mesh) - 1
    ids = vtk.vtkIdTypeArray()
    for cell in range(side**3):
        if wanted(cell % side, cell // side % side, cell // side**2):
            ids.InsertNextValue(cell)
    node = vtk.vtkSelectionNode()
    node.SetFieldType(vtk.vtkSelectionNode.CELL)
    node.SetContentType(vtk.vtkSelectionNode.INDICES)
    node.SetSelectionList(ids)
    selection = vtk.vtkSelection()
    selection.AddNode(node)
    extract = vtk.vtkExtractSelection()
    extract.SetInputData(0, mesh)
    extract.SetInputData(1, selection)
    extract.Update()
    return extract.GetOutput()


def boundary(mesh):
    surface = vtk.vtkDataSetSurfaceFilter()
    surface.SetInputData(mesh)
    surface.Update()
    return surface.GetOutput()


def actor_of(data, colour=None, edges=True, opacity=1.0, array=None, table=None, limits=None, rgb=False):
    mapper = vtk.vtkDataSetMapper()
    mapper.SetInputData(data)
    if array:
        mapper.SetScalarModeToUseCellFieldData()
        mapper.SelectColorArray(array)
        if rgb:
            mapper.SetColorModeToDirectScalars()
        else:
            mapper.SetLookupTable(table)
            mapper.SetScalarRange(*limits)
    else:
        mapper.ScalarVisibilityOff()
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    look = actor.GetProperty()
    if colour:
        look.SetColor(*colour)
    look.SetOpacity(opacity)
    look.SetInterpolationToFlat()
    look.SetAmbient(0.35)
    look.SetDiffuse(0.7)
    if edges:
        look.EdgeVisibilityOn()
        look.SetEdgeColor(0.15, 0.15, 0.15)
        look.SetLineWidth(1.0)
    return actor


def lookup_table(colours):
    table = vtk.vtkLookupTable()
    table.SetNumberOfTableValues(len(colours))
    for i, colour in enumerate(colours):
        table.SetTableValue(i, *colour, 1.0)
    return table


def viridis(count):
    """The colour map by its values at nine places."""
    nodes = np.array([(68, 1, 84), (72, 40, 120), (62, 74, 137), (49, 104, 142), (38, 130, 142), (31, 158, 137),
                      (53, 183, 121), (144, 215, 67), (253, 231, 37)]) / 255
    places = np.linspace(0, len(nodes) - 1, count)
    return [tuple(np.interp(place, range(len(nodes)), nodes[:, channel]) for channel in range(3)) for place in places]


class Picture:
    """A window of columns x rows views, seen from the front (anterior) unless said otherwise."""

    def __init__(self, columns=1, rows=1, view=(520, 520), title_height=34):
        self.columns, self.rows, self.view, self.title = columns, rows, view, title_height
        self.window = vtk.vtkRenderWindow()
        self.window.SetOffScreenRendering(1)
        self.window.SetMultiSamples(8)
        self.window.SetSize(columns * view[0], rows * (view[1] + title_height))
        self.window.SetNumberOfLayers(2)
        self.width, self.height = self.window.GetSize()

    def add_view(self, column, row, title, actors, bounds, towards=(0.25, 1.0, -0.35), zoom=1.25, shift=0.0):
        """Parallel projection; the same bounds and zoom give the same scale. shift: to the left, in half widths."""
        height = self.view[1] + self.title
        low, high = self.height - (row + 1) * height, self.height - row * height
        box = (column / self.columns, low / self.height, (column + 1) / self.columns, high / self.height)
        renderer = vtk.vtkRenderer()
        renderer.SetViewport(*box)
        renderer.SetBackground(*PAPER)
        for actor in actors:
            renderer.AddActor(actor)
        self.window.AddRenderer(renderer)
        camera = renderer.GetActiveCamera()
        camera.ParallelProjectionOn()
        centre = [(bounds[2 * i] + bounds[2 * i + 1]) / 2 for i in range(3)]
        direction = np.array(towards) / np.linalg.norm(towards)
        camera.SetFocalPoint(*centre)
        camera.SetPosition(*(np.array(centre) - 300 * direction))
        camera.SetViewUp(0, 0, 1)
        camera.SetParallelScale(zoom * max(bounds[2 * i + 1] - bounds[2 * i] for i in range(3)) / 2)
        camera.SetWindowCenter(shift, 0.0)
        renderer.ResetCameraClippingRange()
        self.add_text(renderer, title, self.view[0] / 2, height - self.title / 2, 18, centred=True)
        self.add_scale_bar(renderer, camera, height)
        self.add_axes(box, camera)
        return renderer

    @staticmethod
    def add_text(renderer, text, x, y, size, centred=False, colour=INK):
        actor = vtk.vtkTextActor()
        actor.SetInput(text)
        look = actor.GetTextProperty()
        look.SetFontSize(size)
        look.SetColor(*colour)
        look.SetVerticalJustificationToCentered()
        if centred:
            look.SetJustificationToCentered()
        actor.SetPosition(x, y)
        renderer.AddActor2D(actor)

    def add_scale_bar(self, renderer, camera, height):
        length = 10 * height / (2 * camera.GetParallelScale())  # pixels of 10 mm
        right, y = self.view[0] - 18, 22
        points = vtk.vtkPoints()
        for x, dy in ((right - length, 0), (right, 0), (right - length, -5), (right - length, 5), (right, -5), (right, 5)):
            points.InsertNextPoint(x, y + dy, 0)
        lines = vtk.vtkCellArray()
        for first in (0, 2, 4):
            lines.InsertNextCell(2, [first, first + 1])
        data = vtk.vtkPolyData()
        data.SetPoints(points)
        data.SetLines(lines)
        mapper = vtk.vtkPolyDataMapper2D()
        mapper.SetInputData(data)
        actor = vtk.vtkActor2D()
        actor.SetMapper(mapper)
        actor.GetProperty().SetColor(*INK)
        actor.GetProperty().SetLineWidth(2)
        renderer.AddActor2D(actor)
        self.add_text(renderer, "10 mm", right - length / 2, y + 15, 14, centred=True)

    def add_axes(self, box, camera):
        """Arrows towards Left, Posterior and Superior, in the lower left corner."""
        renderer = vtk.vtkRenderer()
        renderer.SetLayer(1)
        width, height = box[2] - box[0], box[3] - box[1]
        renderer.SetViewport(box[0], box[1], box[0] + 0.24 * width, box[1] + 0.24 * height)
        axes = vtk.vtkAxesActor()
        axes.SetXAxisLabelText("L")
        axes.SetYAxisLabelText("P")
        axes.SetZAxisLabelText("S")
        for caption in (axes.GetXAxisCaptionActor2D(), axes.GetYAxisCaptionActor2D(), axes.GetZAxisCaptionActor2D()):
            caption.GetTextActor().SetTextScaleModeToNone()
            look = caption.GetCaptionTextProperty()
            look.SetFontSize(14)
            look.SetColor(*INK)
            look.ShadowOff()
            look.ItalicOff()
        renderer.AddActor(axes)
        self.window.AddRenderer(renderer)
        own = renderer.GetActiveCamera()
        own.ParallelProjectionOn()
        direction = np.array(camera.GetDirectionOfProjection())
        own.SetFocalPoint(0, 0, 0)
        own.SetPosition(*(-10 * direction))
        own.SetViewUp(0, 0, 1)
        own.SetParallelScale(1.55)
        renderer.ResetCameraClippingRange()

    def add_legend(self, renderer, title, colours, labels):
        """A column of colours, from below, and texts beside it; labels: {place in units of a colour: text}."""
        left, right, bottom = self.view[0] - 62, self.view[0] - 42, 0.28 * self.view[1]
        step = 0.5 * self.view[1] / len(colours)
        points, quads = vtk.vtkPoints(), vtk.vtkCellArray()
        for place in range(len(colours)):
            low, high = bottom + place * step, bottom + (place + 1) * step
            first = points.GetNumberOfPoints()
            for corner in ((left, low), (right, low), (right, high), (left, high)):
                points.InsertNextPoint(*corner, 0)
            quads.InsertNextCell(4, range(first, first + 4))
        data = vtk.vtkPolyData()
        data.SetPoints(points)
        data.SetPolys(quads)
        data.GetCellData().SetScalars(numpy_to_vtk(np.round(255 * np.array(colours)).astype(np.uint8), deep=True))
        mapper = vtk.vtkPolyDataMapper2D()
        mapper.SetInputData(data)
        actor = vtk.vtkActor2D()
        actor.SetMapper(mapper)
        renderer.AddActor2D(actor)
        for place, text in labels.items():
            self.add_text(renderer, text, right + 6, bottom + place * step, 14)
        self.add_text(renderer, title, (left + right) / 2, bottom + len(colours) * step + 28, 15, centred=True)

    def write(self, name):
        self.window.Render()
        grab = vtk.vtkWindowToImageFilter()
        grab.SetInput(self.window)
        grab.ReadFrontBufferOff()
        grab.SetInputBufferTypeToRGB()
        indexed = vtk.vtkImageQuantizeRGBToIndex()
        indexed.SetInputConnection(grab.GetOutputPort())
        indexed.SetNumberOfColors(COLOURS)
        indexed.Update()
        rows = vtk_to_numpy(indexed.GetOutput().GetPointData().GetScalars()).reshape(self.height, self.width)[::-1]
        table = indexed.GetLookupTable()
        colours = [table.GetTableValue(i)[:3] for i in range(table.GetNumberOfTableValues())]
        path = os.path.join(FOLDER, name + ".png")
        write_png(path, rows.astype(np.uint8), np.round(255 * np.array(colours)).astype(np.uint8))
        size = os.path.getsize(path)
        print(f"{path}  {size} bytes")
        if size > LARGEST_FILE:
            stop(f"{path} is larger than {LARGEST_FILE} bytes")


def write_png(path, rows, colours):
    """Pixels as places in a list of colours, a third of the size of true colours."""
    def chunk(kind, content):
        return struct.pack(">I", len(content)) + kind + content + struct.pack(">I", zlib.crc32(kind + content))

    height, width = rows.shape
    pixels = np.hstack((np.zeros((height, 1), np.uint8), rows)).tobytes()
    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 3, 0, 0, 0)) +
                   chunk(b"PLTE", colours.tobytes()) + chunk(b"IDAT", zlib.compress(pixels, 9)) + chunk(b"IEND", b""))


def mesh_in_label(sample):
    mesh = sample.mesh("prostate")
    label = sample.label_surface("prostate")
    picture = Picture(columns=2)
    picture.add_view(0, 0, "labelmap", [actor_of(label, LABEL, edges=False)], mesh.GetBounds())
    over = [actor_of(label, LABEL, edges=False, opacity=0.45), actor_of(boundary(mesh), MESH)]
    picture.add_view(1, 0, "mesh over the labelmap", over, mesh.GetBounds())
    picture.write("mesh-in-label")


def shells(sample):
    mesh = sample.mesh("prostate")
    count = nodes_per_side(mesh) // 2
    half = count - 1
    colours = viridis(count)
    look = {"array": "Shell", "table": lookup_table(colours), "limits": (0.5, count + 0.5)}
    picture = Picture(columns=2)
    picture.add_view(0, 0, "without its anterior half", [actor_of(part(mesh, lambda i, j, k: j >= half), **look)],
                     mesh.GetBounds(), towards=(0.15, 1.0, -0.2))
    without_an_eighth = part(mesh, lambda i, j, k: j >= half or k < half or i > half)
    renderer = picture.add_view(1, 0, "without one eighth", [actor_of(without_an_eighth, **look)], mesh.GetBounds(),
                                towards=(0.8, 1.0, -0.7), shift=0.14)
    picture.add_legend(renderer, "shell", colours, {shell - 0.5: str(shell) for shell in range(1, count + 1)})
    picture.write("shells")


def scaled_jacobian(sample):
    mesh = sample.mesh("prostate")
    half = nodes_per_side(mesh) // 2 - 1
    colours = viridis(60)
    look = {"array": "ScaledJacobian", "table": lookup_table(colours), "limits": (0.0, 1.0)}
    picture = Picture(columns=2)
    picture.add_view(0, 0, "surface", [actor_of(mesh, **look)], mesh.GetBounds())
    inside = part(mesh, lambda i, j, k: j >= half)
    renderer = picture.add_view(1, 0, "without its anterior half", [actor_of(inside, **look)], mesh.GetBounds(), shift=0.14)
    picture.add_legend(renderer, "scaled\nJacobian", colours, {60 * value: f"{value:.1f}" for value in np.linspace(0, 1, 6)})
    picture.write("scaled-jacobian")


def checkered(mesh, wanted):
    """Cells that are wanted, with a colour of their block of lattice indices."""
    side = nodes_per_side(mesh) - 1
    block = 4
    cells = np.arange(side**3)
    place = np.stack((cells % side, cells // side % side, cells // side**2), axis=1)
    light = np.where(((place + 1) // block).sum(axis=1) % 2 == 1, 1.0, 0.78)
    colours = np.round(255 * light[:, None] * (0.62 + 0.38 * place / (side - 1))).astype(np.uint8)
    array = numpy_to_vtk(colours, deep=True)
    array.SetName("Block")
    copy = vtk.vtkUnstructuredGrid()
    copy.ShallowCopy(mesh)
    copy.GetCellData().AddArray(array)
    return part(copy, wanted)


def ball(position, colour):
    source = vtk.vtkSphereSource()
    source.SetCenter(*position)
    source.SetRadius(1.3)
    source.SetThetaResolution(24)
    source.SetPhiResolution(24)
    source.Update()
    actor = actor_of(source.GetOutput(), colour, edges=False)
    actor.GetProperty().SetAmbient(0.8)
    actor.GetProperty().SetDiffuse(0.2)
    return actor


def same_place(sample):
    meshes = [sample.mesh("prostate"), sample.mesh("prostate_followup")]
    side = nodes_per_side(meshes[0])
    half = side // 2 - 1
    outside = ((4, 0, 15), (15, 0, 15), (9, 0, 9), (4, 0, 4), (15, 0, 4))
    inside = ((2, half, 10), (5, half, 5), (10, half, 10), (14, half, 14), (17, half, 7))
    both = list(zip(*(mesh.GetBounds() for mesh in meshes)))
    bounds = [min(pair) if i % 2 == 0 else max(pair) for i, pair in enumerate(both)]
    rows = (("surface", lambda i, j, k: True, outside), ("without its anterior half", lambda i, j, k: j >= half, inside))
    picture = Picture(columns=2, rows=2, view=(430, 400))
    for column, (mesh, subject) in enumerate(zip(meshes, ("one labelmap", "another"))):
        for row, (where, wanted, places) in enumerate(rows):
            actors = [actor_of(checkered(mesh, wanted), array="Block", rgb=True)]
            for (i, j, k), colour in zip(places, MARKS):
                actors.append(ball(mesh.GetPoint(i + side * (j + side * k)), colour))
            picture.add_view(column, row, f"{subject}: {where}", actors, bounds, towards=(0.0, 1.0, 0.0), zoom=1.2)
    picture.write("same-place")


PICTURES = {"mesh-in-label": mesh_in_label, "shells": shells, "scaled-jacobian": scaled_jacobian, "same-place": same_place}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("build", metavar="BUILD_FOLDER")
    parser.add_argument("--only", nargs="+", choices=sorted(PICTURES), default=list(PICTURES))
    parser.add_argument("--work", metavar="FOLDER", help="for the sample and its meshes; default: a temporary one")
    arguments = parser.parse_args()
    command = os.path.join(arguments.build, "Applications", "MoserHex", "moserhex")
    if not os.access(command, os.X_OK):
        stop(f"{command} is not there: build the target moserhex first")
    if not os.environ.get("DISPLAY"):
        if IN_XVFB in os.environ or not shutil.which("xvfb-run"):
            stop("no display. Install Debian's xvfb, or set DISPLAY")
        sys.exit(subprocess.run(["xvfb-run", "-a", "-s", "-screen 0 1600x1200x24", sys.executable, *sys.argv],
                                env={**os.environ, IN_XVFB: "1"}, check=False).returncode)
    with tempfile.TemporaryDirectory() as temporary:
        sample = Sample(command, arguments.work or temporary)
        for name in arguments.only:
            PICTURES[name](sample)


if __name__ == "__main__":
    main()
