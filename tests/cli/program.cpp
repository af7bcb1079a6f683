#include "tests/cli/program.hpp"

#include <doctest/doctest.h>
#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>

#include "tests/report/temporary.hpp"

namespace stickslip {
namespace {

int open_for_writing(const std::string& path) {
  return ::open(path.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0600);
}

// A negative descriptor closes the stream.
int spawn(const std::string& program, const Words& arguments, int output, int error) {
  std::vector<char *> argv = {const_cast<char *>(program.c_str())};
  for (const std::string& argument : arguments) {
    argv.push_back(const_cast<char *>(argument.c_str()));
  }
  argv.push_back(nullptr);
  const pid_t process = ::fork();
  if (process == 0) {
    if (output >= 0) {
      ::dup2(output, STDOUT_FILENO);
    } else {
      ::close(STDOUT_FILENO);
    }
    ::dup2(error, STDERR_FILENO);
    ::execv(program.c_str(), argv.data());
    ::_exit(127);
  }
  return process;
}

}  // namespace

Words with(Words arguments, const Words& more) {
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

std::string content(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

int wait_for(int process) {
  int status = 0;
  ::waitpid(process, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

Run run_into(const std::string& program, const Words& arguments, const std::string& output) {
  const TemporaryDirectory temporary;
  const std::string err = temporary.path() / "err";
  const int output_descriptor = output.empty() ? -1 : open_for_writing(output);
  const int error_descriptor = open_for_writing(err);
  Run result;
  result.code = wait_for(spawn(program, arguments, output_descriptor, error_descriptor));
  ::close(error_descriptor);
  if (output_descriptor >= 0) {
    ::close(output_descriptor);
  }
  result.out = std::filesystem::is_regular_file(output) ? content(output) : std::string();
  result.err = content(err);
  return result;
}

int kills() {
  const char * const given = std::getenv("STICKSLIP_KILLS");
  return given == nullptr ? 3 : std::atoi(given);
}

Run run(const std::string& program, const Words& arguments) {
  const TemporaryDirectory temporary;
  return run_into(program, arguments, temporary.path() / "out");
}

Run stickslip_program(const Words& arguments) {
  return run(STICKSLIP_PROGRAM, arguments);
}

int start(const Words& arguments, int output) {
  const int error = open_for_writing("/dev/null");
  const int process = spawn(STICKSLIP_PROGRAM, arguments, output, error);
  ::close(error);
  return process;
}

bool is_one_sentence(const std::string& text, const std::string& part) {
  return text.starts_with("stickslip: ") && text.ends_with(".\n") && text.find(part) != std::string::npos &&
         std::count(text.begin(), text.end(), '\n') == 1;
}

void check_refused(const std::vector<Refusal>& refusals, const std::function<Run(const Words&)>& program) {
  for (const Refusal& refusal : refusals) {
    const Run result = program(refusal.arguments);
    CAPTURE(refusal.named);
    CAPTURE(result.err);
    CHECK(result.code == refusal.code);
    CHECK(is_one_sentence(result.err, refusal.named));
    CHECK(result.out.empty());
  }
}

}  // namespace stickslip
