#include <auxfem/algebra/shared_work.h>
#include <auxfem/analysis/relative_motion.h>
#include <auxfem/analysis/spaced_looks.h>
#include <auxfem/analysis/watch.h>
#include <auxfem/mesh/segment.h>
#include <auxfem/time/moment_text.h>

#include <deal.II/numerics/rtree.h>

#include <boost/iterator/function_output_iterator.hpp>

#include <algorithm>
#include <limits>
#include <optional>
#include <set>
#include <sstream>

namespace auxfem
{
  namespace
  {
    const std::string touching_record = "watch: touching struts",
                      crossing_record = "watch: crossing struts",
                      look_record     = "watch: last look for crossing struts";

    /** With inertia. */
    constexpr unsigned int steps_between_crossing_looks = 20;

    using Points = std::vector<dealii::Point<3>>;
    using Pair   = std::pair<unsigned int, unsigned int>;

    /** Axes of struts as lines through points, in the order of the struts. */
    struct Axes
    {
      std::vector<unsigned int> struts;
      std::vector<Points>       points; ///< of each, m
    };

    dealii::BoundingBox<3> box_of(const Points &points, const double margin)
    {
      dealii::BoundingBox<3> box(points);
      box.extend(margin);
      return box;
    }

    /** Struts that are nearer to each other than they can be. */
    struct NearPairs
    {
      std::set<Pair> touching, crossing;
    };

    /** What has happened to some pairs first, and to how many at most. */
    struct FirstPair
    {
      /** @param found at @p now (s), beside those of @p at_rest. */
      void add(const std::set<Pair> &found,
               const std::set<Pair> &at_rest,
               const double          now)
      {
        unsigned int n = 0;
        for (const Pair &candidate : found)
          if (at_rest.count(candidate) == 0)
            {
              if (most == 0 && n == 0)
                {
                  pair = candidate;
                  time = now;
                }
              ++n;
            }
        most = std::max(most, n);
      }

      std::vector<double> values() const
      {
        return {double(most), double(pair.first), double(pair.second), time};
      }

      void set(const std::vector<double> &values)
      {
        most        = values[0];
        pair.first  = values[1];
        pair.second = values[2];
        time        = values[3];
      }

      /** `at about t = 1 s, later up to 3 pairs`. */
      void write_time(const bool on_path, std::ostream &text) const
      {
        text << " at about " << moment_text(on_path, time, 4);
        if (most > 1)
          text << ", later up to " << most << " pairs";
      }

      unsigned int most = 0;
      Pair         pair;
      double       time = 0; ///< s
    };

    /** Whether two struts touch, or have passed each other. */
    class CrossingRule
    {
    public:
      CrossingRule(const Lattice &lattice, const std::vector<Section> &sections)
        : lattice(lattice)
        , sections(sections)
      {}

      /** By how much the box of an axis is to be wider on all sides (m). */
      double margin(const unsigned int strut) const
      {
        return half_thickness(strut);
      }

      /** How far struts may move against each other between two looks (m). */
      double motion_between_looks(const double mean_strut_length) const
      {
        // Struts that pass each other side by side touch for two thicknesses of
        // the way; in space not all are as near as that.
        const double of_half_thickness = lattice.dimension == 2 ? 2 : 1;
        double       motion            = mean_strut_length / 10;
        for (unsigned int s = 0; s < lattice.struts.size(); ++s)
          if (!lattice.struts[s].is_rigid() && half_thickness(s) > 0)
            motion = std::min(motion, of_half_thickness * half_thickness(s));
        return motion;
      }

      /** Whether two that are not joined are nearer than half the sum of their
       * thicknesses. */
      bool touch(const unsigned int one,
                 const Points      &of_one,
                 const unsigned int other,
                 const Points      &of_other) const
      {
        return !meet(one, other) &&
          are_nearer(of_one,
                     of_other,
                     half_thickness(one) + half_thickness(other));
      }

      bool cross(const unsigned int one,
                 const Points      &of_one,
                 const unsigned int other,
                 const Points      &of_other) const
      {
        return lattice.dimension == 2
          ? cross_in_plane(of_one, of_other, one == other)
          // By half of how far one can be in the other.
          : !meet(one, other) &&
            are_nearer(of_one,
                       of_other,
                       (half_thickness(one) + half_thickness(other)) / 2);
      }

    private:
      /** In the plane that in it, in space the smaller one (m). */
      double half_thickness(const unsigned int strut) const
      {
        const auto &halves =
          sections[lattice.struts[strut].section].half_thicknesses;
        return lattice.dimension == 2 ? halves[1]
                                      : std::min(halves[0], halves[1]);
      }

