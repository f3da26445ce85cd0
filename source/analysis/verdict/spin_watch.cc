#include <auxfem/equations/node_masses.h>
#include <auxfem/mathematics/rotation.h>
#include <auxfem/mesh/sets.h>
#include <auxfem/parameters/numerical_limits.h>
#include <auxfem/time/watch.h>

#include <deal.II/base/quadrature_lib.h>

#include <cmath>
#include <sstream>

namespace auxfem
{
  namespace
  {
    /** Growth that makes noticeable disturbances as large as the motion. */
    constexpr double doubtful_growth = 1 / noticeable_fraction;

    struct PointMass
    {
      double             mass; ///< kg
      dealii::Point<3>   at_rest;
      std::array<int, 3> unknowns; ///< local
    };

    /** Adds nodes of this rank's struts. */
    void add_struts(const LatticeModel &model, std::vector<PointMass> &masses)
    {
      const DofNumbering &numbering = model.numbering;
      for (unsigned int e = 0; e < numbering.elements().size(); ++e)
        {
          const auto &element = numbering.elements()[e];
          if (!element.is_owned)
            continue;
          const StrutInterval           &interval = element.interval;
          const dealii::QGaussLobatto<1> lobatto(element.order + 1);
          const std::vector<double>      element_masses = node_masses(model, e);
          for (unsigned int a = 0; a < element_masses.size(); ++a)
            {
              PointMass    node{element_masses[a], {}, {}};
              SpaceVector  tangent;
              const double part =
                lobatto.point(position_along(a, element.order))[0];
              model.lattice.axis(model.lattice.struts[interval.strut],
                                 interval.begin +
                                   part * (interval.end - interval.begin),
                                 node.at_rest,
                                 tangent);
              for (unsigned int c = 0; c < 3; ++c)
                node.unknowns[c] = numbering.element_unknowns(
                  e)[numbering.n_components() * a + c];
              masses.push_back(node);
            }
        }
    }

    void add_joints(const LatticeModel &model, std::vector<PointMass> &masses)
    {
      for (const MassDefinition &mass : model.plan.scene.masses)
        for (const unsigned int joint :
             joints_of(mass, model.lattice, model.plan.scene.context))
          {
            PointMass node{mass.mass, model.lattice.joints[joint], {}};
            for (unsigned int c = 0; c < 3; ++c)
              node.unknowns[c] = model.numbering.joint_unknown(joint, c);
            if (model.numbering.layout().is_owned(node.unknowns[0]))
              masses.push_back(node);
          }
    }

    SpaceTensor cross_matrix(const SpaceVector &v)
    {
      return SpaceTensor(
        {{0, -v[2], v[1]}, {v[2], 0, -v[0]}, {-v[1], v[0], 0}});
    }

    /**
     * Detects unstable spin of a free lattice. A small rotation theta of a
     * rigid body with inertia J and angular momentum L obeys theta' = J^-1 (L x
     * theta): J rotates with the body, L is constant. Spin about the middle
     * principal axis is unstable: errors within the step tolerance grow beyond
     * it.
     */
    class SpinWatch : public Watch
    {
    public:
      explicit SpinWatch(const WatchContext &run)
        : layout(run.equations.unknowns().layout)
        , tolerance(*run.plan.time.relative_tolerance)
        , growth(run.statistics.number("spin: growth", 1))
        , time(run.statistics.number("spin: time (s)"))
        , rotation_growth(run.statistics.list("spin: turns"))
      {
        add_struts(run.equations.model(), masses);
        add_joints(run.equations.model(), masses);
        rotation_growth = {1, 0, 0, 0, 1, 0, 0, 0, 1};
      }

      void step(const Evaluation &step,
                const EvaluationResults & /*results*/,
                TangentSolver & /*solver*/) override
      {
        const SpaceTensor half =
          step.dt / 4 * (growth_rate(step.from) + growth_rate(step.to));
        SpaceTensor one, before;
        for (unsigned int c = 0; c < 3; ++c)
          {
            one[c][c] = 1;
            for (unsigned int d = 0; d < 3; ++d)
              before[c][d] = rotation_growth[3 * c + d];
          }
        const SpaceTensor now = invert(one - half) * (one + half) * before;
        for (unsigned int c = 0; c < 3; ++c)
          for (unsigned int d = 0; d < 3; ++d)
            rotation_growth[3 * c + d] = now[c][d];
        if (const double size = now.norm() / std::sqrt(3.); size > growth)
          {
            growth = size;
            time   = step.to.time;
          }
      }

      std::vector<Finding> findings() const override
      {
        if (!(growth > doubtful_growth))
          return {};
        std::ostringstream text;
        text.precision(2);
        text
          << "The lattice spins about an axis at which small disturbances "
             "grow, by a factor of "
          << growth << " until t = " << time
          << " s. Errors of its steps grow alike: each step meets Time/Relative "
             "tolerance = "
          << tolerance
          << ", but the final motion may not. Compare with a smaller tolerance.";
        return {{Verdict::doubtful, text.str(), time, ""}};
      }

    private:
      /** Growth rate of small turns (1/s). Collective. */
      SpaceTensor growth_rate(const State &state) const
      {
        // Mass, first and second moments, momentum, angular momentum.
        std::vector<double> sums(16, 0.);
        for (const PointMass &node : masses)
          {
            const SpaceVector r = node.at_rest +
              vector_at(state.displacement.data(), node.unknowns.data()),
                              v = vector_at(state.velocity->data(),
                                            node.unknowns.data()),
                              l = dealii::cross_product_3d(r, v);
            sums[0] += node.mass;
            for (unsigned int c = 0; c < 3; ++c)
              {
                sums[1 + c] += node.mass * r[c];
                sums[4 + c] += node.mass * r[c] * r[c];
                sums[7 + c] += node.mass * r[c] * r[(c + 1) % 3];
                sums[10 + c] += node.mass * v[c];
                sums[13 + c] += node.mass * l[c];
              }
          }
        sums = layout.sum(sums);
        SpaceVector centre, momentum, spin;
        for (unsigned int c = 0; c < 3; ++c)
          {
            centre[c]   = sums[1 + c] / sums[0];
            momentum[c] = sums[10 + c];
            spin[c]     = sums[13 + c];
          }
        spin -= dealii::cross_product_3d(centre, momentum);
        SpaceTensor inertia;
        for (unsigned int c = 0; c < 3; ++c)
          {
            const unsigned int d = (c + 1) % 3, e = (c + 2) % 3;
            inertia[c][c] = sums[4 + d] + sums[4 + e] -
              sums[0] * (centre[d] * centre[d] + centre[e] * centre[e]);
            inertia[c][d] = inertia[d][c] =
              -sums[7 + c] + sums[0] * centre[c] * centre[d];
          }
        // A straight rod has no inertia about its axis.
        const double largest = trace(inertia);
        if (!(determinant(inertia) > 1e-12 * largest * largest * largest))
          return SpaceTensor();
        return invert(inertia) * cross_matrix(spin);
      }

      const UnknownLayout   &layout;
      const double           tolerance;
      std::vector<PointMass> masses;
      /** Largest growth of a small rotation since t = 0, and its time (s). */
      double &growth, &time;
      /** Matrix by which small rotations have grown since t = 0, row by row. */
      std::vector<double> &rotation_growth;
    };
  } // namespace

  std::unique_ptr<Watch> make_spin_watch(const WatchContext &run)
  {
    return std::make_unique<SpinWatch>(run);
  }
} // namespace auxfem
