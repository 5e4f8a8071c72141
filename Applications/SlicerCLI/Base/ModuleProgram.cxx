#include "ModuleProgram.h"

#include "Guard.h"
#include "ModuleLogo.h"
#include "ModuleValues.h"
#include "Signals.h"
#include "Version.h"
#include "moserhex/Common/Errors.h"
#include "moserhex/Common/Stopwatch.h"
#include "moserhex/HexMeshIO/AtomicFile.h"

#include <cstdio>
#include <cstdlib>
#include <sstream>

namespace moserhex::slicer
{
namespace
{

/** Text of a tag must not look like one. */
std::string
escaped(const std::string & text)
{
  std::string result;
  for (const char c : text)
  {
    result += c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '&' ? "&amp;" : std::string(1, c);
  }
  return result;
}

std::string
fileNameOf(const std::string & path)
{
  return path.substr(path.find_last_of('/') + 1); // npos + 1 = 0
}

void
requireAllSimpleOutputs(const ModuleDescription & description, const SimpleOutputs & outputs)
{
  for (const auto & [name, value] : outputs)
  {
    const ModuleParameter * parameter = description.find(name);
    if (parameter == nullptr || !parameter->isSimpleOutput())
    {
      throw Error(ErrorCode::Internal, name + " is not a simple output of the module");
    }
  }
}

void
writeReturnParameters(const std::string & fileName, const SimpleOutputs & outputs)
{
  std::string text;
  for (const auto & [name, value] : outputs)
  {
    text += name + " = " + value + "\n";
  }
  writeTextFile(fileName, text);
}

/** "--shells N", "-l, --label N", "--fixed X,Y,Z ..." where there may be several. */
std::string
usageOf(const ModuleParameter & parameter)
{
  static const std::vector<const char *> values{ "", " INTEGER", " NUMBER", " TEXT", " FILE" };
  const std::string                      more = parameter.isMultiple ? " ..." : "";
  if (parameter.index)
  {
    return parameter.name + more;
  }
  std::string text = parameter.flag.empty() ? "" : "-" + parameter.flag;
  if (!parameter.longFlag.empty())
  {
    text += (text.empty() ? "--" : ", --") + parameter.longFlag;
  }
  if (parameter.listSize == 3)
  {
    return text + " X,Y,Z" + more;
  }
  return text + values[static_cast<std::size_t>(parameter.kind)] + (parameter.isList ? ",..." : "") + more;
}

void
printText(const std::string & text)
{
  std::fwrite(text.data(), 1, text.size(), stdout);
}

} // namespace

ModuleProgress::ModuleProgress(std::string name) : m_Name(std::move(name))
{
  std::printf(
    "<filter-start>\n<filter-name>%s</filter-name>\n<filter-comment>starting</filter-comment>\n</filter-start>\n",
    escaped(m_Name).c_str());
  std::fflush(stdout);
}

ModuleProgress::~ModuleProgress()
{
  std::printf("<filter-end>\n<filter-name>%s</filter-name>\n</filter-end>\n", escaped(m_Name).c_str());
  std::fflush(stdout);
}

void
ModuleProgress::show(double fraction)
{
  constexpr double step = 0.01;
  if (!(fraction >= m_Shown + step) && !(fraction >= 1.0 && m_Shown < 1.0))
  {
    return;
  }
  m_Shown = fraction < 1.0 ? fraction : 1.0;
  std::printf("<filter-progress>%.3f</filter-progress>\n", m_Shown);
  std::fflush(stdout);
}

void
ModuleProgress::comment(const std::string & text)
{
  std::printf("<filter-comment>%s</filter-comment>\n", escaped(text).c_str());
  std::fflush(stdout);
}

std::string
helpOf(const ModuleDescription & description, const std::string & program)
{
  std::ostringstream text;
  std::string        arguments;
  for (const ParameterGroup & group : description.groups)
  {
    for (const ModuleParameter & parameter : group.parameters)
    {
      arguments += parameter.index ? " " + usageOf(parameter) : "";
    }
  }
  text << description.title << ": " << description.description << "\n\nusage: " << program << " [options]" << arguments
       << "\n";
  for (const ParameterGroup & group : description.groups)
  {
    text << "\n" << group.label << "\n";
    for (const ModuleParameter & parameter : group.parameters)
    {
      const std::string range = rangeOf(parameter);
      text << "  " << (parameter.isSimpleOutput() ? parameter.name + " (return parameter)" : usageOf(parameter))
           << "\n      " << parameter.description << (range.empty() ? "" : " [" + range + "]")
           << (parameter.defaultValue.empty() || parameter.isSimpleOutput() || parameter.kind == ValueKind::Flag
                 ? ""
                 : " (" + parameter.defaultValue + ")")
           << "\n";
    }
  }
  text << "\nOf every module\n"
          "  --xml  --help  --version  --logo  --echo\n"
          "  --returnparameterfile FILE\n      Write the return parameters, one \"name = value\" a line\n"
          "  --processinformationaddress TEXT\n      Ignored\n";
  return text.str();
}

int
runModule(int argc, char ** argv, const std::string & xml, const ModuleWork & work)
{
  app::openMissingStreams();
  app::installSignalHandlers();
  const std::vector<std::string> words(argv + 1, argv + argc);
  const int                      status = app::runGuarded([&] {
    const ModuleDescription description = parseModuleDescription(xml);
    const ModuleArguments   arguments(description, words);
    const std::string       program = fileNameOf(argv[0]);
    switch (arguments.request())
    {
      case ModuleRequest::Xml:
        printText(xml);
        return;
      case ModuleRequest::Help:
        printText(helpOf(description, program));
        return;
      case ModuleRequest::Version:
        printText(program + " " + description.version + " (MoserHex " + app::version + ", " + app::gitDescription +
                  ")\n");
        return;
      case ModuleRequest::Logo:
        printText(moduleLogo());
        return;
      case ModuleRequest::Run:
        break;
    }
    ModuleProgress      progress(description.title);
    const SimpleOutputs outputs = work(arguments, progress);
    requireAllSimpleOutputs(description, outputs);
    if (!arguments.returnParameterFile().empty())
    {
      writeReturnParameters(arguments.returnParameterFile(), outputs);
    }
    progress.show(1.0);
  });
  return app::flushOutput(status);
}

} // namespace moserhex::slicer
