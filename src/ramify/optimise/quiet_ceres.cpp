#include "ramify/optimise/quiet_ceres.hpp"

#include <glog/logging.h>

namespace ramify {

void quiet_ceres() {
  FLAGS_minloglevel = google::GLOG_FATAL;
}

}  // namespace ramify
