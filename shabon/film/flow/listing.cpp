#include "shabon/film/flow/listing.h"

#include <optional>
#include <type_traits>
#include <variant>

#include "shabon/base/text.h"

namespace shabon::film {

namespace {

class Lister {
 public:
  template <class T>
  void list(const T& value, const std::string& key) {
    if constexpr (std::is_same_v<T, bool>) {
      add(key, value ? "true" : "false");
    } else if constexpr (std::is_integral_v<T>) {
      add(key, std::to_string(value));
    } else if constexpr (std::is_floating_point_v<T>) {
      add(key, format_number(value));
    } else if constexpr (std::is_same_v<T, math::Vec3d>) {
      add(key, format_number(value.x) + " " + format_number(value.y) + " " + format_number(value.z));
    } else {
      const auto one = [&](const auto& field) {
        list(value.*field.member, (key.empty() ? "" : key + ".") + std::string(field.key));
      };
      std::apply([&](const auto&... field) { (one(field), ...); }, fields(Of<T>{}));
    }
  }
  template <class T>
  void list(const std::optional<T>& value, const std::string& key) {
    value ? list(*value, key) : add(key, "none");
  }
  void list(const std::vector<AirMotion>& motions, const std::string& key) {
    if (motions.empty()) add(key, "none");
    for (std::size_t i = 0; i < motions.size(); ++i)
      std::visit(
          [&](const auto& air) {
            const About told = about(Of<std::decay_t<decltype(air)>>{});
            list(air, key + "[" + std::to_string(i) + "]." + std::string(told.name));
          },
          motions[i]);
  }

  std::vector<std::pair<std::string, std::string>> found;

 private:
  void add(const std::string& key, std::string value) { found.emplace_back(key, std::move(value)); }
};

}  // namespace

std::vector<std::pair<std::string, std::string>> listed(const FlowDesc& desc) {
  Lister lister;
  lister.list(desc, "");
  return std::move(lister.found);
}

}  // namespace shabon::film
