#pragma once

#include <filesystem>
#include <string>

namespace moserhex
{

/** The name under which ITK is to read an image: for NIfTI a link image.nii.gz in a folder of its own, which goes with
 * this object; for other formats the file's own name.
 *
 * The NIfTI library tells compressed files by lower-case names alone, and takes the voxels of X.nii.gz from a file
 * X.nii when there is one beside it. Under .nii.gz it reads plain files too. Made before the reading child is started,
 * so that it goes also when that dies. */
class NiftiLink
{
public:
  /** \throws BadInput  see imageFormatOf; IOError  the temporary folder cannot be written */
  explicit NiftiLink(const std::string & fileName);
  ~NiftiLink();
  NiftiLink(const NiftiLink &) = delete;
  NiftiLink &
  operator=(const NiftiLink &) = delete;

  [[nodiscard]] const std::string &
  name() const
  {
    return m_Name;
  }

private:
  std::filesystem::path m_Folder; ///< empty without a link
  std::string           m_Name;
};

} // namespace moserhex
