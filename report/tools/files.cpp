#include "report/tools/files.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <iterator>
#include <system_error>

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

// A complete file under a temporary name beside its place; gone at the end unless it took that place.
class PendingFile {
 public:
  PendingFile(const fs::path& directory, const File& file)
      : place_(directory / file.name), path_(directory / fmt::format(".{}.{}.tmp", file.name, ::getpid())) {
    require_replaceable(place_);
    ::unlink(path_.c_str());
    const int descriptor = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor < 0) {
      fail("write", place_, errno);
    }
    const int error = write_all(descriptor, file.content);
    const int close_error = ::close(descriptor) == 0 ? 0 : errno;
    if (error != 0 || close_error != 0) {
      ::unlink(path_.c_str());
      fail("write", place_, error != 0 ? error : close_error);
    }
  }
  PendingFile(PendingFile&& other) noexcept : place_(std::move(other.place_)), path_(std::move(other.path_)) {
    other.path_.clear();
  }
  PendingFile(const PendingFile&) = delete;
  PendingFile& operator=(const PendingFile&) = delete;
  PendingFile& operator=(PendingFile&&) = delete;
  ~PendingFile() {
    if (!path_.empty()) {
      ::unlink(path_.c_str());
    }
  }

  void take_place() {
    if (::rename(path_.c_str(), place_.c_str()) != 0) {
      fail("write", place_, errno);
    }
    path_.clear();
  }

 private:
  // 0 or the error number. Returns only when the system has taken the data (fsync), so that a full disk
  // shows.
  static int write_all(int descriptor, const std::string& content) {
    for (std::size_t done = 0; done < content.size();) {
      const ssize_t count = ::write(descriptor, content.data() + done, content.size() - done);
      if (count < 0 && errno != EINTR) {
        return errno;
      }
      done += count < 0 ? 0 : static_cast<std::size_t>(count);
    }
    // EINVAL: the file system has nothing to synchronise.
    return ::fsync(descriptor) == 0 || errno == EINVAL ? 0 : errno;
  }

  fs::path place_;
  fs::path path_;
};

void place_files(const fs::path& directory, const std::vector<File>& files) {
  std::vector<PendingFile> pending;
  pending.reserve(files.size());
  for (const File& file : files) {
    pending.emplace_back(directory, file);
  }
  for (PendingFile& file : pending) {
    file.take_place();
  }
}

}  // namespace

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
  if (::access((there ? directory : parent).c_str(), W_OK | X_OK) != 0) {
    fail(there ? "write to" : "create", directory, errno);
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
