#include "cli/out_of_memory.hpp"

#include <flint/flint.h>
#include <gmp.h>
#include <unistd.h>

#include <cstdlib>
#include <new>

#include "cli/output.hpp"
#include "core/error.hpp"

namespace stickslip::cli {
namespace {

[[noreturn]] void end() {
  tell(out_of_memory);
  ::_exit(exit_internal);
}

// NOLINTBEGIN(cppcoreguidelines-owning-memory): what malloc and free are called by
extern "C" {

void * allocate(std::size_t size) {
  void * block = std::malloc(size);
  return block != nullptr || size == 0 ? block : (end(), nullptr);
}
void * allocate_zeros(std::size_t count, std::size_t size) {
  void * block = std::calloc(count, size);
  return block != nullptr || count == 0 || size == 0 ? block : (end(), nullptr);
}
void * reallocate(void * block, std::size_t size) {
  void * larger = std::realloc(block, size);
  return larger != nullptr || size == 0 ? larger : (end(), nullptr);
}
void * reallocate_known(void * block, std::size_t /*old_size*/, std::size_t size) {
  return reallocate(block, size);
}
void release(void * block) {
  std::free(block);
}
void release_known(void * block, std::size_t /*size*/) {
  std::free(block);
}

}  // extern "C"
// NOLINTEND(cppcoreguidelines-owning-memory)

}  // namespace

void end_in_words_without_memory() {
  mp_set_memory_functions(allocate, reallocate_known, release_known);
  __flint_set_memory_functions(allocate, allocate_zeros, reallocate, release);
  std::set_new_handler(end);  // mimalloc throws nothing, it ends the program without a word
}

}  // namespace stickslip::cli
