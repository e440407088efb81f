#include "flow_folder.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <system_error>

#include "key_values.h"
#include "shabon/base/text.h"
#include "shabon/film/flow/listing.h"
#include "shabon/io/csv.h"
#include "shabon/io/file.h"
#include "streams.h"

namespace shabon::app {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view settings_name = "simulation.csv";
constexpr std::string_view film_name = "film.csv";
constexpr std::string_view rows_name = "diagnostics.csv";
constexpr std::string_view checkpoint_stem = "checkpoint", checkpoint_ending = ".bin";
constexpr std::size_t most_checkpoint_bytes = std::size_t{1} << 32;

// The number in "stem.0012.ending", when `name` is one of ours.
std::optional<int> frame_of(const std::string& name) {
  std::vector<std::string_view> stems = {checkpoint_stem, "film"};
  for (const FrameKind& kind : frame_kinds()) stems.push_back(kind.name);
  const std::vector<std::string_view> parts = split(name, '.');
  if (parts.size() != 3 || std::find(stems.begin(), stems.end(), parts[0]) == stems.end()) return {};
  const auto frame = parse_integer(parts[1]);
  return frame && *frame >= 0 ? std::optional<int>(static_cast<int>(*frame)) : std::nullopt;
}

// The frames that have a checkpoint, rising.
std::vector<int> checkpoint_frames(const fs::path& folder) {
  std::vector<int> frames;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    const std::string name = entry.path().filename().string();
    const auto frame = frame_of(name);
    if (frame && name.starts_with(checkpoint_stem)) frames.push_back(*frame);
  }
  std::sort(frames.begin(), frames.end());
  return frames;
}

// One row of numbers: -1 for a range that is not given, 0 and 1 for kinds.
std::string settings_text(const FlowSettings& settings) {
  std::vector<std::string> names = {"frames_per_second", "checkpoint_every", "lat_long_width",  "cube_edge",
                                    "png_low_nm",        "png_high_nm",      "refractive_index"};
  const auto range = settings.maps.png_range_nm.value_or(std::array{-1.0, -1.0});
  std::vector<double> row = {settings.frames_per_second,
                             double(settings.checkpoint_every),
                             double(settings.maps.lat_long_width),
                             double(settings.maps.cube_edge),
                             range[0],
                             range[1],
                             settings.maps.refractive_index};
  for (const FrameKind& kind : frame_kinds()) {
    names.emplace_back(kind.name);
    row.push_back(std::count(settings.kinds.begin(), settings.kinds.end(), &kind) > 0);
  }
  io::CsvWriter table(names);
  table.row(row);
  return table.text();
}

Diagnostics flaw_of(const fs::path& file, Failure failure, const std::string& message) {
  Diagnostics errors = fail(failure, message);
  errors.front().source = file.string();
  return errors;
}

Result<FlowSettings> read_settings(const fs::path& path) {
  const auto table = io::read_csv(path);
  if (!table) return table.errors();
  Diagnostics errors;
  // A column that is there, with a number that is `fine`; 0 and an error otherwise.
  const auto number = [&](std::string_view name, const auto& fine, const std::string& expected) {
    const auto values = io::numbers(*table, name);
    if (!values) errors.insert(errors.end(), values.errors().begin(), values.errors().end());
    if (!values || fine(values->front())) return values ? values->front() : 0;
    const std::string got = format_number(values->front());
    errors.push_back(
        flaw_of(path, Failure::content, fmt::format("{}: expected {}, got {}", name, expected, got)).front());
    return 0.0;
  };
  const auto any = [&](std::string_view name) {
    return number(
        name, [](double) { return true; }, "");
  };
  const auto whole = [&](std::string_view name, int least) {
    constexpr double most = 1e6;
    const auto fine = [least](double value) { return value >= least && value <= most; };
    return static_cast<int>(number(name, fine, fmt::format("{} to {}", least, most)));
  };
  FlowSettings settings;
  settings.frames_per_second = number(
      "frames_per_second", [](double value) { return value > 0; }, "more than 0");
  settings.checkpoint_every = whole("checkpoint_every", 1);
  settings.maps.lat_long_width = whole("lat_long_width", 2);
  settings.maps.cube_edge = whole("cube_edge", 2);
  const double low = any("png_low_nm"), high = any("png_high_nm");
  if (low >= 0) settings.maps.png_range_nm = {low, high};
  if (table->column("refractive_index")) settings.maps.refractive_index = any("refractive_index");
  for (const FrameKind& kind : frame_kinds())
    if (any(kind.name) != 0) settings.kinds.push_back(&kind);
  if (!errors.empty()) return errors;
  return settings;
}

// That the flow is the folder's film, where the folder says which that is.
Status check_film(const fs::path& folder, const fs::path& file, const film::FilmFlow& flow) {
  const fs::path film_file = folder / film_name;
  std::error_code error;
  if (!fs::exists(film_file, error)) return Done{};
  const auto film = read_key_values(film_file);
  if (!film) return film.errors();
  const auto difference =
      first_difference(*film, "'" + printable(film_file.string()) + "'", film::listed(flow.desc()), "the checkpoint");
  if (difference) return flaw_of(file, Failure::content, "is of another film: " + *difference);
  return Done{};
}

// That the flow is at the frame's time.
Status check_time(const fs::path& file, int frame, double frames_per_second, const film::FilmFlow& flow) {
  const double frame_s = frame / frames_per_second;
  const bool late = flow.time_s() > frame_s + 1e-9, early = flow.time_s() < frame_s - 1e-9 && !flow.rupture();
  if (late || early)
    return flaw_of(file, Failure::content,
                   fmt::format("expected the film at {} s, frame {}, got it at {} s", format_number(frame_s, 9), frame,
                               format_number(flow.time_s(), 9)));
  return Done{};
}

