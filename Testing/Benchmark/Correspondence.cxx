// moserhex_correspondence test-retest FOLDER_A FOLDER_B [--shells N] [--cases K]
// moserhex_correspondence models FOLDER... [--subject REGEX] [--similarity] [--shells N] [--cases K]
// moserhex_correspondence deformations [--shells N]
//
// Prints the tables of Documentation/Correspondence.md: how well nodes of equal index are equal places. --cases K takes
// the first K labelmaps only; --subject takes, of all labelmaps in whose names the expression matches the same text,
// the first; --similarity takes sizes out of the models, too.
#include "CorrespondenceParts.h"

#include <iostream>
#include <stdexcept>

namespace
{

using namespace moserhex;
using namespace moserhex::correspondence;

constexpr const char * usage = "usage: moserhex_correspondence test-retest FOLDER_A FOLDER_B [--shells N] [--cases K]\n"
                               "       moserhex_correspondence models FOLDER... [--subject REGEX] [--similarity] "
                               "[--shells N] [--cases K]\n"
                               "       moserhex_correspondence deformations [--shells N]";

/** Of the words behind the part's name. */
Arguments
parse(const std::vector<std::string> & words)
{
  Arguments arguments;
  for (std::size_t w = 0; w < words.size(); ++w)
  {
    const bool hasValue = w + 1 < words.size();
    if (words[w] == "--similarity")
    {
      arguments.alignment = AlignmentKind::Similarity;
    }
    else if (words[w] == "--shells" && hasValue)
    {
      arguments.shells = std::stoi(words[++w]);
    }
    else if (words[w] == "--cases" && hasValue)
    {
      arguments.cases = std::stoul(words[++w]);
    }
    else if (words[w] == "--subject" && hasValue)
    {
      arguments.subject = words[++w];
    }
    else if (words[w].rfind("--", 0) == 0)
    {
      throw std::invalid_argument(usage);
    }
    else
    {
      arguments.folders.emplace_back(words[w]);
    }
  }
  return arguments;
}

void
run(const std::vector<std::string> & words)
{
  if (words.empty())
  {
    throw std::invalid_argument(usage);
  }
  const std::string part = words.front();
  const Arguments   arguments = parse({ words.begin() + 1, words.end() });
  const std::size_t folders = arguments.folders.size();
  if (part == "test-retest" && folders == 2)
  {
    writeTestRetest(std::cout, arguments);
  }
  else if (part == "models" && folders > 0)
  {
    writeModels(std::cout, arguments);
  }
  else if (part == "deformations" && folders == 0)
  {
    writeDeformations(std::cout, arguments);
  }
  else
  {
    throw std::invalid_argument(usage);
  }
}

} // namespace

int
main(int argc, char ** argv)
{
  try
  {
    run({ argv + 1, argv + argc });
  }
  catch (const std::invalid_argument & error)
  {
    std::cerr << error.what() << '\n';
    return 2;
  }
  catch (const std::exception & error)
  {
    std::cerr << "moserhex_correspondence: " << error.what() << '\n';
    return 1;
  }
  return 0;
}
