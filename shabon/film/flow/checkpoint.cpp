#include "shabon/film/flow/checkpoint.h"

#include <array>
#include <string_view>

#include "shabon/base/random.h"
#include "shabon/film/flow/archive.h"
#include "shabon/film/flow/initial.h"
#include "shabon/film/flow/metric.h"

namespace shabon::film {

namespace {

constexpr std::string_view magic = "SHABON film flow";
constexpr std::uint32_t version = 2;
constexpr std::size_t head = magic.size() + sizeof version, tail = sizeof(std::uint64_t);

std::uint64_t checksum(std::span<const std::byte> bytes) {
  std::uint64_t sum = hash64(bytes.size());
  std::size_t i = 0;
  for (; i + sizeof sum <= bytes.size(); i += sizeof sum) {
    std::uint64_t word;
    std::memcpy(&word, bytes.data() + i, sizeof word);
    sum = hash64(sum ^ word);
  }
  for (; i < bytes.size(); ++i) sum = hash64(sum ^ std::to_integer<std::uint64_t>(bytes[i]));
  return sum;
}

template <class Archive>
void transfer_numbers(Archive& archive, Numbers& numbers) {
  auto count = static_cast<std::uint64_t>(numbers.size());
  transfer(archive, count);
  if constexpr (Archive::reading) {
    if (count != numbers.size()) return archive.refuse();
  }
  archive.raw(numbers.data(), numbers.size() * sizeof(double));
}

template <class Archive>
void transfer_rupture(Archive& archive, std::optional<FilmFlow::Rupture>& rupture) {
  bool there = rupture.has_value();
  transfer(archive, there);
  if (!there) return rupture.reset();
  if (!rupture) rupture.emplace();
  transfer(archive, rupture->time_s), transfer(archive, rupture->threshold_nm), transfer(archive, rupture->from_centre);
}

template <class Archive>
void transfer_film(Archive& archive, FilmState& film) {
  transfer(archive, film.time_s);
  for (Numbers* numbers : {&film.thickness, &film.surfactant, &film.surfactant_last, &film.along, &film.push})
    transfer_numbers(archive, *numbers);
  transfer(archive, film.surfactant_at_start);
  transfer(archive, film.drop_m3), transfer(archive, film.evaporated_m3);
  transfer(archive, film.patches), transfer(archive, film.spots);
  transfer_rupture(archive, film.rupture);
  transfer(archive, film.frame);
}

Diagnostics damaged(const std::string& how) { return fail(Failure::content, "the film's checkpoint " + how); }

}  // namespace

std::vector<std::byte> write_checkpoint(const FlowDesc& desc, const FilmState& film) {
  ArchiveWriter archive;
  std::uint32_t written = version;
  archive.raw(magic.data(), magic.size());
  transfer(archive, written);
  FlowDesc desc_copy = desc;
  FilmState film_copy = film;
  transfer(archive, desc_copy);
  transfer_film(archive, film_copy);
  std::uint64_t sum = checksum(archive.bytes);
  transfer(archive, sum);
  return std::move(archive.bytes);
}

Result<Checkpoint> read_checkpoint(std::span<const std::byte> bytes) {
  if (bytes.size() < head + tail || std::memcmp(bytes.data(), magic.data(), magic.size()) != 0)
    return damaged("is none: it does not begin as one");
  ArchiveReader archive(bytes.subspan(magic.size(), bytes.size() - magic.size() - tail));
  std::uint32_t found = 0;
  transfer(archive, found);
  if (found != version)
    return damaged("is of version " + std::to_string(found) + "; this program reads version " +
                   std::to_string(version));
  std::uint64_t sum = 0;
  std::memcpy(&sum, bytes.data() + bytes.size() - tail, tail);
  if (sum != checksum(bytes.first(bytes.size() - tail))) return damaged("is damaged or cut off: its checksum is wrong");
  Checkpoint read;
  transfer(archive, read.desc);
  if (!archive.ok()) return damaged("ends too early");
  if (Diagnostics problems = check(read.desc); !problems.empty()) return problems;
  const Metric metric(sphere_grid(read.desc.level), read.desc.radius_m);
  read.film = empty_state(metric);
  transfer_film(archive, read.film);
  if (!archive.ok() || archive.left() != 0) return damaged("does not fit its level");
  return read;
}

}  // namespace shabon::film
