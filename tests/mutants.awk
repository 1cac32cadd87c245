# SPDX-License-Identifier: BSD-3-Clause
# The faults that mutate.sh plants: one small change for each line of the C++ sources named, as
#   key TAB file TAB line TAB new line
# Key and change are random numbers that follow from `seed`, the file's name and the line.
# Counts on the layout of .clang-format: binary operators stand between spaces, template brackets do
# not. Strings and comments stay as they are, and so do exceptions, progress and the grains of threads;
# what as a rule changes nothing but speed: < for <= between numbers that are not counted, what is done
# with a tolerance of rounding (1e-6 or less), one more of many, how often something is tried, masks of
# bits, and fetching; and the ranges of sliders, which no result depends on.

BEGIN {
  for (i = 1; i < 256; ++i) code[sprintf("%c", i)] = i
  change(" + ", " - "); change(" * ", " / "); change(" += ", " -= "); change(" *= ", " /= ")
  change(" == ", " != "); change(" && ", " || "); change("std::min(", "std::max(")
  change("std::sin(", "std::cos("); change("std::floor(", "std::ceil(")
  change("return true;", "return false;"); change(".front()", ".back()")
  changeTo(" < ", " > "); changeTo(" <= ", " >= "); changeTo(" > ", " < "); changeTo(" >= ", " <= ")
  equalFrom = count + 1
  change(" < ", " <= "); change(" > ", " >= ")
  equalTo = count + 1
  changeTo("if (!", "if ("); changeTo("continue;", "break;")
  changeTo("std::fabs(", "("); changeTo("std::abs(", "(")
}

function changeTo(a, b) { from[++count] = a; to[count] = b }
function change(a, b) { changeTo(a, b); changeTo(b, a) }

# A number below 2^31 - 1 that follows from `seed` and a text.
function hash(text,  i, h) {
  h = (seed * 7919 + 104729) % 2147483647
  for (i = 1; i <= length(text); ++i) h = (h * 16807 + code[substr(text, i, 1)] + 1) % 2147483647
  for (i = 0; i < 3; ++i) h = (h * 16807 + 11) % 2147483647
  return h
}

# The line with what is between quotes, and a comment at its end, made of a letter of no meaning.
function masked(s,  i, c, out, quote) {
  out = ""; quote = ""
  for (i = 1; i <= length(s); ++i) {
    c = substr(s, i, 1)
    if (quote != "") {
      if (c == "\\") { out = out "\001\001"; ++i; continue }
      if (c == quote) quote = ""
      out = out "\001"
    } else if (c == "\"" || (c == "'" && substr(s, i - 1, 1) !~ /[0-9]/)) {
      quote = c; out = out "\001"
    } else if (c == "/" && substr(s, i + 1, 1) == "/") {
      break
    } else {
      out = out c
    }
  }
  while (length(out) < length(s)) out = out "\001"
  return out
}

# The line with its tolerances, and the signs that they are added or multiplied by, masked, too.
function withoutTolerances(s,  i, hidden) {
  while (match(s, /( [-+*\/] )?[0-9][0-9.]*e-([6-9]|[1-9][0-9])F?( [*\/] [A-Za-z0-9_.]+[^ ;,]*)*/)) {
    hidden = ""
    for (i = 0; i < RLENGTH; ++i) hidden = hidden "\001"
    s = substr(s, 1, RSTART - 1) hidden substr(s, RSTART + RLENGTH)
  }
  return s
}

function add(text) { if (text != line) choice[choices++] = text }

function swap(at, length_, by) { add(substr(line, 1, at - 1) by substr(line, at + length_)) }

