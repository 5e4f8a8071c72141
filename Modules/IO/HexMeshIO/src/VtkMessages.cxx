#include "VtkMessages.h"

#include <vtkLogger.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>

namespace moserhex
{

class MessageCollector : public vtkOutputWindow
{
public:
  vtkTypeMacro(MessageCollector, vtkOutputWindow) static MessageCollector * New();

  void
  DisplayText(const char *) override
  {}

  void
  DisplayErrorText(const char * text) override
  {
    if (firstError.empty() && text)
    {
      firstError = text;
    }
  }

  void
  DisplayWarningText(const char *) override
  {}

  std::string firstError;
};

vtkStandardNewMacro(MessageCollector)

  VtkMessages::VtkMessages()
  : m_Previous(vtkOutputWindow::GetInstance()), m_Collector(vtkSmartPointer<MessageCollector>::New())
{
  vtkOutputWindow::SetInstance(m_Collector);
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
}

VtkMessages::~VtkMessages()
{
  vtkOutputWindow::SetInstance(m_Previous);
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_INFO);
}

std::string
VtkMessages::firstError() const
{
  // "ERROR: In file, line n\nClass (0x...): message\n\n"
  std::string text = m_Collector->firstError;
  const auto  prefix = text.find("): ");
  if (prefix != std::string::npos)
  {
    text = text.substr(prefix + 3);
  }
  return text.substr(0, text.find('\n'));
}

} // namespace moserhex
