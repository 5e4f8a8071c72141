// The kernels of one source file, compiled once for each instruction set, each time in a namespace of its own: in the
// library a dispatcher picks one of them, and the others cannot be called. For a test, which includes what the kernels
// include, says `using namespace moserhex;` and defines
//
//   MOSERHEX_KERNEL_SOURCE           the file's name
//   MOSERHEX_KERNEL_FUNCTIONS(set)   set::moserhex::one, set::moserhex::other: the members of a variant after its name
#include <vector>

#undef MOSERHEX_KERNEL
#define MOSERHEX_KERNEL
namespace plain
{
#include MOSERHEX_KERNEL_SOURCE
} // namespace plain

#if defined(__x86_64__)
#undef MOSERHEX_KERNEL
#define MOSERHEX_KERNEL __attribute__((target("avx2")))
namespace avx2
{
#include MOSERHEX_KERNEL_SOURCE
} // namespace avx2

#undef MOSERHEX_KERNEL
#define MOSERHEX_KERNEL __attribute__((target("avx512f")))
namespace avx512
{
#include MOSERHEX_KERNEL_SOURCE
} // namespace avx512
#endif

/** Those that this machine can run; the plain one comes first. */
template <typename TVariant>
std::vector<TVariant>
runnableVariants()
{
  std::vector<TVariant> variants{ { "plain", MOSERHEX_KERNEL_FUNCTIONS(plain) } };
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2"))
  {
    variants.push_back({ "avx2", MOSERHEX_KERNEL_FUNCTIONS(avx2) });
  }
  if (__builtin_cpu_supports("avx512f"))
  {
    variants.push_back({ "avx512f", MOSERHEX_KERNEL_FUNCTIONS(avx512) });
  }
#endif
  return variants;
}
