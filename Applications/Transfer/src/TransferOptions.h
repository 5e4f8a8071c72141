#pragma once

#include <string>
#include <vector>

namespace moserhex::app
{

struct TransferOptions
{
  std::string         input;  ///< an image of a subject or of the cube, or a list of points
  std::string         mesh;   ///< of the subject
  std::string         toMesh; ///< of another subject; empty: none
  std::string         toCube; ///< the one output that is given says where to
  std::string         toImage;
  std::string         toPoints;
  std::string         like;                ///< image whose grid the output gets
  std::vector<double> spacing;             ///< of a new grid around the mesh, one or three numbers [mm]
  std::string         sampling{ "cells" }; ///< "cells", "nodes", or a number per axis
  bool                labels{ false };
  std::string         segment; ///< of --labels and a .seg.nrrd: name, ID or number; empty: all
  bool                fractions{ false };
  bool                conserve{ false };
  bool                rotate{ false };
  std::string         valuesIn; ///< "LPS" or "RAS": space of vectors and tensors to rotate; empty: as the file says
  bool                nearest{ false };
  double              background{ 0.0 };
  int                 pointsPerAxis{ 0 }; ///< Gauss points; 0: two for each voxel along a cell
  bool                sandbox{ true };
  unsigned int        threads{ 0 };
};

} // namespace moserhex::app
