#ifndef itkHexMeshQualityCalculator_h
#define itkHexMeshQualityCalculator_h

#include "itkCoreAlgorithm.h"
#include "itkHexMeshConversion.h"

#include "moserhex/Quality/HexQuality.h"

#include <itkObject.h>
#include <itkObjectFactory.h>

namespace itk
{

/** \class HexMeshQualityCalculator
 * \brief Volume variance, percentage of concave cells and Verdict's quality measures of a hexahedral lattice (stage K).
 *
 * SetMesh(), Compute(), then GetSummary(). */
template <typename TMesh = LatticeHexMesh>
class HexMeshQualityCalculator : public Object
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(HexMeshQualityCalculator);

  using Self = HexMeshQualityCalculator;
  using Superclass = Object;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkOverrideGetNameOfClassMacro(HexMeshQualityCalculator);

  /** A lattice, with or without padding. */
  itkSetConstObjectMacro(Mesh, TMesh);
  itkGetConstObjectMacro(Mesh, TMesh);

  /** \throws ExceptionObject  no mesh, or not a lattice; InvalidInputError  a coordinate is not finite */
  void
  Compute()
  {
    if (m_Mesh.IsNull())
    {
      itkExceptionMacro("no mesh was given");
    }
    try
    {
      m_Summary = moserhex::summarizeQuality(HexMeshFromItk(m_Mesh.GetPointer()));
    }
    catch (const moserhex::InvalidInput & error)
    {
      throw InvalidInputError(__FILE__, __LINE__, error, this->GetNameOfClass());
    }
  }

  /** Of the last Compute(). */
  itkGetConstReferenceMacro(Summary, moserhex::HexQualitySummary);

protected:
  HexMeshQualityCalculator() = default;
  ~HexMeshQualityCalculator() override = default;

  void
  PrintSelf(std::ostream & os, Indent indent) const override
  {
    Superclass::PrintSelf(os, indent);
    os << indent << "VolumeVariance: " << m_Summary.volumeVariance << std::endl;
    os << indent << "ConcavePercent: " << m_Summary.concavePercent << std::endl;
  }

private:
  typename TMesh::ConstPointer m_Mesh;
  moserhex::HexQualitySummary  m_Summary;
};

} // namespace itk

#endif
