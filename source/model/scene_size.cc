#include <auxfem/model/scene_size.h>
#include <auxfem/parameters/errors.h>

#include <cmath>
#include <limits>
#include <sstream>

#include <unistd.h>

namespace auxfem
{
  namespace
  {
    /** Unknowns from which the size is told: set-up takes a second then. */
    constexpr double many_unknowns = 2e5;

    /** Memory at its peak (bytes): of the program itself, and over unknowns of
     * runs of 50 x 50 and of 8 x 8 x 8 star cells with elements of order 3. */
    constexpr double bytes_of_program           = 1.5e8,
                     bytes_per_unknown_in_plane = 1700,
                     bytes_per_unknown_in_space = 2400;

    struct LatticeCounts
    {
      double joints, struts;
    };

    LatticeCounts counts_of(const UnitCell                    &cell,
                            const std::array<unsigned int, 3> &n_cells)
    {
      if (n_cells == std::array<unsigned int, 3>{{1, 1, 1}})
        return {double(cell.joints.size()), double(cell.struts.size())};
      const Lattice lattice = make_array(cell, n_cells);
      return {double(lattice.joints.size()), double(lattice.struts.size())};
    }

    /** Counts of arrays of @p n_cells cells. As cells share joints and struts
     * with their neighbours alone, they are linear in the number of cells along
     * each of the directions, from @p direction on. */
    LatticeCounts continued_counts(const UnitCell             &cell,
                                   std::array<unsigned int, 3> n_cells,
                                   const unsigned int          direction = 0)
    {
      if (direction == 3)
        return counts_of(cell, n_cells);
      const unsigned int n    = n_cells[direction];
      n_cells[direction]      = 1;
      const LatticeCounts one = continued_counts(cell, n_cells, direction + 1);
      // make_array() refuses to repeat a cell without period.
      if (n == 1 || cell.period[direction] <= 0)
        return one;
      n_cells[direction]      = 2;
      const LatticeCounts two = continued_counts(cell, n_cells, direction + 1);
      return {one.joints + (n - 1.) * (two.joints - one.joints),
              one.struts + (n - 1.) * (two.struts - one.struts)};
    }

    /** Memory of this machine (bytes). */
    double memory_of_machine()
    {
      return double(sysconf(_SC_PHYS_PAGES)) * sysconf(_SC_PAGESIZE);
    }

    /** A number with three digits, or a whole one. */
    std::string number(const double value)
    {
      std::ostringstream text;
      text.precision(value < 1000 ? 3 : 15);
      text << value;
      return text.str();
    }
  } // namespace

  SceneSize size_of(const Scene &scene)
  {
    const LatticeCounts counts =
      continued_counts(scene.lattice.cell->build(), scene.lattice.n_cells);
    const StrutDivision division = scene.discretization.common_division();
    const double        n_nodes =
      counts.joints + counts.struts * division.n_inner_nodes();
    const bool is_planar = scene.context.dimension == 2;
    SceneSize  size;
    size.joints   = counts.joints;
    size.struts   = counts.struts;
    size.unknowns = n_nodes * (is_planar ? 3 : 6);
    size.memory   = bytes_of_program +
      size.unknowns *
        (is_planar ? bytes_per_unknown_in_plane : bytes_per_unknown_in_space);
    return size;
  }

  std::string size_text(const Scene &scene)
  {
    if (scene.context.model == Model::reduced_cell)
      return "";
    const SceneSize   size   = size_of(scene);
    const std::string counts = number(size.joints) + " joints, " +
      number(size.struts) + " struts and " + number(size.unknowns) +
      " unknowns";
    if (size.unknowns > std::numeric_limits<unsigned int>::max())
      throw InputError("Lattice: it would have " + counts +
                       ", more than can be numbered.\nAllowed are " +
                       number(std::numeric_limits<unsigned int>::max()) +
                       " unknowns. Take fewer cells.");
    if (size.unknowns < many_unknowns)
      return "";
    constexpr double gigabyte = 1e9;
    return "A large lattice is set up: " + counts + ". This takes about " +
      number(std::round(10 * size.memory / gigabyte) / 10) + " GB of the " +
      number(std::round(memory_of_machine() / gigabyte)) +
      " GB that this machine has" +
      (scene.discretization.tolerance ? ", more where the run refines elements"
                                      : "") +
      (size.memory > memory_of_machine()
         ? ", so it will probably fail. Take fewer cells, or several machines "
           "by mpirun."
         : ".");
  }
} // namespace auxfem
