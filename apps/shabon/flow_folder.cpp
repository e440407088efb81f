#include "flow_folder.h"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>
#include <tuple>

#include "flow_frame.h"
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

// The frames that have a checkpoint, rising.
std::vector<int> checkpoint_frames(const fs::path& folder) {
  std::vector<int> frames;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    const std::string name = entry.path().filename().string();
    const std::string stem = std::string(checkpoint_stem) + ".";
    if (!name.starts_with(stem) || !name.ends_with(checkpoint_ending)) continue;
    const auto frame = parse_integer(name.substr(stem.size(), name.size() - stem.size() - checkpoint_ending.size()));
    if (frame && *frame >= 0) frames.push_back(static_cast<int>(*frame));
  }
  std::sort(frames.begin(), frames.end());
  return frames;
}

}  // namespace

Result<FlowFolder> FlowFolder::begin(const fs::path& path, double frames_per_second) {
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
  FlowFolder folder(path, frames_per_second);
  const std::string column = "frames_per_second";
  io::CsvWriter settings(std::span(&column, 1));
  settings.row(std::span(&frames_per_second, 1));
  if (const Status written = folder.write(std::string(settings_name), settings.text()); !written)
    return written.errors();
  return folder;
}

Result<FlowFolder> FlowFolder::reopen(const fs::path& path) {
  const auto settings = io::read_csv(path / settings_name);
  if (!settings) return settings.errors();
  const auto rate = io::numbers(*settings, "frames_per_second");
  if (!rate) return rate.errors();
  if (!(rate->front() > 0)) return fail(Failure::content, "expected frames_per_second above 0 in simulation.csv");
  FlowFolder folder(path, rate->front());
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
  const std::vector<int> frames = checkpoint_frames(path_);
  auto found = frames.end();
  for (auto it = frames.begin(); it != frames.end(); ++it)
    if (!frame || *it <= *frame) found = it;
  if (found == frames.end())
    return fail(Failure::content, fmt::format("'{}' holds no checkpoint{}", printable(path_.string()),
                                              frame ? fmt::format(" at or before frame {}", *frame) : std::string()));
  const fs::path file = path_ / frame_name(checkpoint_stem, *found, checkpoint_ending);
  const auto bytes = io::read_file(file, most_checkpoint_bytes);
  if (!bytes) return bytes.errors();
  auto flow = film::FilmFlow::resume(std::as_bytes(std::span(*bytes)));
  if (!flow) {
    Diagnostics errors = flow.errors();
    for (Diagnostic& flaw : errors) flaw.source = file.string();
    return errors;
  }
  std::erase_if(rows_, [&](const std::vector<double>& row) { return row.front() > *found; });
  return Start{std::move(flow).value(), *found};
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
