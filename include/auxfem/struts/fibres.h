#ifndef auxfem_struts_fibres_h
#define auxfem_struts_fibres_h

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
      given ///< by area and moments only: no fibres
    };

    Kind kind = Kind::given;
    /** Inner over outer radius of a tube. */
    double bore = 0;
  };

  /** Orders shapes, for maps. */
  inline bool operator<(const SectionShape &one, const SectionShape &other)
  {
    return one.kind < other.kind ||
      (one.kind == other.kind && one.bore < other.bore);
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
  };

  /**
   * Fibres of a section in the plane, symmetric about the axis. Their sums of
   * weight and weight arm_3^2 are one to round-off; arm_2 is zero.
   *
   * Rectangles have layers by Gauss' rule. Circles have those of the
   * Gauss-Chebyshev rule of the second kind, whose weights are chords. Tubes
   * have rings by Gauss' rule in the squared radius.
   */
  std::vector<Fibre> plane_fibres(const SectionShape &shape,
                                  const FibreNumbers &numbers);

  /**
   * Fibres of a section in space: rectangles have a grid by Gauss' rule,
   * circles and tubes have rings by Gauss' rule in the squared radius, at equal
   * angles. Second moments about both axes are one to round-off.
   */
  std::vector<Fibre> space_fibres(const SectionShape &shape,
                                  const FibreNumbers &numbers);
} // namespace auxfem

#endif
