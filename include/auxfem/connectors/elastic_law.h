#ifndef auxfem_connectors_elastic_law_h
#define auxfem_connectors_elastic_law_h

#include <auxfem/connectors/connector_law.h>

#include <memory>
#include <utility>
#include <vector>

namespace auxfem
{
  /** Elastic force of a connector (N) over its extension (m). */
  class ForceCurve
  {
  public:
    struct Value
    {
      double force;     ///< N
      double stiffness; ///< N/m
    };

    virtual ~ForceCurve() = default;

    virtual Value at(double extension) const = 0;

    /** Mean force over the way between two extensions, and its derivative by @p
     * to. The mean times the way is exactly the change of energy(). */
    virtual Value mean(double from, double to) const = 0;

    /** Energy (J), zero without extension. */
    double energy(const double extension) const
    {
      return mean(0, extension).force * extension;
    }

    /** Whether the stiffness jumps. */
    virtual bool has_kinks() const = 0;
  };

  /** Force of straight pieces, continued beyond its first and last point. Where
   * two pieces meet, the stiffness is the larger of theirs, so that a structure
   * at rest on stops is held. */
  class PiecewiseLinearCurve : public ForceCurve
  {
  public:
    /** Extension (m) and force (N). */
    using Point = std::pair<double, double>;

    /**
     * @param points at which pieces meet, ascending; at least one
     * @param first, last stiffness (N/m) below the first and above the last
     *   point
     */
    PiecewiseLinearCurve(const std::vector<Point> &points,
                         double                    first,
                         double                    last);

    Value at(double extension) const override;
    Value mean(double from, double to) const override;
    bool  has_kinks() const override;

  private:
    /** Force = force + stiffness (u - extension) from `begin` on. */
    struct Piece
    {
      double begin, extension, force, stiffness;
    };

    std::vector<Piece> pieces;
  };

  /** Dashpot in parallel with a force curve: its force is (constant + per_force
   * |elastic force|) du/dt. */
  struct ElasticLawDamping
  {
    double constant  = 0; ///< N s/m
    double per_force = 0; ///< s/m, after Hunt & Crossley (1975)
  };

  /** Law of a force curve with a dashpot in parallel. */
  std::unique_ptr<ConnectorLaw>
  make_elastic_law(std::shared_ptr<const ForceCurve> curve,
                   const ElasticLawDamping          &damping = {});

  /** @name Parameters of several elastic laws. */
  ///@{
  /** Dashpot in parallel (N s/m). */
  const Quantity &parallel_damping();
  /** Dashpot whose force is proportional to the elastic force (s/m). */
  const Quantity &stop_damping();
  ///@}
} // namespace auxfem

#endif
