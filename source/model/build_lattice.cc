#include <auxfem/mesh/designed_array.h>
#include <auxfem/mesh/periodic_array.h>
#include <auxfem/mesh/position_function.h>
#include <auxfem/mesh/sets.h>
#include <auxfem/mesh/strut_crossings.h>
#include <auxfem/model/build_lattice.h>
#include <auxfem/model/plate_placement.h>
#include <auxfem/model/rigid_bodies.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/scene/graded_sections.h>
#include <auxfem/scene/infinite_lattice.h>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include <unistd.h>

namespace auxfem
{
  namespace
  {
    /** Number of unknowns from which the size is reported, about a second of
     * set-up. */
    constexpr double many_unknowns = 2e5;

    /** Peak memory (bytes): program and per unknown, from star lattices with
     * elements of order 3. */
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

    /** Counts of an array of @p n_cells cells, extrapolated from @p direction
     * on. Cells share parts with neighbours only, so counts are linear in the
     * number of cells along each direction. */
    LatticeCounts continued_counts(const UnitCell             &cell,
                                   std::array<unsigned int, 3> n_cells,
                                   const unsigned int          direction = 0)
    {
      if (direction == 3)
        return counts_of(cell, n_cells);
      const unsigned int n    = n_cells[direction];
      n_cells[direction]      = 1;
      const LatticeCounts one = continued_counts(cell, n_cells, direction + 1);
      // make_array() rejects repeating a cell without vector.
      if (n == 1 || !cell.repeats(direction))
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

    /** Text of a number: three digits, integers in full. */
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
                       " unknowns. Use fewer cells.");
    if (size.unknowns < many_unknowns)
      return "";
    constexpr double gigabyte = 1e9;
    return "Large lattice: " + counts + ". It needs about " +
      number(std::round(10 * size.memory / gigabyte) / 10) + " GB of the " +
      number(std::round(memory_of_machine() / gigabyte)) +
      " GB of memory of this machine" +
      (scene.discretization.tolerance ? ", more if the run refines elements"
                                      : "") +
      (size.memory > memory_of_machine()
         ? ", so it will probably fail. Use fewer cells, or several machines "
           "with mpirun."
         : ".");
  }

  namespace
  {
    std::string describe(const unsigned int number,
                         const Lattice     &lattice,
                         const unsigned int dimension)
    {
      const Strut         &strut = lattice.struts[number];
      dealii::Point<3>     middle;
      dealii::Tensor<1, 3> tangent;
      lattice.axis(strut, 0.5, middle, tangent);
      std::ostringstream text;
      text << "Strut " << number << " (joints " << strut.joints[0] << " and "
           << strut.joints[1] << ", middle at "
           << position_text(middle, dimension);
      for (const auto &[name, members] : lattice.strut_sets)
        if (name != "all" &&
            std::binary_search(members.begin(), members.end(), number))
          text << ", in the set \"" << name << "\"";
      text << ')';
      return text.str();
    }

    void check_sections(const Lattice &lattice, const unsigned int dimension)
    {
      const auto has_none = [](const Strut &strut) {
        return strut.section == invalid_index && !strut.is_rigid();
      };
      const auto n_missing =
        std::count_if(lattice.struts.begin(), lattice.struts.end(), has_none);
      if (n_missing == 0)
        return;
      const auto first =
        std::find_if(lattice.struts.begin(), lattice.struts.end(), has_none) -
        lattice.struts.begin();
      throw InputError(
        "Sections: " + describe(first, lattice, dimension) +
        (n_missing > 1 ? " and " + std::to_string(n_missing - 1) + " more have"
                       : " has") +
        " no section. Add a section whose struts include them (\"all\" means "
        "every strut), or make them Rigid parts.");
    }

    void add_plate(const PlateDefinition &plate,
                   const Scene           &scene,
                   Lattice               &lattice)
    {
      check_set_name(plate.name, plate.path, lattice);
      const dealii::Point<3> position =
        position_of_plate(plate, scene, lattice);
      lattice.joint_sets[plate.name] = {
        static_cast<unsigned int>(lattice.joints.size())};
      lattice.joints.push_back(position);
      ++lattice.n_plates;
    }

    /** Refuses rigid parts that go on in the next period: only their piece in
     * this one would be rigid. */
    void refuse_cut_rigid_parts(const Scene &scene, const Lattice &lattice)
    {
      for (const RigidPart &part : lattice.rigid_parts)
        for (const unsigned int joint : part.joints)
          if (lattice.is_image(joint))
            throw InputError(
              scene.rigid_parts[part.definition].path +
              ": the part reaches joint " + std::to_string(joint) +
              ", which belongs to the next period of the infinite lattice. "
              "Rigid parts must lie within the period: choose a cell that does "
              "not cut them.");
    }

