/** A piece of a pattern; what stands for something else is marked. */
export interface PatternPart {
  readonly text: string;
  readonly isOpen: boolean;
}

export type PatternKind = 'glob' | 'regex' | 'format';

/** What stands for something else: levels of a glob, groups of an expression, parameters of a format. */
const OPEN: Readonly<Record<PatternKind, RegExp>> = {
  glob: /\*\*|\*|\?/g,
  regex: /\((?:[^()\\]|\\.)*\)/g,
  format: /\{\{[^}]*\}\}|%s/g,
};

/** A pattern in pieces, for showing which part of it differs from topic to topic. */
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
