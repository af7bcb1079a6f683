#include "cli/commands/cluster.hpp"

#include <cstdlib>
#include <string>

#include "core/error.hpp"
#include "core/parallel.hpp"

#ifdef STICKSLIP_HAS_MPI
#include <mpi.h>

#include <atomic>
#include <chrono>
#include <deque>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>
#endif

namespace stickslip::cli {

using namespace numeric::atlas;

namespace {

// What mpirun of Open MPI, and that of MPICH, tell a process.
int told(const char * open_mpi, const char * mpich, int otherwise) {
  for (const char * name : {open_mpi, mpich}) {
    if (const char * text = std::getenv(name); text != nullptr) {
      return std::atoi(text);
    }
  }
  return otherwise;
}
int told_rank() {
  return told("OMPI_COMM_WORLD_RANK", "PMI_RANK", 0);
}
int told_size() {
  return told("OMPI_COMM_WORLD_SIZE", "PMI_SIZE", 1);
}

}  // namespace

bool is_silent_copy() {
  return told_rank() > 0;
}

#ifndef STICKSLIP_HAS_MPI

Cluster::Cluster() {
  if (told_size() > 1) {
    throw UsageError(
        "mpirun started several copies, but this program was built without MPI: install libopenmpi-dev "
        "(script/bootstrap cluster) and build again");
  }
}
Cluster::~Cluster() = default;

void Cluster::give_up(int code) const {
  std::_Exit(code);
}
std::string Cluster::from_first(const std::string& text) const {
  return text;
}
void Cluster::work_on_all(const Question& q, const std::vector<Tile>& tiles,
                          const std::function<bool()>& stop,
                          const std::function<void(const std::vector<Leaf>&)>& done) {
  numeric::atlas::work_on_all(q, tiles, stop, done);
}

#else

namespace {

// From a worker: "give me a tile; these are left of the last one". From the queue: a tile, 0 for "stop".
constexpr int asks = 1, gives = 2;

// The queue of tiles, asked by the first process's own worker and, for the others, by its main thread.
class Queue {
 public:
  Queue(const std::vector<Tile>& tiles, int workers) : open_(tiles.begin(), tiles.end()), idle_(workers) {}

  // What is left of a worker's last tile. Everyone is idle at the beginning, which gives nothing back.
  void give_back(const std::vector<Tile>& rest, bool had_one) {
    const std::lock_guard hold(lock_);
    idle_ += had_one ? 1 : 0;
    open_.insert(open_.begin(), rest.begin(), rest.end());
  }
  // A tile, or 0 when nothing is left; nothing while others may still give some back.
  std::optional<Tile> take(bool stop) {
    const std::lock_guard hold(lock_);
    if (stop || (open_.empty() && idle_ == workers_)) {
      return 0;
    }
    if (open_.empty()) {
      return std::nullopt;
    }
    const Tile tile = open_.front();
    open_.pop_front();
    --idle_;
    return tile;
  }

 private:
  std::mutex lock_;
  std::deque<Tile> open_;
  int idle_;
  const int workers_ = idle_;
};

constexpr std::chrono::milliseconds pause{1};

void send(const std::vector<Tile>& tiles, int to, int tag) {
  MPI_Send(tiles.data(), static_cast<int>(tiles.size()), MPI_UINT64_T, to, tag, MPI_COMM_WORLD);
}
std::vector<Tile> receive(int from, int tag, const MPI_Status& status) {
  int count = 0;
  MPI_Get_count(&status, MPI_UINT64_T, &count);
  std::vector<Tile> tiles(static_cast<std::size_t>(count));
  MPI_Recv(tiles.data(), count, MPI_UINT64_T, from, tag, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
  return tiles;
}

}  // namespace

Cluster::Cluster() {
  if (told_size() == 1) {
    return;
  }
  int provided = 0;
  MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);
  MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
  MPI_Comm_size(MPI_COMM_WORLD, &size_);
}

Cluster::~Cluster() {
  if (size_ > 1) {
    MPI_Finalize();
  }
}

void Cluster::give_up(int code) const {
  if (size_ > 1) {
    MPI_Abort(MPI_COMM_WORLD, code);
  }
  std::_Exit(code);
}

std::string Cluster::from_first(const std::string& text) const {
  if (size_ == 1) {
    return text;
  }
  auto length = static_cast<unsigned long>(text.size());
  MPI_Bcast(&length, 1, MPI_UNSIGNED_LONG, 0, MPI_COMM_WORLD);
  std::string result = text;
  result.resize(length);
  MPI_Bcast(result.data(), static_cast<int>(length), MPI_CHAR, 0, MPI_COMM_WORLD);
  return result;
}

void Cluster::work_on_all(const Question& q, const std::vector<Tile>& tiles,
                          const std::function<bool()>& stop,
                          const std::function<void(const std::vector<Leaf>&)>& done) {
  if (size_ == 1) {
    numeric::atlas::work_on_all(q, tiles, stop, done);
    return;
  }
  if (rank_ > 0) {
    std::vector<Tile> rest{0};  // the first message: there was no tile before
    for (;;) {
      send(rest, 0, asks);
      Tile tile = 0;
      MPI_Recv(&tile, 1, MPI_UINT64_T, 0, gives, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
      if (tile == 0) {
        return;
      }
      const Block block = work_on(q, tile, stop);
      done(block.leaves);
      rest = block.rest;
    }
  }
  Queue queue(tiles, size_);
  std::atomic<bool> own_worker_done = false;
  std::atomic<bool> failed = false;
  std::exception_ptr failure;
  std::jthread worker([&] {
    give_numbers_back_at_end();
    try {
      for (;;) {
        const std::optional<Tile> tile = queue.take(stop());
        if (!tile) {
          std::this_thread::sleep_for(pause);
          continue;
        }
        if (*tile == 0) {
          break;
        }
        const Block block = work_on(q, *tile, stop);
        done(block.leaves);
        queue.give_back(block.rest, true);
      }
    } catch (...) {
      failure = std::current_exception();
      failed = true;
    }
    own_worker_done = true;
  });
  std::deque<int> waiting;
  for (int working = size_ - 1; (working > 0 || !own_worker_done) && !failed;) {
    int there = 0;
    MPI_Status status;
    MPI_Iprobe(MPI_ANY_SOURCE, asks, MPI_COMM_WORLD, &there, &status);
    if (there != 0) {
      const std::vector<Tile> rest = receive(status.MPI_SOURCE, asks, status);
      const bool had_none = rest.size() == 1 && rest.front() == 0;
      queue.give_back(had_none ? std::vector<Tile>{} : rest, !had_none);
      waiting.push_back(status.MPI_SOURCE);
    }
    while (!waiting.empty()) {
      const std::optional<Tile> tile = queue.take(stop());
      if (!tile) {
        break;
      }
      send({*tile}, waiting.front(), gives);
      waiting.pop_front();
      working -= *tile == 0 ? 1 : 0;
    }
    if (there == 0) {
      std::this_thread::sleep_for(pause);
    }
  }
  worker.join();
  if (failure) {
    std::rethrow_exception(failure);
  }
}

#endif

}  // namespace stickslip::cli