    /** Adds a joint for each axis of the mean deformation of an infinite
     * lattice. */
    void add_axes(Lattice &lattice)
    {
      if (!lattice.periodicity)
        return;
      for (unsigned int d = 0; d < lattice.dimension; ++d)
        {
          lattice.joint_sets[name_of_axis(d)] = {
            static_cast<unsigned int>(lattice.joints.size())};
          lattice.joints.emplace_back(lattice.periodicity->length() *
                                      dealii::Point<3>::unit_vector(d));
        }
      lattice.n_axes = lattice.dimension;
    }

    /** @param add_imperfections adds imperfections to the designed lattice */
    template <class Disturb>
    Lattice build(const Scene &scene, const Disturb &add_imperfections)
    {
      Lattice lattice =
        make_designed_array(scene.lattice, scene.sets, scene.context);
      assign_sections(scene, lattice);
      add_imperfections(lattice);
      make_rigid_parts(scene, lattice);
      refuse_cut_rigid_parts(scene, lattice);
      check_sections(lattice, scene.context.dimension);
      if (!scene.lattice.struts_may_cross)
        refuse_crossing_struts(lattice);
      for (const PlateDefinition &plate : scene.plates)
        add_plate(plate, scene, lattice);
      add_axes(lattice);
      return lattice;
    }
  } // namespace

  Lattice build_lattice(const Scene                 &scene,
                        const GeometryOffsets *const offsets)
  {
    return build(scene, [&](Lattice &lattice) {
      if (!scene.imperfections.empty())
        disturb(offsets != nullptr ? *offsets : given_offsets(scene, lattice),
                lattice);
    });
  }

  Lattice designed_lattice(const Scene &scene)
  {
    return build(scene, [](const Lattice &) {});
  }

  namespace
  {
    void add_random(const ImperfectionDefinition &definition,
                    const Lattice                &lattice,
                    const SceneContext           &context,
                    GeometryOffsets              &offsets)
    {
      GeometryOffsets added(lattice);
      // Boost gives the same numbers with any standard library.
      boost::random::mt19937                     generator(definition.seed);
      boost::random::normal_distribution<double> distances(
        0.,
        definition.amplitude);
      for (const unsigned int joint : joints_of(definition, lattice, context))
        for (unsigned int c = 0; c < lattice.dimension; ++c)
          added.joints[joint][c] = distances(generator);
      for (unsigned int i = 0; i < lattice.struts.size(); ++i)
        added.middles[i] = added.mean_of_ends(lattice.struts[i]);
      offsets.add(1., added);
    }

    void add_expressions(const ImperfectionDefinition &definition,
                         const Lattice                &lattice,
                         const SceneContext           &context,
                         GeometryOffsets              &offsets)
    {
      for (unsigned int c = 0; c < lattice.dimension; ++c)
        {
          PositionFunction    displacement(definition.displacement[c],
                                        "expression",
                                        "",
                                        lattice,
                                        context,
                                        definition.path + "/Displacement " +
                                          "xyz"[c],
                                        PositionFunction::Random::allowed);
          std::vector<double> moved(lattice.joints.size());
          for (unsigned int i = 0; i < moved.size(); ++i)
            {
              moved[i] = displacement.value_at(lattice.joints[i], i);
              offsets.joints[i][c] += moved[i];
            }
          for (unsigned int i = 0; i < lattice.struts.size(); ++i)
            {
              if (displacement.is_random())
                {
                  // Random numbers belong to joints; struts keep their shape.
                  const auto &ends = lattice.struts[i].joints;
                  offsets.middles[i][c] +=
                    (moved[ends[0]] + moved[ends[1]]) / 2;
                  continue;
                }
              dealii::Point<3>     middle;
              dealii::Tensor<1, 3> tangent;
              lattice.axis(lattice.struts[i], 0.5, middle, tangent);
              offsets.middles[i][c] += displacement.value_at(middle);
            }
        }
    }
  } // namespace

  GeometryOffsets given_offsets(const Scene &scene, const Lattice &lattice)
  {
    using Type = ImperfectionDefinition::Type;
    GeometryOffsets offsets(lattice);
    for (const ImperfectionDefinition &definition : scene.imperfections)
      if (definition.type == Type::random)
        add_random(definition, lattice, scene.context, offsets);
      else if (definition.type == Type::expression)
        add_expressions(definition, lattice, scene.context, offsets);
    return offsets;
  }
} // namespace auxfem
