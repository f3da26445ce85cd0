#include <auxfem/mesh/array_changes.h>
#include <auxfem/mesh/lattice_reduction.h>
#include <auxfem/mesh/merge_joints.h>
#include <auxfem/mesh/position_function.h>
#include <auxfem/mesh/sets.h>
#include <auxfem/parameters/errors.h>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_01.hpp>

#include <algorithm>

namespace auxfem
{
  namespace
  {
    const Text kept_region = {
      "Region",
      "all",
      "Condition in x, y, z and xmin, xmax, ... (m) on the middle of a cell; "
      "cells elsewhere are left out, e.g. x^2 + y^2 < 0.1^2. all: every cell."};
    const Text missing = {
      "Missing struts",
      "none",
      "Set of struts of the array that are missing, each with "
      "the Missing probability."};
    const Quantity            probability     = {"Missing probability",
                                                 "1",
                                                 "1",
                                                 Range::closed(0, 1),
                                                 "Probability that such a "
                                                                "strut is missing."};
    const Integer             missing_seed    = {"Missing seed",
                                                 1,
                                                 0,
                                                 2147483647,
                                                 "Seed of the random numbers."};
    const std::array<Text, 3> mapped_position = {
      {{"Map x",
        "x",
        "Expression in x, y, z and xmin, xmax, ... (m) for the coordinate x of "
        "each joint; joints that come to the same place are united."},
       {"Map y", "y", "The same for y."},
       {"Map z", "z", "The same for z; with Dimension = 3."}}};

    /** @param where path of the parameter, with its value */
    void refuse_empty(const Lattice &lattice, const std::string &where)
    {
      if (lattice.struts.empty())
        throw InputError(where +
                         ": no strut of the lattice remains. Leave more of "
                         "it.");
    }

    void remove_missing(const ArrayChanges &changes,
                        const SceneContext &context,
                        Lattice            &lattice)
    {
      // Boost gives the same numbers with any standard library.
      boost::random::mt19937            generator(changes.seed);
      boost::random::uniform_01<double> random;
      LatticeReduction                  reduction(lattice);
      unsigned int                      n = 0;
      for (const unsigned int strut :
           select_struts(lattice,
                         changes.missing_struts,
                         context,
                         context.path + "/" + missing.name))
        if (random(generator) < changes.missing_probability)
          {
            reduction.keep_strut[strut] = false;
            ++n;
          }
      const unsigned int all  = lattice.struts.size();
      const std::string  lost = reduction.apply();
      refuse_empty(lattice,
                   context.path + "/" + missing.name + " = " +
                     changes.missing_struts);
      lattice.notes.push_back(std::to_string(n) + " of " + std::to_string(all) +
                              " struts are missing." +
                              (lost.empty() ? "" : " " + lost));
    }

    void map_joints(const ArrayChanges &changes,
                    const SceneContext &context,
                    Lattice            &lattice)
    {
      std::vector<dealii::Point<3>> mapped = lattice.joints;
      for (unsigned int c = 0; c < lattice.dimension; ++c)
        {
          if (changes.map[c].empty())
            continue;
          PositionFunction coordinate(changes.map[c],
                                      "expression",
                                      "",
                                      lattice,
                                      context,
                                      context.path + "/" +
                                        mapped_position[c].name);
          for (unsigned int j = 0; j < mapped.size(); ++j)
            mapped[j][c] = coordinate.value_at(lattice.joints[j]);
        }
      double size = 0;
      for (unsigned int d = 0; d < 3; ++d)
        {
          const auto [low, high] = coordinate_range(mapped, d);
          size                   = std::max(size, high - low);
        }
      lattice.joints = mapped;
      LatticeReduction reduction(lattice);
      reduction.target = first_joints_within(1e-8 * size, mapped);
      reduction.apply();
      refuse_empty(lattice, context.path + "/Map");
    }
  } // namespace

  Parameters array_change_parameters()
  {
    return {kept_region,
            missing,
            probability,
            missing_seed,
            mapped_position[0],
            mapped_position[1],
            mapped_position[2]};
  }

  ArrayChanges read_array_changes(const ParameterValues &values)
  {
    ArrayChanges changes;
    if (values[kept_region] != kept_region.default_value)
      changes.region = values[kept_region];
    if (values[missing] != missing.default_value)
      changes.missing_struts = values[missing];
    else if (!values.is_default(probability))
      values.refuse(probability,
                    "no struts may be missing. Name them, e.g. set Missing "
                    "struts = all");
    changes.missing_probability = values[probability];
    changes.seed                = values[missing_seed];
    for (unsigned int c = 0; c < 3; ++c)
      if (!values.is_default(mapped_position[c]))
        changes.map[c] = values[mapped_position[c]];
    require_space(values, mapped_position[2]);
    return changes;
  }

  Lattice make_array_in_region(const UnitCell                    &cell,
                               const std::array<unsigned int, 3> &n_cells,
                               const std::string                 &region,
                               const SceneContext                &context)
  {
    if (region.empty())
      return make_array(cell, n_cells);
    // The condition may use the bounds of the whole array.
    const Lattice whole = make_array(cell, n_cells);
    Condition     condition(region,
                        whole,
                        context,
                        context.path + "/" + kept_region.name);
    unsigned int  n_kept  = 0;
    Lattice       lattice = make_array(cell, n_cells, [&](const auto &middle) {
      const bool is_kept = condition.holds_at(middle);
      n_kept += is_kept;
      return is_kept;
    });
    refuse_empty(lattice,
                 context.path + "/" + kept_region.name + " = " + region);
    lattice.notes.push_back("Lattice/Region leaves " + std::to_string(n_kept) +
                            " of " + std::to_string(lattice.n_cells) +
                            " cells.");
    return lattice;
  }

  void change_array(const ArrayChanges &changes,
                    const SceneContext &context,
                    Lattice            &lattice)
  {
    if (!changes.missing_struts.empty())
      remove_missing(changes, context, lattice);
    for (unsigned int c = 0; c < 3; ++c)
      if (!changes.map[c].empty())
        return map_joints(changes, context, lattice);
  }
} // namespace auxfem
