// The motion from rest under the friction law (2), (4), in doubles: where it begins to slip and to stick.
#include <cstdio>

#include <stickslip/numeric/simulation/record.hpp>

int main() {
  using namespace stickslip::numeric;
  const simulation::Start start{.data = {.chi = 0.3, .eta = 4, .us = 0.1, .V = 0.1, .omega = 0.6, .p = 1},
                                .ur = 0.2,
                                .phi = 0,
                                .X = {0, 0, 0, 0}};
  const auto always = [](double) { return true; };
  const simulation::Record record = simulation::record_motion(start, {.duration = 30, .every = {}}, always);
  const char * const names[] = {"slip", "overshoot", "stick"};
  for (const simulation::Transition& event : record.first_events) {
    std::printf("t = %9.6f  %-9s  x2 = %9.6f\n", event.time, names[static_cast<int>(event.after)],
                event.X(1));
  }
}
