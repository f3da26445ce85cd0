#include <auxfem/mesh/strut_geometry.h>
#include <auxfem/parameters/numerical_limits.h>
#include <auxfem/state/step_report.h>
#include <auxfem/struts/effects/struts.h>
#include <auxfem/time/watch.h>

#include <deal.II/base/mpi.h>
#include <deal.II/numerics/rtree.h>

#include <boost/iterator/function_output_iterator.hpp>
#include <boost/serialization/utility.hpp>
#include <boost/serialization/vector.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <sstream>

namespace auxfem
{
  namespace
  {
    using Points = std::vector<dealii::Point<3>>;
    using Pair   = std::pair<unsigned int, unsigned int>;

    /** A strut and its axis as a polyline (m). */
    using Axis = std::pair<unsigned int, Points>;

    /** Pairs of struts that touch or have passed each other. */
    struct NearPairs
    {
      std::set<Pair> touching, crossing;
    };

    /** Criterion for struts that touch or have passed each other. */
    class CrossingRule
    {
    public:
      CrossingRule(const Lattice &lattice, const std::vector<Section> &sections)
        : lattice(lattice)
        , sections(sections)
      {}

      /** Bounding box with the thickness; boxes of touching struts
       * intersect. */
      dealii::BoundingBox<3> box(const Axis &axis) const
      {
        dealii::BoundingBox<3> box(axis.second);
        box.extend(half_thickness(axis.first));
        return box;
      }

      /** Motion (m) after which a new search is due. Struts that pass each
       * other overlap for two thicknesses of motion; in space the overlap is
       * shorter. */
      double motion_between_searches(const double mean_strut_length) const
      {
        const double per_half_thickness = lattice.dimension == 2 ? 2 : 1;
        double       motion             = mean_strut_length / 10;
        for (unsigned int s = 0; s < lattice.struts.size(); ++s)
          if (!lattice.struts[s].is_rigid() && half_thickness(s) > 0)
            motion = std::min(motion, per_half_thickness * half_thickness(s));
        return motion;
      }

      bool touch(const Axis &one, const Axis &other) const
      {
        return are_nearer(one, other, 1);
      }

      bool cross(const Axis &one, const Axis &other) const
      {
        return lattice.dimension == 2
          ? cross_in_plane(one.second, other.second, one.first == other.first)
          // Half of the largest possible overlap.
          : are_nearer(one, other, 0.5);
      }

    private:
      /** Half thickness (m): in the plane the one in it, in space the smaller
       * one. */
      double half_thickness(const unsigned int strut) const
      {
        return sections[lattice.struts[strut].section].contact_half_thickness(
          lattice.dimension);
      }

      /** Whether two struts share a joint or are the same. */
      bool meet(const unsigned int one, const unsigned int other) const
      {
        for (const unsigned int i : lattice.struts[one].joints)
          for (const unsigned int j : lattice.struts[other].joints)
            if (i == j)
              return true;
        return one == other;
      }

      /** Whether polylines cross; their ends may touch, as at a joint. */
      static bool
      cross_in_plane(const Points &one, const Points &other, const bool is_same)
      {
        const auto is_end = [](const double      fraction,
                               const std::size_t segment,
                               const std::size_t n_points) {
          return (segment == 0 && fraction < position_tolerance) ||
            (segment + 2 == n_points && fraction > 1 - position_tolerance);
        };
        for (std::size_t i = 0; i + 1 < one.size(); ++i)
          // Consecutive segments of one strut always meet.
          for (std::size_t j = is_same ? i + 2 : 0; j + 1 < other.size(); ++j)
            if (const auto at =
                  intersection({one[i], one[i + 1]}, {other[j], other[j + 1]}))
              if (!is_end((*at)[0], i, one.size()) &&
                  !is_end((*at)[1], j, other.size()))
                return true;
        return false;
      }

      /** Whether two unconnected struts are closer than @p part of half the sum
       * of their thicknesses. */
      bool
      are_nearer(const Axis &one, const Axis &other, const double part) const
      {
        if (meet(one.first, other.first))
          return false;
        const double least =
          part * (half_thickness(one.first) + half_thickness(other.first));
        const Points &a = one.second, &b = other.second;
        for (std::size_t i = 0; i + 1 < a.size(); ++i)
          for (std::size_t j = 0; j + 1 < b.size(); ++j)
            if (distance({a[i], a[i + 1]}, {b[j], b[j + 1]}) < least)
              return true;
        return false;
      }

      const Lattice              &lattice;
      const std::vector<Section> &sections;
    };

    /** Detects pairs of struts that touch or have passed each other, by an
     * R-tree of their boxes. */
    class CrossingWatch : public Watch
    {
    public:
      explicit CrossingWatch(const WatchContext &run)
        : Watch(SamplingRate::single_steps)
        , equations(run.equations)
        , model(run.equations.model())
        , rule(model.lattice, model.sections)
        , motion_between_searches(
            rule.motion_between_searches(model.mean_strut_length))
        , end_time(run.equations.layout().path
                     ? std::numeric_limits<double>::infinity()
                     : run.plan.time.end_time)
        , touched(run.statistics.occurrences("struts that touch"))
        , crossed(run.statistics.occurrences("struts that cross"))
      {}

      void step(const Evaluation &step,
                const EvaluationResults & /*results*/,
                TangentSolver & /*solver*/) override
      {
        if (motion_since_search(step.to.displacement) <=
              motion_between_searches &&
            step.to.time < end_time)
          return;
        searched              = step.to.displacement;
        const NearPairs found = pairs_at(searched);
        if (found.touching.empty() && found.crossing.empty())
          return;
        if (!at_rest)
          at_rest = pairs_at(Vector(searched.size(), 0.));
        add_new(found.touching, at_rest->touching, step.to.time, touched);
        add_new(found.crossing, at_rest->crossing, step.to.time, crossed);
      }

