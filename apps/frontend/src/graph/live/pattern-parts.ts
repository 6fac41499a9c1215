/** Part of a pattern; variable parts are marked. */
export interface PatternPart {
  readonly text: string;
  readonly isOpen: boolean;
}

export type PatternKind = 'glob' | 'regex' | 'format';

/** Variable parts: wildcards of a glob, groups of a regular expression, parameters of a format. */
const OPEN: Readonly<Record<PatternKind, RegExp>> = {
  glob: /\*\*|\*|\?/g,
  regex: /\((?:[^()\\]|\\.)*\)/g,
  format: /\{\{[^}]*\}\}|%s/g,
};

/** Splits a pattern into fixed parts and parts that differ from topic to topic. */
export function patternParts(text: string, kind: PatternKind): PatternPart[] {
  const parts: PatternPart[] = [];
  let end = 0;
  for (const match of text.matchAll(OPEN[kind])) {
    if (match.index > end) parts.push({ text: text.slice(end, match.index), isOpen: false });
    parts.push({ text: match[0], isOpen: true });
    end = match.index + match[0].length;
  }
  if (end < text.length) parts.push({ text: text.slice(end), isOpen: false });
  return parts;
}
