#include "Arguments.h"

#include "moserhex/HexMeshIO/FileErrors.h"

#include <initializer_list>
#include <utility>

namespace moserhex::python
{
namespace
{

template <typename TValue>
TValue
oneOf(const char * argument, const std::string & name, std::initializer_list<std::pair<const char *, TValue>> values)
{
  std::string list;
  for (const auto & [known, value] : values)
  {
    if (name == known)
    {
      return value;
    }
    list += (list.empty() ? "" : ", ") + std::string(known);
  }
  throw InvalidInput(ErrorCode::Usage, std::string(argument) + ": " + oneLine(name, 40) + " is none of " + list);
}

} // namespace

unsigned int
threadsFrom(long long threads)
{
  constexpr long long most = 1024;
  if (threads < 0 || threads > most)
  {
    throw InvalidInput(ErrorCode::Usage, "threads: " + std::to_string(threads) + ", need 0 (all) to 1024");
  }
  return static_cast<unsigned int>(threads);
}

ImageInterpolation
interpolationFrom(const std::string & name)
{
  return oneOf<ImageInterpolation>(
    "interpolation", name, { { "linear", ImageInterpolation::Linear }, { "nearest", ImageInterpolation::Nearest } });
}

AlignmentKind
alignmentFrom(const std::string & name)
{
  return oneOf<AlignmentKind>("align",
                              name,
                              { { "none", AlignmentKind::None },
                                { "rigid", AlignmentKind::Rigid },
                                { "similarity", AlignmentKind::Similarity } });
}

} // namespace moserhex::python
