#include "moserhex/HexMeshIO/itkVTKUnstructuredGridMeshIO.h"

#include "FileNames.h"
#include "moserhex/HexMeshIO/AtomicFile.h"
#include "moserhex/HexMeshIO/HexCellReader.h"

#include <itkVersion.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <limits>
#include <sstream>

namespace itk
{
namespace
{

constexpr SizeValueType entriesOfHexahedron = 10; // geometry, 8, and the numbers

/** ITK's CellGeometryEnum to the cell types of VTK; 0: not written. */
constexpr std::array<int, 7> vtkTypes{ { 1, 3, 5, 9, 7, 10, 12 } };

template <typename TNumber, typename TTo>
std::vector<TTo>
convertedAs(const void * buffer, std::size_t count)
{
  const auto *     numbers = static_cast<const TNumber *>(buffer);
  std::vector<TTo> converted(count);
  std::transform(numbers, numbers + count, converted.begin(), [](TNumber number) { return static_cast<TTo>(number); });
  return converted;
}

/** Numbers of a buffer of which ITK tells the type at run time. */
template <typename TTo>
std::vector<TTo>
converted(const void * buffer, std::size_t count, IOComponentEnum type)
{
  switch (type)
  {
    case IOComponentEnum::UCHAR:
      return convertedAs<unsigned char, TTo>(buffer, count);
    case IOComponentEnum::CHAR:
      return convertedAs<char, TTo>(buffer, count);
    case IOComponentEnum::USHORT:
      return convertedAs<unsigned short, TTo>(buffer, count);
    case IOComponentEnum::SHORT:
      return convertedAs<short, TTo>(buffer, count);
    case IOComponentEnum::UINT:
      return convertedAs<unsigned int, TTo>(buffer, count);
    case IOComponentEnum::INT:
      return convertedAs<int, TTo>(buffer, count);
    case IOComponentEnum::ULONG:
      return convertedAs<unsigned long, TTo>(buffer, count);
    case IOComponentEnum::LONG:
      return convertedAs<long, TTo>(buffer, count);
    case IOComponentEnum::ULONGLONG:
      return convertedAs<unsigned long long, TTo>(buffer, count);
    case IOComponentEnum::LONGLONG:
      return convertedAs<long long, TTo>(buffer, count);
    case IOComponentEnum::FLOAT:
      return convertedAs<float, TTo>(buffer, count);
    case IOComponentEnum::DOUBLE:
      return convertedAs<double, TTo>(buffer, count);
    default:
      itkGenericExceptionMacro("numbers of a type that VTK files do not hold");
  }
}

/** Numbers of a legacy file, as text or as big-endian bytes. */
class LegacyText
{
public:
  explicit LegacyText(bool isBinary) : m_IsBinary(isBinary)
  {
    m_Text.precision(std::numeric_limits<double>::max_digits10);
  }

  void
  line(const std::string & text)
  {
    m_Text << text << '\n';
  }

  template <typename TNumber>
  void
  number(TNumber value, bool isLastOfLine)
  {
    if (!m_IsBinary)
    {
      m_Text << value << (isLastOfLine ? '\n' : ' ');
      return;
    }
    std::array<char, sizeof(TNumber)> bytes{};
    std::memcpy(bytes.data(), &value, sizeof(TNumber));
    std::reverse(bytes.begin(), bytes.end()); // of a little-endian machine
    m_Text.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  }

  /** After the numbers of an array. */
  void
  endOfArray()
  {
    if (m_IsBinary)
    {
      m_Text << '\n';
    }
  }

  /** Rows of `width` numbers. */
  void
  rows(const std::vector<double> & values, std::size_t width)
  {
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      number(values[i], (i + 1) % width == 0);
    }
    endOfArray();
  }

  [[nodiscard]] std::string
  text() const
  {
    return m_Text.str();
  }

private:
  bool               m_IsBinary;
  std::ostringstream m_Text;
};

void
writeData(LegacyText &                file,
          const std::string &         what,
          const std::string &         name,
          const std::vector<double> & values,
          std::size_t                 tuples)
{
  if (tuples == 0 || values.empty())
  {
    return;
  }
  const std::size_t components = values.size() / tuples;
  file.line(what + " " + std::to_string(tuples));
  file.line("FIELD FieldData 1");
  file.line(name + " " + std::to_string(components) + " " + std::to_string(tuples) + " double");
  file.rows(values, components);
}

} // namespace

VTKUnstructuredGridMeshIO::VTKUnstructuredGridMeshIO()
{
  this->AddSupportedWriteExtension(".vtk");
  this->AddSupportedReadExtension(".vtk");
}

bool
VTKUnstructuredGridMeshIO::CanReadFile(const char * fileName)
{
  if (fileName == nullptr || !moserhex::endsWith(fileName, ".vtk"))
  {
    return false;
  }
  std::ifstream file(fileName, std::ios::binary);
  std::string   line;
  for (int number = 0; number < 5 && std::getline(file, line); ++number)
  {
    if (line.find("UNSTRUCTURED_GRID") != std::string::npos)
    {
      return true;
    }
  }
  return false;
}

