#ifndef auxfem_mesh_cells_msh_tokens_h
#define auxfem_mesh_cells_msh_tokens_h

#include <auxfem/mesh/cells/line_mesh.h>

#include <string>

namespace auxfem
{
  /**
   * Words and numbers of a file in gmsh's format MSH. Numbers may be binary;
   * all that is no number as expected throws MeshMistake.
   */
  class MshTokens
  {
  public:
    /** Reads @p content, which must outlive this object. */
    explicit MshTokens(const std::string &content) : content(content)
    {}

    /** Whether numbers are read as they lie in memory. */
    bool is_binary = false;

    /** The next word; empty at the end of the file. */
    std::string next();

    void skip_line();

    /** Goes on behind the next @p text; whether there is one. */
    bool skip_to_end_of(const std::string &text);

    /** The next text in double quotes. */
    std::string quoted();

    /** An integer of 4 bytes where the file is binary. */
    long long integer(const std::string &what);

    /** An integer of 8 bytes where the file is binary. */
    long long long_integer(const std::string &what);

    /** An integer that counts things of at least one byte each. */
    long long count(const std::string &what);

    /** A long integer that counts things of at least one byte each. */
    long long long_count(const std::string &what);

    /** A finite number. */
    double real(const std::string &what);

    /** Throws MeshMistake: @p what is wrong at the present line or byte. */
    [[noreturn]] void fail(const std::string &what) const;

  private:
    void      skip_blanks();
    long long checked_count(long long n, const std::string &what) const;

    template <class Number>
    Number bytes(const std::string &what);

    template <class Number>
    Number number(const std::string &what, const std::string &kind);

    const std::string &content;
    std::size_t        position = 0;
    std::size_t        line     = 1;
  };
} // namespace auxfem

#endif
