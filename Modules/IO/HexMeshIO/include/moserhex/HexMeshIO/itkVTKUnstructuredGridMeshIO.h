#ifndef itkVTKUnstructuredGridMeshIO_h
#define itkVTKUnstructuredGridMeshIO_h

#include <itkMeshIOBase.h>
#include <itkObjectFactoryBase.h>

#include <string>
#include <vector>

namespace itk
{

/** \class VTKUnstructuredGridMeshIO
 * \brief Legacy VTK files (.vtk) with an unstructured grid, for MeshFileWriter and MeshFileReader.
 *
 * ITK's own VTKPolyDataMeshIO writes no volume cells. This one writes vertices, lines, triangles, quadrilaterals,
 * polygons, tetrahedra and hexahedra; point and cell data of any number of components as one array each, PointData and
 * CellData. Version 4.2, SPACE=LPS in the second line, ASCII with as many digits as doubles need, or binary; complete
 * or not at all. It reads hexahedra, as moserhex::readHexCells does; point and cell data are not read.
 *
 *   VTKUnstructuredGridMeshIOFactory::RegisterOneFactory();   // in front of ITK's own, for all .vtk files from then on
 *   itk::WriteMesh(mesh, "organ.vtk");
 *
 * Needs the PointDimension 3. Throws moserhex::IOError and moserhex::BadInput as itk::ExceptionObject. */
class VTKUnstructuredGridMeshIO : public MeshIOBase
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(VTKUnstructuredGridMeshIO);

  using Self = VTKUnstructuredGridMeshIO;
  using Superclass = MeshIOBase;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  const char *
  GetNameOfClass() const override
  {
    return "VTKUnstructuredGridMeshIO";
  }

  /** A name that ends with .vtk and a file whose header says UNSTRUCTURED_GRID. */
  bool
  CanReadFile(const char * fileName) override;

  /** Reads the whole file; the numbers of points and cells, their types and the size of the cells' buffer are known
   * then. \throws ExceptionObject  as moserhex::readHexCells */
  void
  ReadMeshInformation() override;

  /** \param buffer  for 3 doubles a point: x, y, z in LPS [mm] */
  void
  ReadPoints(void * buffer) override;

  /** \param buffer  for 10 SizeValueType a hexahedron: ITK's geometry, 8, and the numbers of its points */
  void
  ReadCells(void * buffer) override;

  ///@{
  /** Does nothing: ReadMeshInformation() finds no data. */
  void
  ReadPointData(void *) override
  {}
  void
  ReadCellData(void *) override
  {}
  ///@}

  /** A name that ends with .vtk. */
  bool
  CanWriteFile(const char * fileName) override;

  /** Begins a mesh. \throws ExceptionObject  points without three coordinates */
  void
  WriteMeshInformation() override;

  ///@{
  /** Keeps a copy for Write(). \param buffer  as ITK describes it by the numbers and types that were set
   * \throws ExceptionObject  numbers of a type that VTK files do not hold */
  void
  WritePoints(void * buffer) override;
  void
  WriteCells(void * buffer) override;
  void
  WritePointData(void * buffer) override;
  void
  WriteCellData(void * buffer) override;
  ///@}

  /** Makes the file of what was kept. \throws ExceptionObject  a kind of cell that is not written, or as
   * moserhex::writeTextFile */
  void
  Write() override;

protected:
  VTKUnstructuredGridMeshIO();
  ~VTKUnstructuredGridMeshIO() override = default;

private:
  std::vector<double>        m_PointValues;     ///< x, y, z of each point
  std::vector<SizeValueType> m_CellEntries;     ///< of ITK: geometry, number of points, their numbers
  std::vector<double>        m_PointDataValues; ///< to be written
  std::vector<double>        m_CellDataValues;
};

/** \class VTKUnstructuredGridMeshIOFactory
 * \brief Makes VTKUnstructuredGridMeshIO known to ITK. */
class VTKUnstructuredGridMeshIOFactory : public ObjectFactoryBase
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(VTKUnstructuredGridMeshIOFactory);

  using Self = VTKUnstructuredGridMeshIOFactory;
  using Superclass = ObjectFactoryBase;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkFactorylessNewMacro(Self);

  const char *
  GetNameOfClass() const override
  {
    return "VTKUnstructuredGridMeshIOFactory";
  }

  /** Of the ITK that this library was built with. */
  const char *
  GetITKSourceVersion() const override;

  /** What it makes, for people. */
  const char *
  GetDescription() const override;

  /** In front of the factories there are, once however often it is called. */
  static void
  RegisterOneFactory();

protected:
  VTKUnstructuredGridMeshIOFactory();
  ~VTKUnstructuredGridMeshIOFactory() override = default;
};

} // namespace itk

#endif
