// Leaks that are not ours: what fontconfig and D-Bus (through Qt) keep until the process ends. Linked only into tests that
// draw; every other leak still fails them.
extern "C" const char* __lsan_default_suppressions();  // NOLINT: the sanitizer's own name

extern "C" const char* __lsan_default_suppressions() {  // NOLINT
  return "leak:libfontconfig\n"
         "leak:libdbus-1\n";
}
