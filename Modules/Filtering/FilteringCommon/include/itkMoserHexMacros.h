#ifndef itkMoserHexMacros_h
#define itkMoserHexMacros_h

#include <itkMacro.h>

// ITK before 5.4 has itkTypeMacro only, ITK 6 has itkOverrideGetNameOfClassMacro only; the new name is used here.
#ifndef itkOverrideGetNameOfClassMacro
#define itkOverrideGetNameOfClassMacro(thisClass)                                                                      \
  const char * GetNameOfClass() const override                                                                         \
  {                                                                                                                    \
    return #thisClass;                                                                                                 \
  }                                                                                                                    \
  ITK_MACROEND_NOOP_STATEMENT
#endif
#ifndef ITK_MACROEND_NOOP_STATEMENT
#define ITK_MACROEND_NOOP_STATEMENT static_assert(true, "")
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
