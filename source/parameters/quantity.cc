#include <auxfem/parameters/describe.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/parameters/quantity.h>
#include <auxfem/parameters/text.h>

#include <deal.II/base/numbers.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>

namespace auxfem
{
  namespace
  {
    using dealii::Utilities::trim;

    struct Symbol
    {
      const char *word;
      Unit        unit;
    };

    constexpr Dimension none        = {{0, 0, 0, 0, 0}};
    constexpr Dimension length      = {{1, 0, 0, 0, 0}};
    constexpr Dimension mass        = {{0, 1, 0, 0, 0}};
    constexpr Dimension time        = {{0, 0, 1, 0, 0}};
    constexpr Dimension angle       = {{0, 0, 0, 1, 0}};
    constexpr Dimension force       = {{1, 1, -2, 0, 0}};
    constexpr Dimension pressure    = {{-1, 1, -2, 0, 0}};
    constexpr Dimension energy      = {{2, 1, -2, 0, 0}};
    constexpr Dimension rate        = {{0, 0, -1, 0, 0}};
    constexpr Dimension temperature = {{0, 0, 0, 0, 1}};

    const std::vector<Symbol> &symbols()
    {
      constexpr double pound_force = 4.4482216152605, inch = 0.0254,
                       psi                   = pound_force / (inch * inch);
      static const std::vector<Symbol> table = {
        {"m", {length, 1}},
        {"mm", {length, 1e-3}},
        {"cm", {length, 1e-2}},
        {"um", {length, 1e-6}},
        {"km", {length, 1e3}},
        {"in", {length, inch}},
        {"ft", {length, 12 * inch}},
        {"kg", {mass, 1}},
        {"g", {mass, 1e-3}},
        {"t", {mass, 1e3}},
        {"lb", {mass, 0.45359237}},
        {"slug", {mass, pound_force / (12 * inch)}},
        {"s", {time, 1}},
        {"ms", {time, 1e-3}},
        {"us", {time, 1e-6}},
        {"min", {time, 60}},
        {"h", {time, 3600}},
        {"N", {force, 1}},
        {"kN", {force, 1e3}},
        {"MN", {force, 1e6}},
        {"mN", {force, 1e-3}},
        {"lbf", {force, pound_force}},
        {"kip", {force, 1e3 * pound_force}},
        {"kgf", {force, 9.80665}},
        {"Pa", {pressure, 1}},
        {"kPa", {pressure, 1e3}},
        {"MPa", {pressure, 1e6}},
        {"GPa", {pressure, 1e9}},
        {"psi", {pressure, psi}},
        {"ksi", {pressure, 1e3 * psi}},
        {"Msi", {pressure, 1e6 * psi}},
        {"psf", {pressure, psi / 144}},
        {"bar", {pressure, 1e5}},
        {"J", {energy, 1}},
        {"Hz", {rate, 1}},
        {"kHz", {rate, 1e3}},
        {"K", {temperature, 1}},
        {"rad", {angle, 1}},
        {"deg", {angle, dealii::numbers::PI / 180}},
        {"%", {none, 1e-2}}};
      return table;
    }

    bool is_letter(const char c)
    {
      return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '%';
    }

    bool is_digit(const char c)
    {
      return c >= '0' && c <= '9';
    }

    const Unit &find_symbol(const std::string &word)
    {
      std::vector<std::string> known;
      for (const Symbol &symbol : symbols())
        {
          if (word == symbol.word)
            return symbol.unit;
          known.push_back(symbol.word);
        }
      throw InputError("unit word \"" + word + "\" is not known" +
                       did_you_mean(word, known));
    }

    /** One factor of a unit expression, e.g. `mm^4`. */
    struct Factor
    {
      std::string word; // empty for the literal 1
      int         exponent;
      std::size_t position;
    };

    /** Splits a unit expression into factors. */
    class UnitScanner
    {
    public:
      explicit UnitScanner(const std::string &text) : text(text)
      {}

