#include "svg_png.h"

#include <cairo.h>
#include <librsvg/rsvg.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <memory>

namespace shabon::app {

namespace {

template <auto release>
struct Release {
  template <class T>
  void operator()(T* held) const {
    release(held);
  }
};

using Drawing = std::unique_ptr<RsvgHandle, Release<g_object_unref>>;
using Surface = std::unique_ptr<cairo_surface_t, Release<cairo_surface_destroy>>;
using Pen = std::unique_ptr<cairo_t, Release<cairo_destroy>>;

Diagnostics refuse(const std::string& reason) { return fail(Failure::internal, "drawing the picture: " + reason); }

Diagnostics refuse(GError* error) {
  const std::string reason = error != nullptr ? error->message : "unknown reason";
  g_clear_error(&error);
  return refuse(reason);
}

// cairo keeps a pixel as one number, 0xaarrggbb, in the machine's byte order; on white all are opaque.
io::Rgb8Image pixels_of(cairo_surface_t* surface, int width, int height) {
  io::Rgb8Image image{width, height, {}};
  image.rgb.reserve(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  const unsigned char* rows = cairo_image_surface_get_data(surface);
  const auto stride = static_cast<std::size_t>(cairo_image_surface_get_stride(surface));
  for (std::size_t y = 0; y < static_cast<std::size_t>(height); ++y) {
    for (std::size_t x = 0; x < static_cast<std::size_t>(width); ++x) {
      std::uint32_t pixel = 0;
      std::memcpy(&pixel, rows + y * stride + 4 * x, 4);
      for (const int shift : {16, 8, 0}) image.rgb.push_back(static_cast<std::uint8_t>(pixel >> shift & 0xff));
    }
  }
  return image;
}

}  // namespace

Result<io::Rgb8Image> rasterise(const std::string& svg, int width_px) {
  GError* error = nullptr;
  const Drawing drawing(
      rsvg_handle_new_from_data(reinterpret_cast<const guint8*>(svg.data()), static_cast<gsize>(svg.size()), &error));
  if (!drawing) return refuse(error);
  double own_width = 0, own_height = 0;
  if (!rsvg_handle_get_intrinsic_size_in_pixels(drawing.get(), &own_width, &own_height) || !(own_width > 0))
    return refuse("it has no size");
  const int height_px = static_cast<int>(std::lround(own_height * width_px / own_width));

  const Surface surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, width_px, height_px));
  const Pen pen(cairo_create(surface.get()));
  cairo_set_source_rgb(pen.get(), 1, 1, 1);
  cairo_paint(pen.get());
  const RsvgRectangle page{0, 0, static_cast<double>(width_px), static_cast<double>(height_px)};
  if (!rsvg_handle_render_document(drawing.get(), pen.get(), &page, &error)) return refuse(error);
  cairo_surface_flush(surface.get());
  if (const cairo_status_t status = cairo_status(pen.get()); status != CAIRO_STATUS_SUCCESS)
    return refuse(cairo_status_to_string(status));
  return pixels_of(surface.get(), width_px, height_px);
}

}  // namespace shabon::app
