#ifndef auxfem_parameters_quantity_h
#define auxfem_parameters_quantity_h

#include <array>
#include <string>
#include <vector>

namespace auxfem
{
  /** Exponents of length, mass, time, angle, temperature. */
  using Dimension = std::array<int, 5>;

  /** A unit of measurement, reduced to SI. */
  struct Unit
  {
    Dimension dimension = {{0, 0, 0, 0, 0}};
    /** Value of one unit in m, kg, s, rad, K. */
    double factor = 1;
  };

  /** A number as the user wrote it, with its unit word. */
  struct ParsedQuantity
  {
    /** The number before its unit word. */
    double number;
    /** The unit word, empty if there was none. */
    std::string unit;
  };

  /**
   * Reads a unit expression such as `N s/m`, `N*s/m`, `kg/m3`, `mm^4`, `1/s`,
   * `%`, `1`. Products are written with blank or `*`, a `/` divides by the one
   * factor after it, powers are whole numbers with or without `^`. Throws
   * InputError that names an unknown symbol.
   */
  Unit parse_unit(const std::string &expression);

  /**
   * Splits @p text into a decimal number or fraction (`5/6`) and the rest,
   * which is returned as unit word unchecked. Throws InputError if the text
   * does not begin with a finite number.
   */
  ParsedQuantity split_quantity(const std::string &text);

  /** Numbers of a range and their common unit word. */
  struct ParsedRange
  {
    std::vector<double> numbers;
    std::string         unit; ///< empty if there was none
  };

  /**
   * Splits `50:80:5 deg` at the colons; the unit word follows the last number.
   * Throws InputError if a part is not a number.
   */
  ParsedRange split_range(const std::string &text);

  /** @p value followed by @p unit, if there is one. */
  std::string quantity_text(double value, const std::string &unit);

  /**
   * SI value of @p text (`10 mm`, `70 GPa`, `0.3`). @p unit is the unit of the
   * quantity and of numbers without unit word. Throws InputError if the text is
   * not a number or the unit word does not fit.
   */
  double parse_quantity(const std::string &text, const std::string &unit);

  /**
   * Splits at commas and blanks; nothing between two commas gives an empty
   * word.
   */
  std::vector<std::string> split_words(const std::string &text);

  /**
   * Splits `1, 2 mm, 3` or `1 2 mm 3` at the commas and before each number.
   * Empty text gives an empty list.
   */
  std::vector<std::string> split_quantity_list(const std::string &text);

  /** All unit words by measured quantity, e.g. `length: m, mm, ...`. */
  std::vector<std::string> unit_words();

  /** The SI unit of what @p unit measures, e.g. `m^-1 kg s^-2` for `GPa`; empty
   * for a number without unit. */
  std::string si_unit(const std::string &unit);

  /** Unit expressions allowed where @p unit is declared, @p unit first. */
  std::vector<std::string> fitting_units(const std::string &unit);
} // namespace auxfem

#endif
