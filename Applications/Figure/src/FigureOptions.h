#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

namespace moserhex::app
{

struct FigureOptions
{
  std::string           mesh;
  std::string           output;                      ///< .png or .svg
  std::string           kind{ "surface" };           ///< one of figureKinds
  std::string           colour{ "scaled-jacobian" }; ///< one of figureColours, or as valuesOfArray
  std::string           labelImage;                  ///< labelmap of colour "label"
  std::vector<int>      shells;                      ///< to show; empty: up to four, from the outermost inwards
  std::string           layout{ "apart" };           ///< one of figureLayouts, of kind "shells"
  std::string           plane{ "axial" };            ///< of kind "slice": see parsePlane
  int                   width{ 1200 };               ///< [pixels]
  int                   height{ 900 };               ///< [pixels]
  std::optional<double> azimuth;                     ///< of the viewer: 0 anterior, 90 at the patient's left [degrees]
  std::optional<double> elevation;                   ///< of the viewer: 90 superior [degrees]
  std::vector<double>   range;                       ///< lowest and highest number of the colours; empty: from the data
  std::string           title;
  std::string           background{ "white" }; ///< white, black, none or RRGGBB
  bool                  edges{ true };         ///< lines around cells
  bool                  sandbox{ true };       ///< files are read in a child process with limits
  unsigned int          threads{ 0 };          ///< 0: all of the machine's
};

/** The values that options in words may have. */
inline const std::vector<std::string> figureKinds{ "surface", "shells", "slice" };
inline const std::vector<std::string> figureColours{ "scaled-jacobian", "volume", "aspect", "taper", "shell", "label" };
inline const std::vector<std::string> figureLayouts{ "apart", "nested" };

/** Whether colours are by a measure, for which no array of the file is needed. */
[[nodiscard]] inline bool
isFigureColour(const std::string & colour)
{
  return std::find(figureColours.begin(), figureColours.end(), colour) != figureColours.end();
}

inline constexpr int smallestPicture = 200; ///< [pixels]
inline constexpr int largestPicture = 8000; ///< [pixels]

} // namespace moserhex::app
