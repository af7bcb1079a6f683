// Files that appear whole or not at all.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace stickslip::report::tools {

struct File {
  std::string name;  // without directory
  std::string content;
};

// Throws InputOutputError, naming the path and what is wrong with it, unless the directory can be written to
// or can be created in an existing one, which it tries. Leaves nothing there. Called before long work whose
// result goes there.
void require_writable(const std::filesystem::path& directory);

// Throws InputOutputError, naming the path, unless a file can be written there, in an existing directory;
// what stands there may only be an ordinary file: a device or a pipe would be replaced, not written to.
void require_writable_file(const std::filesystem::path& file);

// A file that grows under a temporary name beside its place; gone at the end unless it took that place. A
// program that is killed leaves it under the temporary name. Its functions throw InputOutputError naming the
// place.
class PendingFile {
 public:
  explicit PendingFile(const std::filesystem::path& place);
  PendingFile(PendingFile&& other) noexcept;
  PendingFile(const PendingFile&) = delete;
  PendingFile& operator=(const PendingFile&) = delete;
  PendingFile& operator=(PendingFile&&) = delete;
  ~PendingFile();

  void append(std::string_view text);
  // Returns only when the system has taken all data, so that a full disk shows. Nothing is appended after it.
  void complete();
  // Once it is complete.
  void take_place();

 private:
  void write(std::string_view text);

  std::filesystem::path place_, path_;
  int descriptor_ = -1;
  std::string buffer_;
};

// Writes the files into the directory, which is created if only its last component is missing. Each is first
// written in full under a temporary name; only when all are complete do they take their places. Throws
// InputOutputError naming the path; then no file is incomplete and no temporary one is left, also after an
// interruption.
void write_files(const std::filesystem::path& directory, const std::vector<File>& files);
// The same for one file.
void write_file(const std::filesystem::path& file, std::string content);

// The content of a file. Throws InputOutputError naming the path.
[[nodiscard]] std::string read_file(const std::filesystem::path& path);

}  // namespace stickslip::report::tools
