#include "ramify/draw/drawing_file.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include <cairo-pdf.h>
#include <cairo-ps.h>
#include <cairo-svg.h>
#include <cairo.h>
#include <fmt/format.h>

#include "ramify/core/error.hpp"
#include "ramify/io/atomic_file.hpp"

namespace ramify {
namespace {

using Surface = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;
using Pen = std::unique_ptr<cairo_t, decltype(&cairo_destroy)>;

// An SVG takes some 50 bytes a branch, and viewers slow down at some hundred thousand; a PNG takes seconds a
// million.
constexpr double most_line_nodes = 200'000, most_png_nodes = 5'000'000;

struct FormatInfo {
  DrawingFormat format;
  std::string_view ending, article;
  double most_nodes;
};

constexpr std::array<FormatInfo, 4> formats{{{DrawingFormat::svg, ".svg", "an SVG", most_line_nodes},
                                             {DrawingFormat::pdf, ".pdf", "a PDF", most_line_nodes},
                                             {DrawingFormat::postscript, ".ps", "a PS", most_line_nodes},
                                             {DrawingFormat::png, ".png", "a PNG", most_png_nodes}}};

const FormatInfo& format_of(const std::filesystem::path& path) {
  const auto* const found = std::ranges::find(formats, path.extension().string(), &FormatInfo::ending);
  if (found != formats.end()) return *found;
  throw Error(fmt::format("--output {}", path.string()), "drawings are SVG, PDF, PS or PNG, as the name ends",
              "take a name that ends in .svg, .pdf, .ps or .png");
}

cairo_status_t append(void* text, const unsigned char* bytes, unsigned count) {
  static_cast<std::string*>(text)->append(reinterpret_cast<const char*>(bytes), count);
  return CAIRO_STATUS_SUCCESS;
}

void require(cairo_status_t status) {
  if (status == CAIRO_STATUS_SUCCESS) return;
  throw Error("no picture", fmt::format("Cairo: {}", cairo_status_to_string(status)), "take a smaller tree");
}

/// In runs: one path for each line would make the file several times as long.
void draw_stroke(cairo_t* pen, const Stroke& stroke, const Cancellation& cancellation) {
  constexpr std::size_t run = 256;
  cairo_set_source_rgb(pen, stroke.color[0], stroke.color[1], stroke.color[2]);
  cairo_set_line_width(pen, stroke.width);
  for (std::size_t i = 0; i < stroke.lines.size(); ++i) {
    const auto& [from, to] = stroke.lines[i];
    cairo_move_to(pen, from.x, from.y);
    cairo_line_to(pen, to.x, to.y);
    if (i % run != run - 1) continue;
    if (cancellation.requested()) throw Interrupted();
    cairo_stroke(pen);
  }
  cairo_stroke(pen);
}

void draw_patches(cairo_t* pen, const Patches& patches, const Cancellation& cancellation) {
  constexpr std::size_t often = 1024;
  for (std::size_t patch = 0; patch < patches.count(); ++patch) {
    if (patch % often == 0 && cancellation.requested()) throw Interrupted();
    const PagePoint* p = patches.points(patch).data();
    for (const Patches::Step step : patches.steps(patch)) {
      if (step == Patches::Step::curve) {
        cairo_curve_to(pen, p[0].x, p[0].y, p[1].x, p[1].y, p[2].x, p[2].y);
        p += 3;
        continue;
      }
      if (step == Patches::Step::move)
        cairo_move_to(pen, p->x, p->y);
      else
        cairo_line_to(pen, p->x, p->y);
      ++p;
    }
    const Color color = patches.color(patch);
    cairo_set_source_rgb(pen, color[0], color[1], color[2]);
    cairo_fill(pen);
  }
}

void draw_label(cairo_t* pen, const Label& label) {
  cairo_set_source_rgb(pen, 0.2, 0.2, 0.2);
  cairo_set_font_size(pen, label.size);
  cairo_text_extents_t extents;
  cairo_text_extents(pen, label.text.c_str(), &extents);
  cairo_save(pen);
  cairo_translate(pen, label.place.x, label.place.y);
  if (label.upward) cairo_rotate(pen, -std::acos(-1.0) / 2);
  // The height of a small letter is about half the size of the font.
  cairo_move_to(pen, label.anchor == Label::Anchor::middle ? -extents.x_advance / 2 : 0, 0.35 * label.size);
  cairo_show_text(pen, label.text.c_str());
  cairo_restore(pen);
}

void draw(cairo_surface_t* surface, const Drawing& drawing, const Cancellation& cancellation) {
  const Pen pen(cairo_create(surface), &cairo_destroy);
  cairo_set_source_rgb(pen.get(), 1, 1, 1);
  cairo_paint(pen.get());
  cairo_set_line_cap(pen.get(), CAIRO_LINE_CAP_ROUND);
  cairo_select_font_face(pen.get(), "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
  draw_patches(pen.get(), drawing.patches, cancellation);
  for (const Stroke& stroke : drawing.strokes) draw_stroke(pen.get(), stroke, cancellation);
  for (const Label& label : drawing.labels) draw_label(pen.get(), label);
  require(cairo_status(pen.get()));
}

/// Of a page that is made of lines and outlines, by the function that opens its surface.
template <class Create, class Prepare>
std::string pages_of(const Drawing& drawing, Create create, Prepare prepare,
                     const Cancellation& cancellation) {
  std::string bytes;
  const Surface surface(create(append, &bytes, drawing.width, drawing.height), &cairo_surface_destroy);
  prepare(surface.get());
  draw(surface.get(), drawing, cancellation);
  cairo_surface_finish(surface.get());
  require(cairo_surface_status(surface.get()));
  return bytes;
}

std::string pdf_of(const Drawing& drawing, const Cancellation& cancellation) {
  // The clock has no say in a picture: the thesis's day instead of today.
  const auto date = [](cairo_surface_t* surface) {
    cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATE_DATE, "1996-09-15T00:00:00Z");
  };
  return pages_of(drawing, cairo_pdf_surface_create_for_stream, date, cancellation);
}

std::string postscript_of(const Drawing& drawing, const Cancellation& cancellation) {
  const auto nothing = [](cairo_surface_t*) {};
  std::string text = pages_of(drawing, cairo_ps_surface_create_for_stream, nothing, cancellation);
  const auto date = text.find("%%CreationDate");  // nor here
  if (date != std::string::npos) text.erase(date, text.find('\n', date) + 1 - date);
  return text;
}

std::string png_of(const Drawing& drawing, const Cancellation& cancellation) {
  std::string bytes;
  const Surface surface(
      cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(std::ceil(drawing.width)),
                                 static_cast<int>(std::ceil(drawing.height))),
      &cairo_surface_destroy);
  draw(surface.get(), drawing, cancellation);
  require(cairo_surface_write_to_png_stream(surface.get(), append, &bytes));
  return bytes;
}

}  // namespace

