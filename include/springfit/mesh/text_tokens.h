#ifndef springfit_mesh_text_tokens_h
#define springfit_mesh_text_tokens_h

#include <springfit/mesh/mesh_text.h>

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace springfit
{
  /** The words of a text file, one after the other. */
  class TextTokens
  {
  public:
    /**
     * What begins with @p comment is left out up to the end of its line; '\0'
     * for a format without comments.
     *
     * @throws InputError of read_text_lines.
     */
    explicit TextTokens(const std::filesystem::path &file, char comment = '\0');

    bool
    at_end() const;

    /** The next word, without going on; @p at_end must be false. */
    const std::string &
    peek() const;

    /**
     * The next word. @p what is wanted, for the message.
     *
     * @throws InputError when the file ends before it.
     */
    const std::string &
    next(const std::string &what);

    /** The place of the word that next() gave last. */
    const TextPlace &
    place() const;

    /** @throws InputError of next() and read_real(). */
    double
    real(const std::string &what);

    /** A number >= 0. @throws InputError of next(), or when it is none. */
    std::size_t
    count(const std::string &what);

    /** A number of either sign. @throws InputError of next(), or when none. */
    long
    integer(const std::string &what);

    /** Whether the next word stands on the line of the last one. */
    bool
    goes_on_in_line() const;

    /** Leave out the rest of the line of the last word. */
    void
    skip_line();

  private:
    struct Token
    {
      std::string text;
      std::size_t line;
    };

    std::vector<Token> tokens_;
    std::vector<TextPlace> places_; // of the lines
    std::size_t next_ = 0;
    TextPlace end_;
  };
} // namespace springfit

#endif
