#include "ramify/gallery/gallery.hpp"

#include <algorithm>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "ramify/core/error.hpp"
#include "ramify/draw/drawing_file.hpp"
#include "ramify/gallery/preset_drawing.hpp"
#include "ramify/io/atomic_file.hpp"
#include "ramify/page/html_writer.hpp"
#include "ramify/page/markdown_writer.hpp"

namespace ramify {
namespace {

namespace fs = std::filesystem;

constexpr double picture_side = 800, thumbnail_side = 240, contact_side = 200, contact_letters = 11;
constexpr std::size_t contact_columns = 7;

/// Into a square, in its middle.
void add_in_square(Drawing& page, const Drawing& part, PagePoint at, double side) {
  const double scale = side / std::max(part.width, part.height);
  add_drawing(page, part, {at.x + (side - part.width * scale) / 2, at.y + (side - part.height * scale) / 2},
              scale);
}

/// All pictures side by side, each with its name.
class ContactSheet {
 public:
  explicit ContactSheet(std::size_t pictures) {
    const std::size_t rows = (pictures + contact_columns - 1) / contact_columns;
    page_ = {contact_columns * contact_side, static_cast<double>(rows) * row_height, {}, {}};
  }

  void add(const std::string& name, const Drawing& drawing) {
    const std::size_t column = added_ % contact_columns, row = added_ / contact_columns;
    const PagePoint at{static_cast<double>(column) * contact_side, static_cast<double>(row) * row_height};
    ++added_;
    add_in_square(page_, drawing, at, contact_side);
    page_.labels.push_back({{at.x + contact_side / 2, at.y + contact_side + contact_letters / 2},
                            name,
                            contact_letters,
                            Label::Anchor::middle});
  }

  const Drawing& page() const { return page_; }

 private:
  static constexpr double row_height = contact_side + 2 * contact_letters;

  Drawing page_{};
  std::size_t added_ = 0;
};

constexpr const char* about =
    "Figures and tables of the source documents, with the rules and constants by which their trees are "
    "drawn, as "
    "presets of ramify draw (docs/draw.md). What a source leaves open is a choice of this project, and said.";

/// What a preset says of itself below its picture, and its command.
PageSection section_of(const PicturePreset& preset, PageBlock first) {
  PageSection section{preset.title, {}, {}, preset.name};
  section.blocks.push_back(std::move(first));
  if (!preset.note.empty()) section.blocks.emplace_back(PageParagraph{preset.note});
  section.blocks.emplace_back(
      PageCommands{{fmt::format("ramify draw --preset {0} -o {0}.svg", preset.name)}});
  return section;
}

/// A gallery as it grows, picture by picture.
class Gallery {
 public:
  Gallery(fs::path folder, std::size_t pictures) : folder_(std::move(folder)), contact_(pictures) {
    page_.lead.emplace_back(PageParagraph{about});
    text_.lead.emplace_back(PageParagraph{about});
    text_.lead.emplace_back(
        PageThumbnail{contact_name, contact_name, "All presets side by side", "All presets by name."});
  }

  void add(const PicturePreset& preset, const Cancellation& cancellation) {
    const DrawingFile file(folder_ / (preset.name + ".svg"));
    file.require_room(expected_pieces(preset));
    const Drawing drawing = preset_drawing(preset, picture_side, cancellation);
    file.write(drawing, cancellation);
    Drawing thumbnail{thumbnail_side, thumbnail_side, {}, {}};
    add_in_square(thumbnail, drawing, {0, 0}, thumbnail_side);
    const std::string name = "thumbnails/" + preset.name + ".png";
    DrawingFile(folder_ / name).write(thumbnail, cancellation);
    contact_.add(preset.name, drawing);
    page_.sections.push_back(
        section_of(preset, PageThumbnail{name, preset.name + ".svg", preset.title, preset.source}));
    text_.sections.push_back(section_of(preset, PageParagraph{preset.source}));
  }

  void write(const Cancellation& cancellation) const {
    DrawingFile(folder_ / contact_name).write(contact_.page(), cancellation);
    write_file_atomically(folder_ / "index.html", write_html(page_));
    write_file_atomically(folder_ / "gallery.md", write_markdown(text_));
  }

 private:
  static constexpr const char* contact_name = "contact-sheet.png";

  fs::path folder_;
  ContactSheet contact_;
  Page page_{"Trees of the sources", {}, {}, {}};  // with thumbnails
  Page text_{"Trees of the sources", {}, {}, {}};  // with the contact sheet alone
};

void require_done(const std::error_code& problem, const fs::path& folder) {
  if (problem)
    throw Error(fmt::format("--gallery {}", folder.string()), problem.message(),
                "name a folder that can be made");
}

}  // namespace

void draw_gallery(const fs::path& folder, const fs::path& presets, const Cancellation& cancellation) {
  if (fs::exists(folder))
    throw Error(fmt::format("--gallery {}", folder.string()), "it exists, and a gallery makes its own folder",
                "name another, or remove it");
  const fs::path work = folder.string() + ".incomplete";
  std::error_code problem;
  fs::remove_all(work, problem);
  fs::create_directories(work / "thumbnails", problem);
  require_done(problem, folder);
  try {
    const auto names = picture_preset_names(presets);
    Gallery gallery(work, names.size());
    for (const auto& name : names) gallery.add(find_picture_preset(presets, name), cancellation);
    gallery.write(cancellation);
    fs::rename(work, folder, problem);
    require_done(problem, folder);
  } catch (...) {
    fs::remove_all(work, problem);
    throw;
  }
}

}  // namespace ramify
