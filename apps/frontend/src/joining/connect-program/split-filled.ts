/** A part of a text. */
export interface TextPart {
  readonly text: string;
  readonly isFilled: boolean;
}

/** Splits a text where parts of it were filled in. */
export function splitFilled(text: string, filled: readonly string[]): TextPart[] {
  const parts: TextPart[] = [];
  let at = 0;
  while (at < text.length) {
    const next = filled
      .filter((part) => part !== '')
      .map((part) => ({ part, from: text.indexOf(part, at) }))
      .filter(({ from }) => from >= 0)
      .sort((a, b) => a.from - b.from || b.part.length - a.part.length)[0];
    const end = next?.from ?? text.length;
    if (end > at) parts.push({ text: text.slice(at, end), isFilled: false });
    if (next === undefined) break;
    parts.push({ text: next.part, isFilled: true });
    at = end + next.part.length;
  }
  return parts;
}
