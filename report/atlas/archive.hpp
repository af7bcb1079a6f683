// An atlas as an HDF5 file.
//
// Attributes of the root: program, version, libraries, command, family, axes, parameters, lower, upper (exact
// numbers as text), resolution, decided, outside and open (shares of the volume, exact fractions as text),
// reasons. Datasets, one row for each box, in the order of the tiles: tile, lower and upper (of the axes,
// rounded to doubles), orbits, admissible, stable (-1: not known), reason (a place in `reasons`; 0: decided).
// The same atlas always gives the same bytes.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "numeric/atlas/work.hpp"

namespace stickslip::report::atlas {

// Whether the program was built with HDF5. Without it the functions below throw InputOutputError.
[[nodiscard]] bool has_hdf5();

// Writes the ordered leaves of a complete atlas into the file, which appears whole, and on the disk, or not
// at all. Throws InputOutputError naming the file.
void write_archive(const std::filesystem::path& file, const numeric::atlas::Question& question,
                   const std::vector<numeric::atlas::Leaf>& leaves);

struct Archive {
  numeric::atlas::Question question;
  std::string version;  // of the program that wrote it
  std::vector<numeric::atlas::Leaf> leaves;
  std::set<numeric::atlas::Tile> elsewhere = {};  // those whose `lower` and `upper` are others in the file
};

// Throws InputOutputError naming the file when it cannot be read, is no atlas, does not tile the whole, or
// has attributes that are not those of its parameters and boxes.
[[nodiscard]] Archive read_archive(const std::filesystem::path& file);

}  // namespace stickslip::report::atlas
