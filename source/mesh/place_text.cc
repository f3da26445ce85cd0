#include <auxfem/mesh/place_text.h>

#include <sstream>

namespace auxfem
{
  std::string place_text(const dealii::Point<3> &place,
                         const unsigned int      dimension)
  {
    std::ostringstream text;
    for (unsigned int d = 0; d < dimension; ++d)
      text << (d == 0 ? "(" : ", ") << place[d];
    text << ") m";
    return text.str();
  }
} // namespace auxfem
