/** What the address sanitizer asks the program for: leaks are not looked for,
 * as MPI and the libraries below it keep memory to the end. */
extern "C" const char *
__asan_default_options(); // NOLINT(bugprone-reserved-identifier)

extern "C" const char *
__asan_default_options() // NOLINT(bugprone-reserved-identifier)
{
  return "detect_leaks=0";
}
