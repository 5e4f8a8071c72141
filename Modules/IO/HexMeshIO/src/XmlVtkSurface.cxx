#include "PolygonCollector.h"
#include "VtkMessages.h"
#include "VtkSpace.h"
#include "XmlVtkCheck.h"
#include "moserhex/HexMeshIO/FileErrors.h"

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
  requireHonestXml(fileName, "PolyData", exportSurfaceAgain);
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
