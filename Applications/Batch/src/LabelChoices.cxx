#include "LabelChoices.h"

#include "CaseNames.h"
#include "moserhex/HexMeshIO/SurfaceReader.h"

#include <algorithm>
#include <iterator>
#include <map>

namespace moserhex::app
{
namespace
{

[[nodiscard]] std::string
lettersAndDigits(const std::string & name)
{
  std::string text;
  std::copy_if(name.begin(), name.end(), std::back_inserter(text), [](char c) {
    return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
  });
  return text;
}

/** \param numbers  of the choices, all different */
void
setTexts(std::vector<LabelChoice> & choices, const std::vector<std::string> & numbers)
{
  for (std::size_t n = 0; n < choices.size(); ++n)
  {
    choices[n].text = lettersAndDigits(choices[n].name);
    choices[n].text = choices[n].text.empty() ? numbers[n] : choices[n].text;
  }
  for (bool unique = false; !unique;) // Zone1 and Zone1 with numbers may be the same as another one's Zone13
  {
    std::map<std::string, int> uses;
    for (const LabelChoice & choice : choices)
    {
      ++uses[lowerCase(choice.text)];
    }
    unique = uses.size() == choices.size();
    for (std::size_t n = 0; n < choices.size(); ++n)
    {
      choices[n].text += uses[lowerCase(choices[n].text)] > 1 ? numbers[n] : "";
    }
  }
}

[[nodiscard]] std::vector<LabelChoice>
choicesOf(const std::vector<LabelEntry> & labels)
{
  std::vector<LabelChoice> choices;
  std::vector<std::string> numbers;
  for (const LabelEntry & entry : labels)
  {
    choices.push_back({ "", entry.name, entry.value, std::nullopt });
    numbers.push_back(std::to_string(entry.value));
  }
  setTexts(choices, numbers);
  return choices;
}

/** What `--segment` must be for this one: its name or ID where that is unique, or its number. */
[[nodiscard]] std::string
segmentArgument(const std::vector<SegmentEntry> & segments, std::size_t index)
{
  const auto names = [&segments](const std::string & text) {
    return std::count_if(
      segments.begin(), segments.end(), [&text](const SegmentEntry & segment) { return segment.name == text; });
  };
  const auto ids = [&segments](const std::string & text) {
    return std::count_if(
      segments.begin(), segments.end(), [&text](const SegmentEntry & segment) { return segment.id == text; });
  };
  const SegmentEntry & segment = segments[index];
  if (!segment.name.empty() && names(segment.name) == 1)
  {
    return segment.name;
  }
  if (!segment.id.empty() && ids(segment.id) == 1 && names(segment.id) == 0)
  {
    return segment.id;
  }
  return std::to_string(index + 1);
}

[[nodiscard]] std::vector<LabelChoice>
choicesOf(const std::vector<SegmentEntry> & segments)
{
  std::vector<LabelChoice> choices;
  std::vector<std::string> numbers;
  for (std::size_t n = 0; n < segments.size(); ++n)
  {
    if (segments[n].voxels > 0)
    {
      choices.push_back({ "", segments[n].name, std::nullopt, segmentArgument(segments, n) });
      numbers.push_back(std::to_string(n + 1));
    }
  }
  setTexts(choices, numbers);
  return choices;
}

/** Segments of a file in layers, which are all listed when any that is not empty is read. */
[[nodiscard]] std::vector<SegmentEntry>
readSegments(const InputOptions & input)
{
  for (std::size_t number = 1;; ++number)
  {
    try
    {
      return readLabelImage(input.file, { std::nullopt, std::to_string(number), input.sandbox }).segments;
    }
    catch (const BadInput & error)
    {
      if (error.code() != ErrorCode::EmptyLabel)
      {
        throw;
      }
    }
  }
}

} // namespace

std::vector<LabelChoice>
labelChoicesOf(const InputOptions & input)
{
  if (isSurfaceName(input.file))
  {
    return {};
  }
  try
  {
    return choicesOf(readLabelImage(input.file, { std::nullopt, std::nullopt, input.sandbox }).labels);
  }
  catch (const FileError & error)
  {
    if (error.code() != ErrorCode::Dimension)
    {
      return {};
    }
  }
  try
  {
    return choicesOf(readSegments(input));
  }
  catch (const FileError &)
  {
    return {};
  }
}

} // namespace moserhex::app
