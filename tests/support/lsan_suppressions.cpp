// Leak checks are off in programs that draw, and in them only: while Mesa's threads end, LeakSanitizer's tracer
// sometimes crashes ("Tracer caught signal 11", about one run in a hundred), and fontconfig and D-Bus keep memory of
// their own. AddressSanitizer and UBSan stay on; everything that does not draw is checked for leaks by its own tests.
extern "C" int __lsan_is_turned_off();  // NOLINT: the sanitizer's own name

extern "C" int __lsan_is_turned_off() { return 1; }  // NOLINT
