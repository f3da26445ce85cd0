#ifndef auxfem_mesh_cells_msh_tokens_h
#define auxfem_mesh_cells_msh_tokens_h

#include <auxfem/mesh/cells/line_mesh.h>

#include <string>

namespace auxfem
{
  /**
   * Tokenizer for gmsh's format MSH: words and text or binary numbers. Anything
   * but the expected number throws MeshMistake.
   */
  class MshTokens
  {
  public:
    /** Reads @p content, which must outlive this object. */
    explicit MshTokens(const std::string &content) : content(content)
    {}

    /** Whether numbers are binary. */
    bool is_binary = false;

    /** The next word; empty at the end of the file. */
    std::string next();

    void skip_line();

    /** Moves behind the next @p text; false if there is none. */
    bool skip_to_end_of(const std::string &text);

    /** The next text in double quotes. */
    std::string quoted();

    /** @name Next number
     * @p noun names it in messages. A count is refused if the rest of the file
     * has fewer bytes. */
    ///@{
    long long integer(const std::string &noun);      ///< 4 bytes if binary
    long long long_integer(const std::string &noun); ///< 8 bytes if binary
    long long count(const std::string &noun);        ///< 4 bytes if binary
    long long long_count(const std::string &noun);   ///< 8 bytes if binary
    double    real(const std::string &noun);         ///< finite
    ///@}

    /** Throws MeshMistake with @p problem and the present line or byte. */
    [[noreturn]] void fail(const std::string &problem) const;

  private:
    void      skip_blanks();
    long long checked_count(long long n, const std::string &noun) const;

    template <class Number>
    Number bytes(const std::string &noun);

    template <class Number>
    Number number(const std::string &noun, const std::string &kind);

    const std::string &content;
    std::size_t        position = 0;
    std::size_t        line     = 1;
  };
} // namespace auxfem

#endif