function operators(  i, at, rest, skipped, old) {
  for (i = 1; i <= count; ++i) {
    if (i >= equalFrom && i < equalTo && text !~ /for \(|size\(\)|[cC]ount/) continue
    rest = text " "; skipped = 0; old = from[i]
    while ((at = index(rest, old)) > 0) {
      # A space at the end of the line is not there to be replaced.
      if (skipped + at + length(old) - 1 > length(line))
        add(substr(line, 1, skipped + at - 1) substr(to[i], 1, length(to[i]) - 1))
      else
        swap(skipped + at, length(old), to[i])
      skipped += at + length(old) - 2
      rest = substr(text " ", skipped + 1)
    }
  }
}

function numbers(  rest, skipped, token, before, after, value, tail) {
  rest = text; skipped = 0
  while (match(rest, /[0-9][0-9.]*(e[-+]?[0-9]+)?[FUL]*/)) {
    token = substr(rest, RSTART, RLENGTH)
    before = substr(line, skipped + RSTART - 1, 1)
    after = substr(line, skipped + RSTART + RLENGTH, 1)
    if (skipped + RSTART == 1) before = ""
    if (before !~ /[A-Za-z0-9_.<]/ && after !~ /[A-Za-z0-9_>']/) {
      if (token ~ /[.e]/) {
        tail = token ~ /F$/ ? "F" : ""
        if (token ~ /^0*\.0*F?$/) {
          swap(skipped + RSTART, RLENGTH, "1.0" tail)
        } else if (token !~ /e-/) {
          swap(skipped + RSTART, RLENGTH, "(2.0" tail " * " token ")")
          swap(skipped + RSTART, RLENGTH, "(0.5" tail " * " token ")")
          swap(skipped + RSTART, RLENGTH, "0.0" tail)
        }
      } else {
        value = token; gsub(/[UL]/, "", value); tail = substr(token, length(value) + 1)
        if (value >= 10) {
          swap(skipped + RSTART, RLENGTH, (2 * value) tail)
          swap(skipped + RSTART, RLENGTH, int(value / 2) tail)
        } else {
          swap(skipped + RSTART, RLENGTH, (value + 1) tail)
        }
        if (value > 0 && value < 10) swap(skipped + RSTART, RLENGTH, (value - 1) tail)
      }
    }
    skipped += RSTART + RLENGTH - 1
    rest = substr(text, skipped + 1)
  }
}

# Where the bracket opened at `at` is closed; 0 when that is not on this line.
function closes(at,  i, depth, c) {
  for (i = at; i <= length(text); ++i) {
    c = substr(text, i, 1)
    if (c == "(") ++depth
    if (c == ")" && --depth == 0) return i
  }
  return 0
}

function statements(  at, end) {
  if ((at = index(text, "if (")) > 0 && text !~ /if \(!|if constexpr/ && (end = closes(at + 3)) > 0 &&
      text !~ /;.*;/)
    swap(at + 4, end - at - 4, "!(" substr(line, at + 4, end - at - 4) ")")
  if (text ~ /^ *[A-Za-z_][A-Za-z0-9_:.>-]*\(.*\);$/ && text !~ /^ *(return|throw|assert)/) {
    at = index(text, "(")
    if (closes(at) == length(text) - 1) {
      match(line, /^ */)
      add(substr(line, 1, RLENGTH) ";")
    }
  }
  if (text ~ /^ *(\+\+|--)[A-Za-z_].*;$/) {
    at = match(text, /\+\+|--/)
    swap(at, 2, substr(text, at, 2) == "++" ? "--" : "++")
  }
}

FNR == 1 { thrown = 0; listed = 0 }
{
  line = $0
  text = withoutTolerances(masked(line))
  code_ = text; gsub(/\001/, "", code_)
  if (thrown) { if (code_ ~ /; *$/) thrown = 0; next }
  if (code_ ~ /^ *throw / || code_ ~ /(Error|snprintf)\(/) {
    if (code_ !~ /; *$/) thrown = 1
    next
  }
  if (code_ ~ /^ *$|^ *#|^ *(using|namespace|template|class|struct|friend|static_assert|enum)[ <(]/) next
  if (code_ ~ /[Pp]rogress|parallelFor|reserve\(|operator|[Ww]arn/ ||
      code_ ~ /[Gg]rain|constexpr .*[Bb]lock|0x|fetch\(|\.slider\(/ ||
      code_ ~ /constexpr (int|std::size_t) [A-Za-z]*([Tt]ries|[Aa]ttempts|[Rr]ounds|[Ss]teps)/) next
  choices = 0
  operators()
  numbers()
  statements()
  if (choices == 0) next
  chosen = choice[hash(FILENAME ":" FNR ":" line) % choices]
  printf "%d\t%s\t%d\t%s\n", hash(FNR " " FILENAME " " line), FILENAME, FNR, chosen
}
