#pragma once

#include "Camera.h"
#include "Colours.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace moserhex::app
{

enum class PictureFormat
{
  Png,
  Svg
};

/** Where a text stands to its place. */
enum class TextAlign
{
  Left,
  Middle,
  Right
};

struct Pen
{
  Colour colour;
  double width{ 1.0 }; ///< [pixels]
};

/** A picture being drawn by Cairo, pixels from the upper left corner, x to the right and y down. Needs no display. The
 * same calls give the same bytes with the same Cairo and fonts. */
class Canvas
{
public:
  Canvas(PictureFormat format, int width, int height, const Colour & background);
  ~Canvas();
  Canvas(const Canvas &) = delete;
  Canvas &
  operator=(const Canvas &) = delete;

  /** Fills a polygon and draws its outline. */
  void
  polygon(const std::vector<Point2> & outline, const Colour & fill, const std::optional<Pen> & pen = {});

  void
  line(const std::vector<Point2> & points, const Pen & pen);

  /** \param at  of the left end, the middle or the right end of the line that the letters stand on */
  void
  text(const Point2 & at, const std::string & words, double size, const Colour & colour, TextAlign align);

  /** [pixels] */
  [[nodiscard]] double
  textWidth(const std::string & words, double size);

  /** The finished file; nothing can be drawn any more. \throws Error (Internal)  Cairo failed; std::bad_alloc */
  [[nodiscard]] std::string
  finish();

private:
  struct Handles;
  std::unique_ptr<Handles> m_Handles;
};

} // namespace moserhex::app
