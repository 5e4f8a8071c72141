#include "ModelUse.h"

#include "AtlasFiles.h"
#include "CommandErrors.h"
#include "EarlierAtlas.h"
#include "MeshRecord.h"
#include "TableCells.h"
#include "moserhex/HexMeshIO/HexMeshReader.h"
#include "moserhex/HexMeshIO/HexMeshWriter.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

namespace moserhex::app
{
namespace
{

/** What file names may hold: no slashes. */
std::string
fileNameOf(std::string subject)
{
  std::replace(subject.begin(), subject.end(), '/', '_');
  return subject + ".vtu";
}

/** Of a row without a name, its number. */
std::string
nameOfRow(const TextTable & table, std::size_t row)
{
  const std::size_t column = columnNumber(table, "subject");
  if (column >= table.columns.size() || isMissing(table.rows[row].cells[column]))
  {
    return "row-" + std::to_string(row + 1);
  }
  const std::string & cell = table.rows[row].cells[column];
  const bool isDefused = cell.size() > 1 && cell[0] == '\'' && std::string("=+-@").find(cell[1]) != std::string::npos;
  return isDefused ? cell.substr(1) : cell; // as tableLine has it
}

constexpr const char * reconstructedArray = "Reconstructed"; ///< of a mesh that was

/** \throws UsageError  there is another mesh than one that was reconstructed */
void
requireReplaceable(const std::string & fileName, const AtlasOptions & options)
{
  std::error_code ignored;
  if (!std::filesystem::exists(fileName, ignored))
  {
    return;
  }
  const std::vector<NamedArray> arrays = readHexMeshFile(fileName, { options.sandbox }).meshArrays;
  const auto                    isMark = [](const NamedArray & array) { return array.name == reconstructedArray; };
  if (std::none_of(arrays.begin(), arrays.end(), isMark))
  {
    throw UsageError(
      fileMessage(fileName, "a mesh that is there, and was not reconstructed", "write to another folder"));
  }
}

/** "mode_" and a number, whether or not the model has such a mode. */
bool
isModeColumn(const std::string & column)
{
  const std::string stem = "mode_";
  return column.size() > stem.size() && column.compare(0, stem.size(), stem) == 0 &&
         column.find_first_not_of("0123456789", stem.size()) == std::string::npos;
}

/** \throws BadInput  the model does not have it */
Eigen::Index
modeOfColumn(const std::string & fileName, const std::string & column, Eigen::Index modes)
{
  for (Eigen::Index mode = 0; mode < modes; ++mode)
  {
    if (column == modeColumn(static_cast<std::size_t>(mode)))
    {
      return mode;
    }
  }
  throw BadInput(ErrorCode::Format,
                 fileName,
                 "a column " + column + ", the model has mode_1 to " + modeColumn(static_cast<std::size_t>(modes - 1)),
                 "drop it, or give the model that the scores are of");
}

/** A row a shape, scores in standard deviations; 0 where there is none. */
Eigen::MatrixXd
scoresOfTable(const std::string & fileName, const TextTable & table, Eigen::Index modes)
{
  if (table.rows.empty())
  {
    throw BadInput(ErrorCode::Empty, fileName, "no row", "give the scores of an atlas");
  }
  Eigen::MatrixXd scores = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(table.rows.size()), modes);
  bool            isAny = false;
  for (std::size_t column = 0; column < table.columns.size(); ++column)
  {
    if (!isModeColumn(table.columns[column]))
    {
      continue;
    }
    const Eigen::Index mode = modeOfColumn(fileName, table.columns[column], modes);
    isAny = true;
    const auto numbers = numbersIn(table, column);
    for (std::size_t row = 0; row < numbers.size(); ++row)
    {
      scores(static_cast<Eigen::Index>(row), mode) = numbers[row].value_or(0.0);
    }
  }
  if (!isAny)
  {
    throw BadInput(ErrorCode::Format, fileName, "no column mode_1, mode_2, ...", "give the scores of an atlas");
  }
  return scores;
}

/** How many of the model's modes the options ask for. */
Eigen::Index
modesToUse(const ShapeModel & shape, const AtlasOptions & options)
{
  const Eigen::Index all = shape.modes.cols();
  if (options.maximumModes > 0)
  {
    return static_cast<Eigen::Index>(std::min(options.maximumModes, static_cast<std::size_t>(all)));
  }
  Eigen::Index count = 0;
  for (double held = 0.0; count < all && held < options.varianceFraction * shape.totalVariance; ++count)
  {
    held += shape.variances[count];
  }
  return count;
}

} // namespace

