#ifndef auxfem_tests_verification_label_h
#define auxfem_tests_verification_label_h

#include <sstream>
#include <string>

namespace auxfem
{
  namespace testing_support
  {
    /** `name = number` for tables, with no more digits than needed to tell. */
    inline std::string label(const std::string &name, const double number)
    {
      std::ostringstream text;
      text << name << " = " << number;
      return text.str();
    }
  } // namespace testing_support
} // namespace auxfem

#endif
