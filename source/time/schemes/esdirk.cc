#include <auxfem/time/schemes/runge_kutta.h>
#include <auxfem/time/schemes/time_scheme.h>

#include <arkode/arkode_butcher_dirk.h>

#include <memory>
#include <stdexcept>

namespace auxfem
{
  namespace
  {
    const Integer esdirk_order = {
      "Order of esdirk",
      4,
      3,
      5,
      "Order of Scheme = esdirk; a step has 4, 5 or 6 stages, each as costly as "
      "a step of newmark."};

    /** Name of the SUNDIALS table of @p order. */
    const char *name_of_tableau(const unsigned int order)
    {
      switch (order)
        {
          case 3:
            return "ARKODE_ESDIRK325L2SA_5_2_3";
          case 4:
            return "ARKODE_ARK436L2SA_DIRK_6_3_4";
          default:
            return "ARKODE_ESDIRK547L2SA2_7_4_5";
        }
    }

    std::unique_ptr<TimeScheme> make_esdirk(ParameterValues &values)
    {
      return std::make_unique<RungeKutta>("esdirk",
                                          esdirk_tableau(values[esdirk_order]));
    }
  } // namespace

  ButcherTableau esdirk_tableau(const unsigned int order)
  {
    const std::unique_ptr<ARKodeButcherTableMem, void (*)(ARKodeButcherTable)>
      table(ARKodeButcherTable_LoadDIRKByName(name_of_tableau(order)),
            ARKodeButcherTable_Free);
    if (!table)
      throw std::runtime_error("SUNDIALS has no Butcher table " +
                               std::string(name_of_tableau(order)) + '.');
    const unsigned int n = table->stages;
    ButcherTableau     tableau;
    tableau.times.assign(table->c, table->c + n);
    tableau.weights.assign(table->b, table->b + n);
    for (unsigned int i = 0; i < n; ++i)
      {
        tableau.factors.emplace_back(table->A[i], table->A[i] + i + 1);
        tableau.embedded_difference.push_back(table->b[i] - table->d[i]);
      }
    tableau.diagonal = table->A[n - 1][n - 1];
    tableau.order    = order;
    return tableau;
  }

  TimeSchemeEntry esdirk_entry()
  {
    return {{"esdirk",
             "implicit Runge-Kutta of order 3, 4 or 5, for small errors",
             {esdirk_order},
             make_esdirk},
            {Model::lattice}};
  }
} // namespace auxfem
