#ifndef auxfem_output_failures_h
#define auxfem_output_failures_h

#include <auxfem/equations/equations.h>
#include <auxfem/struts/effects/struts.h>

#include <string>
#include <vector>

namespace auxfem
{
  /** Name of the table of broken struts in the output folder. */
  inline const std::string broken_struts_table = "failures.csv";

  /** All struts that have broken until @p state, by time. Collective. */
  std::vector<BrokenStrut> broken_struts(const Equations &equations,
                                         const State     &state);

  /** Rows `strut,time,x,y,z,cell`, with the middle of the strut at rest. */
  std::string broken_struts_csv(const Lattice                  &lattice,
                                const std::vector<BrokenStrut> &broken);

  /** Number of broken connectors of a group. */
  struct BrokenConnectors
  {
    std::string   group;
    unsigned long number;
  };

  /** Groups of connectors of which some have broken. Collective. */
  std::vector<BrokenConnectors> broken_connectors(const Equations &equations,
                                                  const Solution  &solution);

  /** Lines for the end of a run; empty if nothing has broken. */
  std::string failures_text(const std::vector<BrokenStrut>      &struts,
                            const std::vector<BrokenConnectors> &connectors);
} // namespace auxfem

#endif
