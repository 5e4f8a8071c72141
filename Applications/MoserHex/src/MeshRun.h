#pragma once

#include "MeshOptions.h"
#include "moserhex/HexMeshIO/ScalarImageReader.h"

#include <itkMassPreservingHexahedralMeshFilter.h>

#include <functional>

namespace moserhex::app
{

using PipelineType = itk::MassPreservingHexahedralMeshFilter<LabelImageType, itk::LatticeHexMesh>;

/** Called with the part that is done, in [0,1]. */
using ProgressFunction = std::function<void(double fraction)>;

/** The one call of the pipeline: labelmap in, filter with its results out.
 * \param density   null: equal volumes
 * \param progress  may be empty
 * \throws BadInput, NoMeshError */
[[nodiscard]] PipelineType::Pointer
runPipeline(const ChosenSolid &        solid,
            const ScalarImageType *    density,
            const MeshCommandOptions & options,
            const ProgressFunction &   progress);

} // namespace moserhex::app
