#include <auxfem/analysis/watch.h>
#include <auxfem/mesh/segment.h>

#include <deal.II/base/mpi.h>
#include <deal.II/numerics/rtree.h>

#include <boost/serialization/set.hpp>
#include <boost/serialization/utility.hpp>

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
    const std::string crossing_record = "watch: crossing struts";

    using Points = std::vector<dealii::Point<3>>;
    using Pair   = std::pair<unsigned int, unsigned int>;

    /** Axes of struts as lines through points, in the order of the struts. */
    struct Axes
    {
      std::vector<unsigned int> struts;
      std::vector<Points>       points; ///< of each, m

      template <class Archive>
      void serialize(Archive &archive, const unsigned int /*version*/)
      {
        archive &struts &points;
      }
    };

    dealii::BoundingBox<3> box_of(const Points &points, const double margin)
    {
      dealii::BoundingBox<3> box(points);
      box.extend(margin);
      return box;
    }

    /** Whether two struts have passed each other, by their axes. */
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
        return lattice.dimension == 2 ? 0. : half_thickness(strut);
      }

      /** How far struts may move between two looks (m). */
      double way_between_looks(const double mean_strut_length) const
      {
        double way = mean_strut_length / 20;
        if (lattice.dimension == 3)
          for (unsigned int s = 0; s < lattice.struts.size(); ++s)
            if (!lattice.struts[s].is_rigid() && half_thickness(s) > 0)
              way = std::min(way, half_thickness(s) / 2);
        return way;
      }

      bool cross(const unsigned int one,
                 const Points      &of_one,
                 const unsigned int other,
                 const Points      &of_other) const
      {
        return lattice.dimension == 2
          ? cross_in_plane(of_one, of_other, one == other)
          : !meet(one, other) && overlap(one, of_one, other, of_other);
      }

    private:
      double half_thickness(const unsigned int strut) const
      {
        const auto &fibres =
          sections[lattice.struts[strut].section].fibre_distances;
        return std::min(fibres[0], fibres[1]);
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

      /** Whether one is in the other by more than half of how far it can be. */
      bool overlap(const unsigned int one,
                   const Points      &of_one,
                   const unsigned int other,
                   const Points      &of_other) const
      {
        const double least = (half_thickness(one) + half_thickness(other)) / 2;
        for (std::size_t i = 0; i + 1 < of_one.size(); ++i)
          for (std::size_t j = 0; j + 1 < of_other.size(); ++j)
            if (distance({of_one[i], of_one[i + 1]},
                         {of_other[j], of_other[j + 1]}) < least)
              return true;
        return false;
      }

      const Lattice              &lattice;
      const std::vector<Section> &sections;
    };

    /**
     * Looks for pairs of struts that have passed each other, through a tree of
     * their boxes, whenever nodes have moved against each other.
     */
    class CrossingWatch : public Watch
    {
    public:
      CrossingWatch(const Scene &scene, const Equations &equations)
        : equations(equations)
        , model(equations.model())
        , rule(model.lattice, model.sections)
        , way_between_looks(rule.way_between_looks(model.mean_strut_length))
        , end_time(scene.time.end_time)
        , steps_between_looks(model.simulated.inertia ? 20 : 1)
      {}

      void start(const State &state) override
      {
        last_displacement = state.displacement;
      }

      void step(const Evaluation &step,
                const EvaluationResults & /*results*/,
                TangentSolver & /*solver*/) override
      {
        const bool is_last = step.to.time >= end_time;
        if (++n_steps < steps_between_looks && !is_last)
          return;
        n_steps = 0;
        if (moved_since(step.to.displacement) > way_between_looks)
          look(step.to);
      }

      std::vector<Finding> findings() const override
      {
        if (most == 0)
          return {};
        std::ostringstream text;
        text.precision(4);
        if (first.first == first.second)
          text << "Strut " << first.first << " crosses itself";
        else
          text << "Struts " << first.first << " and " << first.second
               << " have passed into each other";
        text << " at about t = " << time << " s";
        if (most > 1)
          text << ", later up to " << most << " pairs";
        text
          << ": contact is not modelled. What the lattice does from there on "
             "holds only if its struts can pass each other.";
        return {{Verdict::doubtful,
                 text.str(),
                 time,
                 "strut " + std::to_string(first.first)}};
      }

      void save(Records &records) const override
      {
        records.keep(
          crossing_record,
          {double(most), double(first.first), double(first.second), time});
      }

      void resume(const Records &records) override
      {
        const std::vector<double> values = records.values(crossing_record, 4);
        most                             = values[0];
        first = {static_cast<unsigned int>(values[1]),
                 static_cast<unsigned int>(values[2])};
        time  = values[3];
        last_displacement.clear();
      }

    private:
      /** Largest way of a node since the last look beyond the mean of all (m).
       */
      double moved_since(const Vector &displacement) const
      {
        const DofNumbering &numbering = model.numbering;
        // Ranks may differ: one may have no unknowns, or have got ghosts.
        const bool is_new = last_displacement.size() != displacement.size();
        if (numbering.layout().largest(is_new ? 1. : 0.) > 0)
          return std::numeric_limits<double>::infinity();
        const unsigned int n_components = numbering.n_components(),
                           dimension    = model.lattice.dimension;
        std::vector<double> sum(4, 0.);
        const auto          for_ways = [&](const auto &act) {
          for (unsigned int e = 0; e < numbering.elements().size(); ++e)
            if (numbering.elements()[e].is_owned)
              for (unsigned int a = 0; a <= numbering.elements()[e].order; ++a)
                {
                  const int *unknowns =
                    numbering.element_unknowns(e) + n_components * a;
                  for (unsigned int d = 0; d < dimension; ++d)
                    act(d,
                        displacement[unknowns[d]] -
                          last_displacement[unknowns[d]]);
                }
        };
        for_ways([&sum, dimension](const unsigned int d, const double way) {
          sum[d] += way;
          sum[3] += 1. / dimension;
        });
        const UnknownLayout      &layout  = numbering.layout();
        const std::vector<double> total   = layout.sum(sum);
        double                    largest = 0;
        for_ways([&](const unsigned int d, const double way) {
          largest = std::max(largest, std::abs(way - total[d] / total[3]));
        });
        return layout.largest(largest);
      }

      void look(const State &state)
      {
        if (!crossed_at_rest)
          crossed_at_rest =
            pairs(axes_of(Vector(state.displacement.size(), 0.)));
        last_displacement = state.displacement;
        std::set<Pair> found;
        for (const Pair &pair : pairs(axes_of(state.displacement)))
          if (crossed_at_rest->count(pair) == 0)
            found.insert(pair);
        if (most == 0 && !found.empty())
          {
            first = *found.begin();
            time  = state.time;
          }
        most = std::max<unsigned long>(most, found.size());
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

      /** All that cross, of all ranks, each once. Collective. */
      std::set<Pair> pairs(const Axes &mine) const
      {
        const Axes                          all = of_all_ranks(mine);
        std::vector<dealii::BoundingBox<3>> boxes;
        boxes.reserve(all.struts.size());
        for (std::size_t i = 0; i < all.struts.size(); ++i)
          boxes.push_back(box_of(all.points[i], rule.margin(all.struts[i])));
        const auto     tree = dealii::pack_rtree_of_indices(boxes);
        std::set<Pair> of_mine;
        for (std::size_t i = 0; i < mine.struts.size(); ++i)
          {
            const unsigned int one = mine.struts[i];
            for (const std::size_t j :
                 tree |
                   boost::geometry::index::adaptors::queried(
                     boost::geometry::index::intersects(
                       box_of(mine.points[i], rule.margin(one)))))
              if (const unsigned int other = all.struts[j]; one <= other &&
                  rule.cross(one, mine.points[i], other, all.points[j]))
                of_mine.emplace(one, other);
          }
        return of_all_ranks(of_mine);
      }

      /** Gathers what the ranks have; @p mine is all there is on one. */
      template <class Part>
      Part of_all_ranks(const Part &mine) const
      {
        const MPI_Comm communicator = model.numbering.layout().communicator();
        if (dealii::Utilities::MPI::n_mpi_processes(communicator) == 1)
          return mine;
        Part all;
        for (const Part &part :
             dealii::Utilities::MPI::all_gather(communicator, mine))
          add(part, all);
        return all;
      }

      static void add(const Axes &part, Axes &all)
      {
        all.struts.insert(all.struts.end(),
                          part.struts.begin(),
                          part.struts.end());
        all.points.insert(all.points.end(),
                          part.points.begin(),
                          part.points.end());
      }

      static void add(const std::set<Pair> &part, std::set<Pair> &all)
      {
        all.insert(part.begin(), part.end());
      }

      const Equations              &equations;
      const LatticeModel           &model;
      const CrossingRule            rule;
      const double                  way_between_looks; ///< m
      const double                  end_time;          ///< s
      const unsigned int            steps_between_looks;
      unsigned int                  n_steps = 0;
      Vector                        last_displacement; ///< at the last look
      std::optional<std::set<Pair>> crossed_at_rest;
      unsigned long                 most = 0;
      Pair                          first;
      double                        time = 0; ///< s
    };
  } // namespace

  std::unique_ptr<Watch> make_crossing_watch(const Scene     &scene,
                                             const Equations &equations)
  {
    return std::make_unique<CrossingWatch>(scene, equations);
  }
} // namespace auxfem
