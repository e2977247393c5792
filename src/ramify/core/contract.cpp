#include <cstdio>
#include <cstdlib>

namespace ramify::detail {

[[noreturn]] void contract_broken(const char* condition, const char* file, int line);

void contract_broken(const char* condition, const char* file, int line) {
  std::fprintf(stderr, "%s:%d: contract broken: %s\n", file, line, condition);
  std::abort();
}

}  // namespace ramify::detail
