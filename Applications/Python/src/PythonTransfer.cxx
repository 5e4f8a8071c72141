#include "PythonTransfer.h"

#include "Arguments.h"
#include "ArrayOutput.h"
#include "PythonMesh.h"
#include "Unlocked.h"
#include "moserhex/CubeTransfer/CubeAxes.h"
#include "moserhex/CubeTransfer/CubeImage.h"
#include "moserhex/CubeTransfer/CubeSamples.h"
#include "moserhex/CubeTransfer/FieldFunction.h"
#include "moserhex/CubeTransfer/GridMasses.h"
#include "moserhex/CubeTransfer/GridSamples.h"

#include <algorithm>

namespace moserhex::python
{
namespace
{

namespace py = pybind11;

constexpr unsigned int lookEvery = 256; ///< points between looks for Ctrl-C

/** \throws InvalidInput (PixelType)  neither vectors nor symmetric tensors, and to be turned */
void
requireTurnable(bool rotate, int components)
{
  if (rotate && !canBeTurned(components))
  {
    throw InvalidInput(ErrorCode::PixelType,
                       "rotate: " + std::to_string(components) +
                         " components, need 3 (vectors) or 6 (symmetric tensors)");
  }
}

/** Components from a space to LPS and back, a half turn about the third axis in RAS. */
void
turnToLps(Space space, int components, double * values)
{
  if (space == Space::RAS)
  {
    turn(Vector3(-1.0, -1.0, 1.0).asDiagonal(), components, values);
  }
}

/** A subject's image as a function of the cube. \param image  must outlive the function */
CubeFunction
subjectFunction(const FieldVolume & image,
                ImageInterpolation  interpolation,
                double              outside,
                bool                rotate,
                Space               space,
                Watch &             watch)
{
  const FieldFunction field(image, interpolation);
  const int           components = image.components;
  return [=, &watch](const CubePoint & point, double * values) {
    watch.look(lookEvery);
    if (!field.evaluate(point.position, values))
    {
      std::fill_n(values, components, outside);
    }
    else if (rotate)
    {
      turnToLps(space, components, values);
      turn(rotationPart(point.jacobian).transpose(), components, values);
    }
  };
}

py::array
cellMeans(const PythonMesh &  mesh,
          const py::object &  values,
          const py::object &  affine,
          int                 boxes,
          int                 order,
          const std::string & interpolation,
          double              outside,
          bool                rotate,
          long long           threads)
{
  const FieldImage         image = fieldFrom("values", values, affine, mesh.space());
  const ImageInterpolation how = interpolationFrom(interpolation);
  const CubeMeanOptions    options{ boxes, order, threadsFrom(threads) };
  requireTurnable(rotate, image.volume.components);
  return arrayOf(unlocked([&](Watch & watch) {
    const CubeFunction f = subjectFunction(image.volume, how, outside, rotate, mesh.space(), watch);
    return cubeMeans(mesh.lattice(), f, image.volume.components, options).image;
  }));
}

py::array
nodeSamples(const PythonMesh &  mesh,
            const py::object &  values,
            const py::object &  affine,
            const std::string & interpolation,
            double              outside,
            bool                rotate,
            long long           threads)
{
  const FieldImage         image = fieldFrom("values", values, affine, mesh.space());
  const ImageInterpolation how = interpolationFrom(interpolation);
  const unsigned int       count = threadsFrom(threads);
  requireTurnable(rotate, image.volume.components);
  return arrayOf(unlocked([&](Watch & watch) {
    const CubeFunction f = subjectFunction(image.volume, how, outside, rotate, mesh.space(), watch);
    return cubeNodeSamples(mesh.lattice(), f, image.volume.components, count);
  }));
}

py::array
cellVolumesOf(const PythonMesh & mesh, int boxes, long long threads)
{
  const CubeMeanOptions     options{ boxes, 2, threadsFrom(threads) }; // 2 points are exact for det J
  const std::vector<double> volumes = unlocked([&](Watch &) { return cubeVolumes(mesh.lattice(), options); });
  return cubeOf(volumes, boxes > 0 ? boxes : mesh.nodesPerSide() - 1);
}

/** Values on the cube's grid. \param sampling  "cells" or "nodes" \throws InvalidInput (Usage) */
FieldVolume
cubeImageFrom(const std::string & name, const py::object & values, const std::string & sampling)
{
  if (sampling != "cells" && sampling != "nodes")
  {
    throw InvalidInput(ErrorCode::Usage, "sampling: " + oneLine(sampling, 40) + " is none of cells, nodes");
  }
  FieldVolume cube = cubeValuesFrom(name, values);
  static_cast<VoxelGrid &>(cube) =
    cubeGrid(sampling == "cells" ? CubeSampling::Cells : CubeSampling::Nodes, cube.size[0]);
  return cube;
}

py::array
gridSamplesOf(const PythonMesh &  mesh,
              const py::object &  values,
              const py::object &  affine,
              const py::object &  shape,
              const std::string & sampling,
              const std::string & interpolation,
              double              background,
              bool                rotate,
              long long           threads)
{
  const FieldVolume        cube = cubeImageFrom("values", values, sampling);
  const VoxelGrid          grid = gridFrom(shape, affine, mesh.space());
  const ImageInterpolation how = interpolationFrom(interpolation);
  const GridSamplesOptions options{ background, threadsFrom(threads) };
  requireTurnable(rotate, cube.components);
  return arrayOf(unlocked([&](Watch & watch) {
    const FieldFunction field(cube, how);
    const CubeFunction  f = [&](const CubePoint & point, double * result) {
      watch.look(lookEvery);
      (void)field.evaluate(point.cube, result); // the whole cube is in it
      if (rotate)
      {
        turn(rotationPart(point.jacobian), cube.components, result);
        turnToLps(mesh.space(), cube.components, result);
      }
    };
    return gridSamples(mesh.cubeMap(), mesh.lattice(), f, cube.components, grid, options).image;
  }));
}

/** Densities, and the mass of each component beyond the grid. */
py::tuple
gridMassesOf(const PythonMesh & mesh,
             const py::object & masses,
             const py::object & affine,
             const py::object & shape,
             double             background,
             long long          threads)
{
  const FieldVolume cube = cubeImageFrom("masses", masses, "cells");
  const VoxelGrid   grid = gridFrom(shape, affine, mesh.space());
  GridMassOptions   options;
  options.background = background;
  options.threads = threadsFrom(threads);
  const GridMasses result =
    unlocked([&](Watch &) { return gridMasses(mesh.cubeMap(), mesh.lattice(), cube, grid, options); });
  return py::make_tuple(arrayOf(result.image), arrayOf(result.outside, { cube.components }));
}

} // namespace

void
addTransfer(py::module_ & module)
{
  module.def("cell_means", &cellMeans);
  module.def("node_samples", &nodeSamples);
  module.def("cell_volumes", &cellVolumesOf);
  module.def("grid_samples", &gridSamplesOf);
  module.def("grid_masses", &gridMassesOf);
}

} // namespace moserhex::python
