# MoserHex_kissfft_INCLUDE_DIR: kissfft's C++ header, BSD-3-Clause, needed to build the library and not to use it.
find_path(MoserHex_kissfft_INCLUDE_DIR kissfft/kissfft.hh DOC "Folder that holds kissfft/kissfft.hh")
if(NOT MoserHex_kissfft_INCLUDE_DIR)
  message(FATAL_ERROR
    "kissfft/kissfft.hh is missing. Install Debian's libkissfft-dev, or set MoserHex_kissfft_INCLUDE_DIR.")
endif()
mark_as_advanced(MoserHex_kissfft_INCLUDE_DIR)
