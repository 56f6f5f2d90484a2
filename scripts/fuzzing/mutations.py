"""Mutations of files, each chosen and made by a random.Random."""
import re
import struct

NUMBERS = (b"0", b"-1", b"1", b"2", b"1e300", b"-1e300", b"1e-300", b"nan", b"inf", b"-inf",
           b"2147483647", b"2147483648", b"4294967296", b"-2147483648", b"99999999",
           b"18446744073709551616", b"1e400", b"0x10", b"1.5", b"1,5", b"1e", b"--1", b"+1",
           b".5", b"5.", b"1.5D+00", b"1.5d0", b"")
BYTES = (b"\0", b"\xff", b"\xc3\xa9", b"\t", b" ", b"\n", b"\r", b",", b"$", b"*", b"#", b"\"",
         b"{", b"}", b"=", b"-", b"%s", b"9", b"\x1a")
WORD = re.compile(rb"[^\s,=;{}()]+")
NUMBER = re.compile(rb"[+-]?\d[\d.]*(?:[eEdD][+-]?\d+)?\Z")


def _words(data, only_numbers=False):
    words = list(WORD.finditer(data))
    if only_numbers:
        words = [word for word in words if NUMBER.match(word.group())]
    return words


def _put(data, word, text, chance):
    """Instead of a word; every other time in its columns, for files where they count."""
    length = word.end() - word.start()
    if chance.random() < 0.5:
        text = text[:length] if len(text) > length else text.rjust(length)
    return data[:word.start()] + text + data[word.end():]


def _change(data, chance, new_text, only_numbers=True):
    words = _words(data, only_numbers)
    if not words:
        return data
    word = chance.choice(words)
    return _put(data, word, new_text(word.group(), words), chance)


def extreme_number(data, chance):
    return _change(data, chance, lambda old, words: chance.choice(NUMBERS))


def next_number(data, chance):
    def change(old, words):
        try:
            return b"%d" % (int(old) + chance.choice((-1, 1)))
        except ValueError:
            return old + b"1"
    return _change(data, chance, change)


def number_of_elsewhere(data, chance):
    return _change(data, chance, lambda old, words: chance.choice(words).group())


def word_of_elsewhere(data, chance):
    return _change(data, chance, lambda old, words: chance.choice(words).group(), False)


def delete_word(data, chance):
    return _change(data, chance, lambda old, words: b"", False)


def double_word(data, chance):
    return _change(data, chance, lambda old, words: old + b" " + old, False)


def swap_words(data, chance):
    words = _words(data)
    if len(words) < 2:
        return data
    a, b = sorted(chance.sample(words, 2), key=lambda word: word.start())
    return (data[:a.start()] + b.group() + data[a.end():b.start()] + a.group()
            + data[b.end():])


def change_digit(data, chance):
    def change(old, words):
        i = chance.randrange(len(old))
        return old[:i] + chance.choice((b"0", b"1", b"7", b"9", b"-", b".", b"e")) + old[i + 1:]
    return _change(data, chance, change)


def d_exponent(data, chance):
    def change(old, words):
        return re.sub(rb"[eE]", b"D", old) if re.search(rb"[eE]", old) else old + b"D+00"
    if chance.random() < 0.5:
        return _change(data, chance, change)
    return re.sub(rb"(\d\.\d+)(?=\s|,)", rb"\1D0", data)


def delete_line(data, chance):
    return _lines(data, chance, lambda lines, i: lines[:i] + lines[i + 1:])


def double_line(data, chance):
    return _lines(data, chance, lambda lines, i: lines[:i] + [lines[i]] + lines[i:])


def move_line(data, chance):
    def move(lines, i):
        line = lines.pop(i)
        lines.insert(chance.randrange(len(lines) + 1), line)
        return lines
    return _lines(data, chance, move)


def swap_lines(data, chance):
    def swap(lines, i):
        j = chance.randrange(len(lines))
        lines[i], lines[j] = lines[j], lines[i]
        return lines
    return _lines(data, chance, swap)


def delete_lines(data, chance):
    return _lines(data, chance,
                  lambda lines, i: lines[:i] + lines[i + chance.randrange(2, 12):])


def join_lines(data, chance):
    def join(lines, i):
        if i + 1 < len(lines):
            lines[i:i + 2] = [lines[i].rstrip(b"\n") + b" " + lines[i + 1]]
        return lines
    return _lines(data, chance, join)


def empty_line(data, chance):
    return _lines(data, chance, lambda lines, i: lines[:i] + [b"\n"] + lines[i:])


def same_first_word(data, chance):
    """As of an element of a number that another one has."""
    def copy(lines, i):
        others = [line for line in lines if len(line.split()) == len(lines[i].split()) > 1]
        if others:
            first = WORD.search(chance.choice(others))
            mine = WORD.search(lines[i])
            if first and mine:
                text = first.group().ljust(mine.end() - mine.start())
                lines[i] = lines[i][:mine.start()] + text + lines[i][mine.end():]
        return lines
    return _lines(data, chance, copy)


def _lines(data, chance, change):
    lines = data.splitlines(keepends=True)
    return b"".join(change(lines, chance.randrange(len(lines)))) if lines else data


def cut_short(data, chance):
    return data[:chance.randrange(len(data) + 1)]


def cut_last(data, chance):
    return data[:max(0, len(data) - chance.randrange(1, 80))]


