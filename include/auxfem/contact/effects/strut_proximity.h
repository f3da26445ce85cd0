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
   * Contact detection between struts. A pair is rechecked only when motion may
   * have used up its gap: connected axes after a rotation, others after nodal
   * motion. The broad phase is an R-tree of boxes, rebuilt when nodes may have
   * left their boxes.
   *
   * Displacements are indexed by global number; every rank knows all pairs, and
   * checks are shared among ranks.
   */
  class StrutProximity
  {
  public:
    /** Checks the struts at rest. Collective.
     * @param model, curves must outlive the object and its copies */
    StrutProximity(const LatticeModel &model, const StrutCurves &curves);

    /** Overlaps at rest; pairs with StrutOverlap::is_passing are never near. */
    const std::vector<StrutOverlap> &overlaps() const
    {
      return overlaps_at_rest;
    }

    /** Largest motion of a node since the last check (m). */
    double largest_motion_to(const std::vector<double> &displacements) const;

    /** Updates near() for an accepted state; returns whether it changed.
     * Collective.
     * @param way largest_motion_to() this state (m) */
    ///@{
    bool follow(const std::vector<double> &displacements, double way);
    bool follow(const std::vector<double> &displacements)
    {
      return follow(displacements, largest_motion_to(displacements));
    }
    ///@}

    /** Sorted pairs that touch or may touch soon. */
    const std::vector<AxisPair> &near() const
    {
      return near_pairs;
    }

    /** Displacements at the last check. No pair has touched since, as long as
     * nodes moved less than unchecked_motion(). */
    const std::vector<double> &last_checked_displacements() const
    {
      return checked_displacements;
    }

    /** Motion of nodes that needs no check (m). */
    double unchecked_motion() const;

    /** Whether a near pair touches or will touch soon. */
    bool has_contact_candidates() const
    {
      return is_contact_imminent;
    }

    /** Checks all struts in an accepted state, independent of earlier states;
     * returns whether near() changed. Collective. */
    bool restart(const std::vector<double> &displacements);

    /**
     * Finds a pair with an excessive approach on the straight path between two
     * states. The first state, or one before it, must have been passed to
     * follow(). Collective.
     * @param allowed penetration of near pairs over half their thickness; other
     *   pairs must not touch
     * @param way largest_motion_to() the second state (m)
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
    /** Gap below which a pair is near, over half its thickness.
     * @tuned judgement */
    static constexpr double near_gap_fraction = 0.15;

    /** A pair from the broad phase. */
    struct CandidatePair
    {
      AxisPair pair;
      /** Accumulated motion of the nodes at which it is rechecked (m). */
      double due;
      bool   is_near;
    };

    /** A pair with a common node. */
    struct ConnectedPair
    {
      /** Rotation of its axes since their reference state at which they become
       * near (rad). */
      std::array<double, 2> rotation_margin{};
      bool                  is_near = false;
    };

    AxisCurve curve(unsigned int axis, const std::vector<double> &u) const
    {
      return curves.curve(axis, curves.list()[axis].unknowns.data(), u.data());
    }

    void find_nodes();
    /** Upper bound of the relative motion of the nodes of a pair: diagonal of
     * the box of their motions (m). */
    double relative_motion(const AxisPair            &pair,
                           const std::vector<double> &from,
                           const std::vector<double> &to) const;
    /** Gap below which a pair is near (m). */
    double near_gap(const AxisPair &pair) const;
    /** Whether the gap of a pair (m) is below @p least, or will be soon at its
     * closing rate since the last check. */
    bool is_approaching(const AxisPair            &pair,
                        double                     gap,
                        const std::vector<double> &u,
                        double                     least) const;

    double gap(const AxisPair &pair, const std::vector<double> &u) const
    {
      return gap_of(pair, curve(pair[0], u), curve(pair[1], u));
    }

    /** Pairs without a common node whose axes get closer than twice @p margin
     * (m) between two states. */
    std::vector<AxisPair> pairs_in_boxes(const std::vector<double> &from,
                                         const std::vector<double> &to,
                                         double margin) const;
    /** As above, for given boxes of the axes. */
    std::vector<AxisPair>
         pairs_in(const std::vector<dealii::BoundingBox<3>> &boxes) const;
    bool never_touch(const AxisPair &pair) const;
    void find_near_at_rest();
    /** Replaces the candidate list. @param pairs closer than the search
     * distance */
    void set_candidate_pairs(const std::vector<AxisPair> &pairs);
    /** Checks due pairs and stores @p u as the last check; returns whether
     * near() changed. */
    bool update_near_pairs(const std::vector<double> &u);
    void check_candidate_pairs(const std::vector<double> &u);
    void check_connected_pairs(const std::vector<double> &u);
    /** Checks several pairs, by number. */
    void          check_connected_pairs(const std::vector<unsigned int> &pairs,
                                        const std::vector<double>       &u);
    ConnectedPair check_connected_pairs(const AxisPair            &pair,
                                        const std::vector<double> &u) const;
    /** Rotation of an axis since its reference state (rad). */
    double axis_rotation(unsigned int axis, const std::vector<double> &u) const;
    /** Rotation of an axis that triggers its next check (rad). */
    double compute_allowed_rotation(unsigned int axis) const;
    /** Accumulated motion (m) before which an axis that has @p turned (rad)
     * cannot exceed its allowed rotation. */
    double earliest_rotation_check(unsigned int axis, double turned) const;
    /** Axes that have used up their allowed rotation. */
    std::vector<unsigned int> find_rotated_axes(const std::vector<double> &u);
    /** Pairs with a common node that contain one of these axes. */
    std::vector<unsigned int>
    pairs_connected_to(const std::vector<unsigned int> &turned) const;
    /** Makes all connected axes due for a check. */
    void invalidate_rotations();
    void store_reference(unsigned int axis, const std::vector<double> &u);
    /** Collects near() from the checked pairs; returns whether it changed. */
    bool collect_near(const std::vector<double> &u);
    bool any_rank_has_contact_candidates(const std::vector<double> &u) const;

    /** Whether a gap falls below @p least (m) on the straight path. */
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
    /** Upper bound of the motion of the nodes of an axis (m), without the mean
     * deformation between periods. */
    double motion(unsigned int               axis,
                  const std::vector<double> &from,
                  const std::vector<double> &to) const;

    const LatticeModel &model;
    const StrutCurves  &curves;
    const StrutGap      gap_of;
    const double search_distance; ///< largest distance of candidate pairs (m)
    std::vector<StrutOverlap> overlaps_at_rest;
    /** Lines with StrutOverlap::is_passing. */
    std::set<std::array<unsigned int, 2>> passing;
    double thickest = 0, thinnest = 0; ///< half (m)

    std::vector<CandidatePair> candidate_pairs;
    std::vector<AxisPair>      near_pairs;
    std::vector<double> near_gaps; ///< of these, at `checked_displacements` (m)
    /** Displacements at the last check of each axis, by axis, node and
     * component. */
    std::vector<double> reference_displacements;
    /** Offset of each axis in `reference_displacements`. */
    std::vector<std::size_t> first_of_axis;
    /** Global numbers of the displacements of each distinct node. */
    std::vector<std::array<int, 3>> nodes;
    /** An axis of the mean deformation of an infinite lattice. */
    struct MeanAxis
    {
      std::array<int, 3> node{};
      double             factor = 0; ///< largest of ContactAxis::axis_factors
    };
    std::vector<MeanAxis>      mean_axes;
    IndexLists                 connected_of_axis; ///< pairs with a common node
    std::vector<ConnectedPair> connected;
    std::vector<double>        allowed_rotation; ///< of each axis (rad)
    /** Accumulated motion of the nodes at which the rotation of each axis is
     * rechecked (m). */
    std::vector<double> rotation_due;
    bool                is_contact_imminent = false;
    std::vector<double> checked_displacements;
    double total_motion = 0; ///< accumulated up to `checked_displacements` (m)
    double list_update_due =
      0; ///< accumulated motion at which candidates are rebuilt (m)
  };

  /**
   * Follows a motion without contact forces and finds the first struts that
   * touch or pass each other.
   */
  class FirstContactDetector
  {
  public:
    /** @param model, curves must outlive the object
     * @param at_rest before any call of follow() */
    FirstContactDetector(const LatticeModel   &model,
                         const StrutCurves    &curves,
                         const StrutProximity &at_rest)
      : model(model)
      , curves(curves)
      , proximity(at_rest)
    {}

    /** Finds two struts that touch on the straight path of a step. Collective.
     * @param from end of the previous step */
    std::optional<std::array<unsigned int, 2>> find(const State &from,
                                                    const State &to);

  private:
    const LatticeModel &model;
    const StrutCurves  &curves;
    StrutProximity      proximity;
    bool                is_following = false;
    std::vector<double> gathered; ///< displacements gathered from all ranks
  };
} // namespace auxfem

#endif
