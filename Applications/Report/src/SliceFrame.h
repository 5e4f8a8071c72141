#pragma once

#include <string>

namespace moserhex::app
{

/** A slice across the patient, seen as radiologists do: the patient's right is on the left. */
struct SliceFrame
{
  int    axis{ 2 };     ///< of LPS, across the slice: 0 sagittal, 1 coronal, 2 axial
  double place{ 0.0 };  ///< along it [mm]
  double width{ 0.0 };  ///< along the first of the other axes [mm]
  double height{ 0.0 }; ///< along the second [mm]

  /** Pixels of the figure a millimetre. */
  [[nodiscard]] double
  scale() const;

  /** Whether the second of the other axes goes up (Superior), not down as pictures do. */
  [[nodiscard]] bool
  isTurned() const;
};

/** A <figure> with directions, a scale bar and a caption. \param drawing  SVG, in pixels \param what  is shown, as HTML
 * \param id  of an element, once a page */
[[nodiscard]] std::string
framedSlice(const SliceFrame & frame, const std::string & drawing, const std::string & what, const std::string & id);

} // namespace moserhex::app
