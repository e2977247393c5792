#include "ramify/io/picture_format.hpp"

#include <string>

#include <fmt/format.h>

#include "ramify/core/error.hpp"

namespace ramify {

PictureFormat picture_format(const std::filesystem::path& path, std::string_view option,
                             std::string_view what) {
  const std::string ending = path.extension().string();
  if (ending == ".svg") return PictureFormat::svg;
  if (ending == ".png") return PictureFormat::png;
  throw Error(fmt::format("{} {}", option, path.string()),
              fmt::format("{} are SVG or PNG, as the name ends", what),
              "take a name that ends in .svg or .png");
}

}  // namespace ramify
