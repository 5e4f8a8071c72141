#pragma once

#include "InputFile.h"
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
  std::vector<std::string> meshes; ///< in the order of time, the baseline first
  std::string              outputFolder;
  std::string              align{ "rigid" }; ///< rigid | similarity | none
  std::vector<std::string> transforms; ///< files, one a follow-up, from the baseline's space to its; empty: `align`
  std::vector<std::string> regions{ "octants", "shells" }; ///< octants, halves, shells, or tables of boxes
  std::vector<double>      times;                          ///< ascending [months]; empty: not known
  std::vector<std::string> names;                          ///< empty: the files' names without ending
  bool                     sandbox{ true };
  unsigned int             threads{ 0 };
  bool                     quiet{ false };
};

/** \param align  rigid | similarity | none */
[[nodiscard]] AlignmentKind
alignmentOf(const std::string & align);

/** What reports call the alignment: options.align, or "file" where transforms are given. */
[[nodiscard]] std::string
alignmentName(const CompareCommandOptions & options);

/** A mesh at a time. */
struct TimePoint
{
  InputFile             file;
  std::string           name;
  std::optional<double> months;
  HexMesh               lattice;                 ///< without padding [mm]
  double                volume{ 0.0 };           ///< of the organ, which is the lattice with its padding [mm^3]
  VolumeQuality         quality;                 ///< of the lattice
  bool                  hasLocalGrowth{ false }; ///< its cells were free to grow differently
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

/** Reads the meshes of a comparison and says what makes them doubtful: lattices that were turned and not alike (see
 * turnWarnings), padding that is left out, concave cells, cells that are even at one time only, a report beside a mesh
 * that calls it not exact.
 * \throws UsageError  fewer than two meshes, other than so many times, names or transforms, times that do not ascend
 * \throws BadInput    as readHexCells and latticeOf; Precondition: another n or padding than the baseline's
 * \throws IOError     a file cannot be read */
[[nodiscard]] TimeSeries
readTimeSeries(const CompareCommandOptions & options);

} // namespace moserhex::app
