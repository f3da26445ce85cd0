#include <auxfem/output/broken_struts.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <sstream>
#include <tuple>
#include <utility>

namespace auxfem
{
  std::vector<BrokenStrut> broken_struts(const Equations &equations,
                                         const State     &state)
  {
    std::vector<BrokenStrut> mine;
    for (const StrutGroup &group : equations.reporting().struts)
      group.forces->add_broken_struts(state, mine);
    std::vector<std::pair<unsigned int, double>> pairs;
    for (const BrokenStrut &broken : mine)
      pairs.emplace_back(broken.strut, broken.time);
    std::vector<BrokenStrut> all;
    for (const auto &rank_pairs : dealii::Utilities::MPI::all_gather(
           equations.unknowns().layout.communicator(),
           pairs))
      for (const auto &[strut, time] : rank_pairs)
        all.push_back({strut, time});
    std::sort(all.begin(),
              all.end(),
              [](const BrokenStrut &one, const BrokenStrut &other) {
                return std::tie(one.time, one.strut) <
                  std::tie(other.time, other.strut);
              });
    return all;
  }

  std::string broken_struts_csv(const Lattice                  &lattice,
                                const std::vector<BrokenStrut> &broken)
  {
    std::ostringstream text;
    text.precision(15);
    text << "strut,time,x,y,z,cell\n";
    for (const auto &[number, time] : broken)
      {
        const Strut         &strut = lattice.struts[number];
        dealii::Point<3>     middle;
        dealii::Tensor<1, 3> tangent;
        lattice.axis(strut, 0.5, middle, tangent);
        text << number << ',' << time << ',' << middle[0] << ',' << middle[1]
             << ',' << middle[2] << ',' << strut.cell << '\n';
      }
    return text.str();
  }

  std::string broken_struts_text(const std::vector<BrokenStrut> &broken)
  {
    if (broken.empty())
      return "";
    std::ostringstream text;
    text.precision(4);
    text << "Broken struts: " << broken.size() << ", first strut "
         << broken.front().strut << " at t = " << broken.front().time
         << " s; all in " << broken_struts_table << '\n';
    return text.str();
  }
} // namespace auxfem
