#include "moserhex/HexMeshIO/TransformFile.h"

#include "FileNames.h"
#include "FileText.h"
#include "ImageFileCheck.h"
#include "Parcel.h"
#include "ReaderSandbox.h"

#include <itkCompositeTransform.h>
#include <itkHDF5TransformIO.h>
#include <itkMatlabTransformIO.h>
#include <itkTransform.h>
#include <itkTransformFileReader.h>
#include <itkTxtTransformIO.h>

#include <Eigen/LU>

#include <string>
#include <string_view>
#include <vector>

namespace moserhex
{
namespace
{

using TransformType = itk::Transform<double, 3, 3>;
using ReaderType = itk::TransformFileReaderTemplate<double>;

constexpr const char * remedy = "give one transform written by ITK, Slicer or ANTs";

itk::TransformIOBaseTemplate<double>::Pointer
ioFor(const std::string & fileName)
{
  if (endsWithAny(fileName, { ".h5", ".hdf", ".hdf5" }))
  {
    return itk::HDF5TransformIOTemplate<double>::New().GetPointer();
  }
  if (endsWith(fileName, ".mat"))
  {
    return itk::MatlabTransformIOTemplate<double>::New().GetPointer();
  }
  return itk::TxtTransformIOTemplate<double>::New().GetPointer();
}

/** The transforms that have numbers of their own in a text: of a composite its parts, in their order. */
std::vector<const TransformType *>
partsOf(const TransformType & transform)
{
  const auto * composite = dynamic_cast<const itk::CompositeTransform<double, 3> *>(&transform);
  if (composite == nullptr)
  {
    return { &transform };
  }
  std::vector<const TransformType *> parts;
  for (itk::SizeValueType part = 0; part < composite->GetNumberOfTransforms(); ++part)
  {
    parts.push_back(composite->GetNthTransformConstPointer(part));
  }
  return parts;
}

/** Whether the line begins one of partsOf. */
bool
beginsPart(const std::vector<std::string_view> & words)
{
  constexpr std::string_view key = "Transform:";
  if (words.front().substr(0, key.size()) != key)
  {
    return false;
  }
  const std::string_view type = words.size() > 1 ? words[1] : words.front().substr(key.size());
  return type.find("CompositeTransform") == std::string_view::npos;
}

/** ITK reads a text that was cut as a transform with other numbers, without a word.
 * \throws BadInput  not as many numbers as each transform in it has, or an unfinished last line */
void
requireComplete(const std::string & fileName, const TransformType & transform)
{
  const std::vector<const TransformType *> parts = partsOf(transform);
  std::size_t                              begun = 0;
  FileText                                 text(fileName, remedy, '#', ErrorCode::Format);
  if (!text.endsWithNewLine())
  {
    throw BadInput(ErrorCode::Truncated, fileName, "the last line has no end", remedy);
  }
  std::vector<std::string_view> words;
  while (text.nextWords(words))
  {
    begun += beginsPart(words) ? 1 : 0;
    const bool isFixed = words.front() == "FixedParameters:";
    if (isFixed || words.front() == "Parameters:")
    {
      if (begun == 0 || begun > parts.size())
      {
        text.refuse("numbers of no transform of " + std::to_string(parts.size()));
      }
      const TransformType & part = *parts[begun - 1];
      const std::size_t     needed = isFixed ? part.GetFixedParameters().Size() : part.GetNumberOfParameters();
      if (words.size() - 1 != needed)
      {
        throw BadInput(ErrorCode::Truncated,
                       fileName,
                       std::to_string(words.size() - 1) + " numbers after " + std::string(words.front()) + " need " +
                         std::to_string(needed),
                       remedy);
      }
    }
  }
}

/** \throws BadInput  elastix's own format, which says of a transform what only elastix understands */
void
requireNotOfElastix(const std::string & fileName)
{
  constexpr const char * itsRemedy = "run elastix with (ITKTransformOutputFileNameExtension \"tfm\") and give that";
  const FileText         text(fileName, itsRemedy, '\0', ErrorCode::Unsupported);
  if (text.contains("(Transform \""))
  {
    text.refuse("a parameter file of elastix, not a transform of ITK");
  }
}

TransformType::ConstPointer
readTransform(const std::string & fileName)
{
  const bool isText = endsWithAny(fileName, { ".tfm", ".txt" });
  if (isText)
  {
    requireNotOfElastix(fileName);
  }
  const auto reader = ReaderType::New();
  reader->SetFileName(fileName);
  reader->SetTransformIO(ioFor(fileName));
  try
  {
    reader->Update();
  }
  catch (const itk::ExceptionObject & error)
  {
    throw BadInput(ErrorCode::Format, fileName, oneLine(error.GetDescription(), 100), remedy);
  }
  const auto & transforms = *reader->GetTransformList();
  if (transforms.size() != 1)
  {
    throw BadInput(ErrorCode::Unsupported, fileName, std::to_string(transforms.size()) + " transforms", remedy);
  }
  const auto * transform = dynamic_cast<const TransformType *>(transforms.front().GetPointer());
  if (transform == nullptr)
  {
    throw BadInput(ErrorCode::Unsupported, fileName, "not a transform of points in space", remedy);
  }
  if (isText)
  {
    requireComplete(fileName, *transform);
  }
  return transform;
}

Positions
transformed(const std::string & fileName, const Positions & points)
{
  const TransformType::ConstPointer transform = readTransform(fileName);
  Positions                         result;
  result.reserve(points.size());
  for (const Vector3 & point : points)
  {
    const TransformType::OutputPointType moved = transform->TransformPoint(TransformType::InputPointType(point.data()));
    result.emplace_back(moved[0], moved[1], moved[2]);
    if (!result.back().allFinite())
    {
      throw BadInput(ErrorCode::Format, fileName, "it takes a point to one that is not finite", remedy);
    }
  }
  return result;
}

} // namespace

bool
isTransformName(const std::string & fileName)
{
  return endsWithAny(fileName, { ".tfm", ".txt", ".h5", ".hdf", ".hdf5", ".mat" });
}

Positions
transformedByFile(const std::string & fileName, const Positions & points, const ReadOptions & options)
{
  if (!isTransformName(fileName))
  {
    throw BadInput(ErrorCode::Usage, fileName, "not a transform's name", "give a .tfm, .txt, .h5 or .mat file");
  }
  requireRegularFile(fileName);
  if (!options.sandbox)
  {
    return transformed(fileName, points);
  }
  const auto work = [&] {
    ParcelWriter parcel{ {} };
    parcel.put(transformed(fileName, points));
    return parcel.take();
  };
  const std::string parcel = runInSandbox(fileName, {}, work);
  return ParcelReader(parcel, 0).positions();
}

SimilarityTransform
similarityOfFile(const std::string & fileName, const ReadOptions & options)
{
  constexpr double halfSide = 100.0;
  constexpr double largestError = 0.01; // rotations of six decimals stay below
  Positions        corners;
  for (unsigned int corner = 0; corner < 8; ++corner)
  {
    const auto sign = [corner](unsigned int axis) { return (corner >> axis & 1U) != 0 ? halfSide : -halfSide; };
    corners.emplace_back(sign(0), sign(1), sign(2));
  }
  const auto refuse = [&fileName]() {
    throw BadInput(ErrorCode::Unsupported,
                   fileName,
                   "it does more than to move, turn and scale all axes alike",
                   "give a rigid transform");
  };
  const Positions moved = transformedByFile(fileName, corners, options);
  Matrix3         axes;
  axes << moved[1] - moved[0], moved[2] - moved[0], moved[4] - moved[0];
  if (axes.determinant() <= 0.0)
  {
    refuse();
  }
  const SimilarityTransform similarity = similarityAlignment(corners, moved);
  for (std::size_t corner = 0; corner < corners.size(); ++corner)
  {
    if ((similarity(corners[corner]) - moved[corner]).norm() > largestError)
    {
      refuse();
    }
  }
  return similarity;
}

} // namespace moserhex
