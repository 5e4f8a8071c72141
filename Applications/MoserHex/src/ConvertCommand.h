#pragma once

#include <string>

namespace moserhex::app
{

struct ConvertCommandOptions
{
  std::string input;
  std::string output;
  std::string gmshVersion{ "4.1" }; ///< "4.1" or "2.2", of an output .msh
  bool        sandbox{ true };
  bool        quiet{ false };
};

/** Writes a lattice mesh of any file that readHexCells takes in the format of the output's ending. Sets and fields are
 * made anew from the lattice; no array of the input is taken over.
 * \throws UsageError, BadInput (NotHexahedra when the mesh is no lattice), InvalidInput, IOError */
void
runConvertCommand(const ConvertCommandOptions & options);

} // namespace moserhex::app
