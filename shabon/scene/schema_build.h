// Builds the tree of schema.h from the field lists of plain structs. The only place where a struct's type meets the
// untyped object of a Key: both are made from the same T here.
#pragma once

#include <optional>
#include <tuple>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "shabon/base/choice.h"
#include "shabon/base/field.h"
#include "shabon/base/indirect.h"
#include "shabon/scene/schema.h"
#include "shabon/scene/value.h"

namespace shabon::scene {

template <class T>
const Mapping& mapping_of();

// A value that is written as one scalar or vector.
template <class T>
concept PlainValue = requires(const T& value) {
  value_text(value);
};

template <class T>
inline constexpr bool is_variant = false;
template <class... T>
inline constexpr bool is_variant<std::variant<T...>> = true;
template <class T>
inline constexpr bool is_optional = false;
template <class T>
inline constexpr bool is_optional<std::optional<T>> = true;
template <class T>
inline constexpr bool is_list = false;
template <class T>
inline constexpr bool is_list<std::vector<T>> = true;
template <class T>
inline constexpr bool is_indirect = false;
template <class T>
inline constexpr bool is_indirect<Indirect<T>> = true;

template <class V>
void read_member(const io::YamlNode& node, const FieldInfo& info, const Path& path, V& value, Problems& problems) {
  if constexpr (is_optional<V>) {
    using Content = typename V::value_type;
    if constexpr (PlainValue<Content>) {
      Content content{};
      if (read_value(node, info, path, content, problems)) value = content;
    } else {
      read_member(node, info, path, value.emplace(), problems);
    }
  } else if constexpr (is_indirect<V>) {
    read_member(node, info, path, *value, problems);
  } else if constexpr (is_list<V>) {
    if (node.kind != io::YamlNode::Kind::sequence)
      return problems.add(node, path, "expected a list, got " + io::describe(node));
    value.resize(node.items.size());
    for (std::size_t i = 0; i < node.items.size() && !problems.full(); ++i)
      read_member(node.items[i], info, Path{&path, {}, static_cast<int>(i)}, value[i], problems);
  } else if constexpr (PlainValue<V>) {
    read_value(node, info, path, value, problems);
  } else {
    read_mapping(mapping_of<V>(), node, path, &value, problems);
  }
}

template <class V>
void check_member(const V& value, const FieldInfo& info, const Path& path, Problems& problems) {
  if constexpr (is_optional<V>) {
    if (value) check_member(*value, info, path, problems);
  } else if constexpr (is_indirect<V>) {
    check_member(*value, info, path, problems);
  } else if constexpr (is_list<V>) {
    check_length(value.size(), info, path, problems);
    for (std::size_t i = 0; i < value.size() && !problems.full(); ++i)
      check_member(value[i], info, Path{&path, {}, static_cast<int>(i)}, problems);
  } else if constexpr (PlainValue<V>) {
    check_value(value, info, path, problems);
  } else {
    check_mapping(mapping_of<V>(), &value, path, problems);
  }
}

// What the member is called in messages and in the table, and what lies below it.
template <class V>
void describe_member(const V& initial, Key& key) {
  if constexpr (is_optional<V>) {
    describe_member(typename V::value_type{}, key);
    key.initial = key.info.unset.empty() ? "none" : key.info.unset;
  } else if constexpr (is_indirect<V>) {
    describe_member(*initial, key);
  } else if constexpr (is_list<V>) {
    describe_member(typename V::value_type{}, key);
    key.type = "a list";
    if (key.info.items > 0) key.type += " of " + std::to_string(key.info.items);
    key.initial = key.info.required ? "" : "empty";
    key.is_list = true;
  } else if constexpr (PlainValue<V>) {
    key.type = type_text(Of<V>{}, key.info);
    if (!key.info.required) key.initial = value_text(initial);
  } else {
    key.type = "a mapping";
    key.below = &mapping_of<V>;
  }
}

// Whether a function check(const T&, const Path&, Problems&) says how T's members must fit together.
template <class T>
concept HasRules = requires(const T& object, const Path& path, Problems& problems) {
  check(object, path, problems);
};

// Whether a function begin(const io::YamlNode&, T&) sets defaults before T's keys are read.
template <class T>
concept HasBeginning = requires(const io::YamlNode& node, T& object) {
  begin(node, object);
};

// `get` turns the untyped object into a reference to the member, const or not as the object is.
template <class V, class Get>
Key make_key(std::string_view name, const FieldInfo& info, const V& initial, Get get) {
  Key key;
  key.key = name;
  key.info = info;
  describe_member(initial, key);
  key.read = [get, info](const io::YamlNode& node, const Path& path, void* object, Problems& problems) {
    read_member(node, info, path, get(object), problems);
  };
  key.check = [get, info](const void* object, const Path& path, Problems& problems) {
    check_member(std::as_const(get(const_cast<void*>(object))), info, path, problems);
  };
  return key;
}

template <class T, class Struct, class Member>
void add(Mapping& mapping, const Field<Struct, Member>& field) {
  static const T initial{};
  const auto member = field.member;
  mapping.keys.push_back(make_key(field.key, field.info, initial.*member,
                                  [member](void* object) -> Member& { return static_cast<T*>(object)->*member; }));
}

// Adds the keys of alternative I of a variant: its own name, or the keys of its fields when it is flat.
template <std::size_t I, class Variant, class Get>
void add_alternative(Mapping& mapping, Get get) {
  using Alternative = std::variant_alternative_t<I, Variant>;
  static const Alternative initial{};
  constexpr About told = about(Of<Alternative>{});
  const auto chosen = [get](void* object) -> Alternative& { return *std::get_if<I>(&get(object)); };
  mapping.choices.push_back(told);
  const std::size_t first = mapping.keys.size();
  if constexpr (told.flat) {
    const auto add_one = [&](const auto& field) {
      const auto member = field.member;
      mapping.keys.push_back(make_key(
          field.key, field.info, initial.*member,
          [ chosen, member ](void* object) -> auto& { return chosen(object).*member; }));
    };
    std::apply([&](const auto&... field) { (add_one(field), ...); }, fields(Of<Alternative>{}));
    if constexpr (HasRules<Alternative>)
      mapping.rules.push_back([get](const void* object, const Path& path, Problems& problems) {
        const auto* held = std::get_if<I>(&get(const_cast<void*>(object)));
        if (held != nullptr) check(*held, path, problems);
      });
  } else {
    mapping.keys.push_back(make_key(told.name, {.required = true, .doc = told.doc}, initial, chosen));
  }
  for (std::size_t k = first; k < mapping.keys.size(); ++k) mapping.keys[k].choice = static_cast<int>(I);
}

template <class Variant, class Get>
void add_choices(Mapping& mapping, Get get) {
  [&]<std::size_t... I>(std::index_sequence<I...>) {
    (add_alternative<I, Variant>(mapping, get), ...);
    using Maker = void (*)(Variant&);
    static constexpr Maker makers[] = {[](Variant& variant) { variant.template emplace<I>(); }...};
    mapping.choose = [get](void* object, int choice) { makers[choice](get(object)); };
  }
  (std::make_index_sequence<std::variant_size_v<Variant>>{});
  mapping.chosen = [get](const void* object) { return static_cast<int>(get(const_cast<void*>(object)).index()); };
}

template <class T, class Struct, class Variant>
void add(Mapping& mapping, const Choice<Struct, Variant>& choice) {
  const auto member = choice.member;
  add_choices<Variant>(mapping, [member](void* object) -> Variant& { return static_cast<T*>(object)->*member; });
}

// Whether T's keys have a table of their own in the reference: they stand in many places, or within themselves.
template <class T>
concept HasSection = requires {
  section(Of<T>{});
};

template <class T>
Mapping build_mapping() {
  Mapping mapping;
  if constexpr (HasSection<T>) mapping.section = section(Of<T>{});
  if constexpr (is_variant<T>) {
    add_choices<T>(mapping, [](void* object) -> T& { return *static_cast<T*>(object); });
  } else {
    std::apply([&](const auto&... entry) { (add<T>(mapping, entry), ...); }, fields(Of<T>{}));
    if constexpr (HasBeginning<T>)
      mapping.begin = [](const io::YamlNode& node, void* object) { begin(node, *static_cast<T*>(object)); };
    if constexpr (HasRules<T>)
      mapping.rules.push_back([](const void* object, const Path& path, Problems& problems) {
        check(*static_cast<const T*>(object), path, problems);
      });
  }
  return mapping;
}

template <class T>
const Mapping& mapping_of() {
  static const Mapping mapping = build_mapping<T>();
  return mapping;
}

}  // namespace shabon::scene
