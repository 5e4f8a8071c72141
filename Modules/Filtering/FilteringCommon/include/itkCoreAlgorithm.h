#ifndef itkCoreAlgorithm_h
#define itkCoreAlgorithm_h

#include "itkMoserHexMacros.h"

#include "moserhex/Common/Errors.h"

#include <itkMacro.h>
#include <itkProcessObject.h>

#include <utility>

/** The filters and what converts between ITK's images and meshes and the Core's. */
namespace itk
{

/** \class CoreError
 * \brief A Core algorithm threw moserhex::Error; the description is its message, and the code is kept. */
class CoreError : public ExceptionObject
{
public:
  /** \param file, line  where it is thrown; \param where  class of the filter */
  CoreError(const char * file, unsigned int line, const moserhex::Error & error, const std::string & where)
    : ExceptionObject(file, line, error.what(), where.c_str()), m_Code(error.code())
  {}
  itkOverrideGetNameOfClassMacro(CoreError);

  /** Of the Core's error. */
  moserhex::ErrorCode
  GetCode() const
  {
    return m_Code;
  }

private:
  moserhex::ErrorCode m_Code;
};

/** \class InvalidInputError
 * \brief A Core algorithm refused its input (moserhex::InvalidInput); the description says why. */
class InvalidInputError : public CoreError
{
public:
  using CoreError::CoreError;
  itkOverrideGetNameOfClassMacro(InvalidInputError);
};

/** \class NotConvergedError
 * \brief A Core algorithm did not reach what it promises (moserhex::NotConverged); the description has the numbers. */
class NotConvergedError : public CoreError
{
public:
  using CoreError::CoreError;
  itkOverrideGetNameOfClassMacro(NotConvergedError);
};

/** Runs a Core algorithm inside a filter's GenerateData().
 *
 * `algorithm` is called with a moserhex::ProgressCallback that updates the filter's progress between `from` and `to`
 * and stops the algorithm when AbortGenerateData is set. Core errors come out as ITK exceptions that name the filter:
 * InvalidInput as InvalidInputError, NotConverged as NotConvergedError, Cancelled as ProcessAborted. */
template <typename TAlgorithm>
auto
RunCoreAlgorithm(ProcessObject * filter, TAlgorithm && algorithm, double from = 0.0, double to = 1.0)
{
  const moserhex::ProgressCallback progress = [filter, from, to](double fraction) {
    filter->UpdateProgress(static_cast<float>(from + (to - from) * fraction));
    return !filter->GetAbortGenerateData();
  };
  const std::string where = filter->GetNameOfClass();
  try
  {
    return std::forward<TAlgorithm>(algorithm)(progress);
  }
  catch (const moserhex::InvalidInput & error)
  {
    throw InvalidInputError(__FILE__, __LINE__, error, where);
  }
  catch (const moserhex::NotConverged & error)
  {
    throw NotConvergedError(__FILE__, __LINE__, error, where);
  }
  catch (const moserhex::Cancelled &)
  {
    filter->ResetPipeline();
    ProcessAborted aborted(__FILE__, __LINE__);
    aborted.SetLocation(where);
    aborted.SetDescription("Filter execution was aborted by an external request");
    throw aborted;
  }
}

} // namespace itk

#endif
