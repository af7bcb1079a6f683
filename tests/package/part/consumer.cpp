#include <stickslip/numeric/orbits.hpp>
#include <stickslip/version.hpp>

int main() {
  return STICKSLIP_VERSION_MAJOR + static_cast<int>(stickslip::numeric::all_families().size());
}
