// The leak checker of the sanitizer build calls this; other builds do not use it.
extern "C" const char* __lsan_default_suppressions();  // NOLINT: the name is the checker's
extern "C" const char* __lsan_default_suppressions() {
    // A broken PNG makes libpng leave OpenImageIO's reader by longjmp, past the destructor of a 31-byte error
    // text.
    return "leak:libOpenImageIO\n";
}
