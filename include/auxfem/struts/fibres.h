#ifndef auxfem_struts_fibres_h
#define auxfem_struts_fibres_h

#include <array>
#include <cmath>
#include <vector>

namespace auxfem
{
  /** Shape of a cross-section apart from its size. */
  struct SectionShape
  {
    enum class Kind
    {
      rectangle,
      circle,
      tube,
      without_fibres ///< known by its constants only
    };

    Kind kind = Kind::without_fibres;
    /** Inner over outer radius of a tube; side of a rectangle along axis 3 over
     * that along axis 2. */
    double ratio = 0;
  };

  /** Orders shapes, for maps. */
  inline bool operator<(const SectionShape &one, const SectionShape &other)
  {
    return one.kind < other.kind ||
      (one.kind == other.kind && one.ratio < other.ratio);
  }

  /** Whether shapes agree but for round-off. */
  inline bool are_alike(const SectionShape &one, const SectionShape &other)
  {
    return one.kind == other.kind &&
      std::abs(one.ratio - other.ratio) <= 1e-9 * one.ratio;
  }

  /** Numbers of fibres in a section. */
  struct FibreNumbers
  {
    /** In the plane: across the height; in a tube from top to bottom. */
    unsigned int layers;
    /** Through the radius of circles in space, and of tubes. */
    unsigned int rings;
    unsigned int angles; ///< around circles and tubes in space
    unsigned int grid;   ///< along each side of rectangles in space
  };

  /** A fibre along a strut, in a section of unit area whose radii of gyration
   * are one. */
  struct Fibre
  {
    double weight; ///< part of the area
    /** Axial strain of the fibre by curvatures about axes 2 and 3. */
    double arm_2, arm_3;
    /** @name Shear strains along axes 2 and 3
     * By shear strains of the section along both axes and by torsion, each
     * scaled so that its mean square over the section is one. In the plane
     * there is one, along the shear flow. */
    ///@{
    std::array<double, 2> shear_2, shear_3, twist;
    ///@}
  };

  /**
   * Fibres of a section in the plane, symmetric about the axis. Their sums of
   * weight and weight arm_3^2 are one to round-off; arm_2 is zero.
   *
   * Rectangles have layers by Gauss' rule. Circles have those of the
   * Gauss-Chebyshev rule of the second kind, whose weights are chords. Tubes
   * have rings by Gauss' rule in the squared radius.
   *
   * Shear strains are distributed as in elastic sections: parabolas in
   * rectangles and circles, the flow of thin walls in tubes.
   */
  std::vector<Fibre> plane_fibres(const SectionShape &shape,
                                  const FibreNumbers &numbers);

  /**
   * Fibres of a section in space: rectangles have a grid by Gauss' rule,
   * circles and tubes have rings by Gauss' rule in the squared radius, at equal
   * angles. Second moments about both axes are one to round-off.
   *
   * Shear is distributed as in the plane, along both axes; torsion by
   * Saint-Venant's solution, in rectangles a series (Timoshenko & Goodier,
   * Theory of Elasticity, section 109).
   */
  std::vector<Fibre> space_fibres(const SectionShape &shape,
                                  const FibreNumbers &numbers);
} // namespace auxfem

#endif
