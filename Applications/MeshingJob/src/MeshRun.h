#pragma once

#include "MeshOptions.h"
#include "moserhex/Common/StepReport.h"
#include "moserhex/HexMeshIO/ScalarImageReader.h"

#include <itkMassPreservingHexahedralMeshFilter.h>

namespace moserhex::app
{

using PipelineType = itk::MassPreservingHexahedralMeshFilter<LabelImageType, itk::LatticeHexMesh>;

/** The one call of the pipeline: labelmap in, filter with its results out.
 * \param density   null: equal volumes
 * \param progress  may be empty
 * \throws BadInput, NoMeshError; Cancelled when progress asks for a stop */
[[nodiscard]] PipelineType::Pointer
runPipeline(const ChosenSolid &        solid,
            const ScalarImageType *    density,
            const MeshCommandOptions & options,
            const ProgressCallback &   progress);

} // namespace moserhex::app
