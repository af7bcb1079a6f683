// Files that appear whole or not at all.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace stickslip::report::tools {

struct File {
  std::string name;  // without directory
  std::string content;
};

// Throws InputOutputError, naming the path and what is wrong with it, unless the directory can be written to
// or can be created in an existing one. Creates nothing. Called before long work whose result goes there.
void require_writable(const std::filesystem::path& directory);

// Throws InputOutputError, naming the path, unless a file can be written there, in an existing directory;
// what stands there may only be an ordinary file: a device or a pipe would be replaced, not written to.
void require_writable_file(const std::filesystem::path& file);

// Writes the files into the directory, which is created if only its last component is missing. Each is first
// written in full under a temporary name; only when all are complete do they take their places. Throws
// InputOutputError naming the path; then no file is incomplete and no temporary one is left, also after an
// interruption.
void write_files(const std::filesystem::path& directory, const std::vector<File>& files);

// The content of a file. Throws InputOutputError naming the path.
[[nodiscard]] std::string read_file(const std::filesystem::path& path);

}  // namespace stickslip::report::tools
