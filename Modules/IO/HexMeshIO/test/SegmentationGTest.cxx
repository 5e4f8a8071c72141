// Slicer's .seg.nrrd: 3-D and in layers.
#include "ImageText.h"
#include "TestErrors.h"
#include "moserhex/HexMeshIO/LabelImageReader.h"
#include "moserhex/HexMeshIO/ScalarImageReader.h"

#include <gtest/gtest.h>

#include <map>

using namespace moserhex;

namespace
{

LabelReadOptions
segment(const std::string & choice)
{
  LabelReadOptions options;
  options.segment = choice;
  options.sandbox = false;
  return options;
}

std::string
errorWith(const std::string & fileName, const LabelReadOptions & options)
{
  return errorOf([&] { (void)readLabelImage(fileName, options); });
}

/** Three segments, each key as Slicer 5 writes it. */
ImageText
withSegments(ImageText text, const std::map<std::string, std::string> & changes = {})
{
  std::map<std::string, std::string> keys{ { "Segment0_ID", "Segment_1" },
                                           { "Segment0_Name", "Prostate: all" },
                                           { "Segment0_LabelValue", "1" },
                                           { "Segment0_Layer", "0" },
                                           { "Segment1_ID", "Segment_2" },
                                           { "Segment1_Name", "Tumour" },
                                           { "Segment1_LabelValue", "1" },
                                           { "Segment1_Layer", "1" },
                                           { "Segment2_ID", "Segment_3" },
                                           { "Segment2_Name", "3" },
                                           { "Segment2_LabelValue", "2" },
                                           { "Segment2_Layer", "1" },
                                           { "Segmentation_ReferenceImageExtentOffset", "10 20 30" } };
  for (const auto & [key, value] : changes)
  {
    keys[key] = value;
  }
  for (const auto & [key, value] : keys)
  {
    text = value.empty() ? text : text.withLine(key + ":=" + value);
  }
  return text;
}

/** Layer 0: every labelled voxel is 1. Layer 1: the labels themselves. */
std::string
twoLayers()
{
  std::string bytes;
  for (const char voxel : ImageText::voxels())
  {
    bytes += static_cast<char>(voxel ? 1 : 0);
    bytes += voxel;
  }
  return bytes;
}

ImageText
layered()
{
  return ImageText::nrrd()
    .with("dimension", "4")
    .with("sizes", "2 5 4 3")
    .with("kinds", "list domain domain domain")
    .with("space directions", "none (0.5,0,0) (0,0.75,0) (0,0,2)");
}

} // namespace

TEST(Segmentation, SegmentsOfLayersAreListedAndCounted)
{
  const TestFolder folder;
  writeBytes(folder / "a.seg.nrrd", withSegments(layered()).header() + twoLayers());
  const LabelImage image = readLabelImage(folder / "a.seg.nrrd", segment("Tumour"));
  ASSERT_EQ(image.segments.size(), 3u);
  EXPECT_EQ(image.segments[0].name, "Prostate: all");
  EXPECT_EQ(image.segments[0].id, "Segment_1");
  EXPECT_EQ(image.segments[0].voxels, 3u);
  EXPECT_EQ(image.segments[1].voxels, 2u);
  EXPECT_EQ(image.segments[2].layer, 1);
  EXPECT_EQ(image.segments[2].value, 2);
  EXPECT_EQ(image.segments[2].voxels, 1u);
}

TEST(Segmentation, OneSegmentIsChosenByNameIdOrNumber)
{
  const TestFolder folder;
  writeBytes(folder / "a.seg.nrrd", withSegments(layered()).header() + twoLayers());
  const auto voxelsOf = [&](const std::string & choice) {
    const LabelImage image = readLabelImage(folder / "a.seg.nrrd", segment(choice));
    EXPECT_EQ(image.labels.size(), 1u);
    EXPECT_EQ(voxelCount(labelVolumeOfAll(*image.image)), image.labels[0].voxels);
    return std::pair(image.labels[0].name, image.labels[0].voxels);
  };
  EXPECT_EQ(voxelsOf("Prostate: all"), std::pair(std::string("Prostate: all"), std::size_t{ 3 }));
  EXPECT_EQ(voxelsOf("Segment_2"), std::pair(std::string("Tumour"), std::size_t{ 2 }));
  EXPECT_EQ(voxelsOf("1"), std::pair(std::string("Prostate: all"), std::size_t{ 3 }));
  EXPECT_EQ(voxelsOf("3"), std::pair(std::string("3"), std::size_t{ 1 })); // a name counts before a number
}

TEST(Segmentation, LayersWithoutAChoiceAreRefusedWithTheList)
{
  const TestFolder folder;
  writeBytes(folder / "a.seg.nrrd", withSegments(layered()).header() + twoLayers());
  LabelReadOptions here;
  here.sandbox = false;
  const std::string error = errorWith(folder / "a.seg.nrrd", here);
  EXPECT_EQ(error.substr(0, 11), "E_DIMENSION");
  EXPECT_NE(error.find("1 'Prostate: all', 2 'Tumour', 3 '3'"), std::string::npos) << error;
  EXPECT_EQ(errorOf([&] { (void)readScalarImage(folder / "a.seg.nrrd", { false }); }).substr(0, 11), "E_DIMENSION");
}

