// The paper's own four equations (16) as a function of x = (tau, z10, z20, zdot10), for zeros/krawczyk.hpp.
#pragma once

#include "model/symmetric.hpp"
#include "numeric/families/symmetric.hpp"

namespace stickslip::numeric::families {

struct Equations16 {
  model::SymmetricData<Ball> data;
  model::Vector2<Ball> Q;  // of the load, its sign turned for the second load phase

  template <class T>
  [[nodiscard]] model::Vector4<T> operator()(const model::Vector4<T>& x) const {
    const model::Vector2<T> z0(x(1), x(2));
    const model::Vector2<T> zdot0(x(3), T(data.V));
    return model::symmetric_residual<T>(T(data.chi), model::lift<T>(data.m), model::lift<T>(Q), T(data.omega),
                                        T(data.Theta), x(0), z0, zdot0);
  }
};

// At the working precision.
[[nodiscard]] inline Equations16 equations_16(const motion::ExactParameters& a, LoadPhase phase) {
  const model::SymmetricData<Ball> data = symmetric_data(a, phase);
  return {data, model::Vector2<Ball>(model::Q<Ball>(motion::parameters_as<Ball>(a), data.m) * data.sigma)};
}

}  // namespace stickslip::numeric::families
