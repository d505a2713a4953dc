// Leaks that are not ours: what fontconfig keeps until the process ends. Linked only into tests that draw; every other leak
// still fails them.
extern "C" const char* __lsan_default_suppressions();  // NOLINT: the sanitizer's own name

extern "C" const char* __lsan_default_suppressions() { return "leak:libfontconfig\n"; }  // NOLINT
