#include "flow_folder.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <system_error>
#include <tuple>

#include "shabon/base/text.h"
#include "shabon/io/csv.h"
#include "shabon/io/file.h"

namespace shabon::app {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view settings_name = "simulation.csv";
constexpr std::string_view rows_name = "diagnostics.csv";
constexpr std::string_view checkpoint_stem = "checkpoint", checkpoint_ending = ".bin";
constexpr std::size_t most_checkpoint_bytes = std::size_t{1} << 32;

std::vector<std::string> column_names() {
  std::vector<std::string> names = {"frame"};
  std::apply([&](const auto&... field) { (names.emplace_back(field.key), ...); }, film::fields(Of<film::FlowReport>{}));
  return names;
}

std::vector<double> row_of(int frame, const film::FlowReport& report) {
  std::vector<double> row = {static_cast<double>(frame)};
  std::apply([&](const auto&... field) { (row.push_back(static_cast<double>(report.*field.member)), ...); },
             film::fields(Of<film::FlowReport>{}));
  return row;
}

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
  std::vector<std::string> names = {"frames_per_second", "checkpoint_every", "lat_long_width",
                                    "cube_edge",         "png_low_nm",       "png_high_nm"};
  const auto range = settings.maps.png_range_nm.value_or(std::array{-1.0, -1.0});
  std::vector<double> row = {settings.frames_per_second,
                             double(settings.checkpoint_every),
                             double(settings.maps.lat_long_width),
                             double(settings.maps.cube_edge),
                             range[0],
                             range[1]};
  for (const FrameKind& kind : frame_kinds()) {
    names.emplace_back(kind.name);
    row.push_back(std::count(settings.kinds.begin(), settings.kinds.end(), &kind) > 0);
  }
  io::CsvWriter table(names);
  table.row(row);
  return table.text();
}

Result<FlowSettings> read_settings(const fs::path& path) {
  const auto table = io::read_csv(path);
  if (!table) return table.errors();
  Diagnostics errors;
  const auto number = [&](std::string_view name) {
    const auto values = io::numbers(*table, name);
    if (!values) errors.insert(errors.end(), values.errors().begin(), values.errors().end());
    return values ? values->front() : 0;
  };
  FlowSettings settings;
  settings.frames_per_second = number("frames_per_second");
  settings.checkpoint_every = static_cast<int>(number("checkpoint_every"));
  settings.maps.lat_long_width = static_cast<int>(number("lat_long_width"));
  settings.maps.cube_edge = static_cast<int>(number("cube_edge"));
  const double low = number("png_low_nm"), high = number("png_high_nm");
  if (low >= 0) settings.maps.png_range_nm = {low, high};
  for (const FrameKind& kind : frame_kinds())
    if (number(kind.name) != 0) settings.kinds.push_back(&kind);
  if (!errors.empty()) return errors;
  if (!(settings.frames_per_second > 0) || settings.checkpoint_every < 1 || settings.maps.lat_long_width < 2 ||
      settings.maps.cube_edge < 2)
    return fail(Failure::content, fmt::format("expected settings above 0 in '{}'", printable(path.string())));
  return settings;
}

}  // namespace

Result<FlowFolder> FlowFolder::begin(const fs::path& path, const FlowSettings& settings) {
  std::error_code error;
  if (fs::exists(path / settings_name, error))
    return fail(Failure::usage, fmt::format("'{}' holds a simulation already: expected --resume to go on with it, or "
                                            "another folder",
                                            printable(path.string())));
  fs::create_directories(path, error);
  if (error) {
    Diagnostics errors = fail(Failure::file, "cannot make the folder: " + error.message());
    errors.front().source = path.string();
    return errors;
  }
  FlowFolder folder(path, settings);
  if (const Status written = folder.change(settings); !written) return written.errors();
  return folder;
}

Status FlowFolder::change(const FlowSettings& settings) {
  settings_ = settings;
  return write(std::string(settings_name), settings_text(settings));
}

Result<FlowFolder> FlowFolder::reopen(const fs::path& path) {
  const auto settings = read_settings(path / settings_name);
  if (!settings) return settings.errors();
  FlowFolder folder(path, *settings);
  std::error_code error;
  if (!fs::exists(path / rows_name, error)) return folder;
  const auto table = io::read_csv(path / rows_name);
  if (!table) return table.errors();
  folder.rows_.resize(table->rows.size());
  for (const std::string& name : column_names()) {
    const auto values = io::numbers(*table, name);
    if (!values) return values.errors();
    for (std::size_t i = 0; i < values->size(); ++i) folder.rows_[i].push_back((*values)[i]);
  }
  return folder;
}

Result<FlowFolder::Start> FlowFolder::latest(std::optional<int> frame) {
  if (!frame && !rows_.empty()) frame = static_cast<int>(rows_.back().front());
  const std::vector<int> frames = checkpoint_frames(path_);
  const auto after = std::upper_bound(frames.begin(), frames.end(), frame.value_or(std::numeric_limits<int>::max()));
  if (after == frames.begin())
    return fail(Failure::content, fmt::format("'{}' holds no checkpoint{}", printable(path_.string()),
                                              frame ? fmt::format(" at or before frame {}", *frame) : std::string()));
  const auto found = std::prev(after);
  const fs::path file = path_ / frame_name(checkpoint_stem, *found, checkpoint_ending);
  const auto bytes = io::read_file(file, most_checkpoint_bytes);
  if (!bytes) return bytes.errors();
  auto flow = film::FilmFlow::resume(std::as_bytes(std::span(*bytes)));
  if (!flow) {
    Diagnostics errors = flow.errors();
    for (Diagnostic& flaw : errors) flaw.source = file.string();
    if (found != frames.begin())
      errors.back().message += fmt::format("; --resume-from {} takes the checkpoint before it", *std::prev(found));
    return errors;
  }
  forget_after(*found);
  return Start{std::move(flow).value(), *found};
}

void FlowFolder::forget_after(int frame) {
  std::erase_if(rows_, [&](const std::vector<double>& row) { return row.front() > frame; });
  std::vector<fs::path> later;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(path_, error))
    if (const auto number = frame_of(entry.path().filename().string()); number && *number > frame)
      later.push_back(entry.path());
  for (const fs::path& file : later) fs::remove(file, error);
}

Status FlowFolder::add_row(int frame, const film::FlowReport& report) {
  rows_.push_back(row_of(frame, report));
  return write_rows();
}

Status FlowFolder::write_rows() {
  const std::vector<std::string> names = column_names();
  io::CsvWriter table(names);
  for (const std::vector<double>& row : rows_) table.row(row);
  return write(std::string(rows_name), table.text());
}

Status FlowFolder::write_checkpoint(int frame, const std::vector<std::byte>& bytes) {
  return write(frame_name(checkpoint_stem, frame, checkpoint_ending),
               {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

Status FlowFolder::write(const std::string& name, std::string_view bytes) {
  return io::write_file_atomically(path_ / name, bytes);
}

}  // namespace shabon::app
