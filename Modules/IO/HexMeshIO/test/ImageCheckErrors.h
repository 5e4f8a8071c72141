#pragma once

#include "../src/ImageFileCheck.h"

#include "../src/ImageFile.h"
#include "ImageText.h"
#include "TestErrors.h"
#include "moserhex/HexMeshIO/LabelImageReader.h"

#include <gtest/gtest.h>

namespace moserhex
{

/** A header's field, a value that breaks it, and the code that refuses it. */
struct Refusal
{
  std::string  key;
  std::string  value;
  const char * code;
};

/** The message of checkImageFile's error, or what errorOf says of none. */
inline std::string
checkError(const std::string & fileName)
{
  return errorOf([&] { (void)checkImageFile(fileName, imageFormatOf(fileName)); });
}

inline std::string
checkErrorCode(const std::string & fileName)
{
  const std::string error = checkError(fileName);
  return error.substr(0, error.find(' '));
}

/** Read in this process, so that nothing hides what it does. */
inline LabelImage
readHere(const std::string & fileName)
{
  LabelReadOptions options;
  options.sandbox = false;
  return readLabelImage(fileName, options);
}

inline void
expectTestVoxels(const LabelImage & image)
{
  const std::string expected = ImageText::voxels();
  EXPECT_TRUE(std::equal(expected.begin(), expected.end(), image.image->GetBufferPointer())) << image.fileName;
}

} // namespace moserhex