      void forget_steps() override
      {
        searched.clear();
      }

      std::vector<Finding> findings() const override
      {
        const auto touch = touched.first(), crossing = crossed.first();
        if (!touch && !crossing)
          return {};
        const bool touch_comes_first =
          touch && (!crossing || touch->time < crossing->time);
        std::ostringstream text;
        if (touch_comes_first)
          text << "Struts " << touch->number << " and " << touch->group
               << " touch" << time_text(*touch);
        if (crossing)
          {
            text << (touch_comes_first ? "; s" : "S");
            if (crossing->number == crossing->group)
              text << "trut " << crossing->number << " crosses itself";
            else
              text << "truts " << crossing->number << " and " << crossing->group
                   << " have passed into each other";
            text << time_text(*crossing);
          }
        text << ": contact is disabled. Later results hold only if struts can "
                "pass each other; otherwise "
             << advice();
        const LocatedEvent &first = touch_comes_first ? *touch : *crossing;
        return {{Verdict::doubtful,
                 text.str(),
                 first.time,
                 "strut " + std::to_string(first.number)}};
      }

    private:
      std::string time_text(const LocatedEvent &first) const
      {
        return " at about " +
          moment_text(equations.layout().path, first.time, 4);
      }

      /** Advice for touching struts. */
      const char *advice() const
      {
        if (equations.layout().path)
          return "apply the load in steps with Analysis = simulation and "
                 "Scheme = static.";
        return model.plan.simulated.large_rotation
          ? "set Effects/Contact = auto."
          : "set Effects/Large rotation and Effects/Contact to auto.";
      }

      /** Largest motion of a joint since the last search (m); infinite without
       * one. Neighbouring joints move alike, so it also bounds relative
       * motions. Collective. */
      double motion_since_search(const Vector &displacement) const
      {
        // Ranks may differ, since only some gain ghosts.
        const bool is_known = searched.size() == displacement.size();
        if (equations.unknowns().layout.largest(is_known ? 0 : 1) > 0)
          return std::numeric_limits<double>::infinity();
        Vector motion = displacement;
        add_multiple(-1., searched, motion);
        return largest_motion(model, motion).first;
      }

      /** Adds the first pair of @p found that is not in @p before. */
      static void add_new(const std::set<Pair> &found,
                          const std::set<Pair> &before,
                          const double          time,
                          EventExtremes        &pairs)
      {
        for (const auto &pair : found)
          if (before.count(pair) == 0)
            return pairs.add({1., time, pair.first, pair.second});
      }

      /** Axes of the elastic struts of all ranks. Collective. */
      std::vector<Axis> axes_at(const Vector &displacement) const
      {
        std::vector<Axis> mine;
        for (const StrutGroup &group : equations.reporting().struts)
          add_axes(*group.forces, displacement, mine);
        const UnknownLayout &layout = model.numbering.layout();
        if (layout.n_ranks() == 1)
          return mine;
        std::vector<Axis> all;
        for (const auto &axes :
             dealii::Utilities::MPI::all_gather(layout.communicator(), mine))
          all.insert(all.end(), axes.begin(), axes.end());
        return all;
      }

      void add_axes(const StrutForces &struts,
                    const Vector      &displacement,
                    std::vector<Axis> &axes) const
      {
        for (unsigned int e = struts.elements().begin;
             e < struts.elements().end;
             ++e)
          {
            const DofNumbering::Element &element =
              model.numbering.elements()[e];
            if (!element.is_owned)
              continue;
            const Points points =
              struts.axis(displacement, e, element.order + 1);
            const unsigned int strut = element.interval.strut;
            if (axes.empty() || axes.back().first != strut)
              axes.emplace_back(strut, points);
            else
              axes.back().second.insert(axes.back().second.end(),
                                        points.begin() + 1,
                                        points.end());
          }
      }

      /** Touching and crossing pairs, equal on all ranks. Collective. */
      NearPairs pairs_at(const Vector &displacement) const
      {
        const std::vector<Axis>             axes = axes_at(displacement);
        std::vector<dealii::BoundingBox<3>> boxes;
        for (const Axis &axis : axes)
          boxes.push_back(rule.box(axis));
        const auto tree = dealii::pack_rtree_of_indices(boxes);
        NearPairs  pairs;
        for (std::size_t i = 0; i < axes.size(); ++i)
          {
            const Axis &one   = axes[i];
            const auto  check = [&](const std::size_t j) {
              const Axis &other = axes[j];
              if (one.first > other.first)
                return;
              if (rule.touch(one, other))
                pairs.touching.emplace(one.first, other.first);
              if (rule.cross(one, other))
                pairs.crossing.emplace(one.first, other.first);
            };
            tree.query(boost::geometry::index::intersects(boxes[i]),
                       boost::make_function_output_iterator(check));
          }
        return pairs;
      }

      const Equations    &equations;
      const LatticeModel &model;
      const CrossingRule  rule;
      const double        motion_between_searches; ///< m
      const double        end_time;                ///< s
      Vector
        searched; ///< displacements at the last search (m); empty without one
      /** Pairs at rest; searched when first needed. */
      std::optional<NearPairs> at_rest;
      /** Number and group are the two struts. */
      EventExtremes &touched, &crossed;
    };
  } // namespace

  std::unique_ptr<Watch> make_crossing_watch(const WatchContext &run)
  {
    return std::make_unique<CrossingWatch>(run);
  }
} // namespace auxfem
