#include "proofs/pascal2012/statements.hpp"

#include <algorithm>
#include <iterator>
#include <sstream>

#include "core/error.hpp"

namespace stickslip::proofs::pascal2012 {

using namespace methods;

namespace {

void append(std::vector<std::string>& ids, const std::string& words) {
  std::istringstream stream(words);
  ids.insert(ids.end(), std::istream_iterator<std::string>(stream), {});
}

Kind kind_of(const std::string& name) {
  for (int kind = 0; kind <= static_cast<int>(Kind::check); ++kind) {
    if (to_string(static_cast<Kind>(kind)) == name) {
      return static_cast<Kind>(kind);
    }
  }
  throw InternalError("a statement is of no kind " + name);
}

// "S041 step [after (12)] on $(0, tau)$ the motion is the slip (5)".
PrintedStatement read(const std::string& line, const std::string& section) {
  const std::size_t id = line.find(" "), open = line.find(" [", id), close = line.find("] ", open);
  if (close == std::string::npos) {
    throw InternalError("no statement: " + line);
  }
  return {.id = line.substr(0, id),
          .place = line.substr(open + 2, close - open - 2),
          .kind = kind_of(line.substr(id + 1, open - id - 1)),
          .words = line.substr(close + 2),
          .section = section};
}

std::vector<PrintedStatement> read_all(const std::string& text) {
  std::vector<PrintedStatement> all;
  std::istringstream lines(text);
  std::string section;
  for (std::string line; std::getline(lines, line);) {
    const auto follows = [&](const std::string& mark) { return line.starts_with(mark); };
    if (line.empty() || follows("#")) {
      continue;
    }
    if (follows("= ")) {
      section = line.substr(2);
    } else if (!follows("  ")) {
      all.push_back(read(line, section));
    } else if (follows("  but: ")) {
      all.back().missing = line.substr(7);
    } else if (follows("  or: ")) {
      append(all.back().or_read, line.substr(6));
    } else if (follows("  at: ")) {
      all.back().example = line.substr(6);
    } else if (follows("  see: ")) {
      append(all.back().see, line.substr(7));
    } else {
      append(all.back().claims, line);
    }
  }
  return all;
}

}  // namespace

const std::vector<PrintedStatement>& printed_statements() {
  static const std::vector<PrintedStatement> all = read_all(statements_text().front().second);
  return all;
}

bool is_stated(const std::string& claim) {
  return std::ranges::any_of(printed_statements(), [&](const PrintedStatement& statement) {
    return std::ranges::find(statement.claims, claim) != statement.claims.end();
  });
}

}  // namespace stickslip::proofs::pascal2012
