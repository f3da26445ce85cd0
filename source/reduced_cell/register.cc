#include <auxfem/parameters/errors.h>
#include <auxfem/reduced_cell/cell_scheme.h>

namespace auxfem
{
  const std::vector<CellSchemeEntry> &cell_scheme_registry()
  {
    static const std::vector<CellSchemeEntry> registry = {
      {"arkode",
       "explicit Runge-Kutta with error control (SUNDIALS ARKODE)",
       &make_arkode_scheme},
      {"newmark", "average acceleration by default", &make_alpha_cell_scheme},
      {"hht", "Hilber-Hughes-Taylor", &make_alpha_cell_scheme},
      {"generalized-alpha", "Chung-Hulbert", &make_alpha_cell_scheme},
      {"central difference",
       "central differences on two interlaced grids",
       &make_central_difference},
      {"as printed",
       "the paper's equations (18), (20) and scheme (24), (25) with their slips",
       &make_printed_scheme}};
    return registry;
  }

  const CellSchemeEntry &cell_scheme_entry(const Scene &scene)
  {
    for (const CellSchemeEntry &entry : cell_scheme_registry())
      if (entry.name == scene.time.scheme)
        return entry;
    throw InputError("Time/Scheme: the reduced cell has no scheme '" +
                     scene.time.scheme + "'.");
  }
} // namespace auxfem