TEST(Segmentation, ChoiceThatFitsNoneOrTwoIsRefused)
{
  const TestFolder folder;
  writeBytes(folder / "a.seg.nrrd", withSegments(layered(), { { "Segment1_Name", "3" } }).header() + twoLayers());
  EXPECT_EQ(errorWith(folder / "a.seg.nrrd", segment("4")).substr(0, 8), "E_LABELS");
  EXPECT_NE(errorWith(folder / "a.seg.nrrd", segment("Cyst")).find("it has 1 'Prostate"), std::string::npos);
  EXPECT_NE(errorWith(folder / "a.seg.nrrd", segment("3")).find("several segments"), std::string::npos);
  writeBytes(folder / "a.nrrd", ImageText::nrrd().file());
  EXPECT_NE(errorWith(folder / "a.nrrd", segment("1")).find("names no segments"), std::string::npos);
}

TEST(Segmentation, FlatFileKeepsAllLabelsUnlessOneIsChosen)
{
  const TestFolder folder;
  writeBytes(folder / "a.seg.nrrd",
             withSegments(ImageText::nrrd(),
                          { { "Segment1_Layer", "0" },
                            { "Segment1_LabelValue", "2" },
                            { "Segment2_ID", "" },
                            { "Segment2_Name", "" },
                            { "Segment2_LabelValue", "" },
                            { "Segment2_Layer", "" } })
               .file());
  LabelReadOptions here;
  here.sandbox = false;
  const LabelImage all = readLabelImage(folder / "a.seg.nrrd", here);
  ASSERT_EQ(all.labels.size(), 2u);
  EXPECT_EQ(all.labels[1].name, "Tumour");
  EXPECT_EQ(voxelCount(labelVolumeOfAll(*all.image)), 3u);
  const LabelImage one = readLabelImage(folder / "a.seg.nrrd", segment("Tumour"));
  ASSERT_EQ(one.labels.size(), 1u);
  EXPECT_EQ(one.labels[0].value, 2);
  EXPECT_EQ(voxelCount(labelVolumeOfAll(*one.image)), 1u);
}

TEST(Segmentation, CroppedFileStandsWhereItsOwnOriginIs)
{
  const TestFolder folder;
  writeBytes(folder / "a.seg.nrrd", withSegments(layered()).header() + twoLayers());
  const LabelVolume volume = labelVolumeOf(*readLabelImage(folder / "a.seg.nrrd", segment("1")).image, 1);
  EXPECT_EQ(volume.origin, Vector3(1.0, 2.0, 3.0));
  EXPECT_EQ(volume.point(1, 1, 1), Vector3(1.5, 2.75, 5.0));
  EXPECT_EQ(volume.inside[26], 1);
}

TEST(Segmentation, FilesOfSlicerBeforeLayersAreRead)
{
  const TestFolder                         folder;
  const std::map<std::string, std::string> without{ { "Segment0_LabelValue", "" }, { "Segment0_Layer", "" },
                                                    { "Segment1_LabelValue", "" }, { "Segment1_Layer", "" },
                                                    { "Segment2_ID", "" },         { "Segment2_Name", "" },
                                                    { "Segment2_LabelValue", "" }, { "Segment2_Layer", "" } };
  writeBytes(folder / "a.seg.nrrd", withSegments(layered(), without).header() + twoLayers());
  const LabelImage image = readLabelImage(folder / "a.seg.nrrd", segment("Tumour"));
  EXPECT_EQ(image.segments[1].layer, 1);
  EXPECT_EQ(image.labels[0].voxels, 2u); // value 1 of layer 1
}

TEST(Segmentation, OnlySegmentOfLayersNeedsNoChoice)
{
  const TestFolder                   folder;
  std::map<std::string, std::string> without;
  for (const char * key : { "_ID", "_Name", "_LabelValue", "_Layer" })
  {
    without[std::string("Segment1") + key] = "";
    without[std::string("Segment2") + key] = "";
  }
  writeBytes(folder / "a.seg.nrrd", withSegments(layered(), without).header() + twoLayers());
  LabelReadOptions here;
  here.sandbox = false;
  EXPECT_EQ(readLabelImage(folder / "a.seg.nrrd", here).labels[0].voxels, 3u);
}

TEST(Segmentation, KeysThatAreNoNumbersAreRefused)
{
  const TestFolder folder;
  for (const auto & [key, value] : { std::pair("Segment2_Layer", "7"),
                                     std::pair("Segment2_Layer", "x"),
                                     std::pair("Segment2_LabelValue", "0"),
                                     std::pair("Segment2_LabelValue", "99999999999") })
  {
    writeBytes(folder / "a.seg.nrrd", withSegments(layered(), { { key, value } }).header() + twoLayers());
    EXPECT_EQ(errorWith(folder / "a.seg.nrrd", segment("1")).substr(0, 8), "E_HEADER") << key << ' ' << value;
  }
}

TEST(Segmentation, SegmentWithoutVoxelsIsEmpty)
{
  const TestFolder folder;
  writeBytes(folder / "a.seg.nrrd", withSegments(layered(), { { "Segment2_LabelValue", "9" } }).header() + twoLayers());
  EXPECT_EQ(errorWith(folder / "a.seg.nrrd", segment("Segment_3")).substr(0, 13), "E_EMPTY_LABEL");
}
