#include "ReportAssets.h"

namespace moserhex::app
{

const ReportAssets *
reportAssets()
{
  return nullptr;
}

} // namespace moserhex::app
