// Plain structs with field lists to bytes and back. One function, transfer(), walks the members for both ways.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <type_traits>
#include <variant>
#include <vector>

#include "shabon/base/field.h"
#include "shabon/math/vec.h"

namespace shabon::film {

static_assert(std::endian::native == std::endian::little, "checkpoints are little-endian");

class ArchiveWriter {
 public:
  static constexpr bool reading = false;
  void raw(const void* from, std::size_t count) {
    const auto* first = static_cast<const std::byte*>(from);
    bytes.insert(bytes.end(), first, first + count);
  }
  bool ok() const { return true; }
  std::vector<std::byte> bytes;
};

// After the end of the bytes everything reads as zero, and ok() is false.
class ArchiveReader {
 public:
  static constexpr bool reading = true;
  explicit ArchiveReader(std::span<const std::byte> from) : left_(from) {}
  void raw(void* to, std::size_t count) {
    if (count > left_.size()) {
      std::memset(to, 0, count);
      ok_ = false;
      return;
    }
    if (count > 0) std::memcpy(to, left_.data(), count);
    left_ = left_.subspan(count);
  }
  void refuse() { ok_ = false; }
  bool ok() const { return ok_; }
  std::size_t left() const { return left_.size(); }

 private:
  std::span<const std::byte> left_;
  bool ok_ = true;
};

template <class Archive, class T>
requires std::is_arithmetic_v<T>
void transfer(Archive& archive, T& value) {
  if constexpr (std::is_same_v<T, bool>) {
    std::uint8_t byte = value ? 1 : 0;
    archive.raw(&byte, 1);
    value = byte != 0;
  } else {
    archive.raw(&value, sizeof value);
  }
}

template <class Archive>
void transfer(Archive& archive, math::Vec3d& value) {
  transfer(archive, value.x), transfer(archive, value.y), transfer(archive, value.z);
}

template <class Archive, class T>
void transfer(Archive& archive, std::optional<T>& value);
template <class Archive, class... T>
void transfer(Archive& archive, std::variant<T...>& value);
template <class Archive, class T>
void transfer(Archive& archive, std::vector<T>& list);

template <class Archive, class Struct>
requires requires { fields(Of<Struct>{}); }
void transfer(Archive& archive, Struct& object) {
  std::apply([&](const auto&... field) { (transfer(archive, object.*field.member), ...); }, fields(Of<Struct>{}));
}

template <class Archive, class T>
void transfer(Archive& archive, std::optional<T>& value) {
  bool there = value.has_value();
  transfer(archive, there);
  if (!there) return value.reset();
  if (!value) value.emplace();
  transfer(archive, *value);
}

template <class Archive, class... T>
void transfer(Archive& archive, std::variant<T...>& value) {
  std::uint8_t chosen = static_cast<std::uint8_t>(value.index());
  transfer(archive, chosen);
  if constexpr (Archive::reading) {
    if (chosen >= sizeof...(T)) return archive.refuse();
    std::size_t n = 0;
    ((n++ == chosen ? void(value.template emplace<T>()) : void()), ...);
  }
  std::visit([&](auto& held) { transfer(archive, held); }, value);
}

template <class Archive, class T>
void transfer(Archive& archive, std::vector<T>& list) {
  auto count = static_cast<std::uint64_t>(list.size());
  transfer(archive, count);
  if constexpr (Archive::reading) {
    if (count > archive.left()) return archive.refuse();  // every item takes a byte at least
    list.assign(static_cast<std::size_t>(count), T{});
  }
  for (T& item : list) transfer(archive, item);
}

}  // namespace shabon::film
