#include "shabon/optics/media.h"

#include <algorithm>
#include <string>
#include <utility>

#include "shabon/base/text.h"
#include "shabon/optics/media_list.h"

namespace shabon::optics {

namespace {

constexpr std::size_t named_when_unknown = 8;  // of those known
constexpr std::size_t most_shown = 60;         // characters of an unknown name

const MediumEntry* find_entry(std::string_view name) {
  for (const MediumEntry& entry : media_library()) {
    const auto named = [&](std::string_view known) { return same_name(known, name); };
    if (named(entry.name) || std::any_of(entry.aliases.begin(), entry.aliases.end(), named)) return &entry;
  }
  return nullptr;
}

}  // namespace

std::span<const MediumEntry> media_library() {
  static const std::vector<MediumEntry> library = make_media_list();
  return library;
}

std::vector<std::string_view> media_names() {
  std::vector<std::string_view> names;
  for (const MediumEntry& entry : media_library()) names.push_back(entry.name);
  return names;
}

std::optional<Medium> find_medium(std::string_view name) {
  if (const MediumEntry* entry = find_entry(name)) return entry->medium;
  return {};
}

Result<Medium> medium_named(std::string_view name) {
  if (const MediumEntry* entry = find_entry(name)) return entry->medium;
  std::vector<std::string_view> known = media_names();
  for (const MediumEntry& entry : media_library())
    known.insert(known.end(), entry.aliases.begin(), entry.aliases.end());
  if (nearest_name(name, known))
    return fail(Failure::content, unknown_name("medium", name, known));
  std::string message = "unknown medium '" + printable(name, most_shown) + "'; known:";
  for (std::size_t i = 0; i < named_when_unknown; ++i) message += (i ? ", " : " ") + std::string(known[i]);
  message += " and " + std::to_string(media_library().size() - named_when_unknown) + " more; 'shabon media' lists them";
  return fail(Failure::content, std::move(message));
}

}  // namespace shabon::optics
