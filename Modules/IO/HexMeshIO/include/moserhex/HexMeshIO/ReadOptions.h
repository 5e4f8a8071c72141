#pragma once

namespace moserhex
{

/** How a file that nobody vouches for is read. */
struct ReadOptions
{
  /** What a library reads (images by ITK; .vtp, .vtu and legacy .vtk meshes by VTK) is read in a forked child process
   * with limits of memory, CPU and wall time, which writes no files; its death is BadInput (ReaderFailed). Call the
   * reader before other threads work, or switch this off; see the notes on threads at runInSandbox in
   * src/ReaderSandbox.h. */
  bool sandbox{ true };
};

} // namespace moserhex