def cut_out(data, chance):
    begin = chance.randrange(len(data) + 1)
    return data[:begin] + data[begin + chance.randrange(1, 60):]


def twice(data, chance):
    return data + data


def double_part(data, chance):
    begin = chance.randrange(len(data) + 1)
    end = min(len(data), begin + chance.randrange(1, 200))
    return data[:end] + data[begin:]


def other_case(data, chance):
    change = chance.choice((bytes.upper, bytes.lower, bytes.swapcase))
    return change(data) if chance.random() < 0.5 else _change(
        data, chance, lambda old, words: change(old), False)


def line_ends(data, chance):
    return data.replace(b"\n", chance.choice((b"\r\n", b"\r", b"\n\n", b" \n")))


def byte_order_mark(data, chance):
    return b"\xef\xbb\xbf" + data


def insert_bytes(data, chance):
    at = chance.randrange(len(data) + 1)
    return data[:at] + chance.choice(BYTES) * chance.choice((1, 1, 1, 3, 300)) + data[at:]


def flip_byte(data, chance):
    if not data:
        return data
    at = chance.randrange(len(data))
    return data[:at] + bytes([data[at] ^ 1 << chance.randrange(8)]) + data[at + 1:]


def binary_number(data, chance):
    size, form = chance.choice(((4, "i"), (8, "q")))
    at = chance.randrange(max(1, len(data) - size))
    value = chance.choice((0, -1, 1, 2, 255, 99999999, 2 ** 31 - 1, -2 ** 31))
    return data[:at] + struct.pack(chance.choice("<>") + form, value) + data[at + size:]


def not_a_number(data, chance):
    at = chance.randrange(max(1, len(data) - 8))
    value = chance.choice((float("nan"), float("inf"), 1e300, -1e300, 0.))
    return data[:at] + struct.pack(chance.choice("<>") + "d", value) + data[at + 8:]


COMMON = (cut_short, cut_last, cut_out, twice, double_part, insert_bytes, flip_byte)
TEXT = COMMON + (
    extreme_number, extreme_number, extreme_number, next_number, next_number, next_number,
    number_of_elsewhere, number_of_elsewhere, word_of_elsewhere, delete_word, double_word,
    swap_words, change_digit, change_digit, d_exponent, delete_line, delete_line, double_line,
    double_line, move_line, swap_lines, delete_lines, join_lines, empty_line, same_first_word,
    same_first_word, other_case, line_ends, byte_order_mark)
BINARY = COMMON + (flip_byte, flip_byte, binary_number, binary_number, binary_number,
                   binary_number, not_a_number, next_number, extreme_number, delete_line)


def _entries(data):
    return list(re.finditer(rb"^[ \t]*set[ \t]+([^=\n]+?)[ \t]*=[ \t]*([^\n#]*)", data, re.M))


def entry_value(data, chance):
    """A value that another entry has, or an extreme one."""
    entries = _entries(data)
    if not entries:
        return data
    entry = chance.choice(entries)
    values = [chance.choice(NUMBERS), chance.choice(entries).group(2), chance.choice(VALUES)]
    return data[:entry.start(2)] + chance.choice(values) + data[entry.end(2):]


def swap_values(data, chance):
    entries = _entries(data)
    if len(entries) < 2:
        return data
    a, b = sorted(chance.sample(entries, 2), key=lambda entry: entry.start())
    return (data[:a.start(2)] + b.group(2) + data[a.end(2):b.start(2)] + a.group(2)
            + data[b.end(2):])


VALUES = (
    b"2", b"3", b"calibrate", b"box", b"cylinder", b"hollow cylinder", b"tissue", b"specimen",
    b"cell", b"file", b"triangles", b"quadrilaterals", b"tetrahedra", b"hexahedra",
    b"0.01, 0.02, 0.03", b"0.02, 0.02", b"0.01", b"0.49", b"0.5", b"-0.999", b"stress",
    b"strain", b"1: 2, 2: 3", b"skin: 1e4", b"block", b"frobenius", b"consistent",
    b"compliance", b"stable neo-hookean", b"gelder", b"lloyd", b"baudet", b"delingette",
    b"golec", b"frobenius, frobenius", b"none", b"volume", b"point volumes", b"angles",
    b"coupling", b"none, volume, coupling", b"quadratic", b"biquadratic", b"logarithmic",
    b"object", b"affine", b"responses", b"true", b"false", b"stretch x 1.3, shear xy 0.3",
    b"stretch x 0", b"spectral", b"barrier", b"tension", b"x < 1e-6", b"x <", b"(" * 200,
    b"x min", b"nonlinear", b"neo-hookean", b"direct", b"1 to 10000 in 5", b"1 to 0 in 2",
    b"1 to 2 in 999999999", b"0, 0, 0", b"1, 1, 1", b",", b", ,", b"\\", b"a" * 3000, b"=",
    b"%d%s%n", b"\xff\xfe", b"../..", b"|")
PRM = TEXT + 4 * (entry_value,) + 2 * (swap_values,) + 4 * (entry_value,)


def mutate(data, mutations, chance):
    """One to three mutations, and their names; now and then none."""
    count = chance.choices((0, 1, 2, 3), (4, 60, 24, 12))[0]
    names = []
    for _ in range(count):
        mutation = chance.choice(mutations)
        data = mutation(data, chance)
        names.append(mutation.__name__)
    return data, names
