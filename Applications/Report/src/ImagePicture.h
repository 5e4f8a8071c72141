#pragma once

#include "CellField.h"
#include "moserhex/LevelSet/FieldVolume.h"
#include "moserhex/LevelSet/LabelVolume.h"

#include <cstddef>
#include <string>
#include <vector>

namespace moserhex::app
{

/** A picture of 255 greys as a URI of data (a bitmap of 8 bits).
 * \param pixels  row by row from the bottom up; 0 black to 254 white, 255: not in the organ, as the page's ground */
[[nodiscard]] std::string
greyPicture(const std::vector<unsigned char> & pixels, std::size_t width);

/** The smallest and the largest number of the first component in an organ. */
[[nodiscard]] CellField::Range
rangeInOrgan(const FieldVolume & image, const LabelVolume & organ);

/** Three grey pictures of an image through the middle of an organ: axial, coronal, sagittal; the first component, from
 * the smallest number in the organ (black) to the largest.
 * \param organ  on the image's voxels, whose axes are those of LPS; not empty
 * \param what   is shown, as HTML \param id  begins the elements' ids */
[[nodiscard]] std::string
pictureFigures(const FieldVolume & image, const LabelVolume & organ, const std::string & what, const std::string & id);

} // namespace moserhex::app
