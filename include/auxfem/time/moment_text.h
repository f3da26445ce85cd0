#ifndef auxfem_time_moment_text_h
#define auxfem_time_moment_text_h

#include <sstream>
#include <string>

namespace auxfem
{
  /** Where State::time is @p value, in words: `t = 0.1 s`, if @p on_path, one of
   * equilibria, `arc length 0.1 m`. */
  inline std::string
  moment_text(const bool on_path, const double value, const int precision = 6)
  {
    std::ostringstream text;
    text.precision(precision);
    text << (on_path ? "arc length " : "t = ") << value
         << (on_path ? " m" : " s");
    return text.str();
  }
} // namespace auxfem

#endif
