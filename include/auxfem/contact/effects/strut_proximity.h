#ifndef auxfem_contact_effects_strut_proximity_h
#define auxfem_contact_effects_strut_proximity_h

#include <auxfem/contact/effects/strut_gap.h>
#include <auxfem/mesh/lattice.h>
#include <auxfem/state/state.h>

#include <optional>
#include <set>

namespace auxfem
{
  /**
   * Which struts of a lattice come near each other. Pairs are
   * checked_displacements at again only when they may have come nearer than
   * they were allowed to: axes with a common node when one of them has turned
   * by what was left, others when nodes have moved by half of the distance that
   * was left. These come from a tree of boxes (R-tree), made anew when nodes
   * may have moved farther than the boxes are wide.
   *
   * Displacements are those of all ranks, by global number; each rank knows
   * all pairs. Many that are to be checked_displacements at are shared out
   * among the ranks.
   */
  class StrutProximity
  {
  public:
    /** Looks at the struts at rest. Collective.
     * @param model, curves must outlive the object and its copies */
    StrutProximity(const LatticeModel &model, const StrutCurves &curves);

    /** At rest; such as pass each other are never near. */
    const std::vector<StrutOverlap> &overlaps() const
    {
      return overlaps_at_rest;
    }

    /** Largest motion of a node since the last look (m). */
    double largest_motion_to(const std::vector<double> &displacements) const;

    /** Follows an accepted state; whether near() has changed. Collective.
     * @param way largest_motion_to() there */
    ///@{
    bool follow(const std::vector<double> &displacements, double way);
    bool follow(const std::vector<double> &displacements)
    {
      return follow(displacements, largest_motion_to(displacements));
    }
    ///@}

    /** Pairs that touch or may do so soon, sorted. */
    const std::vector<AxisPair> &near() const
    {
      return near_pairs;
    }

    /** Displacements at the last look; nothing has touched since, while nodes
     * have gone no farther than needs a look. */
    const std::vector<double> &last_checked_displacements() const
    {
      return checked_displacements;
    }

    /** Motion of nodes that no pair need be checked_displacements at for (m).
     */
    double unchecked_motion() const;

    /** Whether one of them touches, or does so soon. */
    bool has_contact_candidates() const
    {
      return is_contact_imminent;
    }

    /** Looks at all struts in an accepted state, as if nothing were known of
     * the states before; whether near() has changed. Collective. */
    bool restart(const std::vector<double> &displacements);

    /**
     * A pair of struts that comes nearer on the straight way between two states
     * than it may; none if there is none. The first state, or one before it,
     * was followed. Collective.
     * @param allowed penetration of near pairs over half their thickness;
     *   others may not touch
     * @param way largest_motion_to() the second state
     */
    ///@{
    std::optional<AxisPair>
    first_excessive_approach(const std::vector<double> &from,
                             const std::vector<double> &to,
                             double                     allowed,
                             double                     way) const;
    std::optional<AxisPair>
    first_excessive_approach(const std::vector<double> &from,
                             const std::vector<double> &to,
                             const double               allowed) const
    {
      return first_excessive_approach(from, to, allowed, largest_motion_to(to));
    }
    ///@}

  private:
    /**
     * Gap of a pair that has forces of its own, over half its thickness.
     * @tuned judgement
     */
    static constexpr double near_gap_fraction = 0.15;

    /** A pair within search_distance of each other. */
    struct CandidatePair
    {
      AxisPair pair;
      /** It need not be checked_displacements at before the nodes have
       * total_motion so far (m).
       */
      double due;
      bool   is_near;
    };

    /** A pair with a common node. */
    struct ConnectedPair
    {
      /** What its axes may have turned since they were remembered before they
       * are near (rad). */
      std::array<double, 2> rotation_margin{};
      bool                  is_near = false;
    };

    AxisCurve curve(unsigned int axis, const std::vector<double> &u) const
    {
      return curves.curve(axis, curves.list()[axis].unknowns.data(), u.data());
    }

    void find_nodes();
    /** How far the nodes of a pair move against each other at most: the
     * diagonal of the box of all their motions (m). */
    double relative_motion(const AxisPair            &pair,
                           const std::vector<double> &from,
                           const std::vector<double> &to) const;
    /** How near a pair is to be for having forces (m). */
    double near_gap(const AxisPair &pair) const;
    /** Whether the gap of a pair (m) is smaller than @p least or becomes so
     * soon, if it goes on shrinking as it did since the last look, up to @p u.
     */
    bool is_approaching(const AxisPair            &pair,
                        double                     gap,
                        const std::vector<double> &u,
                        double                     least) const;

    double gap(const AxisPair &pair, const std::vector<double> &u) const
    {
      return gap_of(pair, curve(pair[0], u), curve(pair[1], u));
    }

