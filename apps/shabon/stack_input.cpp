#include "stack_input.h"

#include <utility>

#include "options.h"
#include "shabon/api/resolvers.h"
#include "shabon/desk/film_spectrum.h"
#include "shabon/optics/reference/stack.h"
#include "shabon/optics/stack_expression.h"
#include "streams.h"

namespace shabon::app {

void add_stack_input(CLI::App& app, StackInput& input) {
  app.add_option("STACK", input.expression, "Stack expression, such as 'air | water 300nm | air'")
      ->type_name("")
      ->required();
  add_choice(app, "--interference", input.interference_index, optics::interference_models, "Model of interference");
  app.add_flag("--reverse", input.reversed, "Light from the other side: the last medium is the first");
}

Result<optics::Stack> read_stack(const StackInput& input) {
  Result<optics::Stack> stack = optics::parse_stack(input.expression, api::medium_resolver());
  if (!stack) return stack;
  const Status computable = desk::check_computable(*stack, input.interference());
  if (!computable) return computable.errors();
  return input.reversed ? optics::reversed(*stack) : *stack;
}

Diagnostics power_notes(const optics::Stack& stack, bool transmitted) {
  Diagnostics notes;
  const auto note = [&](std::string message) { notes.push_back(warning_of(std::move(message))); };
  if (!stack.incidence.is_clear())
    note(printable(stack.incidence.name(), 40) +
         " absorbs, and light comes through it: incident and reflected light exchange energy there, so R, T and A are "
         "not shares that add up (docs/physics.md, Powers)");
  if (transmitted && !stack.exit.is_clear())
    note(printable(stack.exit.name(), 40) +
         " absorbs: transmitted is the light that enters it at the last interface, none of which comes out of it");
  return notes;
}

}  // namespace shabon::app
