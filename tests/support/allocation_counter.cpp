// SPDX-License-Identifier: MIT
#include "support/allocation_counter.hpp"

#include <cstddef>

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define ODAS_OWN_MALLOC 0
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define ODAS_OWN_MALLOC 0
#endif
#endif
#ifndef ODAS_OWN_MALLOC
#define ODAS_OWN_MALLOC 1
#endif

namespace {
thread_local std::uint64_t count = 0;
}

#if ODAS_OWN_MALLOC
// glibc's own functions under their other names: ours stand in front of them and count. operator new calls
// malloc, and so counts too.
extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t n, std::size_t size);
void* __libc_realloc(void* old, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);

void* malloc(std::size_t size) {
  ++count;
  return __libc_malloc(size);
}
void* calloc(std::size_t n, std::size_t size) {
  ++count;
  return __libc_calloc(n, size);
}
void* realloc(void* old, std::size_t size) {
  ++count;
  return __libc_realloc(old, size);
}
void* memalign(std::size_t alignment, std::size_t size) {
  ++count;
  return __libc_memalign(alignment, size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) {
  ++count;
  return __libc_memalign(alignment, size);
}
}
#endif

namespace odas::test {

std::uint64_t allocations() noexcept { return count; }

}  // namespace odas::test