std::vector<std::string>
projectMeshes(const AtlasOptions & options)
{
  const AtlasModel    model = readAtlasModel(options.projectOnto);
  const AtlasSubjects subjects = listAtlasSubjects(options.inputs, options.outputFolder);
  requireNoAtlas(options.outputFolder);
  requireNotOverwritten(options.inputs, options.outputFolder);
  const SubjectMeshes meshes = readSubjectMeshes(subjects, options, [](double) {});
  if (meshes.nodesPerSide != model.nodesPerSide || meshes.paddingLayers != model.paddingLayers)
  {
    throw BadInput(ErrorCode::NotHexahedra,
                   subjects.subjects.front().mesh,
                   std::to_string(meshes.nodesPerSide) + " nodes a side and " + std::to_string(meshes.paddingLayers) +
                     " layers of padding, the model has " + std::to_string(model.nodesPerSide) + " and " +
                     std::to_string(model.paddingLayers),
                   "mesh it as the model's subjects were");
  }
  const Positions     mean = pointsOf(model.shape.mean);
  const std::size_t   count = subjects.subjects.size();
  Eigen::MatrixXd     scores(static_cast<Eigen::Index>(count), model.shape.modes.cols());
  std::vector<double> unexplained;
  for (std::size_t i = 0; i < count; ++i)
  {
    const Positions       points = pointsOf(meshes.nodes->readSubject(i));
    const Eigen::VectorXd shape =
      coordinatesOf(transformed(points, alignToMean(points, mean, model.alignment, model.size)));
    const Eigen::VectorXd b = scoresOf(model.shape, shape);
    unexplained.push_back((shape - reconstruct(model.shape, b)).norm() / std::sqrt(static_cast<double>(mean.size())));
    scores.row(static_cast<Eigen::Index>(i)) = b.cwiseQuotient(model.shape.variances.cwiseSqrt()).transpose();
  }
  writeScores(
    options.outputFolder + "/scores.csv", subjects, meshes.figures, "distance_to_model_mm", unexplained, scores);
  std::vector<std::string> warnings = subjects.warnings;
  warnings.insert(warnings.end(), meshes.warnings.begin(), meshes.warnings.end());
  return warnings;
}

std::vector<std::string>
reconstructMeshes(const AtlasOptions & options)
{
  if (options.inputs.size() != 1)
  {
    throw UsageError("--reconstruct takes one table of scores");
  }
  const std::string &   fileName = options.inputs.front();
  const AtlasModel      model = readAtlasModel(options.reconstructWith);
  const TextTable       table = readTextTable(fileName);
  const Eigen::Index    modes = modesToUse(model.shape, options);
  const Eigen::MatrixXd scores = scoresOfTable(fileName, table, model.shape.modes.cols()).leftCols(modes);
  requireNoAtlas(options.outputFolder);
  std::vector<std::string> warnings;
  std::set<std::string>    files;
  for (std::size_t row = 0; row < table.rows.size(); ++row)
  {
    const std::string file = fileNameOf(nameOfRow(table, row));
    if (!files.insert(file).second)
    {
      throw BadInput(ErrorCode::Format, fileName, "two rows for " + file, "give every row its own subject");
    }
    requireReplaceable(options.outputFolder + "/" + file, options);
  }
  for (std::size_t row = 0; row < table.rows.size(); ++row)
  {
    const std::string     file = fileNameOf(nameOfRow(table, row));
    const Eigen::VectorXd b = scores.row(static_cast<Eigen::Index>(row))
                                .transpose()
                                .cwiseProduct(model.shape.variances.head(modes).cwiseSqrt());
    const HexMesh     mesh = meshOf(model, reconstruct(model.shape, b));
    const std::size_t uncertified = mesh.cellCount() - certifyCells(mesh, {}, options.threads).positive;
    if (uncertified > 0)
    {
      warnings.push_back(file + ": " + std::to_string(uncertified) + " cells are not certified");
    }
    HexMeshFields fields;
    fields.meshArrays = notExactArrays();
    fields.meshArrays.push_back({ reconstructedArray, 1, { 1.0 } });
    writeHexMesh(options.outputFolder + "/" + file, mesh, fields);
  }
  return warnings;
}

} // namespace moserhex::app