      /** Whether they are joined to each other, or one. */
      bool meet(const unsigned int one, const unsigned int other) const
      {
        for (const unsigned int i : lattice.struts[one].joints)
          for (const unsigned int j : lattice.struts[other].joints)
            if (i == j)
              return true;
        return one == other;
      }

      /** Ends may touch, as those at a joint do. */
      static bool
      cross_in_plane(const Points &one, const Points &other, const bool is_same)
      {
        constexpr double tolerance = 1e-3;
        const auto       is_end    = [](const double      fraction,
                               const std::size_t segment,
                               const std::size_t n_points) {
          return (segment == 0 && fraction < tolerance) ||
            (segment + 2 == n_points && fraction > 1 - tolerance);
        };
        for (std::size_t i = 0; i + 1 < one.size(); ++i)
          // Of a strut with itself neighbours meet where they are joined.
          for (std::size_t j = is_same ? i + 2 : 0; j + 1 < other.size(); ++j)
            if (const auto at =
                  meeting_point({one[i], one[i + 1]}, {other[j], other[j + 1]}))
              if (!is_end((*at)[0], i, one.size()) &&
                  !is_end((*at)[1], j, other.size()))
                return true;
        return false;
      }

      static bool
      are_nearer(const Points &one, const Points &other, const double least)
      {
        for (std::size_t i = 0; i + 1 < one.size(); ++i)
          for (std::size_t j = 0; j + 1 < other.size(); ++j)
            if (distance({one[i], one[i + 1]}, {other[j], other[j + 1]}) <
                least)
              return true;
        return false;
      }

      const Lattice              &lattice;
      const std::vector<Section> &sections;
    };

    /**
     * Looks for pairs of struts that touch or have passed each other, through a
     * tree of their boxes, whenever nodes have moved against each other.
     */
    class CrossingWatch : public Watch
    {
    public:
      CrossingWatch(const Scene &scene, const Equations &equations)
        : equations(equations)
        , model(equations.model())
        , rule(model.lattice, model.sections)
        , motion_between_looks(
            rule.motion_between_looks(model.mean_strut_length))
        , end_time(equations.layout().path
                     ? std::numeric_limits<double>::infinity()
                     : scene.time.end_time)
        , looks(scene, model.simulated, steps_between_crossing_looks)
        , motion(model)
      {}

      void start(const State &state) override
      {
        motion.start(state.displacement);
      }

      void step(const Evaluation &step,
                const EvaluationResults & /*results*/,
                TangentSolver & /*solver*/) override
      {
        if (!looks.are_due(step.to.time))
          return;
        const bool is_last = step.to.time >= end_time;
        if (motion.largest(step.to.displacement) > motion_between_looks ||
            is_last)
          look(step.to);
      }

      std::vector<Finding> findings() const override
      {
        if (touched.most == 0 && crossed.most == 0)
          return {};
        const bool is_told_by_touch = touched.most > 0 &&
          (crossed.most == 0 || touched.time < crossed.time);
        std::ostringstream text;
        text.precision(4);
        if (is_told_by_touch)
          {
            text << "Struts " << touched.pair.first << " and "
                 << touched.pair.second << " touch";
            touched.write_time(equations.layout().path, text);
          }
        if (crossed.most > 0)
          {
            text << (is_told_by_touch ? "; s" : "S");
            if (crossed.pair.first == crossed.pair.second)
              text << "trut " << crossed.pair.first << " crosses itself";
            else
              text << "truts " << crossed.pair.first << " and "
                   << crossed.pair.second << " have passed into each other";
            crossed.write_time(equations.layout().path, text);
          }
        text << ": contact is left out. What the lattice does from there on "
                "holds only if its struts can pass each other; if they cannot, "
             << advice();
        const FirstPair &first = is_told_by_touch ? touched : crossed;
        return {{Verdict::doubtful,
                 text.str(),
                 first.time,
                 "strut " + std::to_string(first.pair.first)}};
      }

      void save(Records &records) const override
      {
        records.keep(touching_record, touched.values());
        records.keep(crossing_record, crossed.values());
        records.keep(look_record, {looks.save()});
        motion.save(look_record, records);
      }

      void resume(const Records &records) override
      {
        touched.set(records.values(touching_record, 4));
        crossed.set(records.values(crossing_record, 4));
        looks.resume(records.values(look_record, 1)[0]);
        motion.resume(look_record, records);
      }

    private:
      /** What to do for struts that touch. */
      const char *advice() const
      {
        if (equations.layout().path)
          return "load it in steps with Analysis = simulation and Scheme = "
                 "static.";
        return model.simulated.large_rotation
          ? "leave Effects/Contact at auto."
          : "leave Effects/Large rotation and Effects/Contact at auto.";
      }

