#ifndef auxfem_contact_effects_contact_h
#define auxfem_contact_effects_contact_h

#include <auxfem/contact/effects/strut_proximity.h>
#include <auxfem/equations/effect.h>

#include <optional>
#include <string>

namespace auxfem
{
  /** How deep a strut has gone into what it touches. */
  struct Penetration
  {
    double       fraction; ///< of the thickness
    unsigned int strut;
    unsigned int other; ///< the strut or plate that it touches
  };

  /** A point of a strut that touches something. */
  struct ContactReport
  {
    unsigned int         strut;
    unsigned int         other;        ///< the strut or plate that it touches
    dealii::Point<3>     rest;         ///< on the axis (m)
    dealii::Tensor<1, 3> displacement; ///< m
    /** From the face that touches to the axis, now (m). */
    dealii::Tensor<1, 3> to_face;
    dealii::Tensor<1, 3> force; ///< on the strut (N)
    double               depth; ///< of penetration (m)
  };

  /** @name What a strut touches, in the user's words: `the plate "table"`, `strut
   * 3`, `itself`. */
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

  /** Contact of struts, whatever they touch, as output sees it. */
  class Contact : public Effect, public StageTerms, public ChangingCouplings
  {
  public:
    /** The largest of the struts of this rank, if any touches. */
    virtual std::optional<Penetration>
    deepest(const EffectCache &results) const = 0;

    /** All points of this rank that touch, or have in the last step. */
    virtual std::vector<ContactReport> contacts(const EffectCache &results,
                                                const State &state) const = 0;
  };

  /** What a plate and the struts exert on each other. */
  struct PlateReport
  {
    dealii::Tensor<1, 3> displacement; ///< of the plate (m)
    dealii::Tensor<1, 3> force;        ///< of the struts on the plate (N)
    /** The largest penetration over the thickness of the strut. */
    double largest_penetration = 0;
  };

  /**
   * Contact of struts with rigid plates: over the part of an axis that is
   * nearer to the surface than half the thickness, the integral of a force of
   * ContactLaw along the normal, and of Coulomb's friction against the motion
   * along the surface, regularised as v / sqrt(v^2 + v0^2). Forces act on the
   * axis. Theory: doc/theory.md, Contact.
   *
   * Only struts near a plate are coupled with it; which these are follows from
   * accepted states.
   */
  class PlateContact : public Contact
  {
  public:
    /** Number of plates. */
    virtual unsigned int n_plates() const = 0;

    /** By plate, over all ranks. Collective. */
    virtual std::vector<PlateReport> reports(const EffectCache &results,
                                             const State &state) const = 0;

    /** Name of a plate. */
    virtual const std::string &name(unsigned int plate) const = 0;

    /** Lines that show a plate at rest (m); @p size of what has no end. */
    virtual std::vector<std::vector<dealii::Point<3>>>
    outline(unsigned int plate, double size) const = 0;
  };

  /**
   * Contact of struts with struts: at points along each of two axes a force of
   * ContactLaw against the point of the other axis that is nearest, if that is
   * nearer than half the sum of their thicknesses; half of it by the points of
   * either. The potential of all is exact, and the tangent its second
   * derivative. Coulomb's friction as in PlateContact. Theory: doc/theory.md,
   * Contact.
   *
   * After C. Meier, A. Popp, W. A. Wall, Comput. Methods Appl. Mech. Eng. 308,
   * 2016, 377-413 (Gauss points against the nearest point of the other axis).
   */
  class StrutContact : public Contact
  {
  public:
    /** Tells of struts that come to touch in a motion without contact. The
     * object must outlive it. Collective. */
    virtual std::unique_ptr<FirstContactDetector>
    first_contact_detector() const = 0;

    /** Struts that overlap at rest. */
    virtual const std::vector<StrutOverlap> &overlaps() const = 0;
  };

  /** @name Contact in a scene; @p model must outlive it. Collective. */
  ///@{
  /** Throws InputError for struts without thickness, and for such as lie in a
   * plate at rest. */
  std::unique_ptr<PlateContact> make_plate_contact(const LatticeModel &model);

  std::unique_ptr<StrutContact> make_strut_contact(const LatticeModel &model);
  ///@}
} // namespace auxfem

#endif
