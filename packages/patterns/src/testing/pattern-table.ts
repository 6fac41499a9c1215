/** A pattern, a text, and the first match with its groups; undefined where there is none. */
export type MatchRow = readonly [
  source: string,
  text: string,
  match: readonly (string | undefined)[] | undefined,
];

const UUID = '01234567-89ab-cdef-0123-456789abcdef';

/** Expected matches, on every kind of node. */
export const MATCHES: readonly MatchRow[] = [
  // Anywhere in the text, case-sensitive
  ['touch', '/a/touch/b', ['touch']],
  ['Touch', '/touch', undefined],
  ['^b', '/a/b', undefined],
  ['b/c', '/a/b/c/d', ['b/c']],
  ['', 'everything', ['']],
  ['.*', '', ['']],
  ['^$', '', ['']],
  ['^$', '/', undefined],
  // Patterns used in sessions.
  ['/info/*', '/info/session/start', ['/info/']],
  ['/py/*', '/p', undefined],
  ['^/a/[^/]+/c$', '/a/b/c', ['/a/b/c']],
  ['^/a/[^/]+/c$', '/a/b/b/c', undefined],
  ['^/a.b$', '/a/b/b', undefined],
  ['[^/]+$', '/phones/ada', ['ada']],
  ['^/phones/([^/]+)/touch$', '/phones/ada/touch', ['/phones/ada/touch', 'ada']],
  ['[0-9a-f]{8}-(?:[0-9a-f]{4}-){3}[0-9a-f]{12}', `/x/${UUID}/y`, [UUID]],
  ['^/\\d{2}/\\w+$', '/12/abc', ['/12/abc']],
  ['\\/a\\/\\d+', '/a/12', ['/a/12']],
  // Groups, also those that took no part
  ['/(x|y)/', '/x/', ['/x/', 'x']],
  ['/(\\w+)/(\\w+)', '/a/b/x', ['/a/b', 'a', 'b']],
  ['(a)|(b)', 'b', ['b', undefined, 'b']],
  ['(a)?b', 'b', ['b', undefined]],
  ['(a*)b', 'b', ['b', '']],
  ['((a)(b)?)c', 'ac', ['ac', 'a', 'a', undefined]],
  ['(?:ab)+', 'xababx', ['abab']],
  ['(a|b)+', 'ab', ['ab', 'b']],
  // The group of the last round that had it; JavaScript forgets it with each round
  ['(?:(a)|b)*', 'ab', ['ab', 'a']],
  // Named groups count as numbered ones, in both spellings
  ['(?<device>\\w+)/(?<part>\\w+)', 'phone/x', ['phone/x', 'phone', 'x']],
  ['(?P<device>\\w+)/x', 'phone/x', ['phone/x', 'phone']],
  // The first alternative, and the first place
  ['a|ab', 'ab', ['a']],
  ['ab|a', 'ab', ['ab']],
  ['(a|ab)(c|bcd)', 'abcd', ['abcd', 'a', 'bcd']],
  // Greedy and lazy
  ['<.*>', '<a><b>', ['<a><b>']],
  ['<.*?>', '<a><b>', ['<a>']],
  ['a{2}', 'aaa', ['aa']],
  ['a{2,}?', 'aaaa', ['aa']],
  ['x{', 'x{', ['x{']],
  // Classes, escapes and edges
  ['[\\w-]+', '/a-b_c/', ['a-b_c']],
  ['[]a]', ']', undefined],
  ['[^]', '\n', ['\n']],
  ['\\bx\\b', 'a x b', ['x']],
  ['\\.', 'a.b', ['.']],
  ['\\u0061\\x62', 'ab', ['ab']],
  ['a.b', 'a\nb', undefined],
  ['a$', 'a\n', undefined],
  ['(?i)TOUCH', '/touch', ['touch']],
  ['(?s)a.b', 'a\nb', ['a\nb']],
  // Characters beyond ASCII and beyond 16 bits count as one
  ['ä', '/bär', ['ä']],
  ['^/ä/🙂?$', '/ä/🙂', ['/ä/🙂']],
  ['^.$', '🙂', ['🙂']],
  ['([^/]+)$', '/räume/küche 🙂', ['küche 🙂', 'küche 🙂']],
  ['\\p{L}+', '12 Größe', ['Größe']],
  ['\\p{Greek}', 'aβ', ['β']],
  ['[α-ω]+', 'xαβγx', ['αβγ']],
  ['\\w+', 'é', undefined],
  ['\\d', '٣', undefined],
];

/** Invalid expressions, and ones that cannot run in linear time, with a part of the reason. */
export const REFUSED: readonly (readonly [source: string, reason: RegExp])[] = [
  ['(', /missing/],
  ['[a', /missing/],
  ['[', /missing/],
  ['a**', /repetition|repeat/],
  ['*a', /repetition|repeat/],
  ['\\', /backslash/],
  ['a{2,1}', /repeat count/],
  ['a{1001}', /repeat count/],
  ['(?=a)', /look-ahead/],
  ['(?!a)b', /look-ahead/],
  ['(?<=a)b', /look-behind/],
  ['(?<!a)b', /look-behind/],
  ['(a)\\1', /back-references/],
  ['(?<n>a)\\k<n>', /back-references/],
];

/** Expressions that would cost too much per character of a text. */
export const TOO_LARGE: readonly string[] = [
  '(?:(?:a{0,31}){0,31}b)*'.repeat(40),
  '(.*){1000}',
  '(a?){600}(b?){600}',
  '.{1000}.{1000}',
];

/** Expressions that a backtracking engine cannot finish for a text of a thousand `a` and a `!`. */
export const SLOW_ELSEWHERE: readonly string[] = [
  '(a+)+$',
  '^(a+)+$',
  '(a*)*b$',
  '^(a|aa)+$',
  '(x+x+)+y',
  '(.*a){20}$',
  '^(([a-z])+.)+[A-Z]([a-z])+$',
];
