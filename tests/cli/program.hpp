// The program as its users meet it: arguments in, exit code and two streams of text out.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace stickslip {

using Words = std::vector<std::string>;

// The arguments and more of them.
[[nodiscard]] Words with(Words arguments, const Words& more);

// What is in the file.
[[nodiscard]] std::string content(const std::filesystem::path& file);

// How often a test kills what it has started: STICKSLIP_KILLS, or three times.
[[nodiscard]] int kills();

struct Run {
  int code = -1;  // the exit code; 128 + n if signal n ended the program
  std::string out;
  std::string err;
};

// Runs a program with these arguments; standard output goes to the named file and is read back from it, to a
// temporary one by default. An empty name closes standard output.
[[nodiscard]] Run run(const std::string& program, const Words& arguments);
[[nodiscard]] Run run_into(const std::string& program, const Words& arguments, const std::string& output);

// The same for the program under test.
[[nodiscard]] Run stickslip_program(const Words& arguments);

// Starts the program under test with standard output to a pipe of the given descriptor; returns the process
// id.
[[nodiscard]] int start(const Words& arguments, int output);
// Waits for it and returns its exit code, as above.
[[nodiscard]] int wait_for(int process);

// Whether the text is one line "stickslip: ... ." that contains the part.
[[nodiscard]] bool is_one_sentence(const std::string& text, const std::string& part);

struct Refusal {
  Words arguments;
  int code;
  std::string named;
};

// Checks that each is refused in one sentence that says what is wrong, and that nothing is printed; `program`
// runs the arguments.
void check_refused(const std::vector<Refusal>& refusals,
                   const std::function<Run(const Words&)>& program = stickslip_program);

}  // namespace stickslip
