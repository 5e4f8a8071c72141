#pragma once

#include "TransferFiles.h"
#include "moserhex/CubeTransfer/CubePoint.h"
#include "moserhex/CubeTransfer/FieldFunction.h"

#include <atomic>

namespace moserhex::app
{

/** The nearest voxel's value for labels and where it is asked for. */
[[nodiscard]] ImageInterpolation
interpolationOf(const TransferOptions & options);

/** A subject's image as a function of the cube. Points beyond the image or its mask are background, and counted. Keeps
 * references: image and options must outlive the object. Thread-safe. */
class SubjectFunction
{
public:
  SubjectFunction(const TransferImage & image, const TransferOptions & options);

  [[nodiscard]] int
  components() const
  {
    return m_Components;
  }

  void
  operator()(const CubePoint & point, double * values) const;

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
