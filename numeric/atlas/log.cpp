#include "numeric/atlas/log.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <fstream>
#include <iterator>
#include <system_error>

#include "core/error.hpp"

namespace stickslip::numeric::atlas {

namespace fs = std::filesystem;

namespace {

constexpr const char * name_of_question = "question";
constexpr std::size_t size_of_record = 16;
using Record = std::array<unsigned char, size_of_record>;

// Fowler, Noll and Vo's hash 1a.
std::uint32_t hash(const unsigned char * data, std::size_t size, std::uint32_t seed) {
  for (std::size_t i = 0; i < size; ++i) {
    seed = (seed ^ data[i]) * 16777619U;
  }
  return seed;
}

std::uint32_t seed_of(const std::string& identity) {
  return hash(reinterpret_cast<const unsigned char *>(identity.data()), identity.size(), 2166136261U);
}

void put(unsigned char * to, std::uint64_t value, int bytes) {
  for (int i = 0; i < bytes; ++i) {
    to[i] = static_cast<unsigned char>(value >> (8 * i));
  }
}
std::uint64_t get(const unsigned char * from, int bytes) {
  std::uint64_t value = 0;
  for (int i = bytes; i-- > 0;) {
    value = (value << 8) | from[i];
  }
  return value;
}

Record record_of(const Leaf& leaf, std::uint32_t seed) {
  Record r{};
  put(&r[0], leaf.tile, 8);
  r[8] = static_cast<unsigned char>(leaf.finding.orbits);
  r[9] = static_cast<unsigned char>(leaf.finding.admissible);
  r[10] = static_cast<unsigned char>(leaf.finding.stable);
  r[11] = leaf.finding.reason;
  put(&r[12], hash(r.data(), 12, seed), 4);
  return r;
}

Leaf leaf_of(const unsigned char * r) {
  return {get(r, 8),
          {static_cast<std::int8_t>(r[8]), static_cast<std::int8_t>(r[9]), static_cast<std::int8_t>(r[10]),
           r[11]}};
}

// What stands in the file of the question: that, and a line by which damage is seen.
std::string with_sum(const std::string& identity) {
  return identity + fmt::format("{:08x}\n", seed_of(identity));
}

[[noreturn]] void fail(const fs::path& file, const char * what, int error) {
  throw InputOutputError(
      fmt::format("{}: cannot {}: {}", file.string(), what, std::generic_category().message(error)));
}

std::string content_of(const fs::path& file) {
  if (!fs::is_regular_file(file)) {
    throw InputOutputError(fmt::format("{} is not an ordinary file", file.string()));
  }
  std::ifstream stream(file, std::ios::binary);
  if (!stream) {
    fail(file, "be read", errno);
  }
  return {std::istreambuf_iterator<char>(stream), {}};
}

// The leaves of a file, which is cut where they end.
void read_into(std::vector<Leaf>& leaves, const fs::path& file, std::uint32_t seed) {
  const std::string text = content_of(file);
  const auto * data = reinterpret_cast<const unsigned char *>(text.data());
  std::size_t at = 0;
  for (; at + size_of_record <= text.size(); at += size_of_record) {
    if (hash(data + at, 12, seed) != get(data + at + 12, 4)) {
      break;
    }
    leaves.push_back(leaf_of(data + at));
  }
  if (at < text.size() && ::truncate(file.c_str(), static_cast<off_t>(at)) != 0) {
    fail(file, "be cut where it is damaged", errno);
  }
}

}  // namespace

std::string identity(const Question& question, const std::string& version) {
  return "stickslip " + version + " atlas " + text_of(question) + "\n";
}

void create_log(const fs::path& directory, const std::string& identity) {
  std::error_code error;
  if (!fs::create_directory(directory, error)) {
    if (!error) {
      throw InputOutputError(fmt::format(
          "{} exists: an atlas was begun there; go on with --resume, or remove it", directory.string()));
    }
    fail(directory, "be created", error.value());
  }
  // Under its own name only when it is complete: a log without a question is none.
  const fs::path pending = directory / "question.part";
  std::ofstream stream(pending, std::ios::binary);
  stream << with_sum(identity) << std::flush;
  if (!stream) {
    fail(directory / name_of_question, "be written", errno);
  }
  stream.close();
  fs::rename(pending, directory / name_of_question, error);
  if (error) {
    fail(directory / name_of_question, "be written", error.value());
  }
}

LogLock::LogLock(const fs::path& directory) {
  const fs::path question = directory / name_of_question;
  descriptor_ = ::open(question.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor_ < 0) {
    throw InputOutputError(fmt::format("{}: no log of an atlas is there", directory.string()));
  }
  if (::flock(descriptor_, LOCK_EX | LOCK_NB) != 0) {
    const int error = errno;
    ::close(descriptor_);
    if (error == EWOULDBLOCK) {
      throw InputOutputError(
          fmt::format("{}: another run works on this atlas; wait for it, or end it", directory.string()));
    }
    fail(question, "be locked", error);
  }
}

LogLock::~LogLock() {
  ::close(descriptor_);
}

std::vector<Leaf> read_log(const fs::path& directory, const std::string& identity) {
  const fs::path question = directory / name_of_question;
  if (!fs::exists(question)) {
    throw InputOutputError(fmt::format("{}: no log of an atlas is there", directory.string()));
  }
  const std::string content = content_of(question);
  const std::string asked = content.substr(0, content.find('\n') + 1);
  if (content != with_sum(asked)) {
    throw InputOutputError(
        fmt::format("{} is damaged: what the boxes of this log answer is not known", question.string()));
  }
  if (asked != identity) {
    throw UsageError(fmt::format("{} answers another question, or one of another version: {}",
                                 directory.string(), asked.substr(0, asked.size() - 1)));
  }
  std::vector<Leaf> leaves;
  for (const fs::directory_entry& entry : fs::directory_iterator(directory)) {
    if (entry.path().extension() == ".leaves") {
      read_into(leaves, entry.path(), seed_of(identity));
    }
  }
  return leaves;
}

Log::Log(const fs::path& directory, int process, const std::string& identity)
    : file_(directory / fmt::format("{}.leaves", process)), seed_(seed_of(identity)) {
  descriptor_ = ::open(file_.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  if (descriptor_ < 0) {
    fail(file_, "be opened", errno);
  }
}

Log::~Log() {
  ::close(descriptor_);
}

void Log::append(const std::vector<Leaf>& leaves) {
  std::vector<unsigned char> bytes;
  bytes.reserve(leaves.size() * size_of_record);
  for (const Leaf& leaf : leaves) {
    const Record r = record_of(leaf, seed_);
    bytes.insert(bytes.end(), r.begin(), r.end());
  }
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t count = ::write(descriptor_, bytes.data() + done, bytes.size() - done);
    if (count >= 0) {
      done += static_cast<std::size_t>(count);
    } else if (errno != EINTR) {
      fail(file_, "be written", errno);
    }
  }
}

}  // namespace stickslip::numeric::atlas