void
VTKUnstructuredGridMeshIO::ReadMeshInformation()
{
  moserhex::UnstructuredHexMesh mesh;
  try
  {
    mesh = moserhex::readHexCells(this->m_FileName).mesh;
  }
  catch (const moserhex::FileError & error)
  {
    itkExceptionMacro(<< error.what());
  }
  m_PointValues.clear();
  for (const moserhex::Vector3 & node : mesh.nodes)
  {
    m_PointValues.insert(m_PointValues.end(), node.data(), node.data() + 3);
  }
  m_CellEntries.clear();
  for (const auto & cell : mesh.cells)
  {
    m_CellEntries.push_back(static_cast<SizeValueType>(CellGeometryEnum::HEXAHEDRON_CELL));
    m_CellEntries.push_back(cell.size());
    m_CellEntries.insert(m_CellEntries.end(), cell.begin(), cell.end());
  }
  this->m_PointDimension = 3;
  this->m_NumberOfPoints = mesh.nodes.size();
  this->m_NumberOfCells = mesh.cells.size();
  this->m_CellBufferSize = mesh.cells.size() * entriesOfHexahedron;
  this->m_PointComponentType = IOComponentEnum::DOUBLE;
  this->m_CellComponentType = MapComponentType<SizeValueType>::CType;
  this->m_UpdatePoints = true;
  this->m_UpdateCells = true;
}

void
VTKUnstructuredGridMeshIO::ReadPoints(void * buffer)
{
  std::copy(m_PointValues.begin(), m_PointValues.end(), static_cast<double *>(buffer));
}

void
VTKUnstructuredGridMeshIO::ReadCells(void * buffer)
{
  std::copy(m_CellEntries.begin(), m_CellEntries.end(), static_cast<SizeValueType *>(buffer));
}

bool
VTKUnstructuredGridMeshIO::CanWriteFile(const char * fileName)
{
  return fileName != nullptr && moserhex::endsWith(fileName, ".vtk");
}

void
VTKUnstructuredGridMeshIO::WriteMeshInformation()
{
  if (this->m_NumberOfPoints > 0 && this->m_PointDimension != 3)
  {
    itkExceptionMacro(<< "points have " << this->m_PointDimension << " coordinates, need 3");
  }
  m_PointValues.clear();
  m_CellEntries.clear();
  m_PointDataValues.clear();
  m_CellDataValues.clear();
}

void
VTKUnstructuredGridMeshIO::WritePoints(void * buffer)
{
  m_PointValues = converted<double>(buffer, 3 * this->m_NumberOfPoints, this->m_PointComponentType);
}

void
VTKUnstructuredGridMeshIO::WriteCells(void * buffer)
{
  m_CellEntries = converted<SizeValueType>(buffer, this->m_CellBufferSize, this->m_CellComponentType);
}

void
VTKUnstructuredGridMeshIO::WritePointData(void * buffer)
{
  m_PointDataValues = converted<double>(
    buffer, this->m_NumberOfPointPixels * this->m_NumberOfPointPixelComponents, this->m_PointPixelComponentType);
}

void
VTKUnstructuredGridMeshIO::WriteCellData(void * buffer)
{
  m_CellDataValues = converted<double>(
    buffer, this->m_NumberOfCellPixels * this->m_NumberOfCellPixelComponents, this->m_CellPixelComponentType);
}

void
VTKUnstructuredGridMeshIO::Write()
{
  const bool isBinary = this->m_FileType == IOFileEnum::BINARY;
  LegacyText file(isBinary);
  file.line("# vtk DataFile Version 4.2");
  file.line("itk::Mesh; SPACE=LPS");
  file.line(isBinary ? "BINARY" : "ASCII");
  file.line("DATASET UNSTRUCTURED_GRID");
  file.line("POINTS " + std::to_string(this->m_NumberOfPoints) + " double");
  file.rows(m_PointValues, 3);

  std::vector<int> types;
  const auto       entries = m_CellEntries.size() - this->m_NumberOfCells; // VTK's have no geometry
  file.line("CELLS " + std::to_string(this->m_NumberOfCells) + " " + std::to_string(entries));
  for (std::size_t i = 0; i < m_CellEntries.size();)
  {
    const SizeValueType geometry = m_CellEntries[i];
    const SizeValueType points = m_CellEntries[i + 1];
    if (geometry >= vtkTypes.size())
    {
      itkExceptionMacro(<< "cells of ITK's geometry " << geometry << " are not written");
    }
    types.push_back(vtkTypes[geometry]);
    file.number(static_cast<std::int32_t>(points), points == 0);
    for (SizeValueType p = 0; p < points; ++p)
    {
      file.number(static_cast<std::int32_t>(m_CellEntries[i + 2 + p]), p + 1 == points);
    }
    i += 2 + points;
  }
  file.endOfArray();
  file.line("CELL_TYPES " + std::to_string(types.size()));
  for (const int type : types)
  {
    file.number(static_cast<std::int32_t>(type), true);
  }
  file.endOfArray();
  writeData(file, "POINT_DATA", "PointData", m_PointDataValues, this->m_NumberOfPointPixels);
  writeData(file, "CELL_DATA", "CellData", m_CellDataValues, this->m_NumberOfCellPixels);
  try
  {
    moserhex::writeTextFile(this->m_FileName, file.text());
  }
  catch (const moserhex::FileError & error)
  {
    itkExceptionMacro(<< error.what());
  }
}

VTKUnstructuredGridMeshIOFactory::VTKUnstructuredGridMeshIOFactory()
{
  this->RegisterOverride("itkMeshIOBase",
                         "itkVTKUnstructuredGridMeshIO",
                         "Legacy VTK unstructured grids",
                         true,
                         CreateObjectFunction<VTKUnstructuredGridMeshIO>::New());
}

const char *
VTKUnstructuredGridMeshIOFactory::GetITKSourceVersion() const
{
  return ITK_SOURCE_VERSION;
}

const char *
VTKUnstructuredGridMeshIOFactory::GetDescription() const
{
  return "Legacy VTK unstructured grids: meshes with volume cells";
}

void
VTKUnstructuredGridMeshIOFactory::RegisterOneFactory()
{
  static const bool isRegistered = [] {
    ObjectFactoryBase::RegisterFactory(Self::New(), ObjectFactoryEnums::InsertionPosition::INSERT_AT_FRONT);
    return true;
  }();
  (void)isRegistered;
}

} // namespace itk
