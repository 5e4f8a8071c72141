// Closed forms: round-off. Refusals by code.
#include "moserhex/HexMeshIO/TransformFile.h"

#include "TestErrors.h"
#include "TestFolder.h"

#include <gtest/gtest.h>

#include <itkAffineTransform.h>
#include <itkCompositeTransform.h>
#include <itkDisplacementFieldTransform.h>
#include <itkEuler3DTransform.h>
#include <itkHDF5TransformIO.h>
#include <itkMatlabTransformIO.h>
#include <itkTransformFileWriter.h>
#include <itkTranslationTransform.h>
#include <itkTxtTransformIO.h>

#include <cmath>
#include <fstream>

using namespace moserhex;

namespace
{

class TransformFile : public testing::TestWithParam<bool>
{
protected:
  [[nodiscard]] Positions
  transformed(const std::string & name) const
  {
    return transformedByFile(m_Folder / name, { Vector3(1, 2, 3), Vector3(0, 0, 0) }, { GetParam() });
  }

  void
  write(const std::string & name, const std::string & content) const
  {
    std::ofstream(m_Folder / name, std::ios::binary) << content;
  }

  template <typename TIO>
  void
  write(const std::string & name, const itk::Object * transform) const
  {
    const auto writer = itk::TransformFileWriterTemplate<double>::New();
    writer->SetFileName(m_Folder / name);
    writer->SetInput(transform);
    writer->SetTransformIO(TIO::New());
    writer->Update();
  }

  void
  expectRefused(const std::string & name, ErrorCode code) const
  {
    const std::string error = errorOf([&] { (void)transformed(name); });
    EXPECT_EQ(error.substr(0, error.find(' ')), nameOf(code)) << name << ": " << error;
  }

  TestFolder m_Folder;
};

using Affine = itk::AffineTransform<double, 3>;

/** Scaled by 2 and moved by (10, 0, -1). */
Affine::Pointer
affine()
{
  const auto               transform = Affine::New();
  Affine::OutputVectorType shift;
  shift[0] = 10.0;
  shift[1] = 0.0;
  shift[2] = -1.0;
  transform->Scale(2.0);
  transform->Translate(shift);
  return transform;
}

void
expectScaledAndMoved(const Positions & points)
{
  ASSERT_EQ(points.size(), 2u);
  EXPECT_LT((points[0] - Vector3(12, 4, 5)).norm(), 1e-12);
  EXPECT_LT((points[1] - Vector3(10, 0, -1)).norm(), 1e-12);
}

const std::string text = "#Insight Transform File V1.0\n#Transform 0\nTransform: AffineTransform_double_3_3\n"
                         "Parameters: 2 0 0 0 2 0 0 0 2 10 0 -1\nFixedParameters: 0 0 0\n";

} // namespace

TEST_P(TransformFile, OfText)
{
  write("a.tfm", text);
  expectScaledAndMoved(transformed("a.tfm"));
  write("a.TXT", text);
  expectScaledAndMoved(transformed("a.TXT"));
}

TEST_P(TransformFile, OfSinglePrecision)
{
  std::string single = text;
  single.replace(single.find("double"), 6, "float");
  write("a.tfm", single);
  expectScaledAndMoved(transformed("a.tfm"));
}

TEST_P(TransformFile, OfMatlabAsAntsWritesIt)
{
  write<itk::MatlabTransformIOTemplate<double>>("a.mat", affine());
  expectScaledAndMoved(transformed("a.mat"));
}

TEST_P(TransformFile, OfHdf5AsSlicerWritesIt)
{
  write<itk::HDF5TransformIOTemplate<double>>("a.h5", affine());
  expectScaledAndMoved(transformed("a.h5"));
}

TEST_P(TransformFile, OfSeveralPutTogetherTakesTheLastFirst)
{
  const auto                                             move = itk::TranslationTransform<double, 3>::New();
  itk::TranslationTransform<double, 3>::OutputVectorType shift;
  shift.Fill(1.0);
  move->Translate(shift);
  const auto both = itk::CompositeTransform<double, 3>::New();
  both->AddTransform(move);
  both->AddTransform(affine());
  write<itk::HDF5TransformIOTemplate<double>>("a.h5", both);
  const Positions points = transformed("a.h5");
  EXPECT_LT((points[0] - Vector3(13, 5, 6)).norm(), 1e-12);
}

TEST_P(TransformFile, OfTwoRigidPartsInAText)
{
  using Rigid = itk::Euler3DTransform<double>;
  const auto both = itk::CompositeTransform<double, 3>::New();
  for (const double height : { 1.0, 10.0 })
  {
    const auto              part = Rigid::New();
    Rigid::OutputVectorType shift;
    shift.Fill(0.0);
    shift[2] = height;
    part->SetRotation(0.0, 0.0, pi / 4.0);
    part->SetTranslation(shift);
    both->AddTransform(part);
  }
  write<itk::TxtTransformIOTemplate<double>>("a.tfm", both);
  EXPECT_LT((transformed("a.tfm")[0] - Vector3(-2, 1, 14)).norm(), 1e-12);
  const SimilarityTransform found = similarityOfFile(m_Folder / "a.tfm", { GetParam() });
  EXPECT_NEAR(found.angle(), 90.0, 1e-6);
}

