#pragma once

#include "MeshOptions.h"
#include "TemplateInputs.h"
#include "moserhex/Common/StepReport.h"
#include "moserhex/HexMeshIO/ScalarImageReader.h"

#include <itkMassPreservingHexahedralMeshFilter.h>

#include <optional>

namespace moserhex::app
{

using PipelineType = itk::MassPreservingHexahedralMeshFilter<LabelImageType, itk::LatticeHexMesh>;

/** What a run works with besides the label. */
struct PipelineInputs
{
  const ScalarImageType *       density{ nullptr }; ///< null: equal volumes
  std::optional<TemplateInputs> tied;               ///< empty: a mesh of its own
};

/** The one call of the pipeline: labelmap in, filter with its results out.
 * \param progress  may be empty
 * \throws BadInput, NoMeshError; Cancelled when progress asks for a stop */
[[nodiscard]] PipelineType::Pointer
runPipeline(const ChosenSolid &        solid,
            const PipelineInputs &     inputs,
            const MeshCommandOptions & options,
            const ProgressCallback &   progress);

} // namespace moserhex::app
