/** Defaults of the address sanitizer. It does not search for leaks, because MPI
 * and the libraries below it keep memory to the end. It keeps few calls of an
 * allocation, because 30 take a sixth of the time (they return with
 * ASAN_OPTIONS=malloc_context_size=30), and 32 MB of freed memory instead of
 * 256, because the system needs longer for more pages.
 */
extern "C" const char *
__asan_default_options(); // NOLINT(bugprone-reserved-identifier)

extern "C" const char *
__asan_default_options() // NOLINT(bugprone-reserved-identifier)
{
  return "detect_leaks=0:malloc_context_size=4:quarantine_size_mb=32";
}
