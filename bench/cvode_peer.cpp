#include "bench/cvode_peer.hpp"

#include <cvode/cvode.h>
#include <fmt/format.h>
#include <nvector/nvector_serial.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include <cmath>
#include <memory>

#include "core/error.hpp"

namespace stickslip::bench {

using namespace numeric::motion;
using namespace numeric::simulation;

namespace {

using model::Vector4;

void check(int flag, const char * what) {
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

// The law (2), (4), and the phase that selects u in it.
struct Law {
  Start start;
  PhaseKind phase = PhaseKind::slip;

  [[nodiscard]] double load(double t) const {
    return start.data.p * std::cos(start.data.omega * t + start.phi);
  }
  [[nodiscard]] double r(double t, const double * x) const {
    return start.data.chi * (x[1] - x[0]) - load(t) / start.data.eta;
  }
  [[nodiscard]] double u(double t, const double * x) const {
    return phase == PhaseKind::stick ? r(t, x) : (phase == PhaseKind::slip ? start.data.us : -start.data.us);
  }
};

int right_hand_side(double t, N_Vector X, N_Vector rate, void * data) {
  const Law& law = *static_cast<const Law *>(data);
  const model::Parameters<double>& a = law.start.data;
  const double * x = N_VGetArrayPointer(X);
  double * d = N_VGetArrayPointer(rate);
  d[0] = x[2];
  d[1] = x[3];
  d[2] = a.chi * x[1] - x[0];
  d[3] = a.eta * law.u(t, x) + law.load(t) - a.chi * a.eta * (x[1] - x[0]);
  return 0;
}

int events(double t, N_Vector X, double * g, void * data) {
  const Law& law = *static_cast<const Law *>(data);
  const double * x = N_VGetArrayPointer(X);
  const double r = law.r(t, x);
  const bool sticks = law.phase == PhaseKind::stick;
  g[0] = sticks ? law.start.ur - r : law.start.data.V - x[3];
  g[1] = sticks ? law.start.ur + r : 1;
  return 0;
}

class Integrator {
 public:
  Integrator(const Start& start, double tolerance) : law_{start, PhaseKind::slip} {
    SUNContext context = nullptr;
    check(SUNContext_Create(nullptr, &context), "SUNContext_Create");
    context_.reset(context);
    X_.reset(N_VNew_Serial(4, context));
    std::copy(start.X.data(), start.X.data() + 4, x());
    enter_first_phase();
    memory_.reset(CVodeCreate(CV_ADAMS, context));
    check(CVodeInit(memory_.get(), right_hand_side, 0, X_.get()), "CVodeInit");
    check(CVodeSStolerances(memory_.get(), tolerance, tolerance), "CVodeSStolerances");
    check(CVodeSetUserData(memory_.get(), &law_), "CVodeSetUserData");
    check(CVodeSetMaxNumSteps(memory_.get(), 10000000), "CVodeSetMaxNumSteps");
    check(CVodeSetNoInactiveRootWarn(memory_.get()), "CVodeSetNoInactiveRootWarn");
    solver_.reset(SUNNonlinSol_FixedPoint(X_.get(), 0, context));
    check(CVodeSetNonlinearSolver(memory_.get(), solver_.get()), "CVodeSetNonlinearSolver");
    check(CVodeRootInit(memory_.get(), 2, events), "CVodeRootInit");
  }
  Integrator(const Integrator&) = delete;
  Integrator& operator=(const Integrator&) = delete;

  Run run(double duration) {
    Run result;
    double t = 0;
    check(CVodeSetStopTime(memory_.get(), duration), "CVodeSetStopTime");
    while (t < duration) {
      const int flag = CVode(memory_.get(), duration, X_.get(), &t, CV_NORMAL);
      check(flag, "CVode");
      if (flag == CV_ROOT_RETURN) {
        result.transitions.push_back(pass_event(t));
        if (t < duration) {
          check(CVodeReInit(memory_.get(), t, X_.get()), "CVodeReInit");
          check(CVodeSetStopTime(memory_.get(), duration), "CVodeSetStopTime");
        }
      }
    }
    result.end = state();
    return result;
  }

 private:
  [[nodiscard]] double * x() { return N_VGetArrayPointer(X_.get()); }
  [[nodiscard]] Vector4<double> state() { return {x()[0], x()[1], x()[2], x()[3]}; }

  // (4) at x2' = V.
  void enter_at_belt_speed(double r) {
    law_.phase =
        std::abs(r) < law_.start.ur ? PhaseKind::stick : (r > 0 ? PhaseKind::slip : PhaseKind::overshoot);
  }

  void enter_first_phase() {
    const double lag = law_.start.data.V - x()[3];
    if (lag == 0) {
      enter_at_belt_speed(law_.r(0, x()));
    } else {
      law_.phase = lag > 0 ? PhaseKind::slip : PhaseKind::overshoot;
    }
  }

  Transition pass_event(double t) {
    const PhaseKind before = law_.phase;
    const double r = law_.r(t, x());
    x()[3] = law_.start.data.V;
    if (before == PhaseKind::stick) {
      law_.phase = r > 0 ? PhaseKind::slip : PhaseKind::overshoot;
    } else {
      enter_at_belt_speed(r);
    }
    return {t, before, law_.phase, r, state()};
  }

  Law law_;
  std::unique_ptr<std::remove_pointer_t<SUNContext>, FreeContext> context_;
  std::unique_ptr<std::remove_pointer_t<N_Vector>, FreeVector> X_;
  std::unique_ptr<std::remove_pointer_t<SUNNonlinearSolver>, FreeSolver> solver_;
  std::unique_ptr<void, FreeMemory> memory_;
};

}  // namespace

Run follow_by_cvode(const Start& start, double duration, double tolerance) {
  return Integrator(start, tolerance).run(duration);
}

}  // namespace stickslip::bench
