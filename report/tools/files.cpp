#include "report/tools/files.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <iterator>
#include <system_error>
#include <utility>

#include "core/error.hpp"
#include "core/interruption.hpp"

namespace stickslip::report::tools {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const char * what, const fs::path& path, int error) {
  throw InputOutputError(
      fmt::format("cannot {} {}: {}", what, path.string(), std::generic_category().message(error)));
}

bool names_directory(const fs::path& path) {
  std::error_code ignored;
  return fs::is_directory(path, ignored);
}

bool names_something(const fs::path& path) {
  std::error_code ignored;
  return fs::exists(fs::symlink_status(path, ignored));
}

// "out/" and "out" are the same directory, and its parent is the current one.
fs::path without_trailing_slash(const fs::path& path) {
  return path.has_filename() || !path.has_relative_path() ? path : path.parent_path();
}

fs::path parent_of(const fs::path& directory) {
  return directory.has_parent_path() ? directory.parent_path() : fs::path(".");
}

// A device or a pipe would be replaced by a file, not written to.
void require_replaceable(const fs::path& place) {
  std::error_code ignored;
  const fs::file_status there = fs::status(place, ignored);
  if (fs::is_directory(there)) {
    fail("write", place, EISDIR);
  }
  if (fs::exists(there) && !fs::is_regular_file(there)) {
    throw InputOutputError(fmt::format("cannot write {}: it is not an ordinary file", place.string()));
  }
}

void place_files(const fs::path& directory, const std::vector<File>& files) {
  std::vector<PendingFile> pending;
  pending.reserve(files.size());
  for (const File& file : files) {
    pending.emplace_back(directory / file.name);
    pending.back().append(file.content);
    pending.back().complete();
  }
  for (PendingFile& file : pending) {
    file.take_place();
  }
}

}  // namespace

PendingFile::PendingFile(const fs::path& place)
    : place_(place),
      path_(parent_of(place) / fmt::format(".{}.{}.tmp", place.filename().string(), ::getpid())) {
  require_replaceable(place_);
  ::unlink(path_.c_str());
  descriptor_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (descriptor_ < 0) {
    fail("write", place_, errno);
  }
}

PendingFile::PendingFile(PendingFile&& other) noexcept
    : place_(std::move(other.place_)),
      path_(std::exchange(other.path_, {})),
      descriptor_(std::exchange(other.descriptor_, -1)),
      buffer_(std::move(other.buffer_)) {}

PendingFile::~PendingFile() {
  if (descriptor_ >= 0) {
    ::close(descriptor_);
  }
  if (!path_.empty()) {
    ::unlink(path_.c_str());
  }
}

void PendingFile::append(std::string_view text) {
  constexpr std::size_t enough = 1 << 16;
  buffer_ += text;
  if (buffer_.size() >= enough) {
    write(buffer_);
    buffer_.clear();
  }
}

void PendingFile::write(std::string_view text) {
  while (!text.empty()) {
    const ssize_t count = ::write(descriptor_, text.data(), text.size());
    if (count < 0 && errno != EINTR) {
      fail("write", place_, errno);
    }
    text.remove_prefix(count < 0 ? 0 : static_cast<std::size_t>(count));
  }
}

void PendingFile::complete() {
  write(buffer_);
  buffer_.clear();
  // EINVAL: the file system has nothing to synchronise.
  if (::fsync(descriptor_) != 0 && errno != EINVAL) {
    fail("write", place_, errno);
  }
  if (::close(std::exchange(descriptor_, -1)) != 0) {
    fail("write", place_, errno);
  }
}

void PendingFile::take_place() {
  if (::rename(path_.c_str(), place_.c_str()) != 0) {
    fail("write", place_, errno);
  }
  path_.clear();
}

void require_writable(const fs::path& given) {
  const fs::path directory = without_trailing_slash(given);
  if (directory.empty()) {
    throw InputOutputError("cannot write to a directory without a name");
  }
  const bool there = names_something(directory);
  if (there && !names_directory(directory)) {
    fail("write to", directory, ENOTDIR);
  }
  const fs::path parent = parent_of(directory);
  if (!there && !names_directory(parent)) {
    throw InputOutputError(fmt::format("cannot create {}: {} is not an existing directory",
                                       directory.string(), parent.string()));
  }
  if (there && ::access(directory.c_str(), W_OK | X_OK) != 0) {
    fail("write to", directory, errno);
  }
  // What access says of the parent is not all: some file systems refuse, whoever asks.
  if (!there && ::mkdir(directory.c_str(), 0777) != 0) {
    fail("create", directory, errno);
  }
  if (!there) {
    ::rmdir(directory.c_str());
  }
}

void require_writable_file(const fs::path& file) {
  const fs::path directory = parent_of(file);
  if (!names_directory(directory)) {
    throw InputOutputError(
        fmt::format("cannot write {}: {} is not an existing directory", file.string(), directory.string()));
  }
  require_replaceable(file);
  require_writable(directory);
}

void write_files(const fs::path& given, const std::vector<File>& files) {
  require_writable(given);
  const fs::path directory = without_trailing_slash(given);
  const Uninterrupted hold;
  const bool created = !names_something(directory);
  if (created && ::mkdir(directory.c_str(), 0777) != 0) {
    fail("create", directory, errno);
  }
  try {
    place_files(directory, files);
  } catch (...) {
    if (created) {
      ::rmdir(directory.c_str());
    }
    throw;
  }
}

void write_file(const fs::path& file, std::string content) {
  write_files(parent_of(file), {{file.filename().string(), std::move(content)}});
}

std::string read_file(const fs::path& path) {
  if (names_directory(path)) {
    fail("read", path, EISDIR);
  }
  errno = 0;
  std::ifstream stream(path, std::ios::binary);
  if (!stream) {
    fail("read", path, errno);
  }
  std::string content{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  if (stream.bad()) {
    fail("read", path, EIO);
  }
  return content;
}

}  // namespace stickslip::report::tools