std::string svg_of(const Drawing& drawing, const Cancellation& cancellation) {
  const auto pixels = [](cairo_surface_t* surface) {
    cairo_svg_surface_set_document_unit(surface, CAIRO_SVG_UNIT_PX);
  };
  return pages_of(drawing, cairo_svg_surface_create_for_stream, pixels, cancellation);
}

DrawingFormat drawing_format(const std::filesystem::path& path) {
  return format_of(path).format;
}

DrawingFile::DrawingFile(std::filesystem::path path)
    : path_(std::move(path)), format_(drawing_format(path_)) {}

void DrawingFile::require_room(double nodes) const {
  const FormatInfo& info = format_of(path_);
  if (nodes <= info.most_nodes) return;
  const bool is_picture = format_ == DrawingFormat::png;
  throw Error(
      fmt::format("{:.0f} nodes in '{}'", nodes, path_.string()),
      fmt::format("{} holds {:.0f} at most", info.article, info.most_nodes),
      !is_picture && nodes <= most_png_nodes ? "take a name that ends in .png" : "take a smaller tree");
}

std::string DrawingFile::bytes_of(const Drawing& drawing, const Cancellation& cancellation) const {
  switch (format_) {
    case DrawingFormat::svg:
      return svg_of(drawing, cancellation);
    case DrawingFormat::pdf:
      return pdf_of(drawing, cancellation);
    case DrawingFormat::postscript:
      return postscript_of(drawing, cancellation);
    case DrawingFormat::png:
      break;
  }
  return png_of(drawing, cancellation);
}

void DrawingFile::write(const Drawing& drawing, const Cancellation& cancellation) const {
  write_file_atomically(path_, bytes_of(drawing, cancellation));
}

}  // namespace ramify
