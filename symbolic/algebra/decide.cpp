#include "symbolic/algebra/decide.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"
#include "symbolic/algebra/evaluate.hpp"
#include "symbolic/algebra/hypotheses.hpp"
#include "symbolic/algebra/normal_form.hpp"
#include "symbolic/algebra/symbols.hpp"

namespace stickslip::symbolic::algebra {
namespace {

using GiNaC::ex;

std::string entry_name(const Matrix& m, Eigen::Index row, Eigen::Index column) {
  if (m.rows() == 1 && m.cols() == 1) {
    return {};
  }
  return m.cols() == 1 ? fmt::format("({})", row + 1) : fmt::format("({},{})", row + 1, column + 1);
}

const char * const modes_id = "39";

// Which definitions are open, and how.
struct Opening {
  std::vector<const Definition *> definitions;
  bool modes = false;

  [[nodiscard]] ex operator()(const ex& expression) const {
    ex result = expression;
    for (const Definition * definition : definitions) {
      result = result.subs(definition->replacement, GiNaC::subs_options::no_pattern);
    }
    return modes ? in_frequencies(result) : result;
  }

  [[nodiscard]] std::set<std::string> ids() const {
    std::set<std::string> result;
    for (const Definition * definition : definitions) {
      result.insert(definition->id);
    }
    if (modes) {
      result.insert(modes_id);
    }
    return result;
  }
};

// All ways to open the definitions that the expression mentions: fewest first, (39) last.
std::vector<Opening> openings(const ex& expression, const std::vector<Definition>& definitions) {
  const GiNaC::exset symbols = symbols_of(expression);
  std::vector<Opening> result{{}};
  for (const Definition& definition : definitions) {
    const bool mentioned = std::any_of(definition.replacement.begin(), definition.replacement.end(),
                                       [&](const auto& entry) { return symbols.contains(entry.first); });
    const std::size_t known = mentioned ? result.size() : 0;
    for (std::size_t i = 0; i < known; ++i) {
      result.push_back(result[i]);
      result.back().definitions.push_back(&definition);
    }
  }
  std::stable_sort(result.begin(), result.end(), [](const Opening& a, const Opening& b) {
    return a.definitions.size() < b.definitions.size();
  });
  const std::size_t closed = result.size();
  for (std::size_t i = 0; i < closed; ++i) {
    result.push_back(result[i]);
    result.back().modes = true;
  }
  return result;
}

struct Entry {
  Verdict verdict;
  Opening opening;
};

Entry decide_entry(const ex& left, const ex& right, const std::string& name,
                   const std::vector<Definition>& definitions) {
  const ex difference = left - right;
  const std::vector<Opening> ways = openings(difference, definitions);
  try {
    ex previous = difference;
    for (const Opening& open : ways) {
      const ex opened = open(difference);
      if (&open != &ways.front() && opened.is_equal(previous)) {
        continue;  // nothing to open
      }
      previous = opened;
      const TrigField field({opened});
      if (differs_from_zero(opened)) {
        continue;  // a normal form would only say so at length
      }
      if (field.is_zero(opened)) {
        return {Verdict::proved(), open};
      }
    }
  } catch (const OutsideField& reason) {
    return {
        Verdict::undecided(fmt::format("{}{}", name.empty() ? "" : "entry " + name + ": ", reason.what())),
        {}};
  }
  const Opening& open = ways.back();
  if (auto witness = find_witness(open(left), open(right))) {
    witness->component = name;
    return {Verdict::refuted(*std::move(witness)), open};
  }
  return {Verdict::undecided("the normal form of the difference is not zero, but no witness was found"),
          open};
}

}  // namespace

Decision decide_equal(const Matrix& left, const Matrix& right, const std::vector<Definition>& definitions) {
  if (left.rows() != right.rows() || left.cols() != right.cols()) {
    throw InternalError(fmt::format("a {}x{} matrix is compared with a {}x{} one", left.rows(), left.cols(),
                                    right.rows(), right.cols()));
  }
  Decision decision;
  std::vector<Verdict> verdicts;
  std::vector<ex> opened;
  for (Eigen::Index row = 0; row < left.rows(); ++row) {
    for (Eigen::Index column = 0; column < left.cols(); ++column) {
      const ex& a = left(row, column);
      const ex& b = right(row, column);
      Entry entry = decide_entry(a, b, entry_name(left, row, column), definitions);
      opened.push_back(entry.opening(a));
      opened.push_back(entry.opening(b));
      decision.opened.merge(entry.opening.ids());
      verdicts.push_back(std::move(entry.verdict));
    }
  }
  decision.verdict = all_of(verdicts);
  try {
    decision.nonzero = hypotheses_of(opened);
  } catch (const OutsideField& reason) {
    decision.verdict = all_of({decision.verdict, Verdict::undecided(reason.what())});
  }
  return decision;
}

Decision decide_equal(const ex& left, const ex& right, const std::vector<Definition>& definitions) {
  return decide_equal(Matrix(Matrix::Constant(1, 1, left)), Matrix(Matrix::Constant(1, 1, right)),
                      definitions);
}

}  // namespace stickslip::symbolic::algebra
