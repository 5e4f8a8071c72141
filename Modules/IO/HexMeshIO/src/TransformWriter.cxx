#include "moserhex/HexMeshIO/TransformWriter.h"

#include "FileNames.h"
#include "moserhex/HexMeshIO/AtomicFile.h"

#include <iomanip>
#include <limits>
#include <locale>
#include <sstream>

namespace moserhex
{

bool
isWrittenTransformName(const std::string & fileName)
{
  return endsWithAny(fileName, { ".tfm", ".txt" });
}

void
writeTransform(const std::string & fileName, const AffineTransform & transform)
{
  if (!isWrittenTransformName(fileName))
  {
    throw BadInput(ErrorCode::Usage, fileName, "not the name of a transform's text", "give a .tfm or .txt file");
  }
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << std::setprecision(std::numeric_limits<double>::max_digits10)
       << "#Insight Transform File V1.0\n#Transform 0\nTransform: AffineTransform_double_3_3\nParameters:";
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 3; ++column)
    {
      text << ' ' << transform.matrix(row, column);
    }
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    text << ' ' << transform.translation[axis];
  }
  text << "\nFixedParameters: 0 0 0\n";
  writeTextFile(fileName, text.str());
}

} // namespace moserhex
