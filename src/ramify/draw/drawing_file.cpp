#include "ramify/draw/drawing_file.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>

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
constexpr double most_svg_nodes = 200'000, most_png_nodes = 5'000'000;

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
  for (const Stroke& stroke : drawing.strokes) draw_stroke(pen.get(), stroke, cancellation);
  for (const Label& label : drawing.labels) draw_label(pen.get(), label);
  require(cairo_status(pen.get()));
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
  std::string bytes;
  const Surface surface(cairo_svg_surface_create_for_stream(append, &bytes, drawing.width, drawing.height),
                        &cairo_surface_destroy);
  cairo_svg_surface_set_document_unit(surface.get(), CAIRO_SVG_UNIT_PX);
  draw(surface.get(), drawing, cancellation);
  cairo_surface_finish(surface.get());
  require(cairo_surface_status(surface.get()));
  return bytes;
}

DrawingFile::DrawingFile(std::filesystem::path path)
    : path_(std::move(path)), format_(picture_format(path_, "--output", "drawings")) {}

void DrawingFile::require_room(double nodes) const {
  const bool is_svg = format_ == PictureFormat::svg;
  const double most = is_svg ? most_svg_nodes : most_png_nodes;
  if (nodes <= most) return;
  throw Error(fmt::format("{:.0f} nodes in '{}'", nodes, path_.string()),
              fmt::format("{} holds {:.0f} at most", is_svg ? "an SVG" : "a PNG", most),
              is_svg && nodes <= most_png_nodes ? "take a name that ends in .png" : "take a smaller tree");
}

void DrawingFile::write(const Drawing& drawing, const Cancellation& cancellation) const {
  write_file_atomically(
      path_, format_ == PictureFormat::svg ? svg_of(drawing, cancellation) : png_of(drawing, cancellation));
}

}  // namespace ramify
