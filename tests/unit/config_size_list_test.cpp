#include <gtest/gtest.h>

#include "ramify/config/size_list.hpp"
#include "ramify/core/error.hpp"

namespace ramify {
namespace {

using Sizes = std::vector<Size>;

TEST(ReadSizes, TakesOneSizeAListOrAGrid) {
  EXPECT_EQ(read_sizes("--n", "1000"), (Sizes{1000}));
  EXPECT_EQ(read_sizes("--n", "2^10, 0,1e3"), (Sizes{1024, 0, 1000}));
  EXPECT_EQ(read_sizes("--n", "100:1e4:3"), (Sizes{100, 1000, 10'000}));
}

TEST(ReadSizes, RefusesAnythingElse) {
  for (const char* text : {"", ",", "10,", "ten", "-1", "10.5", "10,1e1", "1:10", "1:10:2:5", "1:10:x",
                           "0:10:3", "10:1:3", "2^63"})
    EXPECT_THROW(read_sizes("--n", text), Error) << text;
}

}  // namespace
}  // namespace ramify
