#pragma once

#include <vtkSmartPointer.h>

#include <string>

class vtkOutputWindow;

namespace moserhex
{

class MessageCollector;

/** While it lives, VTK's error messages are kept here instead of being printed: its readers tell many of their errors
 * in no other way. VTK has one message window per process, so not for concurrent use. */
class VtkMessages
{
public:
  VtkMessages();
  ~VtkMessages();
  VtkMessages(const VtkMessages &) = delete;
  VtkMessages &
  operator=(const VtkMessages &) = delete;

  /** The first error, one line; empty when there was none. */
  [[nodiscard]] std::string
  firstError() const;

private:
  vtkSmartPointer<vtkOutputWindow>  m_Previous;
  vtkSmartPointer<MessageCollector> m_Collector;
};

} // namespace moserhex
