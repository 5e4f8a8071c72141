#include "ArgumentNames.h"

#include <utility>

namespace moserhex::python
{
namespace
{

/** An option that another one begins with stands after it. */
constexpr std::pair<const char *, const char *> names[] = {
  { "--align rigid", "align='rigid'" },
  { "--align", "align" },
  { "--allow-partial", "allow_partial=True" },
  { "--density", "density" },
  { "--frame", "frame" },
  { "--image", "image" },
  { "--label", "label" },
  { "--landmarks", "landmarks" },
  { "--local-growth", "local_growth=True" },
  { "--max-repair", "max_repair" },
  { "--padding", "padding" },
  { "--shell-method", "shell_method" },
  { "--shells", "shells" },
  { "--stage exact", "stage='exact'" },
  { "--stage", "stage" },
  { "--template BASELINE", "template=baseline" },
  { "--template-image", "template_image" },
  { "--template-landmarks", "template_landmarks" },
  { "--template", "template" },
  { "--threshold", "labels >= threshold" },
  { "--topology repair", "topology='repair'" },
  { "--topology", "topology" },
  { "--way", "way" },
};

} // namespace

std::string
withArguments(std::string message)
{
  for (const auto & [option, argument] : names)
  {
    for (auto at = message.find(option); at != std::string::npos; at = message.find(option))
    {
      message.replace(at, std::char_traits<char>::length(option), argument);
    }
  }
  return message;
}

std::vector<std::string>
withArguments(std::vector<std::string> messages)
{
  for (std::string & message : messages)
  {
    message = withArguments(std::move(message));
  }
  return messages;
}

} // namespace moserhex::python
