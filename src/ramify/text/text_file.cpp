#include "ramify/text/text_file.hpp"

#include <array>
#include <cerrno>
#include <cstdio>
#include <memory>
#include <system_error>

#include <fmt/format.h>

#include "ramify/text/located_error.hpp"

namespace ramify {
namespace {

Error cannot_read(const std::filesystem::path& path, int reason) {
  const bool absent = reason == ENOENT || reason == ENOTDIR;
  return error_at({}, fmt::format("cannot read '{}'", path.string()), std::generic_category().message(reason),
                  absent ? "check the path" : "give a file that you may read");
}

}  // namespace

std::string read_text_file(const std::filesystem::path& path) {
  // fopen and not ifstream: a stream does not say why it failed.
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), &std::fclose);
  if (!file) throw cannot_read(path, errno);
  std::string text;
  std::array<char, 1 << 16> block;
  while (const std::size_t size = std::fread(block.data(), 1, block.size(), file.get()))
    text.append(block.data(), size);
  if (std::ferror(file.get()) != 0) throw cannot_read(path, errno);
  return text;
}

}  // namespace ramify
