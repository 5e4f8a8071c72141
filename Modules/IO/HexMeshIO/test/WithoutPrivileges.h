#pragma once

#include <stdexcept>

#include <unistd.h>

namespace moserhex
{

/** As long as it lives, a process of root has the rights of user `nobody`; others keep their own. */
class WithoutPrivileges
{
public:
  WithoutPrivileges()
  {
    constexpr uid_t nobody = 65534;
    if (m_User == 0 && ::seteuid(nobody) != 0)
    {
      throw std::runtime_error("cannot give up the rights of root");
    }
  }

  ~WithoutPrivileges()
  {
    [[maybe_unused]] const int done = ::seteuid(m_User);
  }

  WithoutPrivileges(const WithoutPrivileges &) = delete;
  WithoutPrivileges &
  operator=(const WithoutPrivileges &) = delete;

private:
  uid_t m_User = ::geteuid();
};

} // namespace moserhex
