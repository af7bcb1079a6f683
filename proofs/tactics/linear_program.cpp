#include "proofs/tactics/linear_program.hpp"

#include <flint/fmpq_mat.h>
#include <glpk.h>

#include <algorithm>
#include <memory>

namespace stickslip::proofs::tactics {

namespace {

constexpr int most_steps = 1000;

// GLPK has one for each thread that uses it.
struct Environment {
  ~Environment() { glp_free_env(); }
};

// The columns of a basis at which the sum of those wanted is largest.
std::optional<std::vector<std::size_t>> proposed_basis(const std::vector<Column>& columns,
                                                       const Column& right,
                                                       const std::set<std::size_t>& wanted) {
  thread_local const Environment environment;
  const std::unique_ptr<glp_prob, decltype(&glp_delete_prob)> program(glp_create_prob(), glp_delete_prob);
  glp_set_obj_dir(program.get(), GLP_MAX);
  glp_add_rows(program.get(), static_cast<int>(right.size()));
  for (std::size_t i = 0; i < right.size(); ++i) {
    glp_set_row_bnds(program.get(), static_cast<int>(i) + 1, GLP_FX, right[i].get_d(), 0);
  }
  glp_add_cols(program.get(), static_cast<int>(columns.size()));
  for (std::size_t j = 0; j < columns.size(); ++j) {
    const int column = static_cast<int>(j) + 1;  // GLPK counts from 1
    std::vector<int> places{0};
    std::vector<double> values{0};
    for (std::size_t i = 0; i < right.size(); ++i) {
      if (sgn(columns[j][i]) != 0) {
        places.push_back(static_cast<int>(i) + 1);
        values.push_back(columns[j][i].get_d());
      }
    }
    glp_set_mat_col(program.get(), column, static_cast<int>(places.size()) - 1, places.data(), values.data());
    glp_set_col_bnds(program.get(), column, GLP_LO, 0, 0);
    glp_set_obj_coef(program.get(), column, wanted.contains(j) ? 1 : 0);
  }
  glp_smcp parameters;
  glp_init_smcp(&parameters);
  parameters.msg_lev = GLP_MSG_OFF;
  parameters.it_lim = most_steps;
  if (glp_simplex(program.get(), &parameters) != 0 || glp_get_status(program.get()) != GLP_OPT) {
    return std::nullopt;
  }
  std::vector<std::size_t> basis;
  for (std::size_t j = 0; j < columns.size(); ++j) {
    if (glp_get_col_stat(program.get(), static_cast<int>(j) + 1) == GLP_BS) {
      basis.push_back(j);
    }
  }
  return basis;
}

class Matrix {
 public:
  Matrix(std::size_t rows, std::size_t columns) {
    fmpq_mat_init(raw_, static_cast<slong>(rows), static_cast<slong>(columns));
  }
  ~Matrix() { fmpq_mat_clear(raw_); }
  Matrix(const Matrix&) = delete;
  Matrix& operator=(const Matrix&) = delete;

  void set_column(std::size_t j, const Column& values) {
    for (std::size_t i = 0; i < values.size(); ++i) {
      fmpq_set_mpq(entry(i, j), values[i].get_mpq_t());
    }
  }
  [[nodiscard]] fmpq * entry(std::size_t i, std::size_t j) {
    return fmpq_mat_entry(raw_, static_cast<slong>(i), static_cast<slong>(j));
  }
  [[nodiscard]] fmpq_mat_struct * raw() { return raw_; }

 private:
  fmpq_mat_t raw_{};
};

}  // namespace

std::optional<Column> nonnegative_solution(const std::vector<Column>& columns, const Column& right,
                                           const std::set<std::size_t>& wanted) {
  const auto basis = columns.empty() ? std::nullopt : proposed_basis(columns, right, wanted);
  if (!basis) {
    return std::nullopt;
  }
  Matrix system(right.size(), basis->size()), sides(right.size(), 1), values(basis->size(), 1);
  for (std::size_t j = 0; j < basis->size(); ++j) {
    system.set_column(j, columns[(*basis)[j]]);
  }
  sides.set_column(0, right);
  if (fmpq_mat_can_solve(values.raw(), system.raw(), sides.raw()) == 0) {
    return std::nullopt;
  }
  Column result(columns.size());
  for (std::size_t j = 0; j < basis->size(); ++j) {
    fmpq_get_mpq(result[(*basis)[j]].get_mpq_t(), values.entry(j, 0));
  }
  const bool fits =
      std::ranges::all_of(result, [](const Rational& one) { return one >= 0; }) &&
      (wanted.empty() || std::ranges::any_of(wanted, [&](std::size_t j) { return result[j] > 0; }));
  return fits ? std::optional(result) : std::nullopt;
}

}  // namespace stickslip::proofs::tactics
