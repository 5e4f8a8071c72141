#pragma once

#include "InputFile.h"
#include "MeshRecord.h"
#include "moserhex/Deformation/LatticeAlignment.h"
#include "moserhex/Geometry/HexMesh.h"
#include "moserhex/Quality/HexQuality.h"

#include <optional>
#include <string>
#include <vector>

namespace moserhex::app
{

struct CompareCommandOptions
{
  std::vector<std::string>   meshes; ///< in the order of time, the baseline first
  std::string                outputFolder;
  std::optional<std::string> align;      ///< rigid | similarity | none; empty: rigid, or by transforms
  std::vector<std::string>   transforms; ///< files, one a follow-up, from the baseline's space to its; empty: `align`
  std::vector<std::string>   regions{ "octants", "shells" }; ///< octants, halves, shells, or tables of boxes
  std::vector<double>        times;                          ///< ascending [months]; empty: not known
  std::vector<std::string>   names;                          ///< empty: the files' names without ending
  bool                       sandbox{ true };
  unsigned int               threads{ 0 };
  bool                       quiet{ false };
};

/** \param align  rigid | similarity | none */
[[nodiscard]] AlignmentKind
alignmentOf(const std::string & align);

/** What reports call the alignment: options.align, or rigid, or "file" where transforms are given. */
[[nodiscard]] std::string
alignmentName(const CompareCommandOptions & options);

/** A mesh at a time, as read. */
struct TimedMesh
{
  InputFile               file;         ///< its name stands in messages
  HexMesh                 mesh;         ///< [mm]
  std::vector<NamedArray> meshArrays;   ///< of its file
  std::string             reportBeside; ///< the file that a report may lie beside; empty: none
};

/** The same without its padding, measured. */
struct TimePoint
{
  InputFile                  file;
  std::string                name;
  std::optional<double>      months;
  HexMesh                    lattice;       ///< without padding [mm]
  double                     volume{ 0.0 }; ///< of the organ, which is the lattice with its padding [mm^3]
  VolumeQuality              quality;       ///< of the lattice
  CellRecord                 cells;
  std::optional<LatticeTurn> turn;
  std::vector<NamedArray>    record; ///< for another file of the mesh, see recordOf
  /** Onto the baseline, where it was given. */
  std::optional<SimilarityTransform> alignment;
  InputFile                          transform; ///< that gave it, from the baseline's space to this one's
};

/** Whether cells have one volume, up to the rounding of coordinates in a file. */
[[nodiscard]] bool
hasEvenCells(const TimePoint & point);

struct TimeSeries
{
  std::vector<TimePoint>   points; ///< two or more, of the same n
  int                      paddingLayers{ 0 };
  std::vector<std::string> warnings;
};

/** The series of two or more meshes, without names and times, and what makes them doubtful: lattices that were turned
 * and not alike (see turnWarnings), padding that is left out, concave cells, cells whose volumes are no growth: made by
 * a density, not exact, or uneven for an unknown reason.
 * \throws BadInput  Precondition: another n or padding than the baseline's; a mesh without cells that have a volume */
[[nodiscard]] TimeSeries
timeSeriesOf(const std::vector<TimedMesh> & meshes);

/** The same of files, with names, times and transforms.
 * \throws UsageError  fewer than two meshes, other than so many times, names or transforms, times that do not ascend,
 *                     both transforms and a way to align
 * \throws BadInput    as readHexCells, latticeOf and timeSeriesOf
 * \throws IOError     a file cannot be read */
[[nodiscard]] TimeSeries
readTimeSeries(const CompareCommandOptions & options);

} // namespace moserhex::app
