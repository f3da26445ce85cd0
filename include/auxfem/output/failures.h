#ifndef auxfem_output_broken_struts_h
#define auxfem_output_broken_struts_h

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

  /** A line for the end of a run; empty if no strut has broken. */
  std::string broken_struts_text(const std::vector<BrokenStrut> &broken);
} // namespace auxfem

#endif
