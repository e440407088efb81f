// shabon reference --out DIR: tables of standard films, for testing other programs.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <system_error>

#include "command.h"
#include "options.h"
#include "shabon/api/version.h"
#include "shabon/base/text.h"
#include "shabon/desk/reference_tables.h"
#include "shabon/io/file.h"
#include "streams.h"

namespace shabon::app {

namespace {

namespace fs = std::filesystem;

struct ReferenceCommand {
  std::optional<std::string> folder;
  bool list = false;
};

Diagnostics file_error(const fs::path& path, const std::string& message) {
  Diagnostics errors = fail(Failure::file, message);
  errors.front().source = path.string();
  return errors;
}

// A file that the tables may replace: one of an earlier version of them.
Status check_ours(const fs::path& path) {
  std::error_code error;
  if (!fs::exists(fs::symlink_status(path, error))) return Done{};
  constexpr std::size_t most_bytes = 64 << 20;
  const Result<std::string> old = io::read_file(path, most_bytes);
  if (old && old->starts_with(desk::reference_marker)) return Done{};
  return file_error(path, "expected no file or an older reference table, got another file; it is not overwritten");
}

// The folder, made where it is missing; nothing in it is touched yet.
Status prepare(const fs::path& folder, const std::vector<desk::ReferenceFile>& files) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error || !fs::is_directory(folder))
    return file_error(folder, "expected a folder that can be made: " +
                                  (error ? error.message() : std::string("there is a file of that name")));
  for (const desk::ReferenceFile& file : files)
    if (const Status ours = check_ours(folder / file.name); !ours) return ours;
  return io::check_writable(folder / files.front().name);
}

int write_tables(const fs::path& folder) {
  if (const Status ready = prepare(folder, desk::reference_list()); !ready) return report(ready.errors());
  std::size_t bytes = 0;
  const std::vector<desk::ReferenceFile> files = desk::reference_files(version());
  for (const desk::ReferenceFile& file : files) {
    const Status written = io::write_file_atomically(folder / file.name, file.text);
    if (!written) return report(written.errors());
    bytes += file.text.size();
  }
  say(fmt::format("wrote {} files, {:.1f} MB, to {}", files.size(), static_cast<double>(bytes) / 1e6,
                  printable(folder.string())));
  return success;
}

std::string list_text() {
  std::size_t width = 0;
  const std::vector<desk::ReferenceFile> files = desk::reference_list();
  for (const desk::ReferenceFile& file : files) width = std::max(width, file.name.size());
  std::string text = fmt::format("Reference tables, version {}\n\n", desk::reference_tables_version);
  text += fmt::format("{:<{}} {:>6}  {}\n", "file", width, "rows", "content");
  for (const desk::ReferenceFile& file : files)
    text += fmt::format("{:<{}} {:>6}  {}\n", file.name, width, file.rows == 0 ? "" : std::to_string(file.rows),
                        file.description);
  text += "\n";
  for (const desk::ReferenceFilm& film : desk::reference_films())
    text += fmt::format("{:<{}}  {}\n", film.name, width + 6, film.expression);
  return text;
}

int run_reference(const ReferenceCommand& command) {
  if (command.list) return print_result(list_text());
  if (!command.folder) return report(fail(Failure::usage, "expected --out and a folder, or --list"));
  if (command.folder->empty()) return report(fail(Failure::usage, "--out: expected a folder, got an empty name"));
  return write_tables(*command.folder);
}

}  // namespace

Action declare_reference(CLI::App& app) {
  const auto command = std::make_shared<ReferenceCommand>();
  CLI::Option* out = add_text(app, "-o,--out", command->folder, "DIR",
                              "Folder for the tables; it is made where it is missing, other files in it stay");
  app.add_flag("--list", command->list, "Print what the tables are, and write nothing")->excludes(out);
  app.footer(R"(
About 5 MB of CSV: R and T of both polarisations and the colours of standard films, by wavelength, thickness, angle and
lamp, with units, conventions and sources in their heads, and the indices, lamps and observer that they are made from.
README.md in the folder says more. Tables of an earlier run are replaced; a file of one of their names that is something
else is an error, and nothing is written.

Examples:
  shabon reference --list
  shabon reference --out tables)");
  return [command] { return run_reference(*command); };
}

}  // namespace shabon::app
