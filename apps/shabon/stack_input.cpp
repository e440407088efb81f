#include "stack_input.h"

#include "options.h"
#include "shabon/api/resolvers.h"
#include "shabon/desk/film_spectrum.h"
#include "shabon/optics/reference/stack.h"
#include "shabon/optics/stack_expression.h"

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

}  // namespace shabon::app