    /** Pairs without a common node whose axes, on the way between two states,
     * are less than twice @p margin apart (m). */
    std::vector<AxisPair> pairs_in_boxes(const std::vector<double> &from,
                                         const std::vector<double> &to,
                                         double margin) const;
    /** The same of boxes of the axes. */
    std::vector<AxisPair>
         pairs_in(const std::vector<dealii::BoundingBox<3>> &boxes) const;
    bool never_touch(const AxisPair &pair) const;
    void find_near_at_rest();
    /** Makes the list anew. @param pairs less than the search_distance apart */
    void set_candidate_pairs(const std::vector<AxisPair> &pairs);
    /** Looks at what may have come near, and remembers @p u as the last look;
     * whether near() has changed. */
    bool update_near_pairs(const std::vector<double> &u);
    void check_candidate_pairs(const std::vector<double> &u);
    void check_connected_pairs(const std::vector<double> &u);
    /** Several of them, by number. */
    void          check_connected_pairs(const std::vector<unsigned int> &pairs,
                                        const std::vector<double>       &u);
    ConnectedPair check_connected_pairs(const AxisPair            &pair,
                                        const std::vector<double> &u) const;
    /** How much an axis has turned since it was checked_displacements at (rad).
     */
    double axis_rotation(unsigned int axis, const std::vector<double> &u) const;
    /** How much it may turn until it is checked_displacements at again (rad).
     */
    double compute_allowed_rotation(unsigned int axis) const;
    /** Travel of the nodes before which an axis that has @p turned (rad) cannot
     * have turned by as much as it may (m). */
    double earliest_rotation_check(unsigned int axis, double turned) const;
    /** Axes that have turned by as much as they may. */
    std::vector<unsigned int> find_rotated_axes(const std::vector<double> &u);
    /** Of them the pairs with a common node. */
    std::vector<unsigned int>
    pairs_connected_to(const std::vector<unsigned int> &turned) const;
    /** All axes with a common node are checked_displacements at next. */
    void invalidate_rotations();
    void store_reference(unsigned int axis, const std::vector<double> &u);
    /** Makes near() of what was found; whether it has changed. */
    bool collect_near(const std::vector<double> &u);
    bool any_rank_has_contact_candidates(const std::vector<double> &u) const;

    /** Whether a gap becomes smaller than @p least (m) on the straight way. */
    bool gap_falls_below(const AxisPair            &pair,
                         const std::vector<double> &from,
                         const std::vector<double> &to,
                         double                     least) const;

    /** Largest motion of a node (m). */
    ///@{
    double motion(const std::vector<double> &from,
                  const std::vector<double> &to) const;
    template <unsigned int dimension>
    double largest_motion(const std::vector<double> &from,
                          const std::vector<double> &to) const;
    ///@}
    /** Motion of the nodes of an axis, not less than that of any (m). */
    double motion(unsigned int               axis,
                  const std::vector<double> &from,
                  const std::vector<double> &to) const;

    const LatticeModel &model;
    const StrutCurves  &curves;
    const StrutGap      gap_of;
    const double
      search_distance; ///< between axes that are kept in the list (m)
    std::vector<StrutOverlap> overlaps_at_rest;
    /** Struts that pass each other at rest. */
    std::set<std::array<unsigned int, 2>> passing;
    double thickest = 0, thinnest = 0; ///< half (m)

    std::vector<CandidatePair> candidate_pairs;
    std::vector<AxisPair>      near_pairs;
    std::vector<double> near_gaps; ///< of these, in `checked_displacements` (m)
    /** Displacements by axis, node and component when pairs with a common node
     * were checked_displacements at. */
    std::vector<double> reference_displacements;
    /** Of each axis, in `reference_displacements`. */
    std::vector<std::size_t> first_of_axis;
    /** Global numbers of the displacements of each node of any axis, once. */
    std::vector<std::array<int, 3>> nodes;
    IndexLists                 connected_of_axis; ///< pairs with a common node
    std::vector<ConnectedPair> connected;
    std::vector<double>        allowed_rotation; ///< of each axis (rad)
    /** Of each axis, travel of the nodes at which its axis_rotation is
     * checked_displacements at again (m). */
    std::vector<double> rotation_due;
    bool                is_contact_imminent = false;
    std::vector<double> checked_displacements; ///< displacements
    double              total_motion = 0; ///< up to `checked_displacements` (m)
    double list_update_due = 0; ///< travel at which the list is made anew
  };

  /** Follows a motion without contact, step by step, and finds the first struts
   * that touch or pass each other. */
  class FirstContactDetector
  {
  public:
    /** @param model, curves must outlive the object
     * @param at_rest which has followed nothing so far */
    FirstContactDetector(const LatticeModel   &model,
                         const StrutCurves    &curves,
                         const StrutProximity &at_rest)
      : model(model)
      , curves(curves)
      , proximity(at_rest)
    {}

    /**
     * Two struts that touch on the straight way of a step; none if there are
     * none. Collective.
     * @param from where the step before has ended
     */
    std::optional<std::array<unsigned int, 2>> find(const State &from,
                                                    const State &to);

  private:
    const LatticeModel &model;
    const StrutCurves  &curves;
    StrutProximity      proximity;
    bool                is_following = false;
    std::vector<double> room; ///< for what other ranks have
  };
} // namespace auxfem

#endif
