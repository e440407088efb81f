// Linked, in plain x86-64 code, with every test program that is compiled for wider registers: on a machine without
// them the program ends before any of its own code runs, and ctest reports it as skipped.
#include <unistd.h>
#include <cstdlib>

namespace {

constexpr int skipped = 77;  // SKIP_RETURN_CODE of these tests

bool machine_has_variant() {
  __builtin_cpu_init();
#if SHABON_VARIANT_v3
  return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi") &&
         __builtin_cpu_supports("bmi2");
#elif SHABON_VARIANT_v4
  return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
         __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512dq") &&
         __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("fma");
#else
#error "which variant?"
#endif
}

// Before the initialisers of the program itself, which are wide code too (101 is the first number not reserved).
__attribute__((constructor(101))) void skip_on_narrow_machines() {
  if (machine_has_variant()) return;
  constexpr char message[] = "skipped: this machine lacks the instructions the program is compiled for\n";
  if (write(STDOUT_FILENO, message, sizeof message - 1) < 0) std::abort();
  _exit(skipped);
}

}  // namespace
