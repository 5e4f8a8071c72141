#pragma once

#include "TransferLog.h"
#include "TransferOptions.h"
#include "moserhex/CubeTransfer/CubeSamples.h"
#include "moserhex/CubeTransfer/FieldFunction.h"

#include <atomic>
#include <string>
#include <vector>

namespace moserhex::app
{

/** Boxes of the cube along each axis. \param option  that says so, for the message \param sampling  "cells" or a number
 * \throws UsageError  neither of them, or not in 1 to 1000 */
[[nodiscard]] int
boxesPerAxis(const std::string & option, const std::string & sampling, int cellsPerAxis);

/** Between voxels: nearest for labels and where the options say so, else linear. */
[[nodiscard]] ImageInterpolation
interpolationOf(const TransferOptions & options);

/** Two Gauss points for each voxel along the edge of a box of mean volume, unless the options say how many.
 * \param boxes  of the cube along each axis */
[[nodiscard]] CubeMeanOptions
meanOptions(const TransferOptions & options, int boxes, const HexMesh & mesh, const VoxelGrid & image);

/** A subject's image as a function of the cube. Points beyond the image or on voxels without data are background, and
 * counted. Keeps references: the arguments must outlive the object. Thread-safe. */
class SubjectFunction
{
public:
  /** \param hasValue  as in FieldImage; \throws InvalidInput  as requireValid(image) */
  SubjectFunction(const FieldVolume &                image,
                  const std::vector<unsigned char> & hasValue,
                  const TransferOptions &            options);
  SubjectFunction(FieldVolume &&, const std::vector<unsigned char> &, const TransferOptions &) = delete;

  [[nodiscard]] int
  components() const
  {
    return m_Components;
  }

  /** \return false: no data there, the values are background */
  bool
  evaluate(const CubePoint & point, double * values) const;

  void
  operator()(const CubePoint & point, double * values) const
  {
    (void)evaluate(point, values);
  }

  /** Of the points asked for, those beyond the image: part in [0,1], 0 before any. */
  [[nodiscard]] double
  partBeyond() const;

  /** \throws BadInput (Geometry)  no point was in the image; warns when some were not */
  void
  requireCover(const TransferLog & log) const;

private:
  FieldFunction                    m_Field;
  int                              m_Components;
  bool                             m_IsMasked;
  const TransferOptions &          m_Options;
  mutable std::atomic<std::size_t> m_Asked{ 0 };
  mutable std::atomic<std::size_t> m_Beyond{ 0 };
};

} // namespace moserhex::app
