// The same law by SUNDIALS CVODE, Adams with its own root finding. A peer for speed; two zeros of an event
// function in one step are missed.
#pragma once

#include <cvode/cvode.h>
#include <fmt/format.h>
#include <nvector/nvector_serial.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include <memory>
#include <span>

#include "bench/raw_law.hpp"
#include "core/error.hpp"

namespace stickslip::bench {

namespace detail {

inline void check(int flag, const char * what) {
  if (flag < 0) {
    throw InternalError(fmt::format("CVODE gave up: {} returned {}", what, flag));
  }
}

struct FreeContext {
  void operator()(SUNContext context) const { SUNContext_Free(&context); }
};
struct FreeVector {
  void operator()(N_Vector vector) const { N_VDestroy(vector); }
};
struct FreeSolver {
  void operator()(SUNNonlinearSolver solver) const { SUNNonlinSolFree(solver); }
};
struct FreeMemory {
  void operator()(void * memory) const { CVodeFree(&memory); }
};

inline int right_hand_side(double t, N_Vector X, N_Vector rate, void * law) {
  static_cast<const RawLaw *>(law)->rate(t, N_VGetArrayPointer(X), N_VGetArrayPointer(rate));
  return 0;
}

inline int event(double t, N_Vector X, double * g, void * law) {
  *g = static_cast<const RawLaw *>(law)->distance(t, N_VGetArrayPointer(X));
  return 0;
}

}  // namespace detail

// Follows the motion from x to where it is after the duration; returns the number of events. `tolerance`
// bounds the error of each step, relative and absolute. Throws InternalError when CVODE gives up.
inline int follow_by_cvode(RawLaw& law, std::span<double> x, double duration, double tolerance) {
  using namespace detail;
  SUNContext context = nullptr;
  check(SUNContext_Create(nullptr, &context), "SUNContext_Create");
  const std::unique_ptr<std::remove_pointer_t<SUNContext>, FreeContext> keeps(context);
  const std::unique_ptr<std::remove_pointer_t<N_Vector>, FreeVector> X(
      N_VMake_Serial(static_cast<sunindextype>(x.size()), x.data(), context));
  const std::unique_ptr<std::remove_pointer_t<SUNNonlinearSolver>, FreeSolver> solver(
      SUNNonlinSol_FixedPoint(X.get(), 0, context));
  const std::unique_ptr<void, FreeMemory> memory(CVodeCreate(CV_ADAMS, context));
  void * const cvode = memory.get();
  law.begin(x.data());
  check(CVodeInit(cvode, right_hand_side, 0, X.get()), "CVodeInit");
  check(CVodeSStolerances(cvode, tolerance, tolerance), "CVodeSStolerances");
  check(CVodeSetUserData(cvode, &law), "CVodeSetUserData");
  check(CVodeSetMaxNumSteps(cvode, 10000000), "CVodeSetMaxNumSteps");
  check(CVodeSetNoInactiveRootWarn(cvode), "CVodeSetNoInactiveRootWarn");
  check(CVodeSetNonlinearSolver(cvode, solver.get()), "CVodeSetNonlinearSolver");
  check(CVodeRootInit(cvode, 1, event), "CVodeRootInit");
  check(CVodeSetStopTime(cvode, duration), "CVodeSetStopTime");
  int events = 0;
  double t = 0;
  while (t < duration) {
    const int flag = CVode(cvode, duration, X.get(), &t, CV_NORMAL);
    check(flag, "CVode");
    if (flag == CV_ROOT_RETURN) {
      law.pass(t, x.data());
      ++events;
      if (t < duration) {
        check(CVodeReInit(cvode, t, X.get()), "CVodeReInit");
        check(CVodeSetStopTime(cvode, duration), "CVodeSetStopTime");
      }
    }
  }
  return events;
}

}  // namespace stickslip::bench
