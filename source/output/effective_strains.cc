#include <auxfem/mesh/sets.h>
#include <auxfem/output/effective_strains.h>
#include <auxfem/parameters/errors.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace auxfem
{
  namespace
  {
    using Joints = std::vector<unsigned int>;

    /** Joint sets at the lower and upper end of each axis. */
    const char *const sides[3][2] = {{"left", "right"},
                                     {"bottom", "top"},
                                     {"back", "front"}};

    struct Span
    {
      unsigned int  axis;
      const Joints *low, *high;
      double        length; ///< between their means at rest (m)
    };

    double mean_position(const Lattice     &lattice,
                         const Joints      &joints,
                         const unsigned int axis)
    {
      double sum = 0;
      for (const unsigned int joint : joints)
        sum += lattice.joints[joint][axis];
      return sum / joints.size();
    }

    std::optional<Span> span_along(const unsigned int axis,
                                   const Lattice     &lattice)
    {
      const auto low  = lattice.joint_sets.find(sides[axis][0]),
                 high = lattice.joint_sets.find(sides[axis][1]);
      if (low == lattice.joint_sets.end() || high == lattice.joint_sets.end() ||
          low->second.empty() || high->second.empty())
        return {};
      const double begin  = mean_position(lattice, low->second, axis),
                   length = mean_position(lattice, high->second, axis) - begin;
      // Means of equal positions differ by round-off only.
      if (length <= 1e-10 * (std::abs(begin) + std::abs(begin + length)))
        return {};
      return Span{axis, &low->second, &high->second, length};
    }

    std::vector<Span> spans_of(const Lattice &lattice)
    {
      std::vector<Span> spans;
      for (unsigned int axis = 0; axis < lattice.dimension; ++axis)
        if (const std::optional<Span> span = span_along(axis, lattice))
          spans.push_back(*span);
      if (spans.empty())
        throw InputError(
          "Output/Effective strains = true: the lattice has no two opposite "
          "sides. It needs two distant joint sets: left and right, bottom and "
          "top, or in space back and front. Define them in Sets, or set "
          "Effective strains = false.");
      return spans;
    }
  } // namespace

  EffectiveStrains::EffectiveStrains(const LatticeModel &model)
  {
    const DofNumbering &numbering = model.numbering;
    for (const Span &span : spans_of(model.lattice))
      {
        std::vector<Term> axis_terms;
        const auto        add = [&](const Joints &joints, const double sign) {
          for (const unsigned int joint : joints)
            {
              const int unknown = numbering.joint_unknown(joint, span.axis);
              if (numbering.layout().is_owned(unknown))
                axis_terms.push_back(
                  {unknown, sign / (joints.size() * span.length)});
            }
        };
        add(*span.low, -1);
        add(*span.high, 1);
        strain_axes.push_back(span.axis);
        terms.push_back(std::move(axis_terms));
      }
  }

  void EffectiveStrains::check(const Lattice &lattice)
  {
    spans_of(lattice);
  }

  std::vector<Column> EffectiveStrains::columns() const
  {
    std::vector<Column> result;
    for (const unsigned int axis : strain_axes)
      result.push_back(
        {"strain." + axis_name(axis),
         "1",
         std::string("effective strain: mean displacement of the set ") +
           sides[axis][1] + " minus that of " + sides[axis][0] +
           " over their mean distance at rest"});
    return result;
  }

  std::vector<double> EffectiveStrains::values(const State &state) const
  {
    std::vector<double> result;
    for (const std::vector<Term> &axis_terms : terms)
      {
        double strain = 0;
        for (const Term &term : axis_terms)
          strain += term.factor * state.displacement[term.unknown];
        result.push_back(strain);
      }
    return result;
  }

  namespace
  {
    /**
     * Collects axes along which loads or motions act on the sides of a lattice.
     */
    class LoadedAxes
    {
    public:
      LoadedAxes(const Scene &scene, const Lattice &lattice)
        : scene(scene)
        , lattice(lattice)
        , spans(spans_of(lattice))
      {}

      /** @param acts whether @p definition acts along each axis. */
      template <class Definition>
      void add(const Definition &definition, const std::array<bool, 3> &acts)
      {
        const Joints joints = joints_of(definition, lattice, scene.context);
        for (const Span &span : spans)
          if (acts[span.axis] && is_on_one_side(joints, span))
            axes.insert(span.axis);
      }

      void add(const std::array<bool, 3> &acts)
      {
        for (const Span &span : spans)
          if (acts[span.axis])
            axes.insert(span.axis);
      }

      unsigned int single_axis_or(const unsigned int otherwise) const
      {
        return axes.size() == 1 ? *axes.begin() : otherwise;
      }

    private:
      /**
       * Whether all joints are on one of the two sides; joints on both move in
       * shear. Joints of plates count on either side.
       */
      bool is_on_one_side(const Joints &joints, const Span &span) const
      {
        const auto are_in = [&](const Joints &side) {
          return std::all_of(joints.begin(),
                             joints.end(),
                             [&](const unsigned int joint) {
                               return joint >= lattice.n_structural_joints() ||
                                 std::find(side.begin(), side.end(), joint) !=
                                 side.end();
                             });
        };
        return are_in(*span.low) || are_in(*span.high);
      }

      const Scene            &scene;
      const Lattice          &lattice;
      const std::vector<Span> spans;
      std::set<unsigned int>  axes;
    };

    template <class Components>
    std::array<bool, 3> acting(const Components &components)
    {
      return {{!components[0].is_zero(),
               !components[1].is_zero(),
               !components[2].is_zero()}};
    }

    template <class Vector>
    std::array<bool, 3> nonzero(const Vector &vector)
    {
      return {{vector[0] != 0, vector[1] != 0, vector[2] != 0}};
    }
  } // namespace

  unsigned int loaded_axis(const RunPlan &plan, const Lattice &lattice)
  {
    LoadedAxes axes(plan.scene, lattice);
    for (const SupportDefinition &support : plan.scene.supports)
      axes.add(support, acting(support.motion));
    for (const JointLoadDefinition &load : plan.joint_loads())
      axes.add(load, acting(load.components));
    for (const InitialVelocityDefinition &initial : plan.initial_velocities())
      axes.add(initial, nonzero(initial.velocity));
    for (const LineLoadDefinition &load : plan.scene.line_loads)
      axes.add(acting(load.components));
    axes.add(acting(plan.scene.gravity.acceleration));
    axes.add(acting(plan.scene.base_motion.acceleration));
    return axes.single_axis_or(1);
  }

  void LargestStrain::add(const double                     time,
                          const std::vector<unsigned int> &axes,
                          const double                    *values)
  {
    std::array<std::optional<double>, 3> now;
    for (unsigned int i = 0; i < axes.size(); ++i)
      now[axes[i]] = values[i];
    if (!now[loaded] ||
        std::abs(*now[loaded]) <= std::abs(strains[loaded].value_or(0)))
      return;
    strains         = now;
    time_of_largest = time;
  }

  void LargestStrain::serialize(CheckpointArchive &archive)
  {
    archive.values("output: largest effective strain",
                   time_of_largest,
                   strains[0],
                   strains[1],
                   strains[2]);
  }

  std::optional<double>
  LargestStrain::poissons_ratio(const unsigned int axis) const
  {
    if (axis == loaded || !strains[loaded] || !strains[axis])
      return {};
    return -*strains[axis] / *strains[loaded];
  }

  std::string axis_name(const unsigned int axis)
  {
    return {"xyz"[axis]};
  }
} // namespace auxfem
