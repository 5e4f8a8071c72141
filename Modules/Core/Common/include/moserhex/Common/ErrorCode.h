#pragma once

namespace moserhex
{

/** Kinds of faults. Documentation/Errors.md lists them with causes and remedies. */
enum class ErrorCode
{
  Usage,       ///< E_USAGE: the command line contradicts itself or names an unknown option
  NoInput,     ///< E_NOINPUT: the input does not exist, may not be read, or is not a regular file
  Empty,       ///< E_EMPTY: the file has no bytes, or a surface has no triangles
  Format,      ///< E_FORMAT: the content is not of the format that the name promises
  Header,      ///< E_HEADER: the header contradicts itself or breaks the rules of its format
  Truncated,   ///< E_TRUNCATED: the file holds less than its header promises
  Checksum,    ///< E_CHECKSUM: compressed data are damaged
  TooBig,      ///< E_TOO_BIG: more than the library takes
  Reference,   ///< E_REFERENCE: the header refers to a file that is not read: elsewhere, missing, or not a regular file
  Unsupported, ///< E_UNSUPPORTED: legal, but not a kind of file that this library reads
  Dimension,   ///< E_DIMENSION: not a three-dimensional image
  PixelType,   ///< E_PIXELTYPE: not one number per voxel
  Geometry,    ///< E_GEOMETRY: voxel sizes, axes or origin that no mesh can be made with
  Labels,      ///< E_LABELS: voxel values that are not labels, or a label that is not there
  EmptyLabel,  ///< E_EMPTY_LABEL: nothing is labelled
  Topology,    ///< E_TOPOLOGY: not one solid without handles and cavities, and not repaired
  Thin,        ///< E_THIN: too small or too thin for the grid or the smoothing
  Density,     ///< E_DENSITY: a density that does not cover the label or is not positive in it
  Template,    ///< E_TEMPLATE: a template without volume, or one that does not lie where the label is
  TemplateImage,      ///< E_TEMPLATE_IMAGE: an image that does not cover the template, or is the same everywhere in it
  TemplateLandmarks,  ///< E_TEMPLATE_LANDMARKS: landmarks that all lie outside of the template
  Image,              ///< E_IMAGE: an image that does not cover the label, or is the same everywhere in it
  Landmarks,          ///< E_LANDMARKS: landmarks that all lie outside of the label
  SurfaceOpen,        ///< E_SURFACE_OPEN: a surface with a boundary
  SurfaceNonManifold, ///< E_SURFACE_NONMANIFOLD: a surface with edges of other than two triangles, or not orientable
  SurfaceIndex,       ///< E_SURFACE_INDEX: a polygon that names a vertex which is not there
  SurfaceNaN,         ///< E_SURFACE_NAN: a coordinate that is not a finite number
  SurfaceDegenerate,  ///< E_SURFACE_DEGENERATE: a surface without volume
  SurfaceIntersects,  ///< E_SURFACE_INTERSECTS: a surface that cuts through itself
  NotHexahedra,       ///< E_NOT_HEXAHEDRA: a mesh file without usable hexahedra, or not a lattice
  ReaderFailed,       ///< E_READER: the process that read the file died or exceeded its limits
  Precondition,       ///< E_PRECONDITION: another documented precondition is broken; the message names it
  NotConverged,       ///< E_NOT_CONVERGED: an iteration did not reach what it promises
  NotExact,           ///< E_NOT_EXACT: the mesh is not exact; the message says in what
  Shape,              ///< E_SHAPE: too thin, bent or sharp for the lattice, which coarse lattices show in every frame
  OutOfMemory,        ///< E_MEMORY: not enough memory for the work
  TimeLimit,          ///< E_TIMEOUT: the work took longer than was allowed
  Crashed,            ///< E_CRASH: the process that did the work died
  Internal,           ///< E_INTERNAL: a fault of the program: please report it
  CannotCreate,       ///< E_CANTCREAT: the output cannot be created
  InputOutput,        ///< E_IO: the operating system failed while reading or writing
  Locked,             ///< E_LOCKED: another run works on the output folder
  Cancelled,          ///< E_CANCELLED: stopped by the caller
};

/** "E_TRUNCATED" and so on: never changes, for logs and scripts. */
[[nodiscard]] const char *
nameOf(ErrorCode code);

/** What a command that ends with such a fault exits with: 2 wrong usage, 3 bad input, 4 no valid mesh, 70 a fault of
 * the program, 74 input or output failed, 75 try again later, 130 stopped. */
[[nodiscard]] int
exitStatusOf(ErrorCode code);

/** Codes run from 0 to this one. */
inline constexpr ErrorCode lastErrorCode = ErrorCode::Cancelled;

} // namespace moserhex
