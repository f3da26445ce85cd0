#ifndef auxfem_equations_strut_proximity_h
#define auxfem_equations_strut_proximity_h

#include <auxfem/equations/strut_curves.h>

#include <optional>
#include <string>

namespace auxfem
{
  /** Two axes, the one with the lower number first. */
  using AxisPair = std::array<unsigned int, 2>;

  /**
   * Which struts of a lattice come near each other. Pairs are looked at again
   * only when they may have come nearer than they were allowed to: others than
   * neighbours when nodes have moved by half of the distance that was left,
   * neighbours when one of them has turned. Pairs of struts come from a tree of
   * boxes (R-tree), again when nodes have moved by half the width of these.
   *
   * Displacements are those of all ranks, by global number; each rank looks at
   * all pairs, and finds the same.
   */
  class StrutProximity
  {
  public:
    /** @param curves must outlive the object. */
    StrutProximity(const LatticeModel &model, const StrutCurves &curves);

    /** Follows an accepted state; whether near() has changed. */
    bool follow(const std::vector<double> &displacements);

    /** Pairs that touch or may do so soon, sorted. */
    const std::vector<AxisPair> &near() const
    {
      return near_pairs;
    }

    /** Keeps all that near() and its next change follow from. */
    void save(Records &records) const;
    void resume(const Records &records);

    /**
     * A pair of struts that comes nearer on the straight way between two states
     * than it may; none if there is none. The first state, or one before it,
     * was followed.
     * @param allowed penetration of near pairs over half their thickness;
     *   others may not touch
     */
    std::optional<AxisPair> first_too_near(const std::vector<double> &from,
                                           const std::vector<double> &to,
                                           double allowed) const;

  private:
    /** A pair within reach of each other. */
    struct Reach
    {
      AxisPair pair;
      /** It need not be looked at before the nodes have travelled so far (m).
       */
      double due;
      bool   is_near;
    };

    AxisCurve curve(unsigned int axis, const std::vector<double> &u) const
    {
      return curves.curve(axis, curves.list()[axis].unknowns.data(), u.data());
    }

    double margin(const AxisPair &pair) const;

    /** Least distance of a pair less half its thickness (m), or a little less;
     * negative where it touches. */
    ///@{
    double gap(const AxisPair  &pair,
               const AxisCurve &one,
               const AxisCurve &other) const;
    double gap(const AxisPair &pair, const std::vector<double> &u) const;
    double gap_of_ranges(const AxisPair  &pair,
                         const AxisCurve &one,
                         const AxisCurve &other) const;
    double gap_of_strut(const AxisPair  &pair,
                        const AxisCurve &one,
                        const AxisCurve &other) const;
    ///@}

    /** Pairs other than neighbours whose axes, on the way between two states,
     * are less than twice @p margin apart (m). */
    std::vector<AxisPair> pairs_in_boxes(const std::vector<double> &from,
                                         const std::vector<double> &to,
                                         double margin) const;
    void                  find_pairs_in_reach(const std::vector<double> &u);
    void                  look_at_pairs(const std::vector<double> &u);
    void                  look_at_neighbours(const std::vector<double> &u);
    /** Motion of nodes that no pair need be looked at for (m). */
    double unseen_motion() const;

    /** Axes that have turned since their neighbours were looked at, and the
     * pairs of neighbours that these are in. */
    ///@{
    std::vector<unsigned int> turned_axes(const std::vector<double> &u) const;
    std::vector<unsigned int>
    neighbours_of(const std::vector<unsigned int> &turned) const;
    ///@}
    bool has_turned(unsigned int axis, const AxisCurve &now) const;
    bool collect_near();

    /** Whether a gap becomes smaller than @p least (m) on the straight way. */
    bool comes_too_near(const AxisPair            &pair,
                        const std::vector<double> &from,
                        const std::vector<double> &to,
                        double                     least) const;

    /** Displacements in the order of the axes, which is the same on any number
     * of ranks, and back. */
    ///@{
    std::vector<double> by_axis(const std::vector<double> &values) const;
    std::vector<double> by_number(const std::vector<double> &values) const;
    ///@}

    /** Largest motion of a node (m). */
    double motion(const std::vector<double> &from,
                  const std::vector<double> &to) const;

    const LatticeModel &model;
    const StrutCurves  &curves;
    const double        reach; ///< between axes that are kept in the list (m)
    double              thickest = 0, thinnest = 0; ///< half (m)

    std::vector<Reach>     in_reach;
    std::vector<AxisPair>  near_pairs;
    std::vector<AxisCurve> references; ///< when neighbours were looked at
    std::vector<std::vector<unsigned int>> pairs_of_axis; ///< of neighbours
    std::vector<bool>                      neighbour_is_near;
    std::vector<double>                    looked, last; ///< displacements
    double travelled   = 0;                              ///< up to `looked` (m)
    double step_travel = 0;                              ///< m
    double list_due    = 0; ///< travel at which it is made anew
  };
} // namespace auxfem

#endif
