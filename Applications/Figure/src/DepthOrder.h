#pragma once

#include "Camera.h"

#include <cstddef>
#include <vector>

namespace moserhex::app
{

/** The order to draw facets in so that those in front cover those behind.
 *
 * Of every two facets that overlap in the picture, the one that is farther from the viewer, on average over the
 * overlap, comes first; facets are taken for fans of triangles around their first corner. What this leaves open, and
 * where facets cover each other in a circle, the one whose corners are farther on average comes first, and of equally
 * far ones the one with the smaller number. Exact for facets that do not cut through each other and of which none cover
 * each other in a circle. Time and memory in proportion to the facets and the overlaps. */
[[nodiscard]] std::vector<std::size_t>
drawingOrder(const std::vector<SeenFacet> & facets);

} // namespace moserhex::app
