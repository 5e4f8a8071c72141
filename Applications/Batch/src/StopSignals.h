#pragma once

namespace moserhex::app
{

/** While it lives, the first SIGINT, SIGTERM or SIGHUP only asks for an end; the second ends the program at once. */
class StopSignals
{
public:
  StopSignals();
  ~StopSignals();
  StopSignals(const StopSignals &) = delete;
  StopSignals &
  operator=(const StopSignals &) = delete;

  /** The signal that asked for an end; 0: none. */
  [[nodiscard]] int
  received() const;

  /** To wait on: readable when a signal arrived. */
  [[nodiscard]] int
  descriptor() const;
};

} // namespace moserhex::app
