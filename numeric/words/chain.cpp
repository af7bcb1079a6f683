#include "numeric/words/chain.hpp"

namespace stickslip::numeric::words {

Node Link::response(const Node& F) const {
  const Eigen::Index last = F.size() - 1;
  Node d = end_velocity * Ball(-F(last) / rate);
  d.tail(last) -= F.head(last);
  return d;
}

}  // namespace stickslip::numeric::words
