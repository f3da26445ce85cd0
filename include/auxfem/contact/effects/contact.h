#ifndef auxfem_contact_effects_contact_h
#define auxfem_contact_effects_contact_h

#include <auxfem/contact/effects/strut_proximity.h>
#include <auxfem/equations/effect.h>

#include <optional>
#include <string>

namespace auxfem
{
  /** Penetration of a strut into a plate or a strut. */
  struct Penetration
  {
    double       fraction; ///< of the thickness
    unsigned int strut;
    unsigned int other; ///< touched strut or plate
  };

  /** A contact point of a strut, for output. */
  struct ContactReport
  {
    unsigned int         strut;
    unsigned int         other;        ///< touched strut or plate
    dealii::Point<3>     rest;         ///< on the axis (m)
    dealii::Tensor<1, 3> displacement; ///< m
    /** Current vector from the touching face to the axis (m). */
    dealii::Tensor<1, 3> to_face;
    dealii::Tensor<1, 3> force; ///< on the strut (N)
    double               depth; ///< of penetration (m)
  };

  /**
   * @name Text for the touched body: `the plate "table"`, `strut 3`, `itself`.
   */
  ///@{
  inline std::string touched_plate(const std::string &name)
  {
    return "the plate \"" + name + '"';
  }

  inline std::string touched_strut(const unsigned int strut,
                                   const unsigned int other)
  {
    return other == strut ? "itself" : "strut " + std::to_string(other);
  }
  ///@}

  /** Contact of struts with plates or struts; the interface for output. */
  class Contact : public Effect, public StageTerms, public ChangingCouplings
  {
  public:
    /** Largest penetration on this rank; empty without contact. */
    virtual std::optional<Penetration>
    deepest(const EffectCache &results) const = 0;

    /** Contact points of this rank, including those that touched in the last
     * step. */
    virtual std::vector<ContactReport> contacts(const EffectCache &results,
                                                const State &state) const = 0;
  };

  /** Motion of a plate and contact force on it. */
  struct PlateReport
  {
    dealii::Tensor<1, 3> displacement; ///< of the plate (m)
    dealii::Tensor<1, 3> force;        ///< of the struts on the plate (N)
    /** Largest penetration over the thickness of the strut. */
    double largest_penetration = 0;
  };

  /**
   * Contact of struts with rigid plates. ContactLaw and CoulombFriction are
   * integrated over the part of an axis closer to the surface than half the
   * thickness; forces act on the axis. Theory: doc/theory/contact.md.
   *
   * Only struts near a plate are coupled with it; accepted states determine
   * them.
   */
  class PlateContact : public Contact
  {
  public:
    /** Number of plates. */
    virtual unsigned int n_plates() const = 0;

    /** One report per plate, summed over all ranks. Collective. */
    virtual std::vector<PlateReport> reports(const EffectCache &results,
                                             const State &state) const = 0;

    /** Name of a plate. */
    virtual const std::string &name(unsigned int plate) const = 0;

    /** Polylines that draw a plate at rest (m); @p size is the drawn extent of
     * unbounded plates. */
    virtual std::vector<std::vector<dealii::Point<3>>>
    outline(unsigned int plate, double size) const = 0;
  };

  /**
   * Contact between struts. Points along each axis press on the nearest point
   * of the other axis by ContactLaw; each strut contributes half of the force.
   * The tangent is the exact Hessian of the potential. Friction as in
   * PlateContact. Theory: doc/theory/contact.md.
   *
   * After C. Meier, A. Popp, W. A. Wall, Comput. Methods Appl. Mech. Eng. 308,
   * 2016, 377-413 (Gauss points against the nearest point of the other axis).
   */
  class StrutContact : public Contact
  {
  public:
    /** Detector of first contact in a motion without contact forces; this
     * object must outlive it. Collective. */
    virtual std::unique_ptr<FirstContactDetector>
    first_contact_detector() const = 0;

    /** Struts that overlap at rest. */
    virtual const std::vector<StrutOverlap> &overlaps() const = 0;
  };

  /**
   * @name Contact effects of a scene; @p model must outlive them. Collective.
   */
  ///@{
  /**
   * Throws InputError for struts without thickness or inside a plate at rest.
   */
  std::unique_ptr<PlateContact> make_plate_contact(const LatticeModel &model);

  std::unique_ptr<StrutContact> make_strut_contact(const LatticeModel &model);
  ///@}
} // namespace auxfem

#endif
