/** What the address sanitizer asks the program for: leaks are not looked for,
 * as MPI and the libraries below it keep memory to the end; of the calls that
 * led to an allocation few are kept, which of 30 takes a sixth of the time (to
 * have them: ASAN_OPTIONS=malloc_context_size=30); of freed memory 32 MB are
 * kept from use, not 256, as getting pages for these takes the system longer.
 */
extern "C" const char *
__asan_default_options(); // NOLINT(bugprone-reserved-identifier)

extern "C" const char *
__asan_default_options() // NOLINT(bugprone-reserved-identifier)
{
  return "detect_leaks=0:malloc_context_size=4:quarantine_size_mb=32";
}
