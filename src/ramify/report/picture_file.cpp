#include "ramify/report/picture_file.hpp"

#include <cerrno>
#include <fstream>
#include <iterator>
#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <stdlib.h>

#include "ramify/core/error.hpp"
#include "ramify/io/atomic_file.hpp"
#include "ramify/report/gnuplot.hpp"
#include "ramify/report/plot_script.hpp"

namespace ramify {
namespace {

namespace fs = std::filesystem;

/// A folder of our own, for as long as gnuplot draws.
class ScratchFolder {
 public:
  ScratchFolder() {
    std::string name = (fs::temp_directory_path() / "ramify-plot-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr)
      throw Error(fmt::format("no folder '{}'", name), std::generic_category().message(errno),
                  "set TMPDIR to a folder that can be written");
    path_ = name;
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder(ScratchFolder&&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  ScratchFolder& operator=(ScratchFolder&&) = delete;
  ~ScratchFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }

  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

std::string bytes_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

DrawnPlot draw_plot(const Plot& plot, PictureFormat format) {
  const auto script = detail::plot_script(plot, "plot");
  if (!script) return {{}, "there is no value to draw", "ask for other values"};
  const char* ending = format == PictureFormat::svg ? "svg" : "png";
  const ScratchFolder scratch;
  write_file_atomically(scratch.path() / "plot.gp", fmt::format("formats = '{}'\n{}", ending, *script));
  const auto result = detail::run_gnuplot(scratch.path(), "plot.gp");
  std::string picture = bytes_of(scratch.path() / fmt::format("plot.{}", ending));
  if (result.exit_code != 0 || picture.empty())
    return {{},
            detail::gnuplot_complaint(result.exit_code, result.output),
            result.exit_code == detail::not_installed ? "install gnuplot" : "try another plot"};
  return {std::move(picture), {}, {}};
}

PictureFile::PictureFile(fs::path path)
    : path_(std::move(path)), format_(picture_format(path_, "--plot", "pictures")) {}

void PictureFile::draw(const Plot& plot) const {
  const DrawnPlot drawn = draw_plot(plot, format_);
  if (drawn.bytes.empty())
    throw Error(fmt::format("--plot {}", path_.string()), drawn.why_not,
                fmt::format("{}, or leave --plot out", drawn.remedy));
  write_file_atomically(path_, drawn.bytes);
}

}  // namespace ramify
