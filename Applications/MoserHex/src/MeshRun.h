#pragma once

#include "MeshCommand.h"
#include "moserhex/HexMeshIO/ScalarImageReader.h"

#include <itkMassPreservingHexahedralMeshFilter.h>

namespace moserhex::app
{

using PipelineType = itk::MassPreservingHexahedralMeshFilter<LabelImageType, itk::LatticeHexMesh>;

/** The one call of the pipeline: labelmap in, filter with its results out.
 * \param density  null: equal volumes
 * \throws BadInput, NoMeshError */
[[nodiscard]] PipelineType::Pointer
runPipeline(const ChosenSolid & solid, const ScalarImageType * density, const MeshCommandOptions & options);

} // namespace moserhex::app
