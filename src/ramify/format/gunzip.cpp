#include "ramify/format/gunzip.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <new>

#include <fmt/format.h>
#include <zlib.h>

#include "ramify/core/error.hpp"

namespace ramify {
namespace {

/// A stream of zlib, ended when it goes.
class Inflater {
 public:
  Inflater() {
    constexpr int gzip_only = 16 + MAX_WBITS;
    if (inflateInit2(&stream_, gzip_only) != Z_OK) throw std::bad_alloc();
  }
  ~Inflater() { inflateEnd(&stream_); }
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;
  Inflater(Inflater&&) = delete;
  Inflater& operator=(Inflater&&) = delete;

  /// Unpacks one member; takes what it used from the bytes. False where it is damaged or cut off.
  bool member(std::string_view& bytes, std::string& text) {
    std::array<unsigned char, 1 << 16> block;
    inflateReset(&stream_);
    for (int status = Z_OK; status != Z_STREAM_END;) {
      const auto available =
          static_cast<uInt>(std::min<std::size_t>(bytes.size(), std::numeric_limits<uInt>::max()));
      stream_.next_in = reinterpret_cast<const Bytef*>(bytes.data());
      stream_.avail_in = available;
      stream_.next_out = block.data();
      stream_.avail_out = static_cast<uInt>(block.size());
      status = inflate(&stream_, Z_NO_FLUSH);
      if (status != Z_OK && status != Z_STREAM_END) return false;
      text.append(reinterpret_cast<const char*>(block.data()), block.size() - stream_.avail_out);
      bytes.remove_prefix(available - stream_.avail_in);
    }
    return true;
  }

 private:
  z_stream stream_{};
};

}  // namespace

bool is_gzip(std::string_view bytes) {
  return bytes.starts_with("\x1f\x8b");
}

std::string gunzip(std::string_view bytes, std::string_view name) {
  std::string text;
  Inflater inflater;
  do {
    if (!inflater.member(bytes, text))
      throw Error(fmt::format("{}: a gzip file that cannot be unpacked", name), "it is damaged or cut off",
                  "fetch it again, or unpack it with gzip -d");
  } while (is_gzip(bytes));
  return text;
}

}  // namespace ramify
