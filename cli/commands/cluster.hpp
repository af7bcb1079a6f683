// Several copies of the program that were started by mpirun and work together.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "numeric/atlas/work.hpp"

namespace stickslip::cli {

// Whether mpirun started this process as another than the first: it then says nothing.
[[nodiscard]] bool is_silent_copy();

// One of `size` processes. Without mpirun the only one.
class Cluster {
 public:
  // Throws UsageError when mpirun started several copies of a program that was built without MPI.
  Cluster();
  ~Cluster();
  Cluster(const Cluster&) = delete;
  Cluster& operator=(const Cluster&) = delete;

  [[nodiscard]] int rank() const { return rank_; }
  [[nodiscard]] int size() const { return size_; }

  // Ends all processes at once, with this exit code.
  [[noreturn]] void give_up(int code) const;

  // The first process's text in all of them, which may then read what it has written.
  [[nodiscard]] std::string from_first(const std::string& text) const;

  // As atlas::work_on_all, over all processes, the tiles being those of the first: it keeps the queue, and
  // works, too. `done` is called with leaves that this process has found.
  void work_on_all(const numeric::atlas::Question& question, const std::vector<numeric::atlas::Tile>& tiles,
                   const std::function<bool()>& stop,
                   const std::function<void(const std::vector<numeric::atlas::Leaf>&)>& done);

 private:
  int rank_ = 0, size_ = 1;
};

}  // namespace stickslip::cli
