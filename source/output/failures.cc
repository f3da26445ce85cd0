#include <auxfem/connectors/effects/connector_forces.h>
#include <auxfem/output/failures.h>

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

  std::vector<BrokenConnectors> broken_connectors(const Equations &equations,
                                                  const Solution  &solution)
  {
    std::vector<BrokenConnectors> result;
    for (const ConnectorGroup &group : equations.reporting().connectors)
      {
        if (!group.forces->may_break())
          continue;
        unsigned long mine = 0;
        for (unsigned int i = 0; i < group.forces->n_reported(); ++i)
          mine +=
            group.report(i, solution.state, solution.results).is_broken != 0;
        const unsigned long all = dealii::Utilities::MPI::sum(
          mine,
          equations.unknowns().layout.communicator());
        if (all > 0)
          result.push_back({group.forces->name(), all});
      }
    return result;
  }

  std::string failures_text(const std::vector<BrokenStrut>      &struts,
                            const std::vector<BrokenConnectors> &connectors)
  {
    std::ostringstream text;
    text.precision(4);
    if (!struts.empty())
      text << "Broken struts: " << struts.size() << ", first strut "
           << struts.front().strut << " at t = " << struts.front().time
           << " s; all in " << broken_struts_table << '\n';
    for (const auto &[group, number] : connectors)
      text << "Broken connectors: " << number << " of " << group
           << "; when, in the column " << group << ".broken\n";
    return text.str();
  }
} // namespace auxfem
