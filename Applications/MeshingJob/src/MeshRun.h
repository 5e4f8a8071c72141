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
 * \param templateMesh  in memory, where options.templateMesh is only its name in messages; null: it is read from there
 * \throws BadInput, NoMeshError; Cancelled when progress asks for a stop */
[[nodiscard]] PipelineType::Pointer
runPipeline(const ChosenSolid &        solid,
            const ScalarImageType *    density,
            const MeshCommandOptions & options,
            const ProgressCallback &   progress,
            const HexMesh *            templateMesh = nullptr);

} // namespace moserhex::app
