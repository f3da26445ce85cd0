#include <auxfem/mesh/sets.h>
#include <auxfem/output/strut_stresses.h>
#include <auxfem/parameters/errors.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace auxfem
{
  bool StrutStresses::exist() const
  {
    return std::any_of(model.sections.begin(),
                       model.sections.end(),
                       [](const Section &section) {
                         return bool(section.make_stress_points);
                       });
  }

  const SectionStresses &StrutStresses::section_at(const unsigned int section,
                                                   const double part) const
  {
    const Section                        &whole = model.sections[section];
    const std::pair<unsigned int, double> key(section, whole.taper ? part : 0);
    const auto                            found = sections.find(key);
    if (found != sections.end())
      return found->second;
    // Graded lattices may have a section a strut, some kB each.
    constexpr std::size_t most_sections = 4096;
    if (sections.size() >= most_sections)
      sections.clear();
    return sections
      .emplace(key, SectionStresses(whole.at(part), model.lattice.dimension))
      .first->second;
  }

  PointStresses StrutStresses::at(const StrutPoint  &point,
                                  const unsigned int strut,
                                  const double       part) const
  {
    const unsigned int     section  = model.lattice.struts[strut].section;
    const SectionStresses &stresses = section_at(section, part);
    PointStresses          result;
    static_cast<Stresses &>(result) = stresses.at({{point.force[0],
                                                    point.force[1],
                                                    point.force[2],
                                                    point.moment[0],
                                                    point.moment[1],
                                                    point.moment[2]}});
    result.fibre_strain =
      stresses.fibre_strain(point.strain_forces,
                            model.sections[section].youngs_modulus);
    if (model.sections[section].yields())
      {
        // Stresses of yielding sections are not linear in their forces.
        result.bending   = std::numeric_limits<double>::quiet_NaN();
        result.fibre     = point.fibre_stress;
        result.von_mises = point.equivalent_stress;
      }
    return result;
  }

  namespace
  {
    /** Chosen elastic struts. */
    std::vector<unsigned int>
    chosen_struts(const StressProbeDefinition &definition,
                  const Scene                 &scene,
                  const Lattice               &lattice)
    {
      std::vector<unsigned int> struts = select_struts(lattice,
                                                       definition.struts,
                                                       scene.context,
                                                       definition.path);
      struts.erase(std::remove_if(struts.begin(),
                                  struts.end(),
                                  [&](const unsigned int strut) {
                                    return lattice.struts[strut].is_rigid();
                                  }),
                   struts.end());
      if (struts.empty())
        throw InputError(definition.path + ": all struts \"" +
                         definition.struts +
                         "\" are rigid and have no stresses");
      for (const unsigned int strut : struts)
        {
          const SectionDefinition &section =
            scene.sections[lattice.struts[strut].section];
          if (!section.section.make_stress_points)
            throw InputError(
              definition.path + ": the section \"" + section.name +
              "\" is given by its constants, so that its stresses are not "
              "known. Give its Shape, or choose other struts");
        }
      return struts;
    }
  } // namespace

  void StressProbe::check(const StressProbeDefinition &definition,
                          const Scene                 &scene,
                          const Lattice               &lattice)
  {
    chosen_struts(definition, scene, lattice);
  }

  StressProbe::StressProbe(const StressProbeDefinition &definition,
                           const Scene                 &scene,
                           const Equations             &equations)
    : definition(definition)
    , equations(equations)
    , stresses(equations.model())
    , is_chosen(equations.model().lattice.struts.size(), false)
  {
    for (const unsigned int strut :
         chosen_struts(definition, scene, equations.model().lattice))
      is_chosen[strut] = true;
  }

  std::vector<Column> StressProbe::columns() const
  {
    const std::string  &name   = definition.name;
    std::vector<Column> result = {
      {name + ".von_mises", "Pa", "largest von Mises stress of the struts"},
      {name + ".fibre_stress",
       "Pa",
       "largest axial and bending stress at that place, positive in tension"},
      {name + ".strut", "", "number of the strut with the largest stress"},
      {name + ".position", "1", "place along it, from 0 to 1"}};
    if (definition.strength)
      result.push_back(
        {name + ".use", "1", "largest von Mises stress over the strength"});
    return result;
  }

  namespace
  {
    /** A maximum of values at whole numbers. */
    struct SampledMaximum
    {
      double       value, place;
      unsigned int nearest; ///< the largest of the values
    };

    /** The largest of @p values; between them, if they are smooth, the vertex
     * of the parabola through it and its neighbours. */
    SampledMaximum maximum_of(const std::vector<double> &values,
                              const bool                 are_smooth)
    {
      const auto         at = std::max_element(values.begin(), values.end());
      const unsigned int i  = at - values.begin();
      SampledMaximum     found{*at, double(i), i};
      if (!are_smooth || i == 0 || i + 1 == values.size())
        return found;
      const double slope = at[1] - at[-1], bend = 2 * at[0] - at[1] - at[-1];
      if (bend > 0)
        {
          found.value += slope * slope / (8 * bend);
          found.place += slope / (2 * bend);
        }
      return found;
    }
  } // namespace

  void StressProbe::look_along(const StrutForces &struts,
                               const State       &state,
                               const unsigned int element,
                               Place             &largest) const
  {
    const LatticeModel  &model = equations.model();
    const StrutInterval &interval =
      model.numbering.elements()[element].interval;
    const unsigned int n    = 4 * struts.elements().order + 1;
    const auto         part = [&](const double place) {
      return interval.at(-1 + 2 * place / (n - 1));
    };
    const std::vector<StrutPoint> points = struts.sample(state, element, n);
    std::vector<double>           von_mises, fibre;
    for (unsigned int i = 0; i < n; ++i)
      {
        const PointStresses at =
          stresses.at(points[i], interval.strut, part(i));
        von_mises.push_back(at.von_mises);
        fibre.push_back(at.fibre);
      }
    // The fibres of struts that yield are known at Gauss points alone.
    const bool is_smooth =
      !model.sections[model.lattice.struts[interval.strut].section].yields();
    const SampledMaximum found = maximum_of(von_mises, is_smooth);
    if (found.value > largest.von_mises)
      largest = {found.value,
                 fibre[found.nearest],
                 part(found.place),
                 interval.strut};
  }

  std::vector<double> StressProbe::values(const State   &state,
                                          const MPI_Comm communicator) const
  {
    Place               largest;
    const DofNumbering &numbering = equations.model().numbering;
    for (const StrutGroup &group : equations.reporting().struts)
      for (unsigned int e = group.forces->elements().begin;
           e < group.forces->elements().end;
           ++e)
        if (numbering.elements()[e].is_owned &&
            is_chosen[numbering.elements()[e].interval.strut])
          look_along(*group.forces, state, e, largest);
    const double most =
      dealii::Utilities::MPI::max(largest.von_mises, communicator);
    // The first rank that has it tells the place.
    const int rank = dealii::Utilities::MPI::this_mpi_process(communicator);
    const int first =
      dealii::Utilities::MPI::min(largest.von_mises == most
                                    ? rank
                                    : std::numeric_limits<int>::max(),
                                  communicator);
    std::vector<double> place = {largest.fibre,
                                 double(largest.strut),
                                 largest.part};
    MPI_Bcast(place.data(), place.size(), MPI_DOUBLE, first, communicator);
    std::vector<double> result = {most, place[0], place[1], place[2]};
    if (definition.strength)
      result.push_back(most / *definition.strength);
    return result;
  }
} // namespace auxfem