      void look(const State &state)
      {
        motion.start(state.displacement);
        const NearPairs found = pairs(axes_of(state.displacement));
        if (found.touching.empty() && found.crossing.empty())
          return;
        if (!at_rest)
          at_rest = pairs(axes_of(Vector(state.displacement.size(), 0.)));
        touched.add(found.touching, at_rest->touching, state.time);
        crossed.add(found.crossing, at_rest->crossing, state.time);
      }

      /** Of the elastic struts of this rank. */
      Axes axes_of(const Vector &displacement) const
      {
        Axes axes;
        for (const StrutGroup &group : equations.reporting().struts)
          add_axes(*group.forces, displacement, axes);
        return axes;
      }

      void add_axes(const StrutForces &struts,
                    const Vector      &displacement,
                    Axes              &axes) const
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
            if (axes.struts.empty() ||
                axes.struts.back() != element.interval.strut)
              {
                axes.struts.push_back(element.interval.strut);
                axes.points.push_back(points);
              }
            else
              axes.points.back().insert(axes.points.back().end(),
                                        points.begin() + 1,
                                        points.end());
          }
      }

      /** All that touch or cross, of all ranks, each once. Collective. */
      NearPairs pairs(const Axes &mine) const
      {
        const bool  is_alone  = model.numbering.layout().n_ranks() == 1;
        const Axes  of_others = is_alone ? Axes() : axes_of_all_ranks(mine);
        const Axes &all       = is_alone ? mine : of_others;
        std::vector<dealii::BoundingBox<3>> boxes;
        boxes.reserve(all.struts.size());
        for (std::size_t i = 0; i < all.struts.size(); ++i)
          boxes.push_back(box_of(all.points[i], rule.margin(all.struts[i])));
        const auto tree = dealii::pack_rtree_of_indices(boxes);
        NearPairs  of_mine;
        for (std::size_t i = 0; i < mine.struts.size(); ++i)
          {
            const unsigned int one     = mine.struts[i];
            const auto         look_at = [&](const std::size_t j) {
              const unsigned int other = all.struts[j];
              if (one > other)
                return;
              const Points &points = mine.points[i], &others = all.points[j];
              if (rule.touch(one, points, other, others))
                of_mine.touching.emplace(one, other);
              if (rule.cross(one, points, other, others))
                of_mine.crossing.emplace(one, other);
            };
            tree.query(boost::geometry::index::intersects(
                         box_of(mine.points[i], rule.margin(one))),
                       boost::make_function_output_iterator(look_at));
          }
        return is_alone ? of_mine : pairs_of_all_ranks(of_mine);
      }

      /** Of all ranks, in their order. Collective. */
      Axes axes_of_all_ranks(const Axes &mine) const
      {
        const MPI_Comm communicator = model.numbering.layout().communicator();
        std::vector<unsigned int> n_points;
        std::vector<double>       coordinates;
        for (const Points &points : mine.points)
          {
            n_points.push_back(points.size());
            for (const dealii::Point<3> &point : points)
              coordinates.insert(coordinates.end(),
                                 point.begin_raw(),
                                 point.end_raw());
          }
        n_points    = of_all_ranks(n_points, communicator);
        coordinates = of_all_ranks(coordinates, communicator);
        Axes          all{of_all_ranks(mine.struts, communicator), {}};
        const double *next = coordinates.data();
        for (const unsigned int n : n_points)
          {
            Points &points = all.points.emplace_back();
            for (unsigned int i = 0; i < n; ++i, next += 3)
              points.emplace_back(next[0], next[1], next[2]);
          }
        return all;
      }

      /** Of all ranks. Collective. */
      NearPairs pairs_of_all_ranks(const NearPairs &mine) const
      {
        return {of_all(mine.touching), of_all(mine.crossing)};
      }

      std::set<Pair> of_all(const std::set<Pair> &mine) const
      {
        std::vector<unsigned int> ends;
        for (const auto &[one, other] : mine)
          ends.insert(ends.end(), {one, other});
        ends = of_all_ranks(ends, model.numbering.layout().communicator());
        std::set<Pair> all;
        for (std::size_t i = 0; i < ends.size(); i += 2)
          all.emplace(ends[i], ends[i + 1]);
        return all;
      }

      const Equations    &equations;
      const LatticeModel &model;
      const CrossingRule  rule;
      const double        motion_between_looks; ///< m
      const double        end_time;             ///< s
      SpacedLooks         looks;
      RelativeMotion      motion; ///< since the last look
      /** Looked for when there is something to compare with it. */
      std::optional<NearPairs> at_rest;
      FirstPair                touched, crossed;
    };
  } // namespace

  std::unique_ptr<Watch> make_crossing_watch(const Scene     &scene,
                                             const Equations &equations)
  {
    return std::make_unique<CrossingWatch>(scene, equations);
  }
} // namespace auxfem
