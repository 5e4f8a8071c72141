// Round-off: what is written is what was given.
#include "moserhex/HexMeshIO/TransformWriter.h"

#include "TestErrors.h"
#include "TestFolder.h"
#include "moserhex/HexMeshIO/TransformFile.h"

#include <gtest/gtest.h>

#include <filesystem>

using namespace moserhex;

TEST(TransformWriter, WritesWhatIsReadBack)
{
  const TestFolder folder;
  AffineTransform  transform;
  transform.matrix << 0.8, -0.6, 0.1, 0.6, 0.8, 1.0 / 3.0, 0.0, -0.2, 1.1;
  transform.translation = Vector3(1e-7, -123.456789012345, 1.0 / 7.0);
  const Positions points{ Vector3(1, 2, 3), Vector3(-100, 50.5, 1e3) };
  for (const char * name : { "a.tfm", "b.TXT" })
  {
    writeTransform(folder / name, transform);
    const Positions moved = transformedByFile(folder / name, points, { false });
    for (std::size_t p = 0; p < points.size(); ++p)
    {
      EXPECT_LT((moved[p] - transform(points[p])).norm(), 1e-12);
    }
  }
}

TEST(TransformWriter, RefusesOtherNames)
{
  const TestFolder folder;
  EXPECT_EQ(errorOf([&] { writeTransform(folder / "a.h5", {}); }).substr(0, 7), "E_USAGE");
  EXPECT_EQ(errorOf([&] { writeTransform(folder / "no/a.tfm", {}); }).substr(0, 11), "E_CANTCREAT");
  EXPECT_FALSE(std::filesystem::exists(folder / "a.h5"));
}
