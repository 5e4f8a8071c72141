#pragma once

#include "moserhex/HexMeshIO/LabelImageReader.h"

#include <optional>
#include <string>
#include <vector>

namespace moserhex::app
{

/** Which solid of which file. */
struct InputOptions
{
  std::string                file; ///< labelmap or closed surface
  std::optional<LabelValue>  label;
  std::optional<std::string> segment;         ///< of a .seg.nrrd
  std::optional<double>      threshold;       ///< makes a label of a probability map
  bool                       sandbox{ true }; ///< read in a child process with limits
};

/** A solid that the user chose: one label, or all of a labelmap together when none was named. */
struct ChosenSolid
{
  LabelImage              image;  ///< as read
  std::vector<LabelEntry> labels; ///< the chosen ones, at least one
  LabelImageType::Pointer mask;   ///< holds `value` in the solid
  LabelValue              value{ 1 };
  std::size_t             voxels{ 0 };

  [[nodiscard]] std::vector<std::int64_t>
  labelValues() const;

  /** "label 3 (prostate)", "labels 1, 2 together". */
  [[nodiscard]] std::string
  name() const;
};

/** Whether the name is that of a labelmap or a surface. */
[[nodiscard]] bool
isInputName(const std::string & fileName);

/** One label of an image, or all of it together when none is wanted and it has at most sixteen.
 * \throws BadInput  as chooseLabel */
[[nodiscard]] ChosenSolid
chooseSolid(LabelImage image, const std::optional<LabelValue> & label);

/** Reads a labelmap, or voxelises a closed surface as label 1, and chooses.
 * \throws UsageError  an option that does not fit the kind of file; BadInput, IOError */
[[nodiscard]] ChosenSolid
readSolid(const InputOptions & options);

} // namespace moserhex::app
