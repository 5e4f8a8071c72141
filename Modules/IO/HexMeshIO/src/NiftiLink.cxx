#include "NiftiLink.h"

#include "ImageFileCheck.h"
#include "moserhex/HexMeshIO/FileErrors.h"

#include <stdlib.h>

namespace moserhex
{

namespace fs = std::filesystem;

NiftiLink::NiftiLink(const std::string & fileName) : m_Name(fileName)
{
  if (imageFormatOf(fileName) != ImageFormat::Nifti)
  {
    return;
  }
  std::error_code error;
  std::string     folder = (fs::temp_directory_path(error) / "moserhex-link-XXXXXX").string();
  const bool      made = !error && ::mkdtemp(folder.data());
  m_Folder = made ? folder : "";
  m_Name = (m_Folder / "image.nii.gz").string();
  if (made)
  {
    fs::create_symlink(fs::absolute(fileName), m_Name, error);
  }
  if (!made || error)
  {
    fs::remove_all(m_Folder, error);
    throw IOError(ErrorCode::InputOutput,
                  fileName,
                  "cannot make a link to it in the temporary folder",
                  "set TMPDIR to another one");
  }
}

NiftiLink::~NiftiLink()
{
  if (!m_Folder.empty())
  {
    std::error_code ignored;
    fs::remove_all(m_Folder, ignored); // the link, not its target
  }
}

} // namespace moserhex
