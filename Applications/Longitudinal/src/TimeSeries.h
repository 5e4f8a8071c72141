#pragma once

#include "moserhex/Deformation/LatticeAlignment.h"
#include "moserhex/Geometry/HexMesh.h"

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
  std::string           file;
  std::string           name;
  std::optional<double> months;
  HexMesh               lattice; ///< without padding [mm]
  /** Onto the baseline, where it was given. */
  std::optional<SimilarityTransform> alignment;
};

struct TimeSeries
{
  std::vector<TimePoint>   points; ///< two or more, of the same n
  int                      paddingLayers{ 0 };
  std::vector<std::string> warnings;
};

/** Reads the meshes of a comparison and says what makes them doubtful: a lattice that its report calls turned, padding
 * that is left out.
 * \throws UsageError  fewer than two meshes, other than so many times, names or transforms, times that do not ascend
 * \throws BadInput    as readHexCells and latticeOf; Precondition: another n or padding than the baseline's
 * \throws IOError     a file cannot be read */
[[nodiscard]] TimeSeries
readTimeSeries(const CompareCommandOptions & options);

} // namespace moserhex::app
