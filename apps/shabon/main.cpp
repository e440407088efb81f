// shabon: the command line. Every command is a straight line from a text to a result; the longest is that of render:
//   text -> SceneDesc -> compile -> Scene -> render -> Sensor -> develop -> picture -> file       render.cpp
//   text -> Stack -> powers at each wavelength -> table                                            spectrum.cpp
//   text -> Stack -> reflectance -> XYZ -> sRGB                                                    color.cpp
#include <exception>
#include <new>

#include "command.h"
#include "streams.h"

int main(int argc, char** argv) {
  using namespace shabon;
  app::guard_standard_streams();
  try {
    const app::Action action = app::chosen_action({argv + (argc > 0 ? 1 : 0), argv + argc});
    return action();
  } catch (const std::bad_alloc&) {
    return app::report(fail(Failure::internal, "not enough memory"));
  } catch (const std::exception& error) {
    return app::report(fail(Failure::internal, error.what()));
  }
}
