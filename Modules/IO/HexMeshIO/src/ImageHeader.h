#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace moserhex
{

// What the checks of the three image formats share.

/** Deflate compresses at most 1032-fold, so a header that promises more than that lies. */
constexpr std::uint64_t deflateLimit = 1032;

/** Remedies that several refusals share. */
constexpr const char * copyAgain = "copy or export the file again";
constexpr const char * exportScalarVolume = "export the image again as one 3-D scalar volume";

[[nodiscard]] std::string
trimmed(const std::string & text);

/** ASCII only. */
[[nodiscard]] std::string
lowerCase(std::string text);

[[nodiscard]] std::vector<std::string>
wordsOf(const std::string & text);

/** Bytes of three sizes given as text. \throws BadInput  not three counts from 1 to 10^6, or more than 2^40 bytes */
[[nodiscard]] std::uint64_t
promisedBytes(const std::string & file, const std::vector<std::string> & sizes, std::uint64_t bytesPerVoxel);

/** \throws BadInput  fewer bytes present than promised */
void
requireData(const std::string & file, std::uint64_t promised, std::uint64_t present);

/** \throws BadInput  a word of the text, brackets and commas apart, is not a number below 1e9 in size */
void
requireNumbers(const std::string & file, const std::string & what, std::string text);

/** The checks of one format each; see checkImageFile. They return warnings. */
std::vector<std::string>
checkNiftiFile(const std::string & file);
std::vector<std::string>
checkMetaFile(const std::string & file);
std::vector<std::string>
checkNrrdFile(const std::string & file);

/** Lengths of the columns of a NIfTI file's sform: the voxel's sizes again, to a float's digits; nothing when the file
 * has no sform. \throws BadInput  as checkNiftiFile about the header */
[[nodiscard]] std::optional<std::array<double, 3>>
niftiColumnLengths(const std::string & file);

} // namespace moserhex
