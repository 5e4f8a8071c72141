#pragma once

#include "ImageDescription.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace moserhex
{

// What the checks of the three image formats share.

/** Deflate compresses at most 1032-fold. */
constexpr std::uint64_t deflateLimit = 1032;

/** Of an image of vectors, tensors or lists. */
constexpr std::uint64_t mostValuesPerVoxel = 4096;

/** Remedies that several refusals share. */
constexpr const char * copyAgain = "copy or export the file again";
constexpr const char * exportScalarVolume = "export the image again as one 3-D scalar volume";
constexpr const char * correctHeader = "correct the header or export the file again";

[[nodiscard]] std::string
trimmed(const std::string & text);

/** ASCII only. */
[[nodiscard]] std::string
lowerCase(std::string text);

[[nodiscard]] std::vector<std::string>
wordsOf(const std::string & text);

/** What a message quotes of a header: at most 30 characters. */
[[nodiscard]] std::string
quoted(const std::string & text);

/** A refusal of the header. */
[[noreturn]] void
throwHeader(const std::string & file, const std::string & cause);

/** The first bytes of a file, at most so many. \throws IOError */
[[nodiscard]] std::string
beginningOf(const std::string & file, std::size_t bytes);

/** Whole numbers of a header, at least 0, as many as there are words.
 * \throws BadInput (Header)  another kind of word */
[[nodiscard]] std::vector<std::uint64_t>
countsOf(const std::string & file, const std::string & what, const std::string & text);

/** `count` numbers of a header; "nan" and "inf" are numbers here.
 * \throws BadInput (Header)  more, fewer, or other words */
[[nodiscard]] std::vector<double>
numbersOf(const std::string & file, const std::string & what, const std::string & text, std::size_t count);

/** Sets size, component, layers and promised bytes of an image.
 * \throws BadInput (Header)  a size of 0; BadInput (TooBig)  more voxels than the library takes */
void
setVoxels(ImageDescription & image, const std::vector<std::uint64_t> & sizes, ComponentType type, std::uint64_t layers);

/** Sets the grid from the columns of the matrix from voxel numbers to LPS millimetres.
 * \throws BadInput (Geometry)  not finite, voxel sizes outside [1e-3, 1e3], origin beyond 1e6, no right angles
 *         within 1e-3; what rounding does not explain is made orthonormal with a warning */
void
setGeometry(ImageDescription & image, const Matrix3 & columns, const Vector3 & origin);

/** Sets the file of the voxels to `name` in the header's folder.
 * \throws BadInput (Reference)  not a plain name; not an existing regular file; the header itself; a link that leads
 *                               out of the folder */
void
setDataFile(ImageDescription & image, const std::string & name);

/** \throws BadInput (Truncated)  deflate, which compresses at most 1032-fold, cannot have put so many bytes there */
void
requirePlausibleSize(const ImageDescription & image);

/** The checks of one format each; see checkImageHeader. */
[[nodiscard]] ImageDescription
checkNiftiHeader(const std::string & file, VoxelContent content);
[[nodiscard]] ImageDescription
checkMetaHeader(const std::string & file, VoxelContent content);
[[nodiscard]] ImageDescription
checkNrrdHeader(const std::string & file, VoxelContent content);

} // namespace moserhex
