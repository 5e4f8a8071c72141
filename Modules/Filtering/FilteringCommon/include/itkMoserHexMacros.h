#ifndef itkMoserHexMacros_h
#define itkMoserHexMacros_h

#include <itkMacro.h>

// What differs between versions of ITK goes here and nowhere else. .ci/check_headers.py checks it.

// itkOverrideGetNameOfClassMacro: ITK 5.4 and later. Before it there is itkTypeMacro only, which 5.4 deprecates and
// ITK_FUTURE_LEGACY_REMOVE removes.
#ifndef itkOverrideGetNameOfClassMacro
#define itkOverrideGetNameOfClassMacro(thisClass)                                                                      \
  const char * GetNameOfClass() const override                                                                         \
  {                                                                                                                    \
    return #thisClass;                                                                                                 \
  }                                                                                                                    \
  ITK_MACROEND_NOOP_STATEMENT
#endif

/** Set and Get for one field of a filter's options struct m_Options: the default lives in the struct, once. */
#define itkOptionMacro(name, type, field)                                                                              \
  virtual void Set##name(const type & value)                                                                           \
  {                                                                                                                    \
    if (!(this->m_Options.field == value))                                                                             \
    {                                                                                                                  \
      this->m_Options.field = value;                                                                                   \
      this->Modified();                                                                                                \
    }                                                                                                                  \
  }                                                                                                                    \
  virtual type Get##name() const                                                                                       \
  {                                                                                                                    \
    return this->m_Options.field;                                                                                      \
  }                                                                                                                    \
  ITK_MACROEND_NOOP_STATEMENT

#endif
