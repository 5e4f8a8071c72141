#include "FileText.h"
#include "ImageHeader.h"
#include "PolygonCollector.h"
#include "VtkMessages.h"
#include "VtkSpace.h"

#include <vtkCellArray.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>

#include <new>

namespace moserhex
{
namespace
{

/** Before VTK's reader asks for memory: no entities, and no count that the file cannot hold. */
void
requireHonestXml(const std::string & fileName)
{
  FileText text(fileName, exportSurfaceAgain, '\0', ErrorCode::Format);
  if (text.contains("<!DOCTYPE") || text.contains("<!ENTITY"))
  {
    text.refuse("DOCTYPE and entities are not allowed");
  }
  if (!text.contains("<VTKFile"))
  {
    text.refuse("the content is not an XML file of VTK");
  }
  if (!text.contains("<PolyData"))
  {
    text.refuse(ErrorCode::Unsupported, "not a surface (no PolyData element)");
  }
  const std::uint64_t most = deflateLimit * text.remaining();
  while (text.contains("NumberOf"))
  {
    text.skipBehind("NumberOf");
    const std::string_view begin = text.peekBytes(80);
    const std::size_t      quote = begin.find_first_of("\"'");
    const std::size_t      end = quote == std::string_view::npos ? quote : begin.find(begin[quote], quote + 1);
    std::uint64_t          count = 0;
    if (end == std::string_view::npos || !parseNumber(begin.substr(quote + 1, end - quote - 1), count))
    {
      text.refuse(ErrorCode::Header, "a count NumberOf... that is none");
    }
    if (count > most)
    {
      text.refuse(ErrorCode::Truncated, "the file is too short for a count of " + std::to_string(count));
    }
  }
}

RawSurface
surfaceOf(const std::string & fileName, vtkPolyData & data)
{
  PolygonCollector surface(fileName);
  for (vtkIdType point = 0; point < data.GetNumberOfPoints(); ++point)
  {
    Vector3 position;
    data.GetPoint(point, position.data());
    surface.addVertex(position);
  }
  if (data.GetStrips() && data.GetStrips()->GetNumberOfCells() > 0)
  {
    throw BadInput(ErrorCode::Unsupported, fileName, "triangle strips, need polygons", "triangulate the surface");
  }
  vtkCellArray * polygons = data.GetPolys();
  if (polygons && !polygons->IsValid())
  {
    throw BadInput(
      ErrorCode::SurfaceIndex, fileName, "the offsets of the polygons do not fit their corners", exportSurfaceAgain);
  }
  vtkNew<vtkIdList>         ids;
  std::vector<std::int64_t> corners;
  for (vtkIdType cell = 0; polygons && cell < polygons->GetNumberOfCells(); ++cell)
  {
    polygons->GetCellAtId(cell, ids);
    corners.assign(ids->begin(), ids->end());
    surface.addPolygon(corners);
  }
  RawSurface raw = surface.finish();
  raw.isRas = saysRas(data.GetFieldData());
  return raw;
}

} // namespace

RawSurface
readVtp(const std::string & fileName)
{
  requireHonestXml(fileName);
  const VtkMessages            messages;
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(fileName.c_str());
  try
  {
    reader->Update();
  }
  catch (const std::bad_alloc &)
  {
    throw BadInput(ErrorCode::Truncated, fileName, "promises more than fits the memory", exportSurfaceAgain);
  }
  if (reader->GetErrorCode() != 0 || !messages.firstError().empty() || !reader->GetOutput())
  {
    throw BadInput(
      ErrorCode::Format, fileName, "not a readable surface (" + messages.firstError() + ")", exportSurfaceAgain);
  }
  return surfaceOf(fileName, *reader->GetOutput());
}

} // namespace moserhex
