#include "numeric/words/chain.hpp"

#include <algorithm>
#include <iterator>

namespace stickslip::numeric::words {

Node Link::response(const Node& F) const {
  const Eigen::Index last = F.size() - 1;
  Node d = end_velocity * Ball(-F(last) / rate);
  d.tail(last) -= F.head(last);
  return d;
}

Node midpoint(const Node& u) {
  return u.unaryExpr([](const Ball& x) { return x.midpoint(); });
}

Nodes midpoints(const Nodes& nodes) {
  Nodes result;
  std::transform(nodes.begin(), nodes.end(), std::back_inserter(result), midpoint);
  return result;
}

}  // namespace stickslip::numeric::words