TEST_P(TransformFile, OfATextWithAPartOfOtherNumbersIsRefused)
{
  const std::string composite =
    "#Insight Transform File V1.0\n#Transform 0\nTransform: CompositeTransform_double_3_3\n";
  const std::string move = "#Transform 1\nTransform: TranslationTransform_double_3_3\nParameters: 1 2 3\n"
                           "FixedParameters: \n";
  const std::string rest = text.substr(text.find("Transform: "));
  write("whole.tfm", composite + move + "#Transform 2\n" + rest);
  EXPECT_LT((transformed("whole.tfm")[1] - Vector3(11, 2, 2)).norm(), 1e-12);
  std::string other = composite + move + "#Transform 2\n" + rest;
  other.insert(other.find(" 2 3\n"), " 7");
  write("other.tfm", other);
  expectRefused("other.tfm", ErrorCode::Truncated);
}

TEST_P(TransformFile, OfElastixsOwnFormatIsRefusedWithTheRemedy)
{
  write("TransformParameters.0.txt",
        "(Transform \"EulerTransform\")\n(NumberOfParameters 6)\n(TransformParameters 0 0 0.1 1 2 3)\n");
  const std::string error = errorOf([&] { (void)transformed("TransformParameters.0.txt"); });
  EXPECT_EQ(error.substr(0, 13), "E_UNSUPPORTED") << error;
  EXPECT_NE(error.find("a parameter file of elastix"), std::string::npos) << error;
  EXPECT_NE(error.find("ITKTransformOutputFileNameExtension"), std::string::npos) << error;
}

TEST_P(TransformFile, OfADisplacementField)
{
  using Field = itk::DisplacementFieldTransform<double, 3>;
  const auto                             field = Field::DisplacementFieldType::New();
  Field::DisplacementFieldType::SizeType size;
  size.Fill(5);
  field->SetRegions(size);
  field->Allocate();
  Field::OutputVectorType shift;
  shift.Fill(0.5);
  field->FillBuffer(shift);
  const auto transform = Field::New();
  transform->SetDisplacementField(field);
  write<itk::HDF5TransformIOTemplate<double>>("a.h5", transform);
  EXPECT_LT((transformed("a.h5")[0] - Vector3(1.5, 2.5, 3.5)).norm(), 1e-12);
}

TEST_P(TransformFile, OfASimilarityIsFoundAgain)
{
  write("a.tfm", text);
  const SimilarityTransform found = similarityOfFile(m_Folder / "a.tfm", { GetParam() });
  EXPECT_NEAR(found.scale, 2.0, 1e-12);
  EXPECT_LT((found.rotation - Matrix3::Identity()).norm(), 1e-12);
  EXPECT_LT((found.translation - Vector3(10, 0, -1)).norm(), 1e-10);
}

TEST_P(TransformFile, ThatShearsOrMirrorsIsNoSimilarity)
{
  for (const char * matrix : { "1 0.1 0 0 1 0 0 0 1", "-1 0 0 0 1 0 0 0 1" })
  {
    std::string other = text;
    other.replace(other.find("2 0 0 0 2 0 0 0 2"), 17, matrix);
    write("a.tfm", other);
    const std::string error = errorOf([&] { (void)similarityOfFile(m_Folder / "a.tfm", { GetParam() }); });
    EXPECT_EQ(error.substr(0, 13), "E_UNSUPPORTED") << error;
  }
}

TEST_P(TransformFile, RefusesWhatIsNone)
{
  expectRefused("missing.tfm", ErrorCode::NoInput);
  write("a.xfm", text);
  expectRefused("a.xfm", ErrorCode::Usage);
  write("empty.tfm", "");
  expectRefused("empty.tfm", ErrorCode::Format);
  write("noNumbers.tfm", text.substr(0, text.find("Parameters") + 14));
  expectRefused("noNumbers.tfm", ErrorCode::Truncated);
  write("cut.tfm", text.substr(0, text.size() - 1));
  expectRefused("cut.tfm", ErrorCode::Truncated);
  write("short.tfm", text.substr(0, text.size() - 3) + "\n");
  expectRefused("short.tfm", ErrorCode::Format);
  write("words.tfm", "not a transform\n");
  expectRefused("words.tfm", ErrorCode::Format);
  write("a.h5", text);
  expectRefused("a.h5", ErrorCode::Format);
  std::string plane = text;
  plane.replace(plane.find("3_3\nParameters: 2 0 0 0 2 0 0 0 2 10 0 -1"), 42, "2_2\nParameters: 2 0 0 2 10 0\n");
  plane.replace(plane.find("FixedParameters: 0 0 0"), 22, "FixedParameters: 0 0");
  write("plane.tfm", plane);
  expectRefused("plane.tfm", ErrorCode::Unsupported);
  std::string notFinite = text;
  notFinite.replace(notFinite.find("10 0 -1"), 7, "nan 0 0");
  write("nan.tfm", notFinite);
  expectRefused("nan.tfm", ErrorCode::Format);
}

INSTANTIATE_TEST_SUITE_P(Read, TransformFile, testing::Bool(), [](const auto & parameter) {
  return std::string(parameter.param ? "InAChild" : "Here");
});
