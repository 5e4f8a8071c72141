#pragma once

#include "TransferLog.h"
#include "TransferOptions.h"
#include "moserhex/Geometry/HexMesh.h"
#include "moserhex/HexMeshIO/FieldImageReader.h"
#include "moserhex/HexMeshIO/FieldImageWriter.h"
#include "moserhex/HexMeshIO/LabelImageReader.h"

#include <string>
#include <vector>

namespace moserhex::app
{

constexpr LabelValue mostLabelValue = 65535; ///< of segmentations, far above what they hold

/** An image to transfer. Labels are numbers of one component. */
struct TransferImage
{
  FieldVolume                volume;
  std::vector<unsigned char> hasValue;                     ///< as in FieldImage
  std::vector<LabelEntry>    labels;                       ///< of a labelmap, ascending, 0 apart
  FieldValues                kind{ FieldValues::Numbers }; ///< of what the file holds, or the options say
  ValueAxes                  axes{ ValueAxes::Lps };       ///< of vectors and tensors
};

/** Reads a lattice that may be transferred by: no padding, all cells of positive volume.
 * \throws BadInput, IOError */
[[nodiscard]] HexMesh
readTransferMesh(const std::string & fileName, const TransferOptions & options);

/** Reads the input, as labels or numbers, and tells its warnings. Vectors and tensors that are to be turned are put
 * into LPS.
 * \throws BadInput (Geometry)  it is to be turned and nothing says in which space its values are, or they are in the
 * cube's axes and not to be turned back; (PixelType) they are neither vectors nor tensors; IOError */
[[nodiscard]] TransferImage
readTransferImage(const TransferOptions & options, const TransferLog & log);

/** The grid of the reference image, whose warnings are told, or a new one along LPS around the mesh.
 * \param components  numbers in each of its voxels
 * \throws UsageError  more numbers than an image file may hold; BadInput, IOError */
[[nodiscard]] VoxelGrid
readTargetGrid(const TransferOptions & options, const HexMesh & mesh, int components, const TransferLog & log);

/** \throws UsageError  so many numbers are more than an image file may hold \param option  that asks for them */
void
requireWritableSize(double numbers, const std::string & option);

/** How the output's numbers are kept: as the input's, and six that were turned as tensors. */
[[nodiscard]] FieldValues
valuesOf(const TransferOptions & options, const TransferImage & image);

} // namespace moserhex::app
