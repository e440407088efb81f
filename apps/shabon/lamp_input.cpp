#include "lamp_input.h"

#include "options.h"
#include "shabon/api/resolvers.h"
#include "streams.h"

namespace shabon::app {

void add_lamp(CLI::App& app, std::string& target) {
  const std::string option = "--illuminant";
  const auto read = [&target, option](const std::string& text) {
    target = text;
    if (color::illuminant_file(text)) return;
    const Result<color::Illuminant> lamp = color::illuminant_named(text);
    if (!lamp) usage_error(option, lamp.errors().front().message);
  };
  app.add_option_function<std::string>(
         option, read, "Lamp: " + color::illuminant_forms() + ", or file:PATH of one's own [" + target + "]")
      ->type_name("NAME");
}

Result<color::Illuminant> read_lamp(const std::string& text) {
  Result<color::Illuminant> lamp = api::illuminant_resolver()(text);
  if (lamp && !lamp->note.empty()) {
    Diagnostic warning;
    warning.severity = Severity::warning;
    warning.message = lamp->name + ": " + lamp->note;
    report({warning});
  }
  return lamp;
}

}  // namespace shabon::app
