#include "Canvas.h"

#include "moserhex/Common/Errors.h"

#include <cairo/cairo-svg.h>
#include <cairo/cairo.h>

#include <new>

namespace moserhex::app
{
namespace
{

extern "C" cairo_status_t
appendBytes(void * bytes, const unsigned char * data, unsigned int length)
{
  static_cast<std::string *>(bytes)->append(reinterpret_cast<const char *>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

void
requireSuccess(cairo_status_t status)
{
  if (status == CAIRO_STATUS_NO_MEMORY)
  {
    throw std::bad_alloc();
  }
  if (status != CAIRO_STATUS_SUCCESS)
  {
    throw Error(ErrorCode::Internal, std::string("Cairo: ") + cairo_status_to_string(status));
  }
}

/** Cairo numbers the surfaces of a process; the number in a file's only group must not depend on what was drawn before.
 */
void
forgetNumberOfSurface(std::string & svg)
{
  const std::string before = "<g id=\"surface";
  const std::size_t found = svg.find(before);
  if (found != std::string::npos)
  {
    const std::size_t number = found + before.size();
    svg.replace(number, svg.find('"', number) - number, "1");
  }
}

/** Hinting would move letters by parts of a pixel from one size to the next. */
void
chooseFont(cairo_t * context)
{
  cairo_select_font_face(context, "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
  cairo_font_options_t * options = cairo_font_options_create();
  cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
  cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
  cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
  cairo_set_font_options(context, options);
  cairo_font_options_destroy(options);
}

} // namespace

struct Canvas::Handles
{
  PictureFormat     format;
  std::string       bytes;
  cairo_surface_t * surface{ nullptr };
  cairo_t *         context{ nullptr };

  ~Handles()
  {
    cairo_destroy(context);
    cairo_surface_destroy(surface);
  }

  void
  use(const Colour & colour) const
  {
    cairo_set_source_rgba(context, colour.red, colour.green, colour.blue, colour.alpha);
  }

  void
  trace(const std::vector<Point2> & points) const
  {
    cairo_new_path(context);
    for (const Point2 & point : points)
    {
      cairo_line_to(context, point[0], point[1]);
    }
  }
};

Canvas::Canvas(PictureFormat format, int width, int height, const Colour & background)
  : m_Handles(std::make_unique<Handles>())
{
  m_Handles->format = format;
  if (format == PictureFormat::Png)
  {
    m_Handles->surface = cairo_image_surface_create(CAIRO_FORMAT_ARGB32, width, height);
  }
  else
  {
    m_Handles->surface = cairo_svg_surface_create_for_stream(appendBytes, &m_Handles->bytes, width, height);
    cairo_svg_surface_set_document_unit(m_Handles->surface, CAIRO_SVG_UNIT_PX);
  }
  m_Handles->context = cairo_create(m_Handles->surface);
  requireSuccess(cairo_status(m_Handles->context));
  chooseFont(m_Handles->context);
  cairo_set_line_join(m_Handles->context, CAIRO_LINE_JOIN_ROUND);
  cairo_set_line_cap(m_Handles->context, CAIRO_LINE_CAP_ROUND);
  if (background.alpha > 0.0)
  {
    m_Handles->use(background);
    cairo_paint(m_Handles->context);
  }
}

Canvas::~Canvas() = default;

void
Canvas::polygon(const std::vector<Point2> & outline, const Colour & fill, const std::optional<Pen> & pen)
{
  cairo_t * context = m_Handles->context;
  m_Handles->trace(outline);
  cairo_close_path(context);
  m_Handles->use(fill);
  cairo_fill_preserve(context);
  if (pen)
  {
    m_Handles->use(pen->colour);
    cairo_set_line_width(context, pen->width);
    cairo_stroke_preserve(context);
  }
  cairo_new_path(context);
}

void
Canvas::line(const std::vector<Point2> & points, const Pen & pen)
{
  m_Handles->trace(points);
  m_Handles->use(pen.colour);
  cairo_set_line_width(m_Handles->context, pen.width);
  cairo_stroke(m_Handles->context);
}

void
Canvas::text(const Point2 & at, const std::string & words, double size, const Colour & colour, TextAlign align)
{
  const double width = textWidth(words, size);
  const double before = align == TextAlign::Left ? 0.0 : align == TextAlign::Middle ? 0.5 * width : width;
  m_Handles->use(colour);
  cairo_move_to(m_Handles->context, at[0] - before, at[1]);
  cairo_show_text(m_Handles->context, words.c_str());
}

double
Canvas::textWidth(const std::string & words, double size)
{
  cairo_set_font_size(m_Handles->context, size);
  cairo_text_extents_t extents;
  cairo_text_extents(m_Handles->context, words.c_str(), &extents);
  return extents.x_advance;
}

std::string
Canvas::finish()
{
  requireSuccess(cairo_status(m_Handles->context));
  if (m_Handles->format == PictureFormat::Png)
  {
    requireSuccess(cairo_surface_write_to_png_stream(m_Handles->surface, appendBytes, &m_Handles->bytes));
  }
  cairo_surface_finish(m_Handles->surface);
  requireSuccess(cairo_surface_status(m_Handles->surface));
  if (m_Handles->format == PictureFormat::Svg)
  {
    forgetNumberOfSurface(m_Handles->bytes);
  }
  return std::move(m_Handles->bytes);
}

} // namespace moserhex::app
