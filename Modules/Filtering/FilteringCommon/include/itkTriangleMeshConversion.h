#ifndef itkTriangleMeshConversion_h
#define itkTriangleMeshConversion_h

#include "moserhex/Geometry/TriangleMesh.h"

#include <itkMacro.h>
#include <itkMesh.h>
#include <itkTriangleCell.h>

namespace itk
{

/** Surface mesh with double points. itk::Mesh<double, 3> alone stores points as float. */
using DoubleTriangleMesh = Mesh<double, 3, DefaultStaticMeshTraits<double, 3, 2, double, double, double>>;

/** Copies points and triangles into an itk::Mesh, in order. Any earlier content is replaced. */
template <typename TMesh>
void
CopyTriangleMeshToItk(const moserhex::TriangleMesh & source, TMesh * target)
{
  using CellType = typename TMesh::CellType;
  static_assert(std::is_same<typename TMesh::CoordRepType, double>::value, "points must be stored as double");
  target->Initialize();
  target->GetPoints()->Reserve(source.vertices.size());
  for (std::size_t v = 0; v < source.vertices.size(); ++v)
  {
    typename TMesh::PointType point;
    for (unsigned int a = 0; a < 3; ++a)
    {
      point[a] = source.vertices[v][a];
    }
    target->SetPoint(static_cast<IdentifierType>(v), point);
  }
  for (std::size_t f = 0; f < source.triangles.size(); ++f)
  {
    typename CellType::CellAutoPointer cell;
    cell.TakeOwnership(new TriangleCell<CellType>);
    for (int k = 0; k < 3; ++k)
    {
      cell->SetPointId(k, static_cast<IdentifierType>(source.triangles[f][k]));
    }
    target->SetCell(static_cast<IdentifierType>(f), cell);
  }
}

/** Points of a mesh in the order of their identifiers, which must be 0 to n-1. */
template <typename TMesh>
moserhex::Positions
PositionsFromItk(const TMesh * source)
{
  moserhex::Positions positions(source->GetNumberOfPoints());
  for (std::size_t v = 0; v < positions.size(); ++v)
  {
    typename TMesh::PointType point;
    if (!source->GetPoint(static_cast<IdentifierType>(v), &point))
    {
      itkGenericExceptionMacro("point identifiers must be 0 to " << positions.size() - 1 << "; " << v << " is missing");
    }
    positions[v] = { point[0], point[1], point[2] };
  }
  return positions;
}

/** \throws ExceptionObject  when a cell is not a triangle */
template <typename TMesh>
moserhex::TriangleMesh
TriangleMeshFromItk(const TMesh * source)
{
  moserhex::TriangleMesh mesh;
  mesh.vertices = PositionsFromItk(source);
  mesh.triangles.reserve(source->GetNumberOfCells());
  for (IdentifierType f = 0; f < source->GetNumberOfCells(); ++f)
  {
    typename TMesh::CellType::CellAutoPointer cell;
    if (!source->GetCell(f, cell) || cell->GetNumberOfPoints() != 3)
    {
      itkGenericExceptionMacro("cell " << f << " is not a triangle");
    }
    const auto * ids = cell->GetPointIds();
    mesh.triangles.push_back({ static_cast<moserhex::VertexIndex>(ids[0]),
                               static_cast<moserhex::VertexIndex>(ids[1]),
                               static_cast<moserhex::VertexIndex>(ids[2]) });
  }
  return mesh;
}

} // namespace itk

#endif
