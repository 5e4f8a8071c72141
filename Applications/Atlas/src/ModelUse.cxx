#include "ModelUse.h"

#include "AtlasFiles.h"
#include "CommandErrors.h"
#include "moserhex/HexMeshIO/HexMeshWriter.h"

#include <algorithm>
#include <cmath>
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

std::string
nameOfRow(const TextTable & table, const TextTable::Row & row, std::size_t number)
{
  const auto column = std::find(table.columns.begin(), table.columns.end(), "subject");
  return column == table.columns.end() ? "row-" + std::to_string(number + 1)
                                       : row.cells[static_cast<std::size_t>(column - table.columns.begin())];
}

/** Columns mode_1 ... of a table; the model has no more modes than `modes`. */
void
requireModes(const std::string & fileName, const TextTable & table, Eigen::Index modes)
{
  bool isAny = false;
  for (const std::string & column : table.columns)
  {
    isAny = isAny || column == modeColumn(0);
    if (column == modeColumn(static_cast<std::size_t>(modes)))
    {
      throw BadInput(ErrorCode::Format, fileName, "more modes than the model's " + std::to_string(modes), "drop them");
    }
  }
  if (!isAny)
  {
    throw BadInput(ErrorCode::Format, fileName, "no column mode_1", "give the scores of an atlas");
  }
}

/** A row a shape, scores in standard deviations. */
Eigen::MatrixXd
scoresOfTable(const std::string & fileName, const TextTable & table, Eigen::Index modes)
{
  AtlasSubjects asSubjects;
  asSubjects.table = table;
  Eigen::MatrixXd scores = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(table.rows.size()), modes);
  for (Eigen::Index mode = 0; mode < modes; ++mode)
  {
    const std::string column = modeColumn(static_cast<std::size_t>(mode));
    if (std::find(table.columns.begin(), table.columns.end(), column) == table.columns.end())
    {
      continue;
    }
    const auto numbers = numbersOfColumn(asSubjects, column);
    for (std::size_t row = 0; row < numbers.size(); ++row)
    {
      scores(static_cast<Eigen::Index>(row), mode) = numbers[row].value_or(0.0);
    }
  }
  if (table.rows.empty())
  {
    throw BadInput(ErrorCode::Empty, fileName, "no row", "give the scores of an atlas");
  }
  return scores;
}

} // namespace

std::vector<std::string>
projectMeshes(const AtlasOptions & options)
{
  const AtlasModel    model = readAtlasModel(options.projectOnto);
  const AtlasSubjects subjects = listAtlasSubjects(options.inputs, options.outputFolder);
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
  return meshes.warnings;
}

std::vector<std::string>
reconstructMeshes(const AtlasOptions & options)
{
  if (options.inputs.size() != 1)
  {
    throw UsageError("--reconstruct takes one table of scores");
  }
  const std::string & fileName = options.inputs.front();
  const AtlasModel    model = readAtlasModel(options.reconstructWith);
  const TextTable     table = readTextTable(fileName);
  requireModes(fileName, table, model.shape.modes.cols());
  const Eigen::MatrixXd    scores = scoresOfTable(fileName, table, model.shape.modes.cols());
  std::vector<std::string> warnings;
  std::set<std::string>    files;
  for (std::size_t row = 0; row < table.rows.size(); ++row)
  {
    const std::string file = fileNameOf(nameOfRow(table, table.rows[row], row));
    if (!files.insert(file).second)
    {
      throw BadInput(ErrorCode::Format, fileName, "two rows for " + file, "give every row its own subject");
    }
    const Eigen::VectorXd b =
      scores.row(static_cast<Eigen::Index>(row)).transpose().cwiseProduct(model.shape.variances.cwiseSqrt());
    const HexMesh     mesh = meshOf(model, reconstruct(model.shape, b));
    const std::size_t uncertified = mesh.cellCount() - certifyCells(mesh, {}, options.threads).positive;
    if (uncertified > 0)
    {
      warnings.push_back(file + ": " + std::to_string(uncertified) + " cells are not certified");
    }
    writeHexMesh(options.outputFolder + "/" + file, mesh);
  }
  return warnings;
}

} // namespace moserhex::app
