// Laws grow size by size, and stop between two of them.
#include <gtest/gtest.h>

#include "ramify/law/build_law.hpp"

namespace ramify {
namespace {

/// A law that asks to stop once it has so many sizes.
class StoppingLaw {
 public:
  StoppingLaw(Size last, Size& sizes, Cancellation& stop) : last_(last), sizes_(&sizes), stop_(&stop) {}

  Size sizes() const { return *sizes_; }
  template <class Row>
  void extend(const Row&) {
    if (++*sizes_ == last_) stop_->request();
  }

 private:
  Size last_;
  Size* sizes_;
  Cancellation* stop_;
};

TEST(BuildLaw, StopsBetweenSizes) {
  Cancellation stop;
  Size sizes = 1;
  EXPECT_THROW(build_law(Model::parse("bst"), 1000, StoppingLaw(6, sizes, stop), stop), Interrupted);
  EXPECT_EQ(sizes, 6u);
}

TEST(BuildLaw, GoesToTheSizeThatIsAskedFor) {
  Cancellation stop;
  Size sizes = 1;
  build_law(Model::parse("bst"), 1000, StoppingLaw(5000, sizes, stop), stop);
  EXPECT_EQ(sizes, 1001u);
}

}  // namespace
}  // namespace ramify
