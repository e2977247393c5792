#include "config_folder.hpp"

#include "ramify/core/error.hpp"

namespace ramify::cli {

std::filesystem::path config_folder(const std::string& given, const std::string& name) {
  namespace fs = std::filesystem;
  if (!given.empty()) return fs::path(given) / name;
  for (const char* base : {"configs", RAMIFY_SOURCE_CONFIGS, RAMIFY_INSTALLED_CONFIGS})
    if (fs::is_directory(fs::path(base) / name)) return fs::path(base) / name;
  throw Error("no configs found", "neither ./configs nor the place ramify was built from has them",
              "name the folder with --configs");
}

}  // namespace ramify::cli
