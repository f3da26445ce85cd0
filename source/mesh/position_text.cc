#include <auxfem/mesh/position_text.h>

#include <sstream>

namespace auxfem
{
  std::string position_text(const dealii::Point<3> &position,
                            const unsigned int      dimension)
  {
    std::ostringstream text;
    for (unsigned int d = 0; d < dimension; ++d)
      text << (d == 0 ? "(" : ", ") << position[d];
    text << ") m";
    return text.str();
  }
} // namespace auxfem
