#include "CaseList.h"

#include "CaseChecks.h"
#include "CaseNames.h"
#include "CaseRequest.h"
#include "CommandErrors.h"
#include "FileSearch.h"
#include "LabelChoices.h"
#include "ListFile.h"
#include "OutputName.h"
#include "moserhex/HexMeshIO/HexMeshWriter.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <set>

namespace moserhex::app
{
namespace
{

namespace fs = std::filesystem;

void
requireUsable(const CaseListOptions & options)
{
  requireUsable(options.defaults);
  const std::string & ending = options.ending;
  if (ending.find_first_of("./") != ending.rfind('.') || !isHexMeshName("mesh" + ending) || ending.front() != '.')
  {
    throw UsageError("--format: " + oneLine(ending, 40) + " is none of " + hexMeshEndings);
  }
  const InputOptions & input = options.defaults.input;
  if (options.allLabels && (input.label || input.segment || input.threshold))
  {
    throw UsageError("--all-labels excludes --label, --segment and --threshold");
  }
  const std::set<std::string> kept(options.keepColumns.begin(), options.keepColumns.end());
  for (const std::string & column : options.keepColumns)
  {
    if (isListOption(column))
    {
      throw UsageError("--keep-columns: " + column + " is an option of mesh; give the column another name");
    }
  }
  if (kept.size() != options.keepColumns.size())
  {
    throw UsageError("--keep-columns names a column twice");
  }
}

/** The inputs of the command line, one after the other. */
class RequestCollector
{
public:
  explicit RequestCollector(const CaseListOptions & options) : m_Options(options)
  {}

  /** \throws UsageError, BadInput, IOError  see listCases */
  void
  add(const std::string & input)
  {
    std::error_code unknown;
    if (fs::is_directory(input, unknown))
    {
      for (const std::string & file :
           labelmapsBelow(input, { m_Options.include, m_Options.exclude }, m_Options.outputFolder))
      {
        addFile(file, input);
      }
    }
    else if (!fs::exists(input, unknown) && isPattern(input))
    {
      for (const std::string & file : filesMatching(input))
      {
        addFile(file, "");
      }
    }
    else if (!fs::exists(input, unknown))
    {
      throw BadInput(ErrorCode::NoInput, input, "there is no such file or folder", "check the name");
    }
    else if (isListName(input))
    {
      addList(input);
    }
    else
    {
      addFile(input, "");
    }
  }

  [[nodiscard]] std::vector<CaseRequest>
  take()
  {
    setCommonBase();
    requireColumnsFound();
    return std::move(m_Requests);
  }

private:
  /** \param base  empty: known when all files are */
  void
  addFile(const std::string & file, const std::string & base)
  {
    CaseRequest request;
    request.options = m_Options.defaults;
    request.options.input.file = file;
    request.allLabels = m_Options.allLabels;
    request.base = m_Options.base.empty() ? base : m_Options.base;
    request.kept.resize(m_Options.keepColumns.size());
    m_Requests.push_back(std::move(request));
  }

  void
  addList(const std::string & list)
  {
    requireKept(list, (fs::path(m_Options.outputFolder) / "summary.csv").string());
    std::vector<CaseRequest> rows = requestsOfList(list, m_Options, m_Columns);
    std::move(rows.begin(), rows.end(), std::back_inserter(m_Requests));
  }

  void
  setCommonBase()
  {
    std::vector<CaseRequest *> files;
    std::vector<std::string>   names;
    for (CaseRequest & request : m_Requests)
    {
      if (request.base.empty() && request.list.empty())
      {
        files.push_back(&request);
        names.push_back(request.options.input.file);
      }
    }
    const std::string base = names.empty() ? "" : commonFolder(names).string();
    for (CaseRequest * request : files)
    {
      request->base = base;
    }
  }

  void
  requireColumnsFound() const
  {
    for (const std::string & column : m_Options.keepColumns)
    {
      if (m_Columns.count(column) == 0)
      {
        throw UsageError("--keep-columns: no list has a column " + oneLine(column, 60));
      }
    }
  }

  const CaseListOptions &  m_Options;
  std::vector<CaseRequest> m_Requests;
  std::set<std::string>    m_Columns; ///< of all lists
};

/** \throws UsageError  neither a labelmap nor a surface */
void
requireInputName(const CaseRequest & request)
{
  const std::string & file = request.options.input.file;
  std::error_code     unknown;
  const bool          mayBeOne = !fs::path(file).has_extension() && !fs::exists(file, unknown);
  if (!mayBeOne && !isInputName(file))
  {
    refuse(request,
           (request.list.empty() ? "" : shortName(file, 60) + " is ") + std::string("neither labelmap nor surface"),
           "give .nrrd .nhdr .nii .nii.gz .mha .mhd .vtk .vtp .stl .obj .ply .off");
  }
}

/** Where a request's mesh belongs, below the output folder. \throws UsageError  it does not stay there */
[[nodiscard]] std::string
meshNameOf(const CaseRequest & request, const std::string & ending)
{
  if (!request.output.empty())
  {
    return request.output;
  }
  const fs::path relative = normalPath(request.options.input.file).lexically_relative(normalPath(request.base));
  if (!staysBelow(relative))
  {
    refuse(request,
           "the path leaves the output folder: " + shortName(request.options.input.file) + " is not below the base",
           "give an output column, or a --base that holds it");
  }
  return stemOf(relative.generic_string()) + ending;
}

[[nodiscard]] BatchCase
caseOf(const CaseRequest & request, const std::string & name, const std::string & outputFolder)
{
  BatchCase one;
  one.name = name;
  one.options = request.options;
  one.options.output = (fs::path(outputFolder) / name).string();
  one.options.reportFile = (fs::path(outputFolder) / reportNameOf(name)).string();
  one.kept = request.kept;
  return one;
}

/** The cases of a request, whose mesh would have this name without labels. */
void
addCases(const CaseRequest & request, const std::string & name, const std::string & outputFolder, CaseList & list)
{
  const std::vector<LabelChoice> labels =
    request.allLabels ? labelChoicesOf(request.options.input) : std::vector<LabelChoice>{};
  if (labels.empty())
  {
    list.cases.push_back(caseOf(request, name, outputFolder));
  }
  for (const LabelChoice & label : labels)
  {
    BatchCase one = caseOf(request, labelledName(name, label.text), outputFolder);
    one.options.input.label = label.label;
    one.options.input.segment = label.segment;
    one.labelName = label.name;
    list.cases.push_back(std::move(one));
  }
}

} // namespace

CaseList
listCases(const CaseListOptions & options)
{
  requireUsable(options);
  RequestCollector collector(options);
  for (const std::string & input : options.inputs)
  {
    collector.add(input);
  }
  const std::vector<CaseRequest> requests = collector.take();
  if (requests.empty())
  {
    throw UsageError("there is nothing to mesh: give a folder, files, a pattern or a list");
  }
  std::vector<std::string> names; // all of them before the first image is read
  names.reserve(requests.size());
  for (const CaseRequest & request : requests)
  {
    requireInputName(request);
    names.push_back(meshNameOf(request, options.ending));
  }

  CaseList list;
  list.keptColumns = options.keepColumns;
  list.cases.reserve(requests.size());
  for (std::size_t n = 0; n < requests.size(); ++n)
  {
    addCases(requests[n], names[n], options.outputFolder, list);
  }
  keepDistinctCases(list);
  requireInputsKept(list);
  warnOfMissingInputs(list);
  return list;
}

} // namespace moserhex::app
