#pragma once

#include "LabelShares.h"
#include "SubjectFunction.h"
#include "TransferFiles.h"

namespace moserhex::app
{

/** Brings a subject's image into the cube by the subject's mesh, as the options say, and tells what was lost. Keeps
 * references: the arguments must outlive the object. */
class SubjectSampler
{
public:
  /** \throws InvalidInput  as SubjectFunction */
  SubjectSampler(const TransferImage &   image,
                 const HexMesh &         mesh,
                 const TransferOptions & options,
                 const TransferLog &     log);

  /** Means or labels of boxes, or samples at nodes.
   * \throws BadInput (Geometry)  the image does not reach the mesh; UsageError */
  [[nodiscard]] FieldVolume
  cube() const;

  /** Means whose integral over the mesh is known to 1e-6, or a warning says how far it is. \throws as cube() */
  [[nodiscard]] CubeMeans
  conservedMeans() const;

  /** Volumes of the labels in the organ, by its own cells; none where it has too many, which is told. */
  [[nodiscard]] LabelAmounts
  labelVolumes() const;

private:
  [[nodiscard]] FieldVolume
  nodes() const;

  [[nodiscard]] FieldVolume
  labels() const;

  [[nodiscard]] FieldVolume
  means() const;

  /** Boxes of the cube along each axis. \throws UsageError  not a number, or nodes */
  [[nodiscard]] int
  boxes() const;

  [[nodiscard]] CubeMeanOptions
  rule(int boxes) const;

  const TransferImage &   m_Image;
  const HexMesh &         m_Mesh;
  const TransferOptions & m_Options;
  const TransferLog &     m_Log;
  SubjectFunction         m_Function; ///< counts what lies beyond the image: asked for the output only
};

} // namespace moserhex::app