      std::vector<Factor> factors()
      {
        std::vector<Factor> result;
        bool                expect_factor = true;
        int                 sign          = 1;
        for (; position < text.size();)
          if (text[position] == ' ' || text[position] == '\t')
            ++position;
          else if (text[position] == '/' || text[position] == '*')
            {
              const bool divide = (text[position++] == '/');
              // A unit may begin with "/s" ("5 /s"), but not with "*s" or
              // "m//s".
              if (sign < 0 || (expect_factor && !(divide && result.empty())))
                fail();
              sign          = (divide ? -1 : 1);
              expect_factor = true;
            }
          else
            {
              result.push_back(factor(sign));
              sign          = 1;
              expect_factor = false;
            }
        if (expect_factor)
          fail();
        return result;
      }

    private:
      [[noreturn]] void fail() const
      {
        throw InputError("\"" + text +
                         "\" is no unit; write units like mm, N s/m, kg/m3");
      }

      Factor factor(const int sign)
      {
        const std::size_t start = position;
        if (text[position] == '1' &&
            (position + 1 == text.size() || !is_digit(text[position + 1])))
          {
            ++position;
            return {"", sign, start};
          }
        while (position < text.size() && is_letter(text[position]))
          ++position;
        if (position == start)
          fail();
        const std::string word = text.substr(start, position - start);
        return {word, sign * exponent(), start};
      }

      int exponent()
      {
        const bool caret = position < text.size() && text[position] == '^';
        if (caret)
          ++position;
        const bool negative =
          caret && position < text.size() && text[position] == '-';
        if (negative)
          ++position;
        if (position == text.size() || !is_digit(text[position]))
          {
            if (caret)
              fail();
            return 1;
          }
        const int value = text[position++] - '0';
        if (position < text.size() && is_digit(text[position]))
          fail();
        return negative ? -value : value;
      }

      const std::string text;
      std::size_t       position = 0;
    };

    bool begins_number(const std::string &token)
    {
      // The unit word of "5 1/s".
      const bool is_unit = token.compare(0, 2, "1/") == 0 && token.size() > 2 &&
        is_letter(token[2]);
      return !is_unit &&
        (is_digit(token[0]) || token[0] == '+' || token[0] == '-' ||
         token[0] == '.');
    }

    /**
     * Reads a number at @p begin and moves @p begin behind it; false if there
     * is none.
     */
    bool read_number(const char *&begin, const char *end, double &number)
    {
      const auto answer = std::from_chars(begin, end, number);
      begin             = answer.ptr;
      return answer.ec == std::errc() && std::isfinite(number);
    }
  } // namespace



  Unit parse_unit(const std::string &expression)
  {
    Unit result;
    for (const Factor &factor : UnitScanner(expression).factors())
      if (!factor.word.empty())
        {
          const Unit &unit = find_symbol(factor.word);
          for (unsigned int i = 0; i < result.dimension.size(); ++i)
            result.dimension[i] += factor.exponent * unit.dimension[i];
          result.factor *= std::pow(unit.factor, factor.exponent);
        }
    return result;
  }



  ParsedQuantity split_quantity(const std::string &text)
  {
    const std::string trimmed = trim(text);
    const char       *begin   = trimmed.data();
    const char       *end     = begin + trimmed.size();
    if (begin != end && *begin == '+')
      ++begin;
    double number = 0, divisor = 1;
    bool   good = read_number(begin, end, number);
    if (good && end - begin > 1 && *begin == '/' && is_digit(begin[1]))
      good = read_number(++begin, end, divisor) && divisor != 0;
    if (!good)
      throw InputError("\"" + trimmed + "\" is not a number");
    return {number / divisor, trim(std::string(begin, end))};
  }



