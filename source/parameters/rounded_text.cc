#include <auxfem/parameters/rounded_text.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace auxfem
{
  std::string rounded_text(const double value, const unsigned int digits)
  {
    if (value == 0)
      return "0";
    char         text[64];
    const double size = std::abs(value);
    if (!(size >= 1e-4 && size < 1e6))
      {
        std::snprintf(text, sizeof(text), "%.*g", int(digits), value);
        return text;
      }
    const int after_point =
      std::max(0, int(digits) - 1 - int(std::floor(std::log10(size))));
    std::snprintf(text, sizeof(text), "%.*f", after_point, value);
    std::string result = text;
    if (after_point > 0)
      result.erase(result.find_last_not_of('0') + 1);
    if (result.back() == '.')
      result.pop_back();
    return result;
  }

  std::string percentage_text(const double part, const unsigned int digits)
  {
    return rounded_text(100 * part, digits) + " %";
  }
} // namespace auxfem