// The flow of a frame's checkpoint, if that is what the file holds.
Result<film::FilmFlow> read_checkpoint(const fs::path& folder, int frame, double frames_per_second) {
  const fs::path file = folder / frame_name(checkpoint_stem, frame, checkpoint_ending);
  const auto bytes = io::read_file(file, most_checkpoint_bytes);
  if (!bytes) return bytes.errors();
  auto flow = film::FilmFlow::resume(std::as_bytes(std::span(*bytes)));
  if (!flow) {
    Diagnostics errors = flow.errors();
    for (Diagnostic& flaw : errors) flaw.source = file.string();
    return errors;
  }
  if (const Status ours = check_film(folder, file, *flow); !ours) return ours.errors();
  if (const Status timely = check_time(file, frame, frames_per_second, *flow); !timely) return timely.errors();
  return flow;
}

// What film it is, where an older version has not said so.
Status name_film(const fs::path& folder, const film::FilmFlow& flow, Diagnostics& warnings) {
  const fs::path film_file = folder / film_name;
  std::error_code error;
  if (fs::exists(film_file, error)) return Done{};
  warnings.push_back(
      warning_of(fmt::format("there is no '{}' to compare the checkpoint with, as older versions left "
                             "it; the run goes on with the film of the checkpoint",
                             printable(film_file.string()))));
  return write_key_values(film_file, film::listed(flow.desc()));
}

}  // namespace

Result<FlowFolder> FlowFolder::begin(const fs::path& path, const FlowSettings& settings, const film::FlowDesc& film) {
  std::error_code error;
  if (fs::exists(path / settings_name, error) && !checkpoint_frames(path).empty())
    return fail(Failure::usage, fmt::format("'{}' holds a simulation already: expected --resume to go on with it, or "
                                            "another folder",
                                            printable(path.string())));
  fs::create_directories(path, error);
  if (error) return flaw_of(path, Failure::file, "cannot make the folder: " + error.message());
  FlowFolder folder(path, settings);
  if (const Status written = folder.change(settings); !written) return written.errors();
  if (const Status written = write_key_values(path / film_name, film::listed(film)); !written) return written.errors();
  return folder;
}

Status FlowFolder::change(const FlowSettings& settings) {
  settings_ = settings;
  return write(std::string(settings_name), settings_text(settings));
}

Result<FlowFolder> FlowFolder::reopen(const fs::path& path, Diagnostics& warnings) {
  std::error_code error;
  if (!fs::exists(path / settings_name, error))
    return fail(Failure::file, fmt::format("there is nothing to go on from in '{}': expected a simulation's {} there",
                                           printable(path.string()), settings_name));
  const auto settings = read_settings(path / settings_name);
  if (!settings) return settings.errors();
  FlowFolder folder(path, *settings);
  auto rows = FlowRows::read(path / rows_name, warnings);
  if (!rows) return rows.errors();
  folder.rows_ = std::move(rows).value();
  return folder;
}

Result<FlowFolder::Start> FlowFolder::latest(std::optional<int> frame, Diagnostics& warnings) {
  const std::vector<int> frames = checkpoint_frames(path_);
  const auto after = std::upper_bound(frames.begin(), frames.end(), frame.value_or(std::numeric_limits<int>::max()));
  if (after == frames.begin())
    return fail(Failure::content, fmt::format("'{}' holds no checkpoint{}", printable(path_.string()),
                                              frame ? fmt::format(" at or before frame {}", *frame) : std::string()));
  const auto found = std::prev(after);
  auto flow = read_checkpoint(path_, *found, settings_.frames_per_second);
  if (!flow) {
    Diagnostics errors = flow.errors();
    for (auto before = found; before != frames.begin();)
      if (read_checkpoint(path_, *--before, settings_.frames_per_second)) {
        errors.back().message += fmt::format("; --resume-from {} takes the checkpoint before it", *before);
        break;
      }
    return errors;
  }
  if (const Status named = name_film(path_, *flow, warnings); !named) return named.errors();
  forget_after(*found);
  rows_.put(*found, flow->report());  // as it was written, should it be lost
  if (const auto missing = rows_.missing_until(*found))
    warnings.push_back(warning_of(fmt::format("'{}' lacks the rows of frames {}, which are lost; the run goes on",
                                              printable((path_ / rows_name).string()), *missing)));
  return Start{std::move(flow).value(), *found};
}

void FlowFolder::forget_after(int frame) {
  rows_.forget_after(frame);
  std::vector<fs::path> later;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(path_, error))
    if (const auto number = frame_of(entry.path().filename().string()); number && *number > frame)
      later.push_back(entry.path());
  for (const fs::path& file : later) fs::remove(file, error);
}

Status FlowFolder::add_row(int frame, const film::FlowReport& report) {
  rows_.put(frame, report);
  return write(std::string(rows_name), rows_.text());
}

Status FlowFolder::write_checkpoint(int frame, const std::vector<std::byte>& bytes) {
  return write(frame_name(checkpoint_stem, frame, checkpoint_ending),
               {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

std::optional<int> FlowFolder::last_checkpoint() const {
  const std::vector<int> frames = checkpoint_frames(path_);
  return frames.empty() ? std::nullopt : std::optional(frames.back());
}

Status FlowFolder::write(const std::string& name, std::string_view bytes) {
  return io::write_file_atomically(path_ / name, bytes);
}

}  // namespace shabon::app