  ParsedRange split_range(const std::string &text)
  {
    ParsedRange              range;
    std::vector<std::string> parts =
      dealii::Utilities::split_string_list(text, ':');
    const std::string last  = trim(parts.back());
    const std::size_t blank = last.find(' ');
    if (blank != std::string::npos)
      {
        range.unit   = trim(last.substr(blank));
        parts.back() = last.substr(0, blank);
      }
    for (const std::string &part : parts)
      range.numbers.push_back(parse_quantity(part, "1"));
    return range;
  }



  std::string quantity_text(const double value, const std::string &unit)
  {
    return number_text(value) + (unit.empty() ? "" : " " + unit);
  }



  double parse_quantity(const std::string &text, const std::string &unit)
  {
    const ParsedQuantity quantity = split_quantity(text);
    const Unit           declared = parse_unit(unit);
    if (quantity.unit.empty())
      return quantity.number * declared.factor;
    const Unit unit_word = parse_unit(quantity.unit);
    if (unit_word.dimension != declared.dimension)
      throw InputError("unit word \"" + quantity.unit + "\" does not fit");
    return quantity.number * unit_word.factor;
  }



  std::string si_unit(const std::string &unit)
  {
    constexpr std::array<const char *, 5> words = {
      {"m", "kg", "s", "rad", "K"}};
    const Dimension dimension = parse_unit(unit).dimension;
    std::string     text;
    for (std::size_t i = 0; i < words.size(); ++i)
      if (dimension[i] != 0)
        text += (text.empty() ? "" : " ") + std::string(words[i]) +
          (dimension[i] == 1 ? "" : "^" + std::to_string(dimension[i]));
    return text;
  }



  std::vector<std::string> split_words(const std::string &text)
  {
    std::vector<std::string> words;
    for (const std::string &piece :
         dealii::Utilities::split_string_list(text, ','))
      {
        std::istringstream stream(piece);
        std::string        word;
        if (!(stream >> word))
          words.emplace_back();
        else
          do
            words.push_back(word);
          while (stream >> word);
      }
    return words;
  }



  std::vector<std::string> split_quantity_list(const std::string &text)
  {
    std::vector<std::string> items;
    if (trim(text).empty())
      return items;
    for (const std::string &piece :
         dealii::Utilities::split_string_list(text, ','))
      {
        if (piece.empty())
          items.emplace_back();
        bool is_first = true;
        for (const std::string &word : split_words(piece))
          {
            if (is_first || begins_number(word))
              items.push_back(word);
            else
              items.back() += " " + word;
            is_first = false;
          }
      }
    return items;
  }



  std::vector<std::string> unit_words()
  {
    const std::vector<std::pair<const char *, Dimension>> measures = {
      {"length", length},
      {"mass", mass},
      {"time", time},
      {"angle", angle},
      {"force", force},
      {"pressure", pressure},
      {"energy", energy},
      {"rate", rate},
      {"temperature", temperature},
      {"part of one", none}};
    std::vector<std::string> lines;
    for (const auto &[name, dimension] : measures)
      {
        std::string words;
        for (const Symbol &symbol : symbols())
          if (symbol.unit.dimension == dimension)
            words += (words.empty() ? " " : ", ") + std::string(symbol.word);
        lines.push_back(name + (":" + words));
      }
    return lines;
  }



  std::vector<std::string> fitting_units(const std::string &unit)
  {
    std::vector<std::string> result = {unit};
    const auto               add    = [&result](const std::string &word) {
      if (std::find(result.begin(), result.end(), word) == result.end())
        result.push_back(word);
    };
    for (const Factor &factor : UnitScanner(unit).factors())
      for (const Symbol &symbol : symbols())
        if (!factor.word.empty() &&
            symbol.unit.dimension == find_symbol(factor.word).dimension)
          add(unit.substr(0, factor.position) + symbol.word +
              unit.substr(factor.position + factor.word.size()));
    const Unit declared = parse_unit(unit);
    for (const Symbol &symbol : symbols())
      if (symbol.unit.dimension == declared.dimension)
        add(symbol.word);
    return result;
  }
} // namespace auxfem
