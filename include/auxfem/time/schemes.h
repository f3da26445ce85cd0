#ifndef auxfem_time_schemes_h
#define auxfem_time_schemes_h

#include <auxfem/parameters/registry.h>
#include <auxfem/time/time_scheme.h>

namespace auxfem
{
  /**
   * One line of the table of time schemes. Parameters of all schemes stand side
   * by side in the subsection `Time`, those of the chosen one are used.
   */
  struct TimeSchemeEntry : RegistryEntry<TimeScheme>
  {
    /**
     * Models whose scenes may choose it. With Model::lattice it makes an
     * ImplicitScheme.
     */
    std::vector<Model> models;

    bool serves(Model model) const;
  };

  /** All schemes the program knows (time/register.cc), the default first. */
  const std::vector<TimeSchemeEntry> &time_scheme_registry();

  /** The line of the scheme @p name, which must be in the table. */
  const TimeSchemeEntry &time_scheme_entry(const std::string &name);

  /** The first scheme of the table with the default values of its parameters.
   */
  std::shared_ptr<const TimeScheme> default_time_scheme();

  /**
   * @name Table entries of the schemes, one per file
   * source/time/<name>.cc.
   */
  ///@{
  TimeSchemeEntry newmark_entry();
  TimeSchemeEntry hht_entry();
  TimeSchemeEntry generalized_alpha_entry();
  TimeSchemeEntry energy_momentum_entry();
  TimeSchemeEntry esdirk_entry();
  TimeSchemeEntry static_entry();
  ///@}

  /**
   * @name The same for schemes of the reduced cell alone, one per file
   * source/reduced_cell/<name>.cc.
   */
  ///@{
  TimeSchemeEntry central_difference_entry();
  TimeSchemeEntry as_printed_entry();
  TimeSchemeEntry arkode_entry();
  ///@}
} // namespace auxfem

#endif
