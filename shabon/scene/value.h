// The kinds of values a scene file holds: how each is read, checked, named and written.
#pragma once

#include <cstdint>
#include <string>

#include "shabon/base/field.h"
#include "shabon/io/yaml.h"
#include "shabon/math/vec.h"
#include "shabon/optics/interference.h"
#include "shabon/scene/color_desc.h"
#include "shabon/scene/path.h"
#include "shabon/scene/problems.h"
#include "shabon/scene/texture_desc.h"

namespace shabon::scene {

// Each returns whether the node was understood; if not, it has said what was expected and left `value` alone. Whole
// numbers are held against the field's range at once: out of it they may not fit their type.
bool read_value(const io::YamlNode& node, const FieldInfo& info, const Path& path, double& value, Problems& problems);
bool read_value(const io::YamlNode& node, const FieldInfo& info, const Path& path, int& value, Problems& problems);
bool read_value(const io::YamlNode& node, const FieldInfo& info, const Path& path, std::uint64_t& value,
                Problems& problems);
bool read_value(const io::YamlNode& node, const FieldInfo& info, const Path& path, std::string& value,
                Problems& problems);
bool read_value(const io::YamlNode& node, const FieldInfo& info, const Path& path, math::Vec3d& value,
                Problems& problems);
bool read_value(const io::YamlNode& node, const FieldInfo& info, const Path& path, optics::Interference& value,
                Problems& problems);
bool read_value(const io::YamlNode& node, const FieldInfo& info, const Path& path, bool& value, Problems& problems);
bool read_value(const io::YamlNode& node, const FieldInfo& info, const Path& path, Repeat& value, Problems& problems);
bool read_value(const io::YamlNode& node, const FieldInfo& info, const Path& path, ColorDesc& value,
                Problems& problems);

// Adds a problem where the value is not finite, leaves the field's range or is none of its names.
void check_value(double value, const FieldInfo& info, const Path& path, Problems& problems);
void check_value(int value, const FieldInfo& info, const Path& path, Problems& problems);
void check_value(std::uint64_t value, const FieldInfo& info, const Path& path, Problems& problems);
void check_value(const std::string& value, const FieldInfo& info, const Path& path, Problems& problems);
void check_value(const math::Vec3d& value, const FieldInfo& info, const Path& path, Problems& problems);
void check_value(optics::Interference value, const FieldInfo& info, const Path& path, Problems& problems);
void check_value(bool value, const FieldInfo& info, const Path& path, Problems& problems);
void check_value(const Repeat& value, const FieldInfo& info, const Path& path, Problems& problems);
void check_value(const ColorDesc& value, const FieldInfo& info, const Path& path, Problems& problems);

// "a number", "three numbers [x, y, z]", ...; the number itself when the field's range holds only one.
std::string type_text(Of<double>, const FieldInfo& info);
std::string type_text(Of<int>, const FieldInfo& info);
std::string type_text(Of<std::uint64_t>, const FieldInfo& info);
std::string type_text(Of<std::string>, const FieldInfo& info);
std::string type_text(Of<math::Vec3d>, const FieldInfo& info);
std::string type_text(Of<optics::Interference>, const FieldInfo& info);
std::string type_text(Of<bool>, const FieldInfo& info);
std::string type_text(Of<Repeat>, const FieldInfo& info);
std::string type_text(Of<ColorDesc>, const FieldInfo& info);

// As it would be written in a file.
std::string value_text(double value);
std::string value_text(int value);
std::string value_text(std::uint64_t value);
std::string value_text(const std::string& value);
std::string value_text(const math::Vec3d& value);
std::string value_text(optics::Interference value);
std::string value_text(bool value);
std::string value_text(const Repeat& value);
std::string value_text(const ColorDesc& value);

// "0..1000000 nm", "> 0, < 180 degrees", ">= 0"; empty when every number will do.
std::string range_text(const FieldInfo& info);

}  // namespace shabon::scene
